// SPDX-License-Identifier: Apache-2.0
// A worker: one instance of glint with one open scene per view.
import {type Glint, type PrepareRequest, type Scene, instantiate} from 'glint-wasm';

import type {Answers, FromWorker, Rect, Tile, ToWorker} from './protocol';

type JobMessage = Extract<ToWorker, {kind: 'job'}>;
interface OpenScene {
    key: number;
    scene: Scene;
    prepared: string;
}

let wasm: WebAssembly.Module;
let glint: Glint | null = null;
const scenes = new Map<string, OpenScene>();

/** Tells the page how much of a scene is open, ten times a second at most, and only if it is more than before. */
function reporter(id: number) {
    let next = performance.now() + 100, most = 0;
    return (done: number) => {
        if (done <= most || performance.now() < next) return;
        next = performance.now() + 100;
        most = done;
        postMessage({id, done} satisfies FromWorker);
    };
}

/** The next job has a new instance. */
function forget() {
    glint = null;
    scenes.clear();
}

async function sceneOf(job: JobMessage): Promise<OpenScene> {
    glint ??= await instantiate(wasm);
    let open = scenes.get(job.view);
    if (open?.key !== job.key) {
        open?.scene.close();
        scenes.delete(job.view);
        if (!job.request) throw new Error('the scene is not open here');
        open = {key: job.key, scene: glint.open(job.request, {progress: reporter(job.id)}), prepared: '{}'};
        scenes.set(job.view, open);
    }
    return open;
}

function prepare(open: OpenScene, request: PrepareRequest) {
    const wanted = JSON.stringify(request);
    if (wanted === open.prepared) return;
    open.prepared = '';
    open.scene.prepare(request);
    open.prepared = wanted;
}

function tile({scene}: OpenScene, {x, y, width, height}: Rect): Tile {
    const start = performance.now();
    return {...scene.renderPixels(x, y, width, height), milliseconds: performance.now() - start};
}

async function work(job: JobMessage): Promise<Answers[keyof Answers]> {
    const open = await sceneOf(job);
    const {scene} = open;
    const {task} = job;
    if (task.what === 'open') {
        const {report, info} = scene;
        if (!task.rect || !info) return {report, info, tile: null};
        prepare(open, job.prepare);
        return {report, info, tile: tile(open, task.rect)};
    }
    prepare(open, job.prepare);
    if (task.what === 'layers') {
        const {x, y, width, height} = task.rect;
        const {pixels, layers} = scene.renderLayers(task.names, x, y, width, height);
        return {pixels, layers};
    }
    if (task.what === 'floats') {
        const {x, y, width, height} = task.rect;
        const rgb = scene.render(x, y, width, height);
        return {rgb, alpha: task.alpha ? scene.renderLayers(['alpha'], x, y, width, height).layers.alpha : null};
    }
    if (task.what === 'explain') return scene.explain(task.x, task.y);
    if (task.what === 'convert') return scene.toGlint();
    if (task.what === 'compare') {
        const reference = glint!.open(task.reference);
        try {
            return scene.compare(reference, {causes: task.causes});
        } finally {
            reference.close();
        }
    }
    if (task.what === 'compare-picture') return scene.comparePicture(task, {causes: task.causes});
    if (task.what === 'diagnose') return scene.diagnose(task.log, {name: task.name});
    return tile(open, task.rect);
}

addEventListener('message', async ({data}: MessageEvent<ToWorker>) => {
    if (data.kind === 'start') {
        wasm = data.module;
        forget();
        return;
    }
    let reply: FromWorker;
    const transfer: Transferable[] = [];
    try {
        const answer = await work(data);
        if (answer && typeof answer === 'object') {
            if ('milliseconds' in answer) transfer.push(answer.pixels.buffer);
            if ('layers' in answer && !('pixel' in answer))
                transfer.push(answer.pixels.buffer, ...Object.values(answer.layers).map((layer) => layer.buffer));
            if ('rgb' in answer) transfer.push(answer.rgb.buffer);
            if ('tile' in answer && answer.tile) transfer.push(answer.tile.pixels.buffer);
        }
        reply = {id: data.id, answer};
    } catch (error) {
        // After a trap the instance's memory may be corrupt.
        const broken = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
        if (broken) forget();
        reply = {id: data.id, error: error instanceof Error ? error.message : String(error), broken};
    }
    if (glint?.leftOut) {
        reply = {id: data.id, leftOut: true};
        transfer.length = 0;
        forget();
    }
    postMessage(reply, {transfer});
});
