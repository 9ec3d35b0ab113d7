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

/** The object that a mirror or glass shows first. */
function seenIn(explanation: Explanation, hit: ExplainedHit, side: 'reflected' | 'transmitted'): string {
    const ray = hit[side].ray === undefined ? undefined : explanation.rays[hit[side].ray];
    if (!ray) return 'nothing';
    return ray.hit ? phrase(itemName(ray.hit.shape)) : 'the background';
}

/** "Mostly green diffuse light; 22% is the sphere on line 8 in the mirror; the point light on line 12 is blocked by ..." */
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
        const share = (name: (typeof layerNames)[number]) => sum(layers[name]) / total;
        const local = (['ambient', 'diffuse', 'specular', 'emission'] as const).reduce((a, b) => (share(b) > share(a) ? b : a));
        const words = {ambient: 'ambient light', diffuse: 'diffuse light', specular: 'highlight', emission: 'light that the surface emits'}[local];
        if (share(local) > 0.02) {
            const amount = share(local) > 0.9 ? 'almost all' : share(local) > 0.5 ? 'mostly' : `${Math.round(100 * share(local))}%`;
            parts.push(`${amount} ${colorName(layers[local])} ${words}`);
        }
        if (share('reflection') > 0.005) parts.push(`${Math.round(100 * share('reflection'))}% is ${seenIn(explanation, hit, 'reflected')} in the mirror`);
        const isStraight = explanation.rays[hit.transmitted.ray ?? -1]?.straight === true;
        if (share('transmission') > 0.005) parts.push(`${Math.round(100 * share('transmission'))}% is ${seenIn(explanation, hit, 'transmitted')} ${isStraight ? 'behind the transparent surface' : 'through the glass'}`);
        if (share('sky') > 0.005) parts.push(`${Math.round(100 * share('sky'))}% is light from all directions${hit.occlusion ? `, of which ${Math.round(100 * hit.occlusion.blocked / hit.occlusion.samples)}% is blocked` : ''}`);
        if (share('fog') > 0.005) parts.push(`${Math.round(100 * share('fog'))}% is the fog's own light`);
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
