// SPDX-License-Identifier: Apache-2.0
// The canvases of the two pictures; applies the events of the engine's views to them and to the page's state.
import {batch, effect, signal} from '@preact/signals';

import type {Pool} from '../engine/pool';
import type {Opened, Rect} from '../engine/protocol';
import {place} from '../engine/levels';
import {type ViewContent, View, type ViewEvents} from '../engine/view';
import {explainAgain} from '../store/pixels';
import {wasOpened} from '../store/viewpoint';
import {comparison, comparisonFailure, diagnostics, failure, hovered, info, isSecondDone, missing, ownPicture, pinned, services, progress, shownId, size, state} from '../store/state';

export const canvases = {first: document.createElement('canvas'), second: document.createElement('canvas')};
/** The number of completed second pictures, for the difference. */
export const secondDone = signal(0);
export const firstDone = signal(0);

/** The pixels of pictures with transparent parts; a canvas holds the colors multiplied by alpha, which are not exact. */
const straight = new WeakMap<HTMLCanvasElement, ImageData>();

export function pixelsOf(canvas: HTMLCanvasElement): ImageData {
    return straight.get(canvas) ?? canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
}

function isOpaque({data}: ImageData): boolean {
    for (let i = 3; i < data.length; i += 4) {
        if (data[i] !== 255) return false;
    }
    return true;
}

/** Keeps the pixels of a tile if the picture has transparent parts. */
function keep(canvas: HTMLCanvasElement, tile: ImageData, to: Rect) {
    if (!straight.has(canvas)) {
        if (isOpaque(tile)) return;
        straight.set(canvas, pixelsOf(canvas));
    }
    place(tile.data, to, straight.get(canvas)!);
}

/** Draws tiles and coarse pictures on a canvas. */
export function painter(canvas: HTMLCanvasElement, resized?: (width: number, height: number) => void, isPainted?: (content: ViewContent) => void) {
    const context = canvas.getContext('2d', {willReadFrequently: true})!;  // pixels are saved and compared
    let next: {width: number; height: number} | null = null;
    const coarse = document.createElement('canvas');
    return {
        // The old picture stays until new pixels arrive.
        sized(width: number, height: number) {
            next = width === canvas.width && height === canvas.height ? null : {width, height};
        },
        painted(tile: ImageData, to: Rect, stretched: boolean, content: ViewContent) {
            isPainted?.(content);
            if (next) {
                canvas.width = next.width;
                canvas.height = next.height;
                straight.delete(canvas);
                resized?.(next.width, next.height);
                next = null;
            }
            if (!stretched) {
                keep(canvas, tile, to);
                context.putImageData(tile, to.x, to.y);
                return;
            }
            coarse.width = tile.width;
            coarse.height = tile.height;
            coarse.getContext('2d')!.putImageData(tile, 0, 0);
            context.clearRect(to.x, to.y, to.width, to.height);
            context.drawImage(coarse, to.x, to.y, to.width, to.height);
        },
    };
}

function opened({report, info: facts}: Opened, content: ViewContent) {
    const {version} = content;
    if (facts && version !== undefined) services.editor?.wasRead(version);
    batch(() => {
        failure.value = facts ? '' : (report.error ?? '');
        diagnostics.value = report.diagnostics;
        missing.value = report.missing ?? [];
        if (facts) {
            wasOpened(facts.camera, content.document ?? 0);
            info.value = facts;
            state.value = 'rendering';
        } else {
            state.value = 'error';
            forgetOther(content);
        }
    });
}

/** The scene has errors: shows nothing of a scene that was open before. */
function forgetOther({document}: ViewContent) {
    if (document === shownId.value) return;
    info.value = null;
    hovered.value = null;
    pinned.value = null;
}

function failed(why: string, content: ViewContent) {
    batch(() => {
        failure.value = why;
        state.value = 'error';
        forgetOther(content);
    });
}

export function connectViews(pool: Pool) {
    const first: ViewEvents = {
        ...painter(canvases.first, (width, height) => {
            size.value = {width, height};
        }, ({document}) => {
            shownId.value = document ?? 0;
        }),
        opening: (done) => {
            batch(() => {
                state.value = 'reading';
                progress.value = {fraction: done, rays: 0, milliseconds: 0};
            });
        },
        opened,
        progress: (now) => {
            progress.value = now;
        },
        done: (now) => {
            batch(() => {
                progress.value = now;
                if (state.value !== 'error') state.value = 'done';
                firstDone.value += 1;
            });
            void explainAgain('first');
        },
        failed,
    };
    const second: ViewEvents = {
        ...painter(canvases.second),
        opened: ({report, info: facts}) => {
            comparisonFailure.value = facts ? '' : (report.error ?? report.diagnostics.find((one) => one.severity === 'error')?.message ?? '');
        },
        progress: () => {},
        done: () => {
            batch(() => {
                isSecondDone.value = true;
                secondDone.value += 1;
            });
            void explainAgain('second');
        },
        failed: (why) => {
            if (comparison.value) comparisonFailure.value = why;
        },
    };
    effect(() => {
        const own = ownPicture.value;
        if (!own) return;
        const {second: canvas} = canvases, {width, height} = own.image;
        canvas.width = width;
        canvas.height = height;
        canvas.getContext('2d')!.putImageData(own.image, 0, 0);
        straight.delete(canvas);
        batch(() => {
            isSecondDone.value = true;
            comparisonFailure.value = '';
            secondDone.value = secondDone.peek() + 1;
        });
    });
    services.first = new View(pool, 'first', first);
    services.second = new View(pool, 'second', second);
}
