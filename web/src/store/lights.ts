// SPDX-License-Identifier: Apache-2.0
// The scene's lights as the text says them.
import type {Vec3} from 'glint-wasm';

import type {LightText} from '../text/edit';
import {isHere, offsetOf} from './places';
import {format, info, services, text} from './state';

/** How bright those lights were that are off. */
const lightsOff = new Map<number, number>();

export function forgetLights() {
    lightsOff.clear();
}

/** A light of the scene as the text says it; null if it cannot be changed there. */
export function lightText(index: number): LightText | null {
    const place = info.value?.lights[index]?.place;
    const offset = place && isHere(place) ? offsetOf(place) : null;
    return offset === null ? null : (format.value?.light(text.value, offset) ?? null);
}

export function setLight(index: number, change: {intensity?: number; place?: Vec3}) {
    const light = lightText(index);
    if (!light) return;
    const edits = change.intensity !== undefined ? light.setIntensity(change.intensity) : light.setPlace(change.place!);
    if (edits) services.editor?.apply(edits);
}

export function switchLight(index: number, on: boolean) {
    const light = lightText(index);
    if (!light) return;
    if (!on) lightsOff.set(index, light.intensity);
    setLight(index, {intensity: on ? (lightsOff.get(index) ?? 1) : 0});
}
