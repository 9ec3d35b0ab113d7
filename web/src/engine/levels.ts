// SPDX-License-Identifier: Apache-2.0
// The sizes at which a picture is rendered, coarse to fine, and its division into tiles.
import type {PrepareRequest, SceneInfo} from 'glint-wasm';

import type {Rect} from './protocol';

/** Pixels of the largest picture that the page renders; larger ones are rendered at a smaller size. */
const maxPixels = 4096 * 4096;

export interface Level {
    width: number;
    height: number;
    prepare: PrepareRequest;
    /** Samples per pixel. */
    samples: number;
    final: boolean;
}

function setting(info: SceneInfo, name: string): string {
    return info.settings.find((one) => one.name === name)?.value ?? '';
}

/** The setting aa: "N" or "adaptive:N:T", and perhaps ":jitter". */
export interface Samples {
    n: number;
    /** Of adaptive sampling; null: all pixels have n x n samples. */
    threshold: string | null;
    jitter: boolean;
}

export function samplesOf(aa: string): Samples {
    const words = aa.split(':');
    const jitter = words.at(-1) === 'jitter', adaptive = words[0] === 'adaptive';
    return {n: Number(words[adaptive ? 1 : 0]), threshold: adaptive ? words[2]! : null, jitter};
}

export function samplesText({n, threshold, jitter}: Samples): string {
    return `${threshold === null ? n : `adaptive:${n}:${threshold}`}${jitter ? ':jitter' : ''}`;
}

/** The pictures of a content, coarse to fine; the first has at most `affordable` samples, if that is possible. */
export function levelsOf({prepare: wanted}: {prepare: PrepareRequest}, info: SceneInfo, affordable: number): Level[] {
    const asked = wanted.settings?.['size']?.split('x').map(Number) ?? [info.width, info.height];
    const [wholeWidth, wholeHeight] = asked as [number, number];
    const shrink = Math.min(1, Math.sqrt(maxPixels / (wholeWidth * wholeHeight)));
    const samples = wanted.settings?.['aa'] ?? setting(info, 'aa');
    const {n} = samplesOf(samples);
    const level = (scale: number, aa: number): Level => {
        const width = Math.max(1, Math.round(wholeWidth * scale)), height = Math.max(1, Math.round(wholeHeight * scale));
        const settings: Record<string, string> = {...wanted.settings};
        if (scale !== 1 || aa !== n) settings['size'] = `${width}x${height}`;
        if (aa !== n) settings['aa'] = String(aa);
        return {width, height, samples: aa * aa, prepare: {...wanted, settings}, final: false};
    };
    const full = {...level(shrink, n), final: true};
    // At one world unit per pixel, fewer pixels would show less of the scene.
    if (setting(info, 'pixel_sample') === 'whole') return [full];
    const pixels = full.width * full.height;
    if (pixels * full.samples <= affordable) return [full];
    const coarse = Math.max(Math.min(1, 16 / Math.min(full.width, full.height)), Math.min(1, Math.sqrt(affordable / pixels)));
    const levels = coarse > 0.9 ? [] : [level(coarse * shrink, 1)];
    if (coarse < 0.3) levels.push(level(0.5 * shrink, 1));
    if (full.samples > 1) levels.push(level(shrink, 1));
    return [...levels, full];
}

export function isSameLevel(a: Level, b: Level): boolean {
    return a.width === b.width && a.height === b.height && JSON.stringify(a.prepare) === JSON.stringify(b.prepare);
}

/** Copies a tile's pixels into a picture. */
export function place(pixels: Uint8ClampedArray, rect: Rect, picture: ImageData) {
    for (let row = 0; row < rect.height; ++row) {
        picture.data.set(pixels.subarray(4 * row * rect.width, 4 * (row + 1) * rect.width),
                         4 * ((rect.y + row) * picture.width + rect.x));
    }
}

/** Splits a picture into vertical strips: left and right differ less in cost than top and bottom. */
export function strips(width: number, height: number, count: number): Rect[] {
    const n = Math.min(count, width);
    const edge = (i: number) => Math.round((i * width) / n);
    return Array.from({length: n}, (_, i) => ({x: edge(i), y: 0, width: edge(i + 1) - edge(i), height}));
}

/** The rectangles of a picture, from the middle outwards, where users look first. */
export function tiles(width: number, height: number, step: number): Rect[] {
    const list: Rect[] = [];
    for (let y = 0; y < height; y += step) {
        for (let x = 0; x < width; x += step)
            list.push({x, y, width: Math.min(step, width - x), height: Math.min(step, height - y)});
    }
    const distance = (rect: Rect) => Math.hypot(rect.x + rect.width / 2 - width / 2, rect.y + rect.height / 2 - height / 2);
    return list.sort((a, b) => distance(a) - distance(b));
}
