// SPDX-License-Identifier: Apache-2.0
// Keeps the page's state in the browser, so that a reload comes back as it was; and the user's recent scenes. Nothing leaves
// the browser. Without storage (a private window, a full disk) the page works without this.
import {effect, signal} from '@preact/signals';

import {gallery, parts} from '../gallery';
import type {StoredScene} from '../share';
import {pixelToKeep} from './pixels';
import {
    type Tab, comparison, fileName, includes, overrides, pinned, sceneName, step, tab, text,
} from './state';

interface KeptPage extends StoredScene {
    tab: Tab;
    pixel?: [number, number] | undefined;
    step?: number | undefined;
    /** The address's fragment then: another one is another scene. */
    hash: string;
}

const largest = 2e6;
const mostRecent = 8;

/** Of this tab, or of the browser. Where storage is forbidden, naming it throws. */
type Where = 'sessionStorage' | 'localStorage';

function read<T>(where: Where, key: string): T | null {
    try {
        return JSON.parse(globalThis[where].getItem(key) ?? 'null') as T | null;
    } catch {
        return null;
    }
}

function write(where: Where, key: string, value: unknown) {
    try {
        const json = JSON.stringify(value);
        if (json.length <= largest) {
            globalThis[where].setItem(key, json);
        } else {
            globalThis[where].removeItem(key);
        }
    } catch {
        // There is no storage, or no room in it.
    }
}

const pageKey = 'glint.page', recentKey = 'glint.recent';

/** The present scene, to be opened again. */
export function presentScene(): StoredScene {
    return {
        name: fileName.value, text: text.value, scene: sceneName.value,
        includes: includes.value === parts ? undefined : includes.value,
        overrides: Object.keys(overrides.value).length > 0 ? overrides.value : undefined,
        compare: comparison.value ?? undefined,
    };
}

/** The page as it was: of this tab, else of the last one. */
export const keptPage = () => read<KeptPage>('sessionStorage', pageKey) ?? read<KeptPage>('localStorage', pageKey);

/** The newest first. */
export const recent = signal<StoredScene[]>(read<StoredScene[]>('localStorage', recentKey) ?? []);

/** Remembers a scene that is the user's own: not one of the gallery. */
export function remember(scene: StoredScene) {
    const isGallery = gallery.some((one) => one.name === scene.name && one.text === scene.text) && !scene.overrides;
    if (scene.name === '' || isGallery) return;
    const others = recent.value.filter((one) => one.name !== scene.name || one.scene !== scene.scene);
    recent.value = [{...scene, compare: undefined}, ...others].slice(0, mostRecent);
    while (JSON.stringify(recent.value).length > largest) recent.value = recent.value.slice(0, -1);
    write('localStorage', recentKey, recent.value);
}

/** Keeps the page from now on. */
export function keepPage() {
    let timer = 0;
    const keep = () => {
        clearTimeout(timer);
        timer = 0;
        const page: KeptPage = {...presentScene(), tab: tab.value, pixel: pixelToKeep(), step: step.value ?? undefined, hash: location.hash};
        write('sessionStorage', pageKey, page);
        write('localStorage', pageKey, page);
    };
    effect(() => {
        presentScene();
        void [tab.value, pinned.value, step.value];
        timer ||= window.setTimeout(keep, 400);
    });
    addEventListener('pagehide', keep);
    addEventListener('visibilitychange', keep);
}
