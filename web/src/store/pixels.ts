// SPDX-License-Identifier: Apache-2.0
// Why a pixel is what it is: the one pointed at, and the one that is pinned.
import {batch} from '@preact/signals';
import type {Explanation} from 'glint-wasm';

import {
    type Side, comparison, difference, hovered, machinery, pinned, pinnedIn, pixel, selected, settingIn, size, split, tab,
} from './state';

let asking = false;
let wanted: [number, number] | null = null;

/** The picture that is seen at a pixel. */
function sideAt([x]: readonly [number, number]): Side {
    const isRight = comparison.value && !difference.value && (x + 0.5) / size.value.width > split.value;
    return isRight ? 'second' : 'first';
}

async function ask(at: readonly [number, number], side: Side): Promise<Explanation | null> {
    const current = machinery[side]?.current;
    if (!current || !machinery.pool) return null;
    const {subject, key, prepare} = current;
    try {
        const told = await machinery.pool.run(
            {view: side, key, request: subject.request, prepare, task: {what: 'explain', x: at[0], y: at[1]}}, true);
        return told && !told.error ? told : null;
    } catch {
        return null;
    }
}

/** Points at a pixel; the newest one is explained as soon as the one before it is. */
export async function hover(at: [number, number] | null) {
    pixel.value = at;
    wanted = at;
    if (!at) hovered.value = null;
    if (asking) return;
    asking = true;
    while (wanted) {
        const next: [number, number] = wanted;
        wanted = null;
        const told = await ask(next, sideAt(next));
        if (pixel.value) hovered.value = told;
    }
    asking = false;
}

const isPhong = (side: Side) => settingIn(machinery[side]?.current?.info, 'shading')?.value === 'phong';

export async function pin(at: [number, number] | null) {
    if (!at) {
        pinned.value = null;
        return;
    }
    const side = sideAt(at);
    const told = await ask(at, side);
    if (!told) return;
    batch(() => {
        pinned.value = told;
        pinnedIn.value = {side, isPhong: isPhong(side)};
        selected.value = {ray: 0, light: strongestLight(told, 0)};
        tab.value = 'inspect';
    });
}

/** A picture changed: its pixels are explained anew. */
export async function explainAgain(side: Side) {
    if (pixel.value && sideAt(pixel.value) === side) void hover(pixel.value);
    const at = pinned.value?.pixel;
    const facts = machinery[side]?.current?.info;
    if (!at || !facts || pinnedIn.value.side !== side) return;
    const told = at[0] < facts.width && at[1] < facts.height ? await ask(at, side) : null;
    if (!pinned.value) return;
    batch(() => {
        pinned.value = told;
        pinnedIn.value = {side, isPhong: isPhong(side)};
        if (told && selected.value.ray >= told.rays.length) selected.value = {ray: 0, light: strongestLight(told, 0)};
    });
}

export function strongestLight(told: Explanation, ray: number): number {
    const sums = told.rays[ray]?.hit?.lights.map((light) => [...light.diffuse, ...light.specular].reduce((a, b) => a + b, 0));
    return sums && sums.length > 0 ? sums.indexOf(Math.max(...sums)) : 0;
}
