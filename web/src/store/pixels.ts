// SPDX-License-Identifier: Apache-2.0
// The explanations of the pixel under the pointer and of the pinned pixel.
import {batch} from '@preact/signals';
import type {Explanation} from 'glint-wasm';

import {
    type Side, comparison, difference, documentId, hovered, isFirstVisit, isPictureOfScene, services, pinned, pinnedIn, pixel, selected, settingIn, size, split, step, tab,
} from './state';

let asking = false;
let wanted: [number, number] | null = null;

/** The view that is visible at a pixel. */
function sideAt([x]: readonly [number, number]): Side {
    const isRight = comparison.value && !difference.value && (x + 0.5) / size.value.width > split.value;
    return isRight ? 'second' : 'first';
}

async function ask(at: readonly [number, number], side: Side): Promise<Explanation | null> {
    const current = services[side]?.current;
    if (!current || !services.pool || current.content.document !== documentId.value) return null;
    const {content, key, prepare} = current;
    try {
        const explanation = await services.pool.run(
            {view: side, key, request: content.request, prepare, task: {what: 'explain', x: at[0], y: at[1]}}, true);
        return explanation;
    } catch {
        return null;
    }
}

/** Points at a pixel. The newest one is explained when the previous explanation is complete. */
export async function hover(at: [number, number] | null) {
    pixel.value = at;
    wanted = at;
    if (!at) hovered.value = null;
    if (asking) return;
    asking = true;
    while (wanted) {
        const next: [number, number] = wanted;
        wanted = null;
        const explanation = await ask(next, sideAt(next));
        // Without an answer, the scene's picture is being replaced: the next one explains the pixel again.
        if (pixel.value && (explanation || !isPictureOfScene.value)) hovered.value = explanation;
    }
    asking = false;
}

const isPhong = (side: Side) => settingIn(services[side]?.current?.info, 'shading')?.value === 'phong';

/** A pixel to be pinned in the next picture; `opens`: the user has clicked it, which opens the inspector. */
let pinNext: {at: [number, number]; opens: boolean; ray: number | null} | null = null;
let pins = 0;
/** The pixel whose explanation is awaited, to be pinned. */
let awaited: [number, number] | null = null;

/** The pinned pixel, or the one that will be. */
export const pixelToKeep = () => pinned.value?.pixel ?? awaited ?? pinNext?.at;

/** Explains a pixel and keeps its explanation. While the picture is replaced, this waits for the next one. */
export async function pin(at: [number, number] | null, opens = true, ray: number | null = null) {
    const number = ++pins;
    pinNext = null;
    awaited = at;
    if (!at) {
        pinned.value = null;
        return;
    }
    const side = sideAt(at);
    const explanation = await ask(at, side);
    if (number !== pins) return;  // another pixel was pinned meanwhile
    awaited = null;
    if (!explanation) {
        pinNext = {at, opens, ray};
        return;
    }
    batch(() => {
        pinned.value = explanation;
        pinnedIn.value = {side, isPhong: isPhong(side)};
        selected.value = {ray: 0, light: strongestLight(explanation, 0)};
        step.value = ray;
        if (opens) {
            tab.value = 'inspect';
            isFirstVisit.value = false;
        }
    });
}

/** Pins a pixel as soon as the picture is complete. ray: the step through its rays that is shown then. */
export function pinLater(at: [number, number], ray: number | null = null) {
    pinNext = {at, opens: false, ray};
}

/** A picture changed: explains its pixels again. */
export async function explainAgain(side: Side) {
    if (pixel.value && sideAt(pixel.value) === side) void hover(pixel.value);
    const facts = services[side]?.current?.info;
    if (pinNext && facts && side === 'first') {
        const {at: [x, y], opens, ray} = pinNext;
        pinNext = null;
        if (x < facts.width && y < facts.height) {
            await pin([x, y], opens, ray);
            return;
        }
    }
    const at = pinned.value?.pixel;
    if (!at || !facts || pinnedIn.value.side !== side) return;
    const number = pins;
    const isInside = at[0] < facts.width && at[1] < facts.height;
    const explanation = isInside ? await ask(at, side) : null;
    if (!pinned.value || number !== pins) return;
    if (isInside && !explanation) return;  // the picture is being replaced: the next one explains it
    batch(() => {
        pinned.value = explanation;
        pinnedIn.value = {side, isPhong: isPhong(side)};
        if (explanation && selected.value.ray >= explanation.rays.length) selected.value = {ray: 0, light: strongestLight(explanation, 0)};
    });
}

export function strongestLight(explanation: Explanation, ray: number): number {
    const sums = explanation.rays[ray]?.hit?.lights.map((light) => [...light.diffuse, ...light.specular].reduce((a, b) => a + b, 0));
    return sums && sums.length > 0 ? sums.indexOf(Math.max(...sums)) : 0;
}
