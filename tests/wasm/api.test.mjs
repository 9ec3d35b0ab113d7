// SPDX-License-Identifier: Apache-2.0
// The browser build in node: the same bytes as the native build, tiles that form the whole picture, and bad input.
// GLINT_WASM: glint.wasm; GLINT_PACKAGE: the npm package; GLINT_NATIVE_API: native_api of a native build; GLINT_SCENES: the
// folder scenes/.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, readdirSync, readFileSync} from 'node:fs';
import {join, relative} from 'node:path';
import {test} from 'node:test';
import {gzipSync} from 'node:zlib';

import {instantiate} from '../../src/wasm/glint.mjs';

const module = await WebAssembly.compile(readFileSync(process.env.GLINT_WASM));
const glint = await instantiate(module);

const files = readdirSync(process.env.GLINT_SCENES, {recursive: true, withFileTypes: true})
                  .filter((entry) => entry.isFile())
                  .map((entry) => relative(process.env.GLINT_SCENES, join(entry.parentPath ?? entry.path, entry.name)));
const read = (path) => ({name: path, text: readFileSync(join(process.env.GLINT_SCENES, path), 'utf8')});
const includes = files.filter((path) => path.includes('/parts/')).map(read);

/** The request for files of scenes/, rendered at a size. */
function request(paths, settings) {
    return {texts: paths.map(read), settings, includes};
}

function open(...args) {
    const scene = glint.open(request(...args));
    const report = scene.report;
    assert.ok(report.ready, JSON.stringify(report));
    return {scene, report};
}

/** The results of the same API natively. */
function native(body, ...what) {
    return execFileSync(process.env.GLINT_NATIVE_API, what.map(String), {input: JSON.stringify(body), maxBuffer: 1 << 28});
}

function nativeFloats(body, x, y, width, height) {
    const bytes = native(body, 'render', x, y, width, height);
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
        const isBlack = paths[0].endsWith('faults/black.glint');  // on purpose
        assert.equal(new Set(here).size > 100, !isBlack, 'a picture of more than a few colours');
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

for (const {paths, settings} of pictures) {
    test(`the same explanations, facts and .glint as natively: ${paths.join(' + ')}`, () => {
        const {scene, report} = open(paths, settings);
        const body = request(paths, settings);
        for (const [x, y] of [[0.5, 0.6], [0.31, 0.77]]) {
            const pixel = [Math.floor(x * report.width), Math.floor(y * report.height)];
            const here = scene.explain(...pixel);
            assert.deepEqual(here, JSON.parse(native(body, 'explain', ...pixel)));
            assert.deepEqual([...scene.renderPixels(...pixel, 1, 1).pixels], [...here.bytes, 255]);
        }
        assert.deepEqual(scene.info, JSON.parse(native(body, 'info')));
        assert.equal(scene.toGlint(), native(body, 'convert').toString());
        assert.ok(scene.toGlint().length > 100);
        scene.close();
    });
}

test('the facts of a scene', () => {
    const {scene} = open(['cgfs/three_mirrors.cgfs'], {shading: 'blinn-phong'});
    const {info} = scene;
    assert.deepEqual([info.width, info.height, info.profile, info.shapes], [600, 600, 'cgfs', {sphere: 4}]);
    assert.deepEqual(info.lights.map((light) => light.kind), ['ambient', 'point', 'directional']);
    assert.deepEqual(info.lights[1].position, [2, 1, 0]);
    assert.deepEqual(info.lights[1].place, {file: 'cgfs/three_mirrors.cgfs', line: 12, column: 1});
    assert.deepEqual(info.light_fields.map((field) => field.name), ['color', 'specular_color', 'position', 'to_light', 'attenuation']);
    assert.deepEqual(info.light_fields[3].keys, ['to_light', 'direction']);
    assert.deepEqual(info.lights.map((light) => info.light_fields.filter((field) => field.name in light).length), [1, 4, 3]);
    assert.deepEqual(info.camera.view, {right: [1, 0, 0], up: [0, 1, 0], forward: [0, 0, 1]});
    const shading = info.settings.find((setting) => setting.name === 'shading');
    assert.deepEqual([shading.value, shading.profile_value, shading.origin], ['blinn-phong', 'phong', 'command']);
    scene.close();
});

test('a scene is prepared otherwise, and as it was again', () => {
    const {scene} = open(...tiled);
    const pixels = () => scene.renderPixels(0, 0, scene.info.width, scene.info.height);
    const whole = pixels();
    assert.ok(whole.rays > 160 * 160);
    scene.prepare({settings: {size: '40x30', shading: 'normals'}});
    const small = open(tiled[0], {...tiled[1], size: '40x30', shading: 'normals'}).scene;
    assert.deepEqual(pixels().pixels, small.renderPixels(0, 0, 40, 30).pixels);
    scene.prepare({camera: {position: [0, 0, 90], right: [60, 0, 0], up: [0, 60, 0], forward: [0, 0, -1]}});
    assert.equal(scene.info.camera.projection, 'orthographic');
    assert.notDeepEqual(pixels().pixels, whole.pixels);
    for (const bad of ['{', '3', {settings: {size: '0x0'}}, {settings: {no: '1'}}, {camera: {position: [1, 2]}},
                       {camera: {position: [0, 0, 0], right: [1, 0, 0], up: [0, 1, 0], forward: [1, 0, 0]}}]) {
        assert.throws(() => scene.prepare(bad), /./, JSON.stringify(bad));
        assert.throws(() => scene.render(0, 0, 1, 1), /./);
    }
    scene.prepare({});
    assert.deepEqual(pixels(), whole);
    small.close();
    scene.close();
});

test('the package is what npm would publish, and under a megabyte compressed', () => {
    const folder = process.env.GLINT_PACKAGE;
    const {files, version} = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
    for (const file of files) assert.ok(existsSync(join(folder, file)), file);
    assert.equal(version, glint.version);
    const size = gzipSync(readFileSync(process.env.GLINT_WASM), {level: 9}).length;
    assert.ok(size < 1e6, `${size} bytes`);
    const shown = execFileSync(process.execPath, [join(folder, 'example.mjs')]).toString();
    assert.match(shown, /pixel \(30, 30\) is/);
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
