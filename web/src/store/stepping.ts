// SPDX-License-Identifier: Apache-2.0
// Steps through the rays of the pinned pixel, in the order of the tree, while their sum grows.
import {batch, computed, signal} from '@preact/signals';
import type {Explanation, ExplainedRay, Vec3} from 'glint-wasm';

import {strongestLight} from './pixels';
import {pinned, selected, step} from './state';

/** What a ray adds to the sum of its pixel's samples. */
export function addedBy(ray: ExplainedRay): Vec3 {
    return ownLight(ray).map((c, i) => c + (ray.fog?.added[i] ?? 0)) as Vec3;
}

/** The same without the fog before the surface or the background. */
function ownLight({hit, background}: ExplainedRay): Vec3 {
    return hit ? ([0, 1, 2].map((c) => hit.parts.ambient[c]! + hit.parts.diffuse[c]! + hit.parts.specular[c]! + hit.parts.emission[c]! + (hit.occlusion?.part[c] ?? 0)) as Vec3) : background!;
}

/** The rays in the order of the tree: each before the mirror ray and the ray through glass that it causes. */
export function raysInOrder({rays}: Explanation): number[] {
    const order: number[] = [];
    const waiting = rays.flatMap((ray, i) => (ray.parent === null ? [i] : [])).reverse();
    for (let next = waiting.pop(); next !== undefined; next = waiting.pop()) {
        order.push(next);
        const {hit} = rays[next]!;
        for (const branch of [hit?.transmitted, hit?.reflected]) if (branch?.ray !== undefined) waiting.push(branch.ray);
    }
    return order;
}

/** Null: no pixel is pinned. `at`: null if all rays are shown. `shown`: those up to the present one. */
export const steps = computed(() => {
    const explanation = pinned.value;
    if (!explanation) return null;
    const order = raysInOrder(explanation);
    const at = step.value === null ? null : Math.min(step.value, order.length - 1);
    const shown = order.slice(0, at === null ? order.length : at + 1);
    const samples = explanation.samples ** 2;
    const sum = [0, 1, 2].map((c) => shown.reduce((all, ray) => all + addedBy(explanation.rays[ray]!)[c]!, 0) / samples) as Vec3;
    return {order, at, ray: at === null ? null : order[at]!, shown: new Set(shown), sum};
});

/** Goes to a step; null, and beyond the last: all rays. */
export function goTo(next: number | null) {
    const {order} = steps.value ?? {order: []};
    const explanation = pinned.value;
    if (!explanation) return;
    batch(() => {
        step.value = next === null || next < 0 || next >= order.length ? null : next;
        const ray = order[step.value ?? 0]!;
        selected.value = {ray, light: strongestLight(explanation, ray)};
    });
}

/** The rays are shown one after the other, each for a while. */
export const isPlaying = signal(false);

/** Begins with the first ray, or goes on from the present one; or stops. */
export function play(on: boolean) {
    const now = steps.value;
    if (on && now && (now.at === null || now.at + 1 >= now.order.length)) goTo(0);
    isPlaying.value = on && now !== null;
}

/** The next ray, or the one before; from all rays to the first or the last. */
export function stepBy(by: 1 | -1) {
    const now = steps.value;
    if (now) goTo(now.at === null ? (by > 0 ? 0 : now.order.length - 1) : now.at + by);
}

/** While one steps, choosing a ray in the tree goes to it. */
export function goToRay(ray: number) {
    const now = steps.value;
    if (now && now.at !== null) goTo(now.order.indexOf(ray));
}
