// SPDX-License-Identifier: Apache-2.0
// One plain sentence about a pixel, from its explanation.
import type {Explanation, ExplainedHit, ExplainedRay, LightTerms, Vec3} from 'glint-wasm';

import {addedBy} from '../store/stepping';
import {byLight, firstHit, itemName, layerNames, lightName} from './words';

const hues = ['red', 'orange', 'yellow', 'green', 'green', 'green', 'cyan', 'blue', 'blue', 'violet', 'magenta', 'red'];

/** A plain name of a color: "dark red" is red, greys are grey, black or white by their brightness. */
export function colorName(color: Vec3): string {
    const high = Math.max(...color), low = Math.min(...color);
    if (high <= 0.02) return 'black';
    if (high - low < 0.15 * high) return high > 0.8 ? 'white' : 'grey';
    const [r, g, b] = color, range = high - low;
    const sixth = high === r ? ((g - b) / range + 6) % 6 : high === g ? (b - r) / range + 2 : (r - g) / range + 4;
    return hues[Math.round(sixth * 2) % 12]!;
}

/** "the sphere on line 8", "the light “lamp”". */
const phrase = (name: string) => `the ${name.replace(/^“/, 'light “').replace(/, line (\d+)$/, ' on line $1')}`;

const sum = (color: Vec3) => color.reduce((a, b) => a + Math.max(0, b), 0);

const small = 0.005;  // of the pixel; smaller parts are left out

/** What a mirror or glass shows: the first thing on the way, but not the far side of a clear ball that adds nothing itself. */
function seenIn(explanation: Explanation, hit: ExplainedHit, side: 'reflected' | 'transmitted'): string {
    const isClear = (one: ExplainedRay) => one.hit !== undefined && one.hit.shape.index === hit.shape.index && one.hit.transmitted.ray !== undefined && sum(addedBy(one)) < small * sum(explanation.value);
    let ray = hit[side].ray === undefined ? undefined : explanation.rays[hit[side].ray];
    if (!ray) return 'nothing';
    for (let inside = 0; side === 'transmitted' && isClear(ray) && inside < 8; ++inside) ray = explanation.rays[ray.hit!.transmitted.ray!]!;
    if (!ray.hit) return 'the background';
    return ray.hit.shape.index === hit.shape.index ? `${phrase(itemName(hit.shape))} itself` : phrase(itemName(ray.hit.shape));
}

/** A color's name before a noun; nothing for a color so dark that its hue cannot be seen. */
const hue = (color: Vec3) => (colorName(color) === 'black' ? '' : `${colorName(color)} `);


/** Shares of a whole in percent that add up to 100: those with the largest rests are rounded up. */
function percents(shares: readonly number[]): number[] {
    const whole = shares.reduce((a, b) => a + b, 0), exact = shares.map((share) => (100 * share) / whole);
    const floors = exact.map(Math.floor), left = 100 - floors.reduce((a, b) => a + b, 0);
    const byRest = exact.map((value, i) => ({i, rest: value - floors[i]!})).sort((a, b) => b.rest - a.rest);
    for (const {i} of byRest.slice(0, left)) floors[i]! += 1;
    return floors.map((value) => Math.max(1, value));
}

/** The channels that are brighter than white, which a picture cannot show. */
function clamped({value}: Explanation): string | null {
    const names = ['red', 'green', 'blue'].filter((_, c) => value[c]! > 1 + 1e-9);
    if (names.length === 0) return null;
    return `${names.join(' and ')} ${names.length === 1 ? 'is' : 'are'} above 1 and shown as 255`;
}

/** Whether the pixel's samples see different shapes. */
function isEdge({rays}: Explanation): boolean {
    const seen = new Set(rays.filter(({parent}) => parent === null).map(({hit}) => hit?.shape.index ?? -1));
    return seen.size > 1;
}

