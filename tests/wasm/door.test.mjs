// The browser build in node: the same bytes as the native build, tiles that make the whole, and bad input.
// GLINT_WASM: glint.wasm; GLINT_NATIVE_DOOR: native_door of a native build; GLINT_SCENES: the folder scenes/.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readdirSync, readFileSync} from 'node:fs';
import {join, relative} from 'node:path';
import {test} from 'node:test';

import {instantiate} from '../../src/wasm/glint.mjs';

const module = await WebAssembly.compile(readFileSync(process.env.GLINT_WASM));
const glint = await instantiate(module);

const files = readdirSync(process.env.GLINT_SCENES, {recursive: true, withFileTypes: true})
                  .filter((entry) => entry.isFile())
                  .map((entry) => relative(process.env.GLINT_SCENES, join(entry.parentPath ?? entry.path, entry.name)));
const read = (path) => ({name: path, text: readFileSync(join(process.env.GLINT_SCENES, path), 'utf8')});
const includes = files.filter((path) => path.includes('/parts/')).map(read);

/** The request for files of scenes/, drawn at a size. */
function request(paths, settings) {
    return {texts: paths.map(read), settings, includes};
}

function open(...args) {
    const scene = glint.open(request(...args));
    const report = scene.report;
    assert.ok(report.ready, JSON.stringify(report));
    return {scene, report};
}

function nativeFloats(body, x, y, width, height) {
    const bytes = execFileSync(process.env.GLINT_NATIVE_DOOR, [x, y, width, height].map(String),
                               {input: JSON.stringify(body), maxBuffer: 1 << 28});
    return new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);
}

const pictures = [
    {paths: ['cgfs/three_mirrors.cgfs'], settings: {size: '200x150', reflections: '3'}},
    {paths: ['cgfs/only_spheres.cgfs', 'cgfs/only_lights.cgfs'], settings: {size: '150x150', aa: '2'}},
    {paths: ['epfl/castle.json'], settings: {size: '160x160', reflections: '4', shading: 'blinn-phong'}},
    {paths: ['epfl/mirror_room.json'], settings: {size: '160x120', reflections: '4', shading: 'phong'}},
    // Every scene of the gallery.
    ...files.filter((path) => !path.includes('/parts/') && !path.includes('/only_'))
        .map((path) => ({paths: [path], settings: {size: '80x60', aa: '1'}})),
];
const tiled = [pictures[2].paths, pictures[2].settings];

for (const {paths, settings} of pictures) {
    test(`the same bytes as natively: ${paths.join(' + ')}`, () => {
        const {scene, report} = open(paths, settings);
        const here = scene.render(0, 0, report.width, report.height);
        scene.close();
        const native = nativeFloats(request(paths, settings), 0, 0, report.width, report.height);
        assert.equal(here.length, native.length);
        assert.ok(new Set(here).size > 100, 'a picture of more than a few colours');
        const differing = here.findIndex((value, i) => !Object.is(value, native[i]));
        assert.equal(differing, -1, `float ${differing}: ${here[differing]}, natively ${native[differing]}`);
    });
}

test('tiles make the whole', () => {
    const {scene, report} = open(...tiled);
    const {width, height} = report;
    const whole = scene.render(0, 0, width, height);
    for (const [x, y, w, h] of [[0, 0, 50, 70], [50, 0, width - 50, 70], [0, 70, width, height - 70]]) {
        const tile = scene.render(x, y, w, h);
        for (let row = 0; row < h; ++row) {
            const from = 3 * ((y + row) * width + x);
            assert.deepEqual(tile.subarray(3 * row * w, 3 * (row + 1) * w), whole.subarray(from, from + 3 * w));
        }
    }
    assert.throws(() => scene.render(width - 10, 0, 20, 10), /./);
    scene.close();
});

test('bad scenes have messages with places', () => {
    const scene = glint.open({texts: [{name: 'bad.cgfs', text: 'sphere { center = (0, oops, 3) radius = 1 color = (1, 2, 3) }\n'}]});
    const {ready, diagnostics} = scene.report;
    assert.equal(ready, false);
    assert.equal(diagnostics[0].severity, 'error');
    assert.equal(diagnostics[0].line, 1);
    assert.equal(diagnostics[0].column, 23);
    assert.match(diagnostics[0].text, /^bad\.cgfs:1:23: error: .*\n.*oops.*\n +\^/);
    assert.throws(() => scene.render(0, 0, 1, 1), /errors/);
    scene.close();
});

test('requests that are none are answered', () => {
    for (const bad of ['', '{', '[]', '3', '{}', '{"texts": 5}', '{"texts": [1, {"name": 2}]}', '['.repeat(100000)]) {
        const scene = glint.open(bad);
        assert.equal(scene.report.ready, false, bad.slice(0, 40));
        scene.close();
    }
});

test('closed scenes give their memory back', () => {
    const draw = () => {
        const {scene} = open(...tiled);
        scene.render(0, 0, 16, 16);
        scene.close();
    };
    for (let i = 0; i < 5; ++i) draw();
    const before = glint.memoryBytes;
    for (let i = 0; i < 50; ++i) draw();
    assert.equal(glint.memoryBytes, before);
});

test('the version is the project’s', () => {
    assert.match(glint.version, /^\d+\.\d+\.\d+$/);
});
