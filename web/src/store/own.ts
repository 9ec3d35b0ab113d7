// SPDX-License-Identifier: Apache-2.0
// The user's own picture of the scene: how it differs from glint's, and why.
import {batch, effect, signal} from '@preact/signals';
import type {Comparison} from 'glint-wasm';

import {readPicture} from '../picture_file';
import {presentRequest, setComparison} from './scene';
import {documentId, notice, overrides, ownPicture, services, shownId, size, state, tab, text} from './state';

/** The figures, then with causes; or why there are none. */
export const answer = signal<Comparison | string | null>(null);
export const isSearching = signal(false);

/** Opens a picture beside the scene's. */
export async function openPicture(file: File) {
    try {
        const image = await readPicture(file);
        setComparison(null);
        batch(() => {
            ownPicture.value = {name: file.name, image};
            answer.value = null;
            tab.value = 'compare';
        });
    } catch (error) {
        notice.value = `${file.name} is not opened: ${error instanceof Error ? error.message : String(error)}.`;
    }
}

export function closePicture() {
    ++last;
    batch(() => {
        ownPicture.value = null;
        answer.value = null;
        isSearching.value = false;
    });
}

export const fits = () => ownPicture.value?.image.width === size.value.width && ownPicture.value.image.height === size.value.height;

let last = 0;

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

let asked = 0;

async function judge() {
    const own = ownPicture.value, number = ++asked;
    isSearching.value = false;
    if (!own || !fits()) {
        answer.value = null;
        return;
    }
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
        void [ownPicture.value, text.value, overrides.value, size.value];
        if (isReady) void judge();
    });
}
