// SPDX-License-Identifier: Apache-2.0
// The page's address: that of a gallery scene, a step of a lesson, or a challenge. Back, a reload and a bookmark return to it.
import type {GalleryScene} from '../gallery';
import type {StoredScene} from '../share';
import {presentScene} from './memory';

export type Place = {what: 'scene'; name: string} | {what: 'lesson'; id: string; step: number} | {what: 'challenge'; id: string};

/** The name of a gallery scene in addresses. Files of several scenes have one for each. */
export const galleryName = ({id, name, scene}: GalleryScene) => id ?? (scene ? `${name}/${scene}` : name);

/** The fragment of a place. Steps are counted from 1. */
export function fragmentOf(place: Place): string {
    if (place.what === 'lesson') return `#lesson=${place.id}${place.step > 0 ? `/${place.step + 1}` : ''}`;
    return `#${place.what}=${place.what === 'scene' ? place.name : place.id}`;
}

/** The place of a fragment; null if it is another one. */
export function placeOf(fragment: string): Place | null {
    const lesson = /^#lesson=(\w+)(?:\/(\d+))?$/.exec(fragment);
    if (lesson) return {what: 'lesson', id: lesson[1]!, step: Math.max(0, Number(lesson[2] ?? 1) - 1)};
    const other = /^#(scene|challenge)=([\w./-]+)$/.exec(fragment);
    if (!other) return null;
    return other[1] === 'scene' ? {what: 'scene', name: other[2]!} : {what: 'challenge', id: other[2]!};
}

/** What an entry of the browser's history keeps: the scene as it was when it was left. */
export interface Entry {scene?: StoredScene}

const largest = 500_000;  // characters of a scene; browsers limit what they keep

let isArriving = false;

/** Opens what the history's present entry stands for: nothing is entered into the history meanwhile. */
export async function arrive(open: () => Promise<void>) {
    isArriving = true;
    try {
        await open();
    } finally {
        isArriving = false;
    }
}

/** Enters a place into the address; null: none. Going back then returns to the present scene. */
export function setAddress(place: Place | null) {
    const fragment = place ? fragmentOf(place) : '';
    if (location.hash === fragment) return;
    const url = `${location.pathname}${location.search}${fragment}`;
    if (isArriving) history.replaceState(history.state, '', url);
    else history.pushState(null, '', url);
}

/** Keeps the present scene in the history's entry, before another one is opened. */
export function keepForBack() {
    const scene = presentScene();
    if (isArriving || scene.name === '' || scene.text.length > largest) return;
    try {
        history.replaceState({scene} satisfies Entry, '');
    } catch {
        // The browser does not keep so much: Back opens the address's own scene.
    }
}
