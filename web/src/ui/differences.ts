// SPDX-License-Identifier: Apache-2.0
// What tells two explanations of one pixel apart, from the general to the particular.
import type {Explanation, ExplainedHit, LightTerms, Vec3} from 'glint-wasm';

import {sentence} from './sentence';
import {firstHit, itemName, layerNames, lightName, reasons, short, shortColor} from './words';

/** The layer whose light differs most. */
function layerHint(own: Explanation, target: Explanation): string[] {
    const apart = (name: (typeof layerNames)[number]) => Math.max(...own.layers[name].map((value, c) => Math.abs(value - target.layers[name][c]!)));
    const most = layerNames.reduce((a, b) => (apart(b) > apart(a) ? b : a));
    if (apart(most) === 0) return [];
    return [`The part that differs most is ${most}: ${shortColor(own.layers[most])} in your picture, ${shortColor(target.layers[most])} in the target.`];
}

/** The lights of a hit: of an area light's samples, the first that adds light, or the first. */
function lightsOf(terms: readonly LightTerms[]): LightTerms[] {
    const lights = new Map<number, LightTerms>();
    for (const one of terms) {
        const before = lights.get(one.light.index ?? -1);
        if (!before || (before.reason !== 'adds' && one.reason === 'adds')) lights.set(one.light.index ?? -1, one);
    }
    return [...lights.values()];
}

function lightHints(own: LightTerms[], target: LightTerms[], isSamePoint: boolean): string[] {
    if (own.length !== target.length) return [`The number of lights besides ambient ones is ${own.length} in your scene and ${target.length} in the target’s.`];
    return own.flatMap((terms, i) => {
        const other = target[i]!, name = lightName(terms.light);
        if (terms.reason !== other.reason) {
            const blocker = terms.blocker ? ` by ${itemName(terms.blocker.shape)}` : '';
            return [`In your picture the light ${name} ${reasons[terms.reason]}${blocker}; in the target it ${reasons[other.reason]}.`];
        }
        if (shortColor(terms.light.color) !== shortColor(other.light.color)) return [`The light ${name} has another color or intensity in the target.`];
        if (isSamePoint && terms.to_light.some((value, c) => Math.abs(value - other.to_light[c]!) > 1e-3)) return [`The light ${name} comes from another direction in the target.`];
        return [];
    });
}

function materialHints(own: ExplainedHit, target: ExplainedHit): string[] {
    const values = (hit: ExplainedHit) => hit.material as unknown as Record<string, unknown>;
    const differing = Object.entries(values(target)).filter(([key, value]) =>
        (typeof value === 'number' || Array.isArray(value)) && !['index', 'line', 'column', 'length'].includes(key) &&
        JSON.stringify(value) !== JSON.stringify(values(own)[key])).map(([key]) => key);
    return differing.length > 0 ? [`The material of ${itemName(own.shape)} is another one in the target: its ${differing.join(', ')}.`] : [];
}

/** A few sentences, all of them true of this pixel. */
export function differencesOf(own: Explanation, target: Explanation): string[] {
    const hints = [`Your picture here: ${sentence(own)}`];
    if (sentence(target) !== sentence(own)) hints.push(`The target here: ${sentence(target)}`);
    hints.push(...layerHint(own, target));
    const hit = firstHit(own), wanted = firstHit(target);
    if (!hit || !wanted) return hints;
    const apart = (a: Vec3, b: Vec3) => Math.max(...a.map((value, c) => Math.abs(value - b[c]!)));
    if (apart(own.rays[0]!.direction, target.rays[0]!.direction) > 1e-9 || apart(own.rays[0]!.origin, target.rays[0]!.origin) > 1e-9)
        return [...hints, 'The camera sees this pixel from elsewhere, or in another direction, than in the target.'];
    if (hit.shape.index !== wanted.shape.index || hit.shape.kind !== wanted.shape.kind)
        return [...hints, `Another object is seen here: ${itemName(hit.shape)} in your picture, and a ${wanted.shape.kind.replace('_', ' ')}${wanted.shape.name ? ` “${wanted.shape.name}”` : ''} in the target.`];
    const moved = apart(hit.point, wanted.point);
    if (moved > 1e-6) hints.push(`The ${itemName(hit.shape)} is elsewhere, or of another size, in the target: its point here is ${short(moved)} away.`);
    hints.push(...materialHints(hit, wanted), ...lightHints(lightsOf(hit.lights), lightsOf(wanted.lights), moved <= 1e-6));
    if (own.rays.length !== target.rays.length) hints.push(`This pixel has ${own.rays.length} rays in your picture and ${target.rays.length} in the target: mirrors and glass, or the setting reflections.`);
    return hints;
}
