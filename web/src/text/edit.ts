// SPDX-License-Identifier: Apache-2.0
// Changing a value in a scene's text, and nothing else in it.
import type {CameraInfo, FieldInfo, Vec3} from 'glint-wasm';

/** Replaces the text between `from` and `to`, in UTF-16 units like the editor's offsets. */
export interface Edit {
    from: number;
    to: number;
    insert: string;
}

/** A light as given in its text. */
export interface LightText {
    /** The factor of its color, or the largest channel if the format has no factor. */
    intensity: number;
    setIntensity(value: number): Edit[];
    /** Null if the format cannot say the field, or not in this text. */
    setField(field: FieldInfo, value: number | boolean | Vec3): Edit[] | null;
}

/** The fog, or another block that a scene has at most once, as given in its text. */
export interface FogText {
    setKind(kind: string): Edit[];
    setField(field: FieldInfo, value: number | boolean | Vec3): Edit[];
    remove(): Edit[];
}

/** The edits of one format's text. Null or false: this format cannot express it. */
export interface SceneFormat {
    name: string;
    /** Sets a setting in the text. */
    setting(text: string, key: string, value: string, isConvention: boolean): Edit[] | null;
    /** The light at an offset of the text. */
    light(text: string, offset: number): LightText | null;
    /** The fog at an offset of the text. */
    fog?(text: string, offset: number): FogText | null;
    /** Adds a fog of this density to a text without one. */
    addFog?(text: string, density: number): Edit[];
    /** Another block of which a scene has one, by its word and the key of its kind. */
    block?(text: string, offset: number, word: string, key: string): FogText | null;
    /** Adds a line with such a block. */
    addBlock?(text: string, line: string): Edit[];
    /** Moves the shape at an offset of the text by a vector of the world; null: not in this text. */
    moveShape?(text: string, offset: number, by: Vec3): Edit[] | null;
    /** The names of the scenes in a text, if it may have several. */
    scenes?(text: string): string[];
    /** Moves the camera at an offset of the text; offset null: adds one. */
    camera(text: string, offset: number | null, camera: CameraInfo): Edit[] | null;
}

/** The edits that set a light's position, where a format can say no other field. */
export function ofPosition(set: (position: Vec3) => Edit[]): LightText['setField'] {
    return (field, value) => (field.name === 'position' ? set(value as Vec3) : null);
}

/** A number in a text; not a part of a word. */
export const aNumber = /(?<![\w.])-?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])/g;

/** A number for a scene: five digits, as short as they can be. */
export function number(value: number): string {
    const rounded = Number(value.toPrecision(5));
    return String(Math.abs(rounded) < 1e-6 ? 0 : rounded);
}

/** The length of a vector. */
export const length = (v: Vec3) => Math.hypot(...v);

/** Scales a color to this largest channel; black becomes grey. */
export function withLargest(color: Vec3, value: number): Vec3 {
    const largest = Math.max(...color.map(Math.abs));
    return largest === 0 ? [value, value, value] : (color.map((c) => (c * value) / largest) as Vec3);
}
