// SPDX-License-Identifier: Apache-2.0
// What the page and its workers say to each other.
import type {Explanation, OpenRequest, PrepareRequest, Report, SceneInfo} from 'glint-wasm';

export interface Rect {
    x: number;
    y: number;
    width: number;
    height: number;
}

export type Task =
    /** With a rectangle: it is drawn as well, which spares a frame a way there and back. */
    | {what: 'open'; rect?: Rect}
    | {what: 'tile'; rect: Rect}
    | {what: 'explain'; x: number; y: number}
    | {what: 'convert'};

/** One piece of work. A worker keeps one open scene a view; `request` comes along when it has not opened `key` yet. */
export interface Job {
    view: string;
    key: number;
    request: OpenRequest;
    prepare: PrepareRequest;
    task: Task;
}

export type ToWorker =
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

export interface Answers {
    open: Opened;
    tile: Tile;
    explain: Explanation | null;
    convert: string;
}

/** broken: the instance ran out of memory or trapped, and everything that was open in it is gone. */
export type FromWorker = {id: number; answer: Answers[keyof Answers]} | {id: number; error: string; broken: boolean};
