// SPDX-License-Identifier: Apache-2.0
// A picture that is rendered coarse to fine; a change of its content restarts it.
import type {OpenRequest, PrepareRequest, SceneInfo} from 'glint-wasm';

import {type Level, isSameLevel, levelsOf, place, strips, tiles} from './levels';
import {type Pool, Stopped} from './pool';
import type {Opened, Rect, Tile} from './protocol';

/** The content of a view. */
export interface ViewContent {
    request: OpenRequest;
    /** Changes to the scene, such as another camera. */
    prepare: PrepareRequest;
    /** For the caller: the document, and the version of its text. */
    document?: number | undefined;
    version?: number | undefined;
}

export interface Progress {
    /** Of all samples, including those of coarser pictures; 0 to 1. */
    fraction: number;
    /** Of the finest picture so far, and the time since its start. */
    rays: number;
    milliseconds: number;
}

/** A content that is open, and what its whole picture is rendered with. */
export interface Shown {
    content: ViewContent;
    key: number;
    info: SceneInfo;
    prepare: PrepareRequest;
    width: number;
    height: number;
}

export interface ViewEvents {
    /** The content was read; the scene may have errors. */
    opened(opened: Opened, content: ViewContent): void;
    /** A picture of this size starts. */
    sized(width: number, height: number): void;
    /** Pixels for a rectangle of the picture; coarse ones are stretched to it. */
    painted(tile: ImageData, to: Rect, stretched: boolean, content: ViewContent): void;
    progress(progress: Progress): void;
    /** The content is being read: the part that is done, 0 to 1. Only of contents that take long. */
    opening?(done: number): void;
    /** The picture is complete; perhaps that of the last scene without errors, after one with errors. */
    done(progress: Progress, key: number): void;
    failed(why: string, content: ViewContent): void;
}

/** The time for a first, coarse picture, in milliseconds, so that dragging stays smooth. */
const frameTime = 35;
const tileTime = 12;

/** Shared by all views: the workers identify open content by its key. */
let lastKey = 0;

export class View {
    /** The content that is shown, for explanations; set when it is open. */
    current: Shown | null = null;
    #pending: ViewContent | null = null;
    #key = 0;
    #busy = false;
    #since = 0;
    #shownAt = -Infinity;
    /** The number of contents in quick succession. */
    #quick = 0;
    #coarseShown = false;
    #sampleTime = 0.001;
    /** The last, finest level of the current picture if it is not complete. */
    #missing: Level | null = null;
    #isStopped = false;

    constructor(private readonly pool: Pool, readonly name: string, private readonly events: ViewEvents) {}

    /** True if rendering is not finished. */
    get busy() {
        return this.#busy || this.#pending !== null;
    }

