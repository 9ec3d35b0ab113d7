// SPDX-License-Identifier: Apache-2.0
// Keeps the page's state in the browser, so that a reload comes back as it was; and the user's recent scenes. Nothing leaves
// the browser. Without storage (a private window, a full disk) the page works without this.
import {effect, signal} from '@preact/signals';

import {gallery, parts} from '../gallery';
import type {KeptHistory} from '../editor/kept_history';
import type {StoredScene} from '../share';
import {keepLarge, largeOf} from './large';
import {pixelToKeep} from './pixels';
import {
    type Tab, comparison, documentId, fileName, includes, notice, overrides, pinned, sceneName, services, step, tab, text,
} from './state';

interface KeptPage extends StoredScene {
    tab: Tab;
    pixel?: [number, number] | undefined;
    step?: number | undefined;
    /** The address's fragment then: another one is another scene. */
    hash: string;
    /** The scene's number, and what undo takes back. */
    id?: number | undefined;
    undo?: KeptHistory | undefined;
}

/** The largest text that storage holds, in characters; larger ones are in IndexedDB (large.ts). */
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

/** False: there is no storage, or no room in it. */
function write(where: Where, key: string, value: unknown): boolean {
    try {
        globalThis[where].setItem(key, JSON.stringify(value));
        return true;
    } catch {
        return false;
    }
}

/** Stands in storage for what is in IndexedDB. */
interface Elsewhere {large: string}

const isElsewhere = (value: object): value is Elsewhere => 'large' in value;

/** About the characters that a scene takes in storage. */
const sizeOf = (scene: StoredScene) => scene.text.length + (scene.includes ?? []).reduce((sum, one) => sum + one.text.length + (one.base64?.length ?? 0), 0);

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
export async function keptPage(): Promise<KeptPage | null> {
    const kept = read<KeptPage | Elsewhere>('sessionStorage', pageKey) ?? read<KeptPage | Elsewhere>('localStorage', pageKey);
    return kept && isElsewhere(kept) ? (await largeOf(kept.large) as KeptPage | null) : kept;
}

/** A scene that was opened before; `large`: its text is kept elsewhere. */
export interface RecentScene extends StoredScene {
    large?: string | undefined;
}

/** The newest first. */
export const recent = signal<RecentScene[]>(read<RecentScene[]>('localStorage', recentKey) ?? []);

/** The whole of a recent scene; null: it is kept no longer. */
export async function recentScene(scene: RecentScene): Promise<StoredScene | null> {
    return scene.large === undefined ? scene : (await largeOf(scene.large) as StoredScene | null);
}

const nameOf = (scene: StoredScene) => `recent ${scene.name} ${scene.scene ?? ''}`;

/** Remembers a scene that is the user's own: not one of the gallery. */
export function remember(scene: StoredScene) {
    const isGallery = gallery.some((one) => one.name === scene.name && one.text === scene.text) && !scene.overrides;
    if (scene.name === '' || isGallery) return;
    const enter = (entry: RecentScene) => {
        const others = recent.value.filter((one) => one.name !== scene.name || one.scene !== scene.scene);
        recent.value = [entry, ...others].slice(0, mostRecent);
        write('localStorage', recentKey, recent.value);
    };
    const whole = {...scene, compare: undefined}, large = nameOf(scene);
    if (sizeOf(scene) <= largest / mostRecent) enter(whole);
    else void keepLarge(large, whole).then((isKept) => isKept && enter({...whole, large, text: '', includes: undefined}));
}

/** The key of this tab's page in IndexedDB: that of the reload before. */
const ownKey = () => {
    const kept = read<KeptPage | Elsewhere>('sessionStorage', pageKey);
    return kept && isElsewhere(kept) ? kept.large : `page ${crypto.randomUUID?.() ?? Math.random()}`;
};

/** Says once of each scene that a reload would lose it. */
function warn(page: KeptPage, warned: {id: number}) {
    if (warned.id === documentId.value) return;
    warned.id = documentId.value;
    const size = sizeOf(page);
    notice.value = `The browser has no room for this scene (${size < 1e6 ? `${Math.ceil(size / 1000)} kB` : `${(size / 1e6).toFixed(1)} MB`}): a reload would lose your changes. Save scene makes a file of it.`;
}

/** Keeps the page from now on. */
export function keepPage() {
    const large = ownKey(), warned = {id: 0};
    let timer = 0;
    const keep = async () => {
        clearTimeout(timer);
        timer = 0;
        const page: KeptPage = {...presentScene(), tab: tab.value, pixel: pixelToKeep(), step: step.value ?? undefined, hash: location.hash, id: documentId.value, undo: services.editor?.kept};
        if (sizeOf(page) <= largest && write('sessionStorage', pageKey, page)) {
            write('localStorage', pageKey, page);
        } else if (await keepLarge(large, page)) {
            for (const where of ['sessionStorage', 'localStorage'] as const) write(where, pageKey, {large} satisfies Elsewhere);
        } else {
            warn(page, warned);
        }
    };
    effect(() => {
        presentScene();
        void [tab.value, pinned.value, step.value];
        timer ||= window.setTimeout(keep, 400);
    });
    addEventListener('pagehide', () => void keep());
    addEventListener('visibilitychange', () => void keep());
}
