// SPDX-License-Identifier: Apache-2.0
// The canvases of the two pictures; applies the events of the engine's views to them and to the page's state.
import {batch, signal} from '@preact/signals';

import type {Pool} from '../engine/pool';
import type {Opened, Rect} from '../engine/protocol';
import {type ViewContent, View, type ViewEvents} from '../engine/view';
import {explainAgain} from '../store/pixels';
import {comparison, comparisonFailure, diagnostics, failure, info, services, progress, size, state} from '../store/state';

export const canvases = {first: document.createElement('canvas'), second: document.createElement('canvas')};
/** The number of completed second pictures, for the difference. */
export const secondDone = signal(0);
export const firstDone = signal(0);

function painter(canvas: HTMLCanvasElement, resized?: (width: number, height: number) => void) {
    const context = canvas.getContext('2d', {alpha: false})!;
    let next: {width: number; height: number} | null = null;
    const coarse = document.createElement('canvas');
    return {
        // The old picture stays until new pixels arrive.
        sized(width: number, height: number) {
            next = width === canvas.width && height === canvas.height ? null : {width, height};
        },
        painted(tile: ImageData, to: Rect, stretched: boolean) {
            if (next) {
                canvas.width = next.width;
                canvas.height = next.height;
                resized?.(next.width, next.height);
                next = null;
            }
            if (!stretched) {
                context.putImageData(tile, to.x, to.y);
                return;
            }
            coarse.width = tile.width;
            coarse.height = tile.height;
            coarse.getContext('2d', {alpha: false})!.putImageData(tile, 0, 0);
            context.drawImage(coarse, to.x, to.y, to.width, to.height);
        },
    };
}

function opened({report, info: facts}: Opened, {version}: ViewContent) {
    if (facts && version !== undefined) services.editor?.wasRead(version);
    batch(() => {
        failure.value = facts ? '' : (report.error ?? '');
        diagnostics.value = report.diagnostics;
        if (facts) {
            info.value = facts;
            state.value = 'rendering';
        } else {
            state.value = 'error';
        }
    });
}

function failed(why: string) {
    batch(() => {
        failure.value = why;
        state.value = 'error';
    });
}

export function connectViews(pool: Pool) {
    const first: ViewEvents = {
        ...painter(canvases.first, (width, height) => {
            size.value = {width, height};
        }),
        opened,
        progress: (now) => {
            progress.value = now;
        },
        done: (now) => {
            batch(() => {
                progress.value = now;
                state.value = 'done';
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
            secondDone.value += 1;
            void explainAgain('second');
        },
        failed: (why) => {
            if (comparison.value) comparisonFailure.value = why;
        },
    };
    services.first = new View(pool, 'first', first);
    services.second = new View(pool, 'second', second);
}