    show(content: ViewContent) {
        const now = performance.now();
        this.#quick = now - this.#shownAt < 500 ? this.#quick + 1 : 0;
        this.#shownAt = now;
        this.#pending = content;
        this.#isStopped = false;
        if (!this.#busy) {
            void this.#work();
        } else if (this.#coarseShown || now - this.#since > 300) {
            // Otherwise a picture that changes continuously would never appear.
            this.pool.cancel(this.name, this.#key);
        }
    }

    /** Stops rendering. */
    stop() {
        this.#pending = null;
        this.#isStopped = true;
        this.pool.cancel(this.name, this.#key);
    }

    async #work() {
        this.#busy = true;
        while (this.#pending) {
            const content = this.#pending;
            this.#pending = null;
            const key = this.#key = ++lastKey;
            this.#since = performance.now();
            this.#coarseShown = false;
            try {
                await this.#render(content, key);
            } catch (error) {
                const stopped = error instanceof Stopped && error.message === '';
                this.pool.cancel(this.name, key);
                if (!stopped && !this.#pending) this.events.failed(error instanceof Error ? error.message : String(error), content);
            }
            await this.#finish(content);
        }
        this.#busy = false;
    }

    /** After a content with errors, completes the picture of the one before: it stays visible. */
    async #finish(after: ViewContent) {
        const {current} = this, level = this.#missing;
        if (!current || !level || this.#pending || this.#isStopped) return;
        if (current.content === after || current.content.document !== after.document) return;
        this.#key = current.key = ++lastKey;
        this.#coarseShown = true;
        try {
            await this.#renderLevel(current.content, current.key, level, level, null);
        } catch {
            this.pool.cancel(this.name, current.key);
        }
    }

    async #render(content: ViewContent, key: number) {
        const affordable = this.#affordable();  // used to predict the cost and to check it
        // While something is dragged, contents are similar, so the cost of the next one can be predicted.
        const expected = this.#quick >= 2 && this.current ? levelsOf(content, this.current.info, affordable)[0]! : null;
        const opening = (expected && !expected.final && await this.#openAndRender(content, key, expected)) || await this.#open(content, key);
        this.events.opened(opening.opened, content);
        const {info} = opening.opened;
        if (!info) return;
        let levels = levelsOf(content, info, affordable);
        const last = levels.at(-1)!;
        this.current = {content, key, info, prepare: last.prepare, width: last.width, height: last.height};
        this.#missing = last;
        this.events.sized(last.width, last.height);
        if (expected && opening.picture && isSameLevel(expected, levels[0]!)) {
            this.events.painted(opening.picture, {x: 0, y: 0, width: last.width, height: last.height}, true, content);
            this.#coarseShown = true;
            levels.shift();
        } else if (levels.length > 1) {
            await this.#probe(content, key, info, last);
            levels = levelsOf(content, info, this.#affordable());
        }
        const samplesOf = (level: Level) => level.width * level.height * level.samples;
        const all = levels.reduce((sum, level) => sum + samplesOf(level), 0);
        let before = 0;
        for (const level of levels) {
            if (this.#pending && this.#coarseShown) return;
            const renderedBefore = before;
            await this.#renderLevel(content, key, level, last, (share) => (renderedBefore + share * samplesOf(level)) / all);
            before += samplesOf(level);
            this.#coarseShown = true;
        }
    }

    /** The number of samples that fit into the time of a first picture. */
    #affordable() {
        return (frameTime * this.pool.size) / this.#sampleTime;
    }

    /** Renders a few samples to measure their time; they are shown if that time was long. */
    async #probe(content: ViewContent, key: number, info: SceneInfo, last: Level) {
        const start = performance.now();
        const level = levelsOf(content, info, this.#affordable() / 16)[0]!;
        const picture = new ImageData(level.width, level.height);
        let spent = 0;
        await Promise.all(tiles(level.width, level.height, 32).map(async (rect) => {
            const job = {view: this.name, key, request: content.request, prepare: level.prepare};
            const tile = await this.pool.run({...job, task: {what: 'tile', rect}});
            place(tile.pixels, rect, picture);
            spent += tile.milliseconds;
        }));
        this.#sampleTime = Math.max(1e-6, spent / (level.width * level.height));
        if (performance.now() - start < 100) return;
        this.events.painted(picture, {x: 0, y: 0, width: last.width, height: last.height}, true, content);
        this.#coarseShown = true;
    }

    async #open(content: ViewContent, key: number): Promise<Opening> {
        const job = {view: this.name, key, request: content.request, prepare: {}};
        return {opened: await this.pool.run({...job, task: {what: 'open'}}, true, (done) => this.events.opening?.(done)), picture: null};
    }

    /** Opens the scene and renders its first, coarse picture in one step, if its size is that of the scene before. */
    async #openAndRender(content: ViewContent, key: number, level: Level): Promise<Opening | null> {
        const job = {view: this.name, key, request: content.request, prepare: level.prepare};
        const rects = strips(level.width, level.height, this.pool.size);
        const first = this.pool.run({...job, task: {what: 'open', rect: rects[0]!}}, true);
        const others = rects.slice(1).map((rect) => this.pool.run({...job, task: {what: 'tile', rect}}, true));
        const rendered = await Promise.allSettled([first, ...others]);
        const stopped = rendered.find((one) => one.status === 'rejected' && one.reason instanceof Stopped);
        if (stopped?.status === 'rejected') throw stopped.reason;
        if (rendered[0]!.status === 'rejected') return null;  // it differs from the scene before: start over
        const opened = rendered[0]!.value as Opened;
        const tiles = [opened.tile, ...rendered.slice(1).map((one) => (one.status === 'fulfilled' ? (one.value as Tile) : null))];
        if (tiles.includes(null)) return {opened, picture: null};
        const picture = new ImageData(level.width, level.height);
        tiles.forEach((tile, i) => {
            place(tile!.pixels, rects[i]!, picture);
            this.#measure(tile!, rects[i]!, level.samples);
        });
        return {opened, picture};
    }

    #measure(tile: Tile, rect: Rect, samples: number) {
        const area = rect.width * rect.height;
        const measured = Math.max(1e-6, tile.milliseconds / (area * samples));
        if (area >= 256) this.#sampleTime += 0.15 * (measured - this.#sampleTime);
    }

    async #renderLevel(content: ViewContent, key: number, level: Level, last: Level,
                       fractionAt: ((share: number) => number) | null) {
        const start = performance.now();
        const pixels = Math.max(16, tileTime / (this.#sampleTime * level.samples));
        const perWorker = (level.width * level.height) / (2 * this.pool.size);
        const side = Math.sqrt(Math.min(pixels, Math.max(perWorker, 1024)));
        const step = side >= 32 ? Math.min(256, 32 * Math.floor(side / 32)) : Math.max(4, Math.floor(side / 4) * 4);
        // A coarse picture is shown as a whole; the tiles of the last one appear as they are ready.
        const whole = level.final ? null : new ImageData(level.width, level.height);
        let done = 0, rays = 0;
        const progress = () => ({fraction: fractionAt?.(done / (level.width * level.height)) ?? 1, rays, milliseconds: performance.now() - start});
        const take = (rect: Rect, tile: Tile) => {
            const area = rect.width * rect.height;
            done += area;
            rays += tile.rays;
            this.#measure(tile, rect, level.samples);
            if (whole) {
                place(tile.pixels, rect, whole);
            } else {
                this.events.painted(new ImageData(tile.pixels, rect.width, rect.height), rect, false, content);
            }
            if (fractionAt) this.events.progress(progress());
        };
        await Promise.all(tiles(level.width, level.height, step).map(async (rect) => {
            const job = {view: this.name, key, request: content.request, prepare: level.prepare};
            take(rect, await this.pool.run({...job, task: {what: 'tile', rect}}));
        }));
        if (whole) this.events.painted(whole, {x: 0, y: 0, width: last.width, height: last.height}, true, content);
        if (!level.final || this.#pending) return;
        this.#missing = null;
        this.events.done(progress(), key);
    }
}

interface Opening {
    opened: Opened;
    picture: ImageData | null;
}
