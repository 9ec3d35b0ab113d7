// SPDX-License-Identifier: Apache-2.0
// What emscripten expects of node's files and node does not do. To be loaded before emscripten's script.
'use strict';
const fs = require('node:fs');

// Standard input, or output, may be a pipe that another program has set not to block.
function again(call) {
    return (...given) => {
        for (;;) {
            try {
                return call(...given);
            } catch (error) {
                if (error.code === 'EOF') return 0;  // of a pipe, on Windows
                if (error.code !== 'EAGAIN') throw error;
                Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 5);
            }
        }
    };
}
fs.readSync = again(fs.readSync);
fs.writeSync = again(fs.writeSync);

// emscripten and glint know paths that begin at /. On Windows, C:\a is /C:/a to them; where such a path is appended to another,
// as to the folder of a scene, it still begins at its drive.
function toWindows(path, folder) {
    if (typeof path !== 'string') return path;
    const whole = /^([A-Za-z]:|[\\/])/.test(path) ? path : `${folder}/${path}`;
    return whole.replace(/^.*\/(?=[A-Za-z]:(\/|$))/, '').replace(/^([A-Za-z]:)$/, '$1/');
}
const fromWindows = (path) => path.replace(/\\/g, '/').replace(/^(?=[A-Za-z]:)/, '/');

function mapPaths() {
    const folder = process.cwd();
    const one = ['openSync', 'statSync', 'lstatSync', 'readlinkSync', 'unlinkSync', 'mkdirSync', 'rmdirSync', 'readdirSync',
        'chmodSync', 'chownSync', 'truncateSync', 'utimesSync', 'writeFileSync'];
    for (const name of one) {
        const call = fs[name];
        fs[name] = (path, ...more) => call(toWindows(path, folder), ...more);
    }
    const rename = fs.renameSync, readlink = fs.readlinkSync;
    fs.renameSync = (from, to) => rename(toWindows(from, folder), toWindows(to, folder));
    fs.readlinkSync = (...given) => fromWindows(readlink(...given));
    process.cwd = () => fromWindows(folder);
    for (let i = 2; i < process.argv.length; ++i) process.argv[i] = process.argv[i].replace(/\\/g, '/');
}
if (process.platform === 'win32') mapPaths();

module.exports = {toWindows, fromWindows};
