// SPDX-License-Identifier: Apache-2.0
// Hints for a challenge: what glint finds at one pixel where the pictures differ, in the present scene and in the target.
import {signal} from '@preact/signals';
import type {Explanation, OpenRequest} from 'glint-wasm';

import {presentRequest} from './scene';
import {services} from './state';

/** The sentences of the pixel, and how many of them are shown; null: none have been asked for. */
export const hints = signal<{pixel: [number, number]; all: string[]; shown: number} | null>(null);
export const isSearching = signal(false);

let asked = 0;

/** The hints are of a picture that is no more. */
export function forgetHints() {
    ++asked;
    hints.value = null;
    isSearching.value = false;
}

let last = 0;

async function explain(request: OpenRequest, [x, y]: [number, number]): Promise<Explanation | null> {
    return services.pool!.run({view: 'hint', key: ++last, request, prepare: {}, task: {what: 'explain', x, y}}, true).catch(() => null);
}

/** Shows the next hint: the first one asks glint. pixel: where the pictures differ. words: the sentences about it. */
export async function nextHint(target: OpenRequest, pixel: [number, number], words: (own: Explanation, target: Explanation) => string[]) {
    if (hints.value) {
        hints.value = {...hints.value, shown: Math.min(hints.value.shown + 1, hints.value.all.length)};
        return;
    }
    const number = ++asked;
    isSearching.value = true;
    const own = await explain(presentRequest(), pixel), wanted = await explain(target, pixel);
    if (number !== asked) return;
    isSearching.value = false;
    hints.value = {pixel, all: own && wanted ? words(own, wanted) : ['The pixels cannot be explained: the scene has errors.'], shown: 1};
}
