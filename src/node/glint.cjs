#!/usr/bin/env node
// SPDX-License-Identifier: Apache-2.0
// The glint command in node: `npx glint-wasm render castle.json`. glint.js is made by emscripten.
'use strict';
const {constants: {signals}} = require('node:os');
const threads = require('node:worker_threads');
require('./files.cjs');

// node sometimes aborts if the process exits while its workers end, so they end first.
const workers = new Set();
threads.Worker = class extends threads.Worker {
    constructor(...given) {
        super(...given);
        workers.add(this);
        this.once('exit', () => workers.delete(this));
    }
};
const exit = process.exit;
process.exit = (code) => {
    process.exitCode = code;
    Promise.all([...workers].map((worker) => worker.terminate())).finally(() => exit(code));
};

// node has fetch(), by which emscripten would try to open its own file.
globalThis.fetch = undefined;
const engine = require('./glint.js');

// As natively: an unfinished file is removed, then the signal ends the process.
for (const name of ['SIGINT', 'SIGTERM', 'SIGHUP']) {
    process.on(name, () => {
        try {
            engine._glint_interrupted?.(signals[name]);
        } catch {
            // The engine is not there yet, and neither is a file.
        }
        if (process.platform === 'win32') exit(128 + signals[name]);
        process.removeAllListeners(name);
        process.kill(process.pid, name);
    });
}
