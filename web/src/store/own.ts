// SPDX-License-Identifier: Apache-2.0
// The user's own picture of the scene: how it differs from glint's, and why.
import {batch, effect, signal} from '@preact/signals';
import type {Comparison} from 'glint-wasm';

import {readPicture} from '../picture_file';
import {presentRequest, setComparison} from './scene';
import {documentId, info, notice, overrides, ownPicture, services, shownId, state, tab, text} from './state';

/** The figures, then with causes; or why there are none. */
export const answer = signal<Comparison | string | null>(null);
export const isSearching = signal(false);

/** Opens a picture beside the scene's. */
export async function openPicture(file: File) {
    const number = ++opened, scene = documentId.value;
    stopAsking();
    try {
        const image = await readPicture(file);
        if (number !== opened || scene !== documentId.value) return;  // another picture or scene has been opened meanwhile
        setComparison(null);
        batch(() => {
            ownPicture.value = {name: file.name, image};
            answer.value = null;
            tab.value = 'compare';
        });
        if (hasHoles(image)) notice.value = `${file.name} has transparent parts: they are compared as the browser shows them.`;
    } catch (error) {
        notice.value = `${file.name} is not opened: ${error instanceof Error ? error.message : String(error)}.`;
    }
}

let opened = 0;

function hasHoles({data}: ImageData): boolean {
    for (let i = 3; i < data.length; i += 4) {
        if (data[i] !== 255) return true;
    }
    return false;
}

export function closePicture() {
    ++opened;
    stopAsking();
    batch(() => {
        ownPicture.value = null;
        answer.value = null;
        isSearching.value = false;
    });
}

/** The scene's size, which the picture must have: the page may show the scene reduced. */
export const sceneSize = () => ({width: info.value?.width ?? 0, height: info.value?.height ?? 0});
export const fits = () => ownPicture.value?.image.width === sceneSize().width && ownPicture.value.image.height === sceneSize().height;

let last = 0, asked = 0;

/** What has been asked is of an older picture. */
function stopAsking() {
    ++asked;
    services.pool?.cancel('own', last);
    isSearching.value = false;
}

async function ask(causes: boolean): Promise<Comparison | string> {
    const {image} = ownPicture.value!;
    try {
        return await services.pool!.run({
            view: 'own', key: ++last, request: presentRequest(), prepare: {},
            task: {what: 'compare-picture', pixels: new Uint8ClampedArray(image.data), width: image.width, height: image.height, causes},
        }, !causes);
    } catch (error) {
        return error instanceof Error ? error.message : String(error);
    }
}

async function judge() {
    stopAsking();
    const number = asked;
    answer.value = null;
    if (!ownPicture.value || !fits()) return;
    const figures = await ask(false);
    if (number !== asked) return;
    answer.value = figures;
    if (typeof figures === 'string' || figures.equal === figures.pixels) return;
    isSearching.value = true;
    const found = await ask(true);
    if (number !== asked) return;
    isSearching.value = false;
    answer.value = found;
}

/** Compares again whenever there is another picture of either kind. */
export function followOwnPicture() {
    effect(() => {
        const isReady = state.value === 'done' && shownId.value === documentId.value;
        void [ownPicture.value, text.value, overrides.value, info.value];
        if (isReady) void judge();
    });
}
