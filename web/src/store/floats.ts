// SPDX-License-Identifier: Apache-2.0
// The linear numbers of the first picture, for files that have more than bytes.
import {tiles} from '../engine/levels';
import type {Numbers} from '../engine/protocol';
import type {Shown} from '../engine/view';
import {services} from './state';

const side = 256;

/** Renders a picture of the first view again. Throws Stopped if that renders another scene meanwhile. */
export async function numbersOf({content, key, prepare, width, height}: Shown, hasAlpha: boolean): Promise<Numbers> {
    const whole: Numbers = {rgb: new Float32Array(3 * width * height), alpha: hasAlpha ? new Float32Array(width * height) : null};
    const place = (from: Float32Array, to: Float32Array, channels: number, {x, y, width: columns, height: rows}: {x: number; y: number; width: number; height: number}) => {
        for (let row = 0; row < rows; ++row) to.set(from.subarray(channels * row * columns, channels * (row + 1) * columns), channels * ((y + row) * width + x));
    };
    await Promise.all(tiles(width, height, side).map(async (rect) => {
        const {rgb, alpha} = await services.pool!.run({
            view: 'first', key, request: content.request, prepare, task: {what: 'floats', rect, alpha: hasAlpha},
        });
        place(rgb, whole.rgb, 3, rect);
        if (alpha && whole.alpha) place(alpha, whole.alpha, 1, rect);
    }));
    return whole;
}
