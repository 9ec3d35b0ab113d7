// SPDX-License-Identifier: Apache-2.0
// Changing a value in a scene's text, and nothing else in it.
import type {CameraInfo, FieldInfo, Vec3} from 'glint-wasm';

/** Replaces the text from `from` to `to`, in UTF-16 units as the editor counts. */
export interface Edit {
    from: number;
    to: number;
    insert: string;
}

/** A light as its text has it. */
export interface LightText {
    /** The factor of its colour, or the largest channel where a format has no factor. */
    intensity: number;
    setIntensity(value: number): Edit[];
    /** Null if the format cannot say the field, or not in this text. */
    setField(field: FieldInfo, value: number | Vec3): Edit[] | null;
}

/** What a page may ask of a format's text. Null, or false: this format cannot say it. */
export interface SceneFormat {
    name: string;
    /** Puts a setting's value into the text. */
    setting(text: string, key: string, value: string, isConvention: boolean): Edit[] | null;
    /** The light whose text begins at an offset. */
    light(text: string, offset: number): LightText | null;
    /** The names of the scenes in a text that may have several. */
    scenes?(text: string): string[];
    /** Moves the camera whose text begins at an offset; null as offset: there is none yet. */
    camera(text: string, offset: number | null, camera: CameraInfo): Edit[] | null;
}

/** The edits that set a light's position, where a format can say no other field. */
export function ofPosition(set: (position: Vec3) => Edit[]): LightText['setField'] {
    return (field, value) => (field.name === 'position' ? set(value as Vec3) : null);
}

/** A number for a scene: five digits, as short as they can be. */
export function number(value: number): string {
    const rounded = Number(value.toPrecision(5));
    return String(Math.abs(rounded) < 1e-6 ? 0 : rounded);
}

/** The length of a vector. */
export const length = (v: Vec3) => Math.hypot(...v);

/** Makes a colour's largest channel this; black becomes grey. */
export function withLargest(color: Vec3, value: number): Vec3 {
    const largest = Math.max(...color.map(Math.abs));
    return largest === 0 ? [value, value, value] : (color.map((c) => (c * value) / largest) as Vec3);
}
