// SPDX-License-Identifier: Apache-2.0
// Renders the view in space with the scene that the page has open: coarse while it is turned, then fine. Colors are those of
// the surfaces, lit from the viewer and by the scene's lights, so that nothing is black; borders of objects are drawn.
import {type Pool, Stopped} from '../engine/pool';
import type {Layered, Rect} from '../engine/protocol';
import type {View} from '../engine/view';
import type {Frame} from './frame';

export interface Wanted {
    view: View;
    frame: Frame;
    /** Of the canvas, in its pixels. */
    width: number;
    height: number;
    isCoarse: boolean;
}
/** The distance of each pixel's surface, to hide lines behind it. */
export interface Depths {
    width: number;
    height: number;
    values: Float32Array;
    frame: Frame;
}

const names = ['albedo', 'normal', 'depth', 'object'];
/** Of the scene in the view. */
export const viewSettings = {
    shading: 'diffuse', shadows: 'false', reflections: '0', aa: '1', pixel_sample: 'center', camera_t_min: '0', ray_direction: 'unit',
};
/** Pixels of a picture while it is turned. */
const coarsePixels = 60_000;

/** The pixels of a rectangle of the view; without a surface they are transparent. */
function shaded({pixels, layers}: Layered, width: number, height: number, towards: number[]): Uint8ClampedArray<ArrayBuffer> {
    const out = new Uint8ClampedArray(4 * width * height);
    const {albedo, normal, object} = layers as Record<'albedo' | 'normal' | 'object', Float32Array>;
    for (let i = 0; i < width * height; ++i) {
        if (object[i] === 0) continue;
        const facing = Math.abs(normal[3 * i]! * towards[0]! + normal[3 * i + 1]! * towards[1]! + normal[3 * i + 2]! * towards[2]!);
        const x = i % width;
        const isBorder = (x > 0 && object[i - 1] !== object[i]) || (i >= width && object[i - width] !== object[i]);
        for (let c = 0; c < 3; ++c) {
            const own = 0.2 + 0.8 * Math.min(1, albedo[3 * i + c]!);
            const value = 255 * own * (0.28 + 0.42 * facing) + 0.4 * pixels[4 * i + c]!;
            out[4 * i + c] = isBorder ? 0.55 * value : value;
        }
        out[4 * i + 3] = 255;
    }
    return out;
}

export class SpacePicture {
    #wanted: Wanted | null = null;
    #busy = false;
    #ended = false;

    constructor(private readonly pool: Pool, private readonly canvas: HTMLCanvasElement, private readonly painted: (depths: Depths) => void) {}

    show(wanted: Wanted) {
        this.#wanted = wanted;
        if (!this.#busy) void this.#work();
    }

    end() {
        this.#ended = true;
        this.#wanted = null;
    }

    async #work() {
        this.#busy = true;
        while (this.#wanted) {
            const wanted: Wanted = this.#wanted;
            this.#wanted = null;
            try {
                await this.#render(wanted);
            } catch (error) {
                // The scene changed; it is shown again when it is open.
                if (!(error instanceof Stopped)) this.#wanted ??= null;
            }
        }
        this.#busy = false;
    }

    async #render({view, frame, width: whole, height: wholeHeight, isCoarse}: Wanted) {
        const {current} = view;
        if (!current) return;
        const scale = isCoarse ? Math.min(1, Math.sqrt(coarsePixels / (whole * wholeHeight))) : 1;
        const width = Math.max(1, Math.round(whole * scale)), height = Math.max(1, Math.round(wholeHeight * scale));
        const prepare = {settings: {...viewSettings, size: `${width}x${height}`}, camera: frame};
        const job = {view: view.name, key: current.key, request: current.content.request, prepare};
        const rows = isCoarse ? Math.ceil(height / this.pool.size) : 48;
        const rects: Rect[] = [];
        for (let y = 0; y < height; y += rows) rects.push({x: 0, y, width, height: Math.min(rows, height - y)});
        const tiles = await Promise.all(rects.map((rect) => this.pool.run({...job, task: {what: 'layers', rect, names}}, isCoarse)));
        if (this.#ended || (this.#wanted && !isCoarse)) return;
        const depths = new Float32Array(width * height);
        const {canvas} = this;
        canvas.width = width;
        canvas.height = height;
        const context = canvas.getContext('2d')!;
        tiles.forEach((tile, i) => {
            const rect = rects[i]!;
            context.putImageData(new ImageData(shaded(tile, rect.width, rect.height, frame.forward), rect.width, rect.height), 0, rect.y);
            depths.set(tile.layers['depth']!, rect.y * width);
        });
        this.painted({width, height, values: depths, frame});
    }
}
