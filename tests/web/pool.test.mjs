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
    const pool = new Pool(null, () => Promise.reject(new Error('no network')), 4, () => {
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

/** A pool of two workers with the core: each answer is made from the module that the worker has and the job. */
function poolWithCore(loadWhole) {
    const workers = [];
    const pool = new Pool('core', loadWhole, 2, () => {
        const worker = {
            jobs: [], opened: [],
            addEventListener: (kind, listener) => { if (kind === 'message') worker.answer = listener; },
            postMessage: (message) => {
                if (message.kind === 'start') worker.module = message.module;
                else worker.jobs.push({...message, module: worker.module});
                if (message.request) worker.opened.push(`${message.key} ${worker.module}`);
            },
            terminate: () => {},
        };
        workers.push(worker);
        return worker;
    });
    /** Lets all workers finish their present job; those of .pov need the whole engine. */
    const finish = () => {
        for (const worker of workers) {
            for (const {id, key, module} of worker.jobs.splice(0))
                worker.answer({data: key >= 100 && module === 'core' ? {id, leftOut: true} : {id, answer: `${key} ${module}`}});
        }
    };
    const run = (key, view = 'main') => pool.run({view, key, request: {texts: [{name: 'a', text: ''}]}, prepare: {}, task: {what: 'open'}});
    return {pool, run, finish, workers};
}
const moment = () => new Promise((next) => setTimeout(next, 0));

test('a job that the core cannot do is repeated with the whole engine, which all workers have from then on', async () => {
    let loaded = 0;
    const {run, finish, workers} = poolWithCore(async () => {
        ++loaded;
        return 'whole';
    });
    const easy = [run(1), run(1)];
    finish();
    assert.deepEqual(await Promise.all(easy), ['1 core', '1 core']);
    assert.equal(loaded, 0);
    const hard = [run(100), run(100)];
    finish();
    await moment();
    finish();
    assert.deepEqual(await Promise.all(hard), ['100 whole', '100 whole']);
    const after = [run(1), run(1)];
    finish();
    assert.deepEqual(await Promise.all(after), ['1 whole', '1 whole']);
    assert.equal(loaded, 1);
    for (const {opened} of workers) assert.deepEqual(opened, ['1 core', '100 core', '100 whole', '1 whole']);
});

test('without a network the core goes on, and the next job that needs the whole engine tries again', async () => {
    let isOnline = false;
    const {run, finish} = poolWithCore(async () => {
        if (!isOnline) throw new Error('no network');
        return 'whole';
    });
    const hard = run(100);
    finish();
    await assert.rejects(hard, /rest of the engine.*no network/);
    const easy = run(1);
    finish();
    assert.equal(await easy, '1 core');
    isOnline = true;
    const again = run(100);
    finish();
    await moment();
    finish();
    assert.equal(await again, '100 whole');
});

test('jobs that wait for the whole engine can be cancelled', async () => {
    let arrive = null;
    const {pool, run, finish} = poolWithCore(() => new Promise((done) => { arrive = done; }));
    const waiting = run(100);
    finish();
    pool.cancel('main', 100);
    await assert.rejects(waiting, {message: ''});
    const running = run(101);
    pool.cancel('main', 101);
    finish();
    await assert.rejects(running, {message: ''});
    const other = run(102, 'other');
    finish();
    arrive('whole');
    await moment();
    finish();
    assert.equal(await other, '102 whole');
});
