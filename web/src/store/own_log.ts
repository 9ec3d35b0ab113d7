// SPDX-License-Identifier: Apache-2.0
// The log of the user's own ray tracer: what glint finds in it, and the pixel of it whose values are shown.
import {batch, computed, effect, signal, untracked} from '@preact/signals';
import type {DiagnosedRow, Diagnosis} from 'glint-wasm';

import {logOfText, readLog} from '../log_file';

import {pin} from './pixels';
import {presentRequest, shortName} from './scene';
import {documentId, includes, info, notice, ownLog, overrides, pinned, services, shownId, size, skipsUnsupported, state, tab, text} from './state';

/** What is found, or why nothing can be; null: it is not known yet. */
export const diagnosis = signal<Diagnosis | string | null>(null);

export interface LoggedPixel {
    /** As the log counts them. */
    at: [number, number];
    rows: DiagnosedRow[];
    /** The index of its first wrong row; -1: there is none. */
    first: number;
}

/** The pixels of the log whose values are listed, by "x,y". */
export const loggedPixels = computed(() => {
    const pixels = new Map<string, LoggedPixel>(), found = diagnosis.value;
    if (!found || typeof found === 'string') return pixels;
    for (const row of found.rows) {
        const key = row.pixel.join();
        const one = pixels.get(key) ?? {at: row.pixel, rows: [], first: -1};
        if (one.rows.length === 0) pixels.set(key, one);
        if (row.verdict === 'wrong' && one.first < 0) one.first = one.rows.length;
        one.rows.push(row);
    }
    return pixels;
});

const chosen = signal('');
/** That whose values are shown. */
export const chosenPixel = computed(() => loggedPixels.value.get(chosen.value) ?? null);

/** The size of the picture of which the log is. */
export const logSize = () => ownLog.value?.size ?? [info.value?.width ?? 0, info.value?.height ?? 0];
/** True if the log's pixels are those of the picture on the page. */
export const isLogOfPicture = () => logSize().join() === [size.value.width, size.value.height].join();

/** A pixel of the log in the picture, or one of the picture in the log. */
export function mirrored([x, y]: readonly [number, number]): [number, number] {
    const found = diagnosis.value;
    return found && typeof found !== 'string' && found.rows_from_bottom ? [x, logSize()[1]! - 1 - y] : [x, y];
}

/** A log of so many pixels is of the whole picture, or of a part of it. */
const mostMarks = 500;

/** Whether the picture shows which pixels are in the log: beside its panel; those of a lesson's log beside the lesson, too. */
export function areLogPixelsMarked() {
    const log = ownLog.value;
    return log !== null && (tab.value === 'compare' || (log.isOfTask && tab.value === 'learn')) && isLogOfPicture() && loggedPixels.value.size <= mostMarks;
}

/** Of the marks, in pixels of the picture. */
export const markRadius = () => size.value.width / 220;

/** The pixel of the log whose mark is at this pixel; without one, the pixel itself. */
export function markedPixel(pixel: [number, number] | null): [number, number] | null {
    if (!pixel || !areLogPixelsMarked()) return pixel;
    let nearest = pixel, least = markRadius() + 1;
    for (const {at} of loggedPixels.value.values()) {
        const mark = mirrored(at), distance = Math.hypot(mark[0] - pixel[0], mark[1] - pixel[1]);
        if (distance < least) [nearest, least] = [mark, distance];
    }
    return nearest;
}

/** Shows the values of a pixel of the log, and selects it in the picture. */
export function choosePixel(at: readonly [number, number]) {
    chosen.value = at.join();
    const [x, y] = mirrored(at);
    const isInside = x >= 0 && y >= 0 && x < size.value.width && y < size.value.height;
    if (isLogOfPicture() && isInside) void pin([x, y], false);
}

/** Opens a log of the present scene. */
export async function openLog(file: File) {
    const number = ++opened, document = documentId.value;
    try {
        const log = await readLog(file);
        if (number !== opened || document !== documentId.value) return;  // another log or scene has been opened meanwhile
        batch(() => {
            ownLog.value = {name: file.name, document, isOfTask: false, ...log};
            isNew = true;
            tab.value = 'compare';
        });
    } catch (error) {
        notice.value = `${shortName(file.name)} is not opened: ${error instanceof Error ? error.message : String(error)}.`;
    }
}

/** Opens the log of a lesson or challenge, whose scene has been opened. The panel stays. */
export function openLogOf({name, text}: {name: string; text: string}) {
    ++opened;
    isNew = false;
    chosen.value = '';
    ownLog.value = {name, document: documentId.value, isOfTask: true, ...logOfText(text)};
}

let opened = 0;
/** No pixel of the log has been shown in the picture yet. */
let isNew = false;

export function closeLog() {
    ++opened;
    ownLog.value = null;
}

let last = 0, timer = 0;

/** What has been asked is of an older scene or log. */
function stopAsking() {
    clearTimeout(timer);
    services.pool?.cancel('log', last);
    diagnosis.value = null;
}

async function ask() {
    const {bytes, name} = ownLog.value!, key = ++last;
    let found: Diagnosis | string;
    try {
        found = await services.pool!.run({view: 'log', key, request: presentRequest(), prepare: {}, task: {what: 'diagnose', log: bytes, name}});
    } catch (error) {
        found = error instanceof Error ? error.message : String(error);
    }
    if (key !== last || !ownLog.value) return;
    diagnosis.value = found;
    if (typeof found === 'string') return;
    if (isNew) showFirst(found);
    else choosePinned();
}

/** Shows the pixel that is explained, if it is in the log. */
function choosePinned() {
    const key = pinned.value && isLogOfPicture() ? mirrored(pinned.value.pixel).join() : '';
    if (loggedPixels.value.has(key)) chosen.value = key;
}

/** Of a log that has just been opened, the pixel that is explained, or one of the first mistake. */
function showFirst({findings}: Diagnosis) {
    isNew = !isLogOfPicture();
    const now = pinned.value && mirrored(pinned.value.pixel).join(), first = findings[0]?.example.pixel ?? [...loggedPixels.value.values()][0]?.at;
    if (now && loggedPixels.value.has(now)) chosen.value = now;
    else if (first) choosePixel(first);
}

/** While one types or drags, the scene changes many times a second. */
const pause = 300;

/** Compares the log again whenever the scene has changed; the log of another scene is closed. */
export function followOwnLog() {
    effect(() => {
        const log = ownLog.value;
        void [text.value, overrides.value, includes.value, skipsUnsupported.value];
        const isOther = log !== null && log.document !== documentId.value;
        const isReady = state.value === 'done' && shownId.value === documentId.value;
        untracked(() => {
            stopAsking();
            ++last;
            if (isOther) {
                if (!log.isOfTask) notice.value ||= `${shortName(log.name)} is closed: it is the log of the scene before.`;
                queueMicrotask(() => ownLog.value === log && closeLog());  // not that of a challenge which has just been opened
            } else if (log && isReady) {
                timer = window.setTimeout(() => void ask(), pause);
            }
        });
    });
    effect(() => {
        void pinned.value;
        untracked(choosePinned);
    });
}
