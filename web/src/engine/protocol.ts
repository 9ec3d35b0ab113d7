// SPDX-License-Identifier: Apache-2.0
// The messages between the page and its workers.
import type {Comparison, Diagnosis, Explanation, OpenRequest, PrepareRequest, Report, SceneInfo} from 'glint-wasm';

export interface Rect {
    x: number;
    y: number;
    width: number;
    height: number;
}

export type Task =
    /** With a rectangle, it is rendered as well, which saves a round trip per frame. */
    | {what: 'open'; rect?: Rect}
    | {what: 'tile'; rect: Rect}
    | {what: 'layers'; rect: Rect; names: string[]}
    /** The linear numbers of a rectangle. */
    | {what: 'floats'; rect: Rect; alpha: boolean}
    | {what: 'explain'; x: number; y: number}
    | {what: 'convert'}
    /** Against the picture of another scene. */
    | {what: 'compare'; reference: OpenRequest; causes: boolean}
    /** A picture of the scene by another program, as ImageData has it. */
    | {what: 'compare-picture'; pixels: Uint8ClampedArray<ArrayBuffer>; width: number; height: number; causes: boolean}
    /** The log of another ray tracer. */
    | {what: 'diagnose'; log: Uint8Array<ArrayBuffer>; name: string};

/** One job. A worker keeps one open scene per view; `request` is sent if it has not opened `key` yet. */
export interface Job {
    view: string;
    key: number;
    request: OpenRequest;
    prepare: PrepareRequest;
    task: Task;
}

export type ToWorker =
    /** The module of all following jobs; scenes that are open are lost. */
    | {kind: 'start'; module: WebAssembly.Module}
    | {kind: 'job'; id: number; view: string; key: number; request: OpenRequest | null; prepare: PrepareRequest; task: Task};

export interface Opened {
    report: Report;
    info: SceneInfo | null;
    tile: Tile | null;
}
export interface Tile {
    pixels: Uint8ClampedArray<ArrayBuffer>;
    rays: number;
    milliseconds: number;
}

/** Pixels, and layers of the same rectangle. */
export interface Layered {
    pixels: Uint8ClampedArray<ArrayBuffer>;
    layers: Record<string, Float32Array<ArrayBuffer>>;
}

export interface Numbers {
    rgb: Float32Array<ArrayBuffer>;
    /** Null if it was not asked for. */
    alpha: Float32Array<ArrayBuffer> | null;
}

export interface Answers {
    open: Opened;
    tile: Tile;
    layers: Layered;
    floats: Numbers;
    explain: Explanation | null;
    convert: string;
    compare: Comparison;
    'compare-picture': Comparison;
    diagnose: Diagnosis;
}

/**
 * done: the part of a scene that a job has opened, from 0 to 1; the answer follows. leftOut: the job needs the whole engine, and
 * this worker has its core. broken: the instance ran out of memory or trapped. In both cases all its open scenes are lost.
 */
export type FromWorker =
    {id: number; done: number} | {id: number; answer: Answers[keyof Answers]} | {id: number; leftOut: true} | {id: number; error: string; broken: boolean};
