// SPDX-License-Identifier: Apache-2.0
// What tells two explanations of one pixel apart, from the general to the particular.
import type {Explanation, ExplainedHit, LightTerms} from 'glint-wasm';

import {sentence} from './sentence';
import {itemName, layerNames, lightName, reasons, short, shortColor} from './words';

/** The layer whose light differs most. */
function layerHint(own: Explanation, target: Explanation): string[] {
    const apart = (name: (typeof layerNames)[number]) => Math.max(...own.layers[name].map((value, c) => Math.abs(value - target.layers[name][c]!)));
    const most = layerNames.reduce((a, b) => (apart(b) > apart(a) ? b : a));
    if (apart(most) === 0) return [];
    return [`The part that differs most is ${most}: ${shortColor(own.layers[most])} in your picture, ${shortColor(target.layers[most])} in the target.`];
}

function lightHints(own: LightTerms[], target: LightTerms[]): string[] {
    if (own.length !== target.length) return [`Your scene has ${own.length} lights besides ambient ones, and the target’s has ${target.length}.`];
    return own.flatMap((terms, i) => {
        const other = target[i]!, name = lightName(terms.light);
        if (terms.reason !== other.reason) {
            const blocker = terms.blocker ? ` by ${itemName(terms.blocker.shape)}` : '';
            return [`In your picture the light ${name} ${reasons[terms.reason]}${blocker}; in the target it ${reasons[other.reason]}.`];
        }
        if (shortColor(terms.light.color) !== shortColor(other.light.color)) return [`The light ${name} has another color or intensity in the target.`];
        if (terms.to_light.some((value, c) => Math.abs(value - other.to_light[c]!) > 1e-3)) return [`The light ${name} comes from another direction in the target.`];
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
    const hit = own.rays[0]?.hit, wanted = target.rays[0]?.hit;
    if (!hit || !wanted) return hints;
    if (hit.shape.kind !== wanted.shape.kind || hit.shape.name !== wanted.shape.name) return hints;
    const moved = Math.max(...hit.point.map((value, c) => Math.abs(value - wanted.point[c]!)));
    if (moved > 1e-6) hints.push(`The ${itemName(hit.shape)} is elsewhere, or of another size, in the target: its point here is ${short(moved)} away.`);
    hints.push(...materialHints(hit, wanted), ...lightHints(hit.lights, wanted.lights));
    if (own.rays.length !== target.rays.length) hints.push(`This pixel has ${own.rays.length} rays in your picture and ${target.rays.length} in the target: mirrors and glass, or the setting reflections.`);
    return hints;
}
