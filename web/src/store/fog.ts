// SPDX-License-Identifier: Apache-2.0
// The scene's fog as the text says it.
import type {FogText} from '../text/edit';
import {isHere, offsetOf} from './places';
import {format, info, services, text} from './state';

/** The fog as given in the text; null if there is none, or if it cannot be changed there. */
export function fogText(): FogText | null {
    const place = info.value?.fog?.place;
    const offset = place && isHere(place) ? offsetOf(place) : null;
    return offset === null ? null : (format.value?.fog?.(text.value, offset) ?? null);
}

/** A density at which half of the light from the middle of the scene is seen. */
function usualDensity(): number {
    const {bounds, camera} = info.value!;
    const middle = bounds ? bounds.min.map((low, c) => (low + bounds.max[c]!) / 2) : [0, 0, 0];
    const distance = Math.hypot(...middle.map((x, c) => x - camera.position[c]!));
    return Number((Math.LN2 / (distance || 10)).toPrecision(2));
}

export function switchFog(on: boolean) {
    const edits = on ? format.value?.addFog?.(text.value, usualDensity()) : fogText()?.remove();
    if (edits) services.editor?.apply(edits);
}
