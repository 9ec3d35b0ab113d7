// A worker: one instance of glint, one open scene a view.
import {type Glint, type Scene, instantiate} from 'glint-wasm';

import type {Answers, FromWorker, ToWorker} from './protocol';

type JobMessage = Extract<ToWorker, {kind: 'job'}>;
interface OpenScene {
    key: number;
    scene: Scene;
    prepared: string;
}

let wasm: WebAssembly.Module;
let glint: Glint | null = null;
const scenes = new Map<string, OpenScene>();

async function sceneOf(job: JobMessage): Promise<OpenScene> {
    glint ??= await instantiate(wasm);
    let open = scenes.get(job.view);
    if (open?.key !== job.key) {
        open?.scene.close();
        scenes.delete(job.view);
        if (!job.request) throw new Error('the scene is not open here');
        open = {key: job.key, scene: glint.open(job.request), prepared: '{}'};
        scenes.set(job.view, open);
    }
    return open;
}

async function work(job: JobMessage): Promise<Answers[keyof Answers]> {
    const open = await sceneOf(job);
    const {scene} = open;
    if (job.task.what === 'open') return {report: scene.report, info: scene.info};
    const prepared = JSON.stringify(job.prepare);
    if (prepared !== open.prepared) {
        open.prepared = '';
        scene.prepare(job.prepare);
        open.prepared = prepared;
    }
    if (job.task.what === 'explain') return scene.explain(job.task.x, job.task.y);
    if (job.task.what === 'convert') return scene.toGlint();
    const start = performance.now();
    const {x, y, width, height} = job.task.rect;
    return {...scene.renderPixels(x, y, width, height), milliseconds: performance.now() - start};
}

addEventListener('message', async ({data}: MessageEvent<ToWorker>) => {
    if (data.kind === 'start') {
        wasm = data.module;
        return;
    }
    let reply: FromWorker;
    const transfer: Transferable[] = [];
    try {
        const answer = await work(data);
        if (answer && typeof answer === 'object' && 'pixels' in answer) transfer.push(answer.pixels.buffer);
        reply = {id: data.id, answer};
    } catch (error) {
        // After a trap the instance's memory is not to be trusted: the next job makes a new one.
        const broken = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
        if (broken) {
            glint = null;
            scenes.clear();
        }
        reply = {id: data.id, error: error instanceof Error ? error.message : String(error), broken};
    }
    postMessage(reply, {transfer});
});
