// SPDX-License-Identifier: Apache-2.0
// The scene's lights as the text says them.
import type {FieldInfo, LightInfo, Vec3} from 'glint-wasm';

import type {LightText} from '../text/edit';
import {isHere, offsetOf} from './places';
import {format, info, services, text} from './state';

/** The brightness of the lights that are switched off. */
const lightsOff = new Map<number, number>();

export function forgetLights() {
    lightsOff.clear();
}

/** A light of the scene as given in the text; null if it cannot be changed there. */
export function lightText(index: number): LightText | null {
    const place = info.value?.lights[index]?.place;
    const offset = place && isHere(place) ? offsetOf(place) : null;
    return offset === null ? null : (format.value?.light(text.value, offset) ?? null);
}

export type FieldValue = number | boolean | Vec3;

/** The value of a field, or undefined if the light's kind has none. */
export function fieldValue(light: LightInfo, field: FieldInfo): FieldValue | undefined {
    return (light as unknown as Record<string, FieldValue | undefined>)[field.name];
}

export function setIntensity(index: number, value: number) {
    const light = lightText(index);
    if (light) services.editor?.apply(light.setIntensity(value));
}

export function setField(index: number, field: FieldInfo, value: FieldValue) {
    const edits = lightText(index)?.setField(field, value);
    if (edits) services.editor?.apply(edits);
}

export function switchLight(index: number, on: boolean) {
    const light = lightText(index);
    if (!light) return;
    if (!on) lightsOff.set(index, light.intensity);
    setIntensity(index, on ? (lightsOff.get(index) ?? 1) : 0);
}
