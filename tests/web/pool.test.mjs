// SPDX-License-Identifier: Apache-2.0
// Which workers open a scene: all of them, or as many as have room for it.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {pageModule} from './page_module.mjs';

globalThis.window ??= globalThis;
const {Pool} = await pageModule('engine/pool.ts');

/** A pool of four workers that answer when they are told to. */
function poolOfFour() {
    const workers = [];
    const pool = new Pool(null, 4, () => {
        const worker = {
            jobs: [], opened: new Set(),
            addEventListener: (kind, listener) => { if (kind === 'message') worker.answer = listener; },
            postMessage: (message) => {
                if (message.kind !== 'job') return;
                worker.jobs.push(message.id);
                if (message.request) worker.opened.add(message.key);
            },
            terminate: () => {},
        };
        workers.push(worker);
        return worker;
    });
    /** Lets all workers finish all their jobs. */
    const finish = () => {
        for (let busy = true; busy;) {
            busy = false;
            for (const worker of workers) {
                if (worker.jobs.length === 0) continue;
                busy = true;
                worker.answer({data: {id: worker.jobs.shift(), answer: {}}});
            }
        }
    };
    const run = (key, bytes, count, view = 'main') => Array.from({length: count}, () => pool.run({
        view, key, request: {texts: [{name: 'a.ply', text: 'x'.repeat(bytes)}]}, prepare: {},
        task: {what: 'tile', rect: {x: 0, y: 0, width: 1, height: 1}},
    }));
    const openedBy = (key) => workers.filter(({opened}) => opened.has(key)).length;
    return {run, finish, openedBy, pool, workers};
}

test('a small scene is opened by all workers, a large one by as many as have room', async () => {
    const {run, finish, openedBy} = poolOfFour();
    for (const [key, bytes, workers] of [[1, 1000, 4], [2, 100e6, 2], [3, 300e6, 1], [4, 1000, 4]]) {
        const answers = run(key, bytes, 12);
        finish();
        await Promise.all(answers);
        assert.equal(openedBy(key), workers, `${bytes} bytes`);
    }
});

test('a job that reports its progress has its time again, unless it is cancelled', async () => {
    const timers = new Map();
    let last = 0;
    const {setTimeout: before, clearTimeout: beforeClear} = globalThis;
    globalThis.setTimeout = window.setTimeout = (_, milliseconds) => timers.set(++last, milliseconds) && last;
    globalThis.clearTimeout = (timer) => timers.delete(timer);
    try {
        const {pool, workers} = poolOfFour();
        const parts = [];
        const job = {view: 'main', key: 1, request: {texts: [{name: 'a.ply', text: 'x'}]}, prepare: {}, task: {what: 'open'}};
        const answer = pool.run(job, true, (done) => parts.push(done));
        const [id] = workers[0].jobs, [first] = timers.keys();
        workers[0].answer({data: {id, done: 0.4}});
        assert.deepEqual(parts, [0.4]);
        assert.ok(!timers.has(first) && timers.size === 1);
        pool.cancel('main', 1);
        const [limited] = timers.entries();
        workers[0].answer({data: {id, done: 0.5}});
        assert.deepEqual([parts, ...timers.entries()], [[0.4], limited]);
        workers[0].answer({data: {id, answer: {}}});
        await answer;
        assert.equal(timers.size, 0);
    } finally {
        Object.assign(globalThis, {setTimeout: before, clearTimeout: beforeClear});
        window.setTimeout = before;
    }
});

test('a large scene leaves no room for another one but in one worker', async () => {
    const {run, finish, openedBy} = poolOfFour();
    const first = run(1, 180e6, 4);
    finish();
    const second = run(2, 180e6, 4, 'other');
    finish();
    await Promise.all([...first, ...second]);
    assert.deepEqual([openedBy(1), openedBy(2)], [1, 1]);
});
