// SPDX-License-Identifier: Apache-2.0
// Modules of the page that need no browser, and the engine, in node.
import {readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {fileURLToPath, pathToFileURL} from 'node:url';

const project = fileURLToPath(new URL('../..', import.meta.url));
const vite = createRequire(`${project}web/package.json`).resolve('vite').replace(/index\.cjs$/, 'dist/node/index.js');
const {transformWithEsbuild} = await import(pathToFileURL(vite).href);

export const {load} = await import(`${project}build/wasm/glint-wasm/glint.mjs`);

/** A module of web/src, which imports only types. */
export async function pageModule(name) {
    const {code} = await transformWithEsbuild(readFileSync(`${project}web/src/${name}`, 'utf8'), name);
    return import(`data:text/javascript,${encodeURIComponent(code)}`);
}
