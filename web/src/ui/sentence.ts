// SPDX-License-Identifier: Apache-2.0
// One plain sentence about a pixel, from its explanation.
import type {Explanation, ExplainedHit, Vec3} from 'glint-wasm';

import {itemName, layerNames, lightName} from './words';

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

/** What a mirror or glass shows: the first thing on the way that is not the surface itself, as the far side of a glass ball. */
function seenIn(explanation: Explanation, hit: ExplainedHit, side: 'reflected' | 'transmitted'): string {
    const isSame = (other: ExplainedHit) => other.shape.index === hit.shape.index && other.shape.kind === hit.shape.kind;
    let ray = hit[side].ray === undefined ? undefined : explanation.rays[hit[side].ray];
    if (!ray) return 'nothing';
    for (let inside = 0; ray.hit && isSame(ray.hit) && inside < 8; ++inside) {
        const next: number | undefined = ray.hit.transmitted.ray ?? ray.hit.reflected.ray;
        if (next === undefined) return `${phrase(itemName(hit.shape))} itself`;
        ray = explanation.rays[next]!;
    }
    return ray.hit ? phrase(itemName(ray.hit.shape)) : 'the background';
}

/** The same for a part of a pixel, before a noun; nothing for a part so dark that its hue cannot be seen. */
const hue = (color: Vec3) => (colorName(color) === 'black' ? '' : `${colorName(color)} `);

const small = 0.005;  // of the pixel; smaller parts are left out

const percent = (share: number) => `${Math.max(1, Math.round(100 * share))}%`;

/** The channels that are brighter than white, which a picture cannot show. */
function clamped({value}: Explanation): string | null {
    const names = ['red', 'green', 'blue'].filter((_, c) => value[c]! > 1 + 1e-9);
    if (names.length === 0) return null;
    return `${names.join(' and ')} ${names.length === 1 ? 'is' : 'are'} above 1 and shown as 255`;
}

/** "82% green diffuse light; 18% is the sphere on line 8 in the mirror; the point light on line 12 is blocked by ..." */
export function sentence(explanation: Explanation): string {
    const hit = explanation.rays[0]?.hit;
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
        const occluded = hit.occlusion ? `, of which ${Math.round(100 * hit.occlusion.blocked / hit.occlusion.samples)}% is blocked` : '';
        // Every part of the pixel, the largest first.
        const words: Record<(typeof layerNames)[number], () => string> = {
            background: () => 'is the background', ambient: () => `${hue(layers.ambient)}ambient light`, diffuse: () => `${hue(layers.diffuse)}diffuse light`,
            specular: () => `${hue(layers.specular)}highlight`, emission: () => `${hue(layers.emission)}light that the surface emits`,
            reflection: () => `is ${seenIn(explanation, hit, 'reflected')} in the mirror`,
            transmission: () => `is ${seenIn(explanation, hit, 'transmitted')} ${isStraight ? 'behind the transparent surface' : 'through the glass'}`,
            sky: () => `is light from all directions${occluded}`, fog: () => 'is the fog’s own light',
        };
        const shares = layerNames.map((name) => ({name, share: sum(layers[name]) / total})).filter(({share}) => share > small).sort((a, b) => b.share - a.share);
        for (const [i, {name, share}] of shares.entries()) {
            const text = words[name]();
            const isOwn = !text.startsWith('is ');
            if (shares.length === 1) parts.push(isOwn ? `all ${text}` : `all of it ${text}`);
            else parts.push(`${percent(share)} ${i === 0 && isOwn ? text : isOwn ? `is ${text}` : text}`);
        }
        const tooBright = clamped(explanation);
        if (tooBright) parts.push(tooBright);
    }
    for (const {light, reason, blocker, sample} of hit.lights) {
        // Of an area light's samples, the first speaks for all if they have the same fate.
        if (sample !== undefined) {
            const all = hit.lights.filter((terms) => terms.light.index === light.index);
            const blocked = all.filter((terms) => terms.reason === 'blocked').length;
            if (sample > 0 && (blocked === 0 || blocked === all.length)) continue;
            if (sample === 0 && blocked > 0 && blocked < all.length)
                parts.push(`${blocked} of ${all.length} samples of ${phrase(lightName(light))} are blocked`);
            if (blocked > 0 && blocked < all.length) continue;
        }
        if (reason === 'blocked') parts.push(`${phrase(lightName(light))} is blocked${blocker ? ` by ${phrase(itemName(blocker.shape))}` : ''}`);
        if (reason === 'faint') parts.push(`${phrase(lightName(light))} is too faint to count`);
        if (reason === 'outside_cone') parts.push(`${phrase(lightName(light))} shines past the point`);
        if (reason === 'back_of_light') parts.push(`${phrase(lightName(light))} faces away from the point`);
        if (reason === 'behind') parts.push(`${phrase(lightName(light))} is behind the surface`);
        if (reason === 'faded') parts.push(`${phrase(lightName(light))} is too far to add anything`);
        if (reason === 'in_surface') parts.push(`${phrase(lightName(light))} is at the very point`);
        if (reason === 'no_color') parts.push(`${phrase(lightName(light))} has no color that this surface reflects`);
    }
    const text = parts.join('; ');
    return `${text[0]!.toUpperCase()}${text.slice(1)}.`;
}