const fates: Partial<Record<LightTerms['reason'], string>> = {
    faint: 'is too faint to count', outside_cone: 'shines past the point', back_of_light: 'faces away from the point', behind: 'is behind the surface',
    faded: 'is too far to add anything', in_surface: 'is at the very point', no_color: 'has no color that this surface reflects',
};

/** Why a light adds nothing, if it does; of an area light, how many of its samples do not. */
function fateOf(group: readonly LightTerms[]): string[] {
    const {light, reason, blocker} = group[0]!, name = phrase(lightName(light));
    const dark = group.filter((terms) => terms.reason !== 'adds');
    if (dark.length === 0) return [];
    if (dark.length < group.length || group.some((terms) => terms.reason !== reason)) {
        const blocked = dark.filter((terms) => terms.reason === 'blocked').length;
        return [`${blocked > 0 ? blocked : dark.length} of ${group.length} samples of ${name} ${blocked > 0 ? 'are blocked' : 'add nothing'}`];
    }
    if (reason === 'blocked') return [`${name} is blocked${blocker ? ` by ${phrase(itemName(blocker.shape))}` : ''}`];
    return [`${name} ${fates[reason] ?? 'adds nothing'}`];
}

/** "82% green diffuse light; 18% is the sphere on line 8 in the mirror; the point light on line 12 is blocked by ..." */
export function sentence(explanation: Explanation): string {
    const hit = firstHit(explanation);
    const {layers} = explanation;
    const total = layerNames.reduce((all, name) => all + sum(layers[name]), 0);
    if (!hit) {
        const share = total > 0 ? Math.round((100 * sum(layers.fog)) / total) : 0;
        return `The ray hits nothing: this is the ${share === 0 ? 'background' : share === 100 ? 'fog' : `background through the fog, whose own light is ${share}% of it`}.`;
    }
    const parts: string[] = [];
    if (total <= 1e-6) {
        parts.push('black: nothing adds light here');
    } else {
        const isStraight = explanation.rays[hit.transmitted.ray ?? -1]?.straight === true;
        const occluded = hit.occlusion ? ` (${Math.round(100 * hit.occlusion.blocked / hit.occlusion.samples)}% of the directions are blocked)` : '';
        // Every part of the pixel, the largest first.
        const words: Record<(typeof layerNames)[number], () => string> = {
            background: () => 'is the background', ambient: () => `${hue(layers.ambient)}ambient light`, diffuse: () => `${hue(layers.diffuse)}diffuse light`,
            specular: () => `${hue(layers.specular)}highlight`, emission: () => `${hue(layers.emission)}light that the surface emits`,
            reflection: () => `is ${seenIn(explanation, hit, 'reflected')} in the mirror`,
            transmission: () => `is ${seenIn(explanation, hit, 'transmitted')} ${isStraight ? 'behind the transparent surface' : 'through the glass'}`,
            sky: () => `is light from all directions${occluded}`, fog: () => 'is the fog’s own light',
        };
        const shares = layerNames.map((name) => ({name, share: sum(layers[name]) / total})).filter(({share}) => share > small).sort((a, b) => b.share - a.share);
        const parted = percents(shares.map(({share}) => share));
        for (const [i, {name}] of shares.entries()) {
            const text = words[name]();
            const isOwn = !text.startsWith('is ');
            if (shares.length === 1) parts.push(isOwn ? `all ${text}` : `all of it ${text}`);
            else parts.push(`${parted[i]}% ${i === 0 && isOwn ? text : isOwn ? `is ${text}` : text}`);
        }
        const tooBright = clamped(explanation);
        if (tooBright) parts.push(tooBright);
    }
    for (const members of byLight(hit.lights)) parts.push(...fateOf(members.map((i) => hit.lights[i]!)));
    if (isEdge(explanation)) parts.push(`the pixel is the mean of ${explanation.samples ** 2} samples, which see different things; this is of ${phrase(itemName(hit.shape))}`);
    const text = parts.join('; ');
    return `${text[0]!.toUpperCase()}${text.slice(1)}.`;
}
