// SPDX-License-Identifier: Apache-2.0
// The browser build in node: the same bytes as the native build, tiles that form the whole picture, and bad input.
// GLINT_WASM: glint.wasm; GLINT_PACKAGE: the npm package; GLINT_NATIVE_API: native_api of a native build; GLINT_SCENES: the
// folder scenes/.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join, relative} from 'node:path';
import {test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {gzipSync} from 'node:zlib';

import {InstanceError, load} from '../../src/wasm/glint.mjs';

const glint = await load(pathToFileURL(process.env.GLINT_WASM));
const {encodePng} = await import(pathToFileURL(join(process.env.GLINT_PACKAGE, 'png.mjs')).href);
const {encodeExr} = await import(pathToFileURL(join(process.env.GLINT_PACKAGE, 'exr.mjs')).href);

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
        assert.equal(new Set(here).size > 100, !isBlack, 'a picture of more than a few colors');
        const differing = here.findIndex((value, i) => !Object.is(value, native[i]));
        assert.equal(differing, -1, `float ${differing}: ${here[differing]}, natively ${native[differing]}`);
    });
}

// Heights of one strip, of two, of whole strips, and enough pixels for several deflate blocks in a strip.
for (const [paths, size] of [[['cgfs/three_mirrors.cgfs'], '64x32'], [['epfl/castle.json'], '90x33'], [['epfl/castle.json'], '1x1'],
                             [['glint/temple.glint'], '128x96'], [['epfl/three_lights.json'], '2500x40']]) {
    test(`a PNG has the bytes of the native file: ${paths} ${size}`, () => {
        const {scene, report: {width, height}} = open(paths, {size, aa: '1'});
        const here = encodePng(scene.renderPixels(0, 0, width, height).pixels, width, height);
        scene.close();
        assert.ok(Buffer.from(here).equals(native(request(paths, {size, aa: '1'}), 'png')));
    });
}

for (const settings of [{transfer: 'none'}, {transfer: 'srgb'}, {transfer: 'none', gamma: '2.2'}, {transfer: 'srgb', rounding: 'down'}, {alpha: 'true'},
                        {alpha: 'true', transfer: 'srgb', aa: '2'}, {alpha: 'true', gamma: '1.8', aa: '2'}]) {
    test(`a PNG has the bytes of the native file: ${JSON.stringify(settings)}`, () => {
        const all = {size: '70x50', ...settings};
        const {scene, report: {width, height}} = open(['glint/still_life.glint'], all);
        const here = encodePng(scene.renderPixels(0, 0, width, height).pixels, width, height,
                               {alpha: settings.alpha === 'true', srgb: settings.transfer === 'srgb'});
        scene.close();
        assert.ok(Buffer.from(here).equals(native(request(['glint/still_life.glint'], all), 'png')));
    });
}

test('a PNG of noise has the bytes of the native file', () => {
    // 3000 small balls: hardly a run of equal bytes.
    let seed = 1;
    const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
    const balls = Array.from({length: 3000}, () => `sphere { center = (${3 * random() - 1.5}, ${3 * random() - 1.5}, 3) radius = 0.03 color = (${
        [0, 0, 0].map(() => Math.floor(256 * random())).join()}) }`);
    const body = {texts: [{name: 'noise.cgfs', text: `${balls.join('\n')}\nlight { type = ambient intensity = 1 }`}], settings: {size: '700x70'}};
    const scene = glint.open(body);
    const here = encodePng(scene.renderPixels(0, 0, 700, 70).pixels, 700, 70);
    scene.close();
    assert.ok(Buffer.from(here).equals(native(body, 'png')));
});

for (const [paths, size, alpha] of [[['cgfs/three_mirrors.cgfs'], '64x32', false], [['epfl/castle.json'], '61x47', true], [['epfl/castle.json'], '1x1', false],
                                    [['glint/temple.glint'], '128x96', true], [['glint/still_life.glint'], '333x17', false]]) {
    test(`an OpenEXR has the bytes of the native file: ${paths} ${size}${alpha ? ' with alpha' : ''}`, () => {
        const settings = {size, aa: '2', ...(alpha ? {alpha: 'true'} : {})};
        const {scene, report: {width, height}} = open(paths, settings);
        const rgb = scene.render(0, 0, width, height);
        const here = encodeExr(rgb, width, height, alpha ? {alpha: scene.renderLayers(['alpha'], 0, 0, width, height).layers.alpha} : {});
        scene.close();
        assert.ok(Buffer.from(here).equals(native(request(paths, settings), 'exr')));
    });
}

test('a picture that is none is not encoded', () => {
    for (const wrong of [[new Uint8Array(4), 1, 2], [new Uint8Array(4), 0, 1], [new Uint8Array(4), NaN, 1], [new Uint8Array(8), 0.5, 4], [[], 65537, 1]])
        assert.throws(() => encodePng(...wrong), /^TypeError: (pixels|width|height): expected/);
    for (const [rgb, width, height, options] of [[new Float32Array(11), 2, 2], [new Float32Array(12), 2, 0], [new Float32Array(12), 2, 2, {alpha: new Float32Array(3)}]])
        assert.throws(() => encodeExr(rgb, width, height, options), TypeError);
});

test('the loader says what it cannot read', async () => {
    await assert.rejects(load('no.wasm'), /no\.wasm/);
    await assert.rejects(load(new URL('api.test.mjs', import.meta.url)), WebAssembly.CompileError);
});

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
    assert.deepEqual(info.light_fields.map((field) => field.name), ['color', 'specular_color', 'position', 'to_light',
        'axis', 'inner_angle', 'outer_angle', 'tightness', 'side_u', 'side_v', 'radius', 'samples_u', 'samples_v', 'one_sided', 'jitter',
        'adaptive', 'circular', 'oriented', 'cone', 'attenuation', 'fade_distance', 'fade_power', 'casts_shadows']);
    assert.deepEqual(info.light_fields[3].keys, ['to_light', 'direction']);
    assert.deepEqual(info.lights.map((light) => info.light_fields.filter((field) => field.name in light).length), [1, 7, 4]);
    assert.deepEqual(info.camera_fields.map((field) => field.name), ['position', 'look_at', 'up', 'fov', 'width', 'lighting_eye']);
    assert.deepEqual(info.material_fields.find((field) => field.name === 'diffuse').keys, ['diffuse_color']);
    assert.deepEqual(info.blocks.sphere.slice(0, 3), ['center', 'radius', 'material']);
    assert.deepEqual(info.blocks.light.slice(0, 4), ['type', 'intensity', 'target', 'color']);
    // Each key is one that the reader knows, and it names no other.
    for (const [word, keys] of Object.entries(info.blocks)) {
        const isKnown = (key) => {
            const other = glint.open({texts: [{name: 'a.glint', text: `${word} ${['material', 'texture'].includes(word) ? 'm ' : ''}{ ${key} = ? }`}]});
            const {diagnostics} = other.report;
            other.close();
            return !diagnostics.some(({message}) => new RegExp(`^an? ${word}( block)? has no `).test(message));
        };
        assert.deepEqual([...keys, 'zzz'].filter((key) => !isKnown(key)), ['zzz'], word);
    }
    assert.deepEqual(info.camera.view, {right: [1, 0, 0], up: [0, 1, 0], forward: [0, 0, 1]});
    const shading = info.settings.find((setting) => setting.name === 'shading');
    assert.deepEqual([shading.value, shading.profile_value, shading.origin], ['blinn-phong', 'phong', 'command']);
    scene.close();
});

test('fog and alpha', () => {
    const scene = glint.open({texts: [{name: 'ball.glint', text: `render { size = 5 x 5  alpha = true }
background = (1, 1, 1)
fog { type = linear  start = 0  end = 10 }
conventions { fog_background = false }
camera { projection = orthographic  position = (0, 0, 6)  width = 10 }
light { type = ambient }
sphere { center = (0, 0, 0)  radius = 1  ambient_color = (1, 0, 0) }\n`}]});
    const {info} = scene;
    assert.deepEqual(info.fog_fields.map((field) => field.name), ['color', 'density', 'start', 'end', 'transmit', 'filter', 'falloff', 'height', 'up']);
    assert.deepEqual(info.fog, {kind: 'linear', place: {file: 'ball.glint', line: 3, column: 1},
        color: [0.5, 0.5, 0.5], start: 0, end: 10, transmit: 0, filter: 0});
    const {pixels} = scene.renderPixels(0, 2, 3, 1);
    assert.deepEqual([...pixels], [0, 0, 0, 0, 0, 0, 0, 0, 191, 64, 64, 255]);  // half of it is seen
    const {rays, alpha} = scene.explain(2, 2);
    assert.deepEqual([rays[0].fog, alpha], [{visibility: 0.5, added: [0.25, 0.25, 0.25]}, 1]);
    assert.equal(scene.explain(0, 0).rays[0].transparent, true);
    scene.close();
    const {scene: clear} = open(['cgfs/three_mirrors.cgfs'], {});
    assert.equal(clear.info.fog, null);
    clear.close();
});

test('layers of a rectangle', () => {
    const scene = glint.open({texts: [{name: 'ball.glint', text: `render { size = 5 x 5 }
camera { projection = orthographic  position = (0, 0, 6)  width = 10 }
light { position = (0, 0, 9) }
sphere { center = (0, 0, 0)  radius = 1  color = (0.5, 0.25, 1)  diffuse = 1 }\n`}]});
    const {pixels, layers} = scene.renderLayers(['depth', 'albedo', 'normal'], 2, 1, 1, 2);
    assert.deepEqual([...layers.depth], [Infinity, 5]);
    assert.deepEqual([...layers.albedo].slice(3), [0.5, 0.25, 1]);
    assert.deepEqual([...layers.normal].slice(3), [0, 0, 1]);
    assert.deepEqual(pixels, scene.renderPixels(2, 1, 1, 2).pixels);
    assert.deepEqual(scene.renderLayers([], 2, 1, 1, 2), {...scene.renderPixels(2, 1, 1, 2), layers: {}});
    const light = scene.renderLayers(['light:1', 'light:none'], 2, 1, 1, 2).layers;
    const picture = scene.render(2, 1, 1, 2);
    for (const [i, value] of light['light:1'].entries()) assert.ok(Math.abs(value + light['light:none'][i] - picture[i]) < 1e-5);
    assert.throws(() => scene.renderLayers(['light:2'], 2, 1, 1, 2), /no layer 'light:2'/);
    for (const names of [['dept'], ['depth', 'depth']]) assert.throws(() => scene.renderLayers(names, 0, 0, 1, 1), /dept/);
    assert.throws(() => scene.renderLayers(['depth'], 4, 0, 2, 1), /./);
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
        const before = pixels(), {info} = scene;
        assert.throws(() => scene.prepare(bad), /./, JSON.stringify(bad));
        assert.match(scene.report.error, /./);
        assert.deepEqual(pixels(), before, 'a refused request changes nothing');
        assert.deepEqual(scene.info, info);
        assert.equal(scene.report.error, undefined, 'the last request succeeded');
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
    assert.deepEqual([diagnostics[0].item, diagnostics[0].index], [null, 0]);
    assert.match(diagnostics[0].text, /^bad\.cgfs:1:23: error: .*\n.*oops.*\n +\^/);
    assert.throws(() => scene.render(0, 0, 1, 1), /errors/);
    scene.close();
});

test('a closed scene says so, and leaves the instance as it was', () => {
    const {scene} = open(...tiled);
    const other = open(...tiled).scene;
    const before = other.renderPixels(0, 0, 20, 20);
    scene.close();
    scene.close();
    for (const use of [() => scene.report, () => scene.info, () => scene.render(0, 0, 1, 1), () => scene.renderPixels(0, 0, 1, 1),
                       () => scene.prepare({}), () => scene.explain(0, 0), () => scene.toGlint(), () => scene.check(), () => scene.diagnose(''),
                       () => other.compare(scene), () => scene.comparePicture({pixels: new Uint8Array(4), width: 1, height: 1})])
        assert.throws(use, /^Error: the scene is closed$/);
    assert.deepEqual(other.renderPixels(0, 0, 20, 20), before);
    other.close();
});

test('rectangles, pixels and texts that are none are refused', () => {
    const {scene} = open(...tiled);
    const before = scene.renderPixels(0, 0, 160, 160);
    for (const numbers of [[0.5, 0, 10.5, 10], [0, 0, NaN, 10], [0, 0, 2 ** 32 + 1, 1], [0, 0, '1', 1], [0, 0, 1]]) {
        assert.throws(() => scene.render(...numbers), /expected a whole number/);
        assert.throws(() => scene.renderPixels(...numbers), /expected a whole number/);
    }
    for (const numbers of [[-1, 0, 1, 1], [0, 0, 0, 1], [0, 0, 1, -1], [0, 0, 161, 1], [2147483647, 0, 2147483647, 1]])
        assert.throws(() => scene.renderPixels(...numbers), /./);
    assert.throws(() => scene.explain(NaN, 5), /expected a whole number/);
    for (const pixel of [[-1, 5], [160, 5], [5, 160]]) assert.throws(() => scene.explain(...pixel), /./);
    assert.throws(() => scene.prepare({camera: {position: [NaN, 0, 0], right: [1, 0, 0], up: [0, 1, 0], forward: [0, 0, 1]}}), /camera/);
    const text = '# half of a sun: \ud83c\nsphere';
    assert.throws(() => glint.open({texts: [{name: 'a.cgfs', text}]}), /line 1 .*U\+D83C/);
    assert.throws(() => glint.open(text), /U\+D83C/);
    assert.throws(() => scene.prepare({settings: {size: '\udc00'}}), /U\+DC00/);
    for (const size of ['0x0', '65537x1', '-1x5', 'NaN', '1e3x5', NaN, null, {}, '65536x65536x65536']) {
        assert.throws(() => scene.prepare({settings: {size}}), /size/, String(size));
        const refused = glint.open(request(tiled[0], {size}));
        assert.equal(refused.report.ready, false, String(size));
        assert.match(refused.report.diagnostics[0].text, /size/);
        refused.close();
    }
    for (const number of [NaN, Infinity, '\u2212 1']) assert.throws(() => scene.prepare({settings: {epsilon: number}}), /epsilon/);
    assert.deepEqual(scene.renderPixels(0, 0, 160, 160), before);
    scene.close();
});

test('a picture that does not fit into memory is refused, and its parts are rendered', () => {
    const {scene} = open(['cgfs/three_mirrors.cgfs'], {size: '65536x65536'});
    assert.throws(() => scene.render(0, 0, 65536, 65536), /65536x65536 pixels are too many at once/);
    assert.throws(() => scene.renderPixels(0, 0, 65536, 16384), /too many/);
    assert.throws(() => scene.compare(scene), /too many/);
    assert.equal(scene.renderPixels(32768, 32768, 4, 4).pixels.length, 64);
    scene.close();
});

test('missing texts are named, so that they can be supplied', () => {
    const texts = [{name: 'my/main.glint', text: 'include "parts/ball.glint"\ninclude "other.glint"\n'}];
    const scene = glint.open({texts, includes: [{name: 'my/other.glint', text: 'light { type = ambient }\n'}]});
    assert.deepEqual(scene.report.missing, ['my/parts/ball.glint']);
    scene.close();
    const whole = glint.open({texts, includes: [{name: 'my/other.glint', text: ''}, {name: 'my/parts/ball.glint', text: ''}]});
    assert.equal(whole.report.missing, undefined);
    whole.close();
});

test('all missing texts of a POV-Ray scene are named at once, and none that glint has of its own', () => {
    const text = `#include "colors.inc"
#if (true) #include "one.inc"
#include "two.inc" #else #include "other_branch.inc" #end
#ifdef (Never) #include "not_read.inc" #end
#include "metals.inc"
#include "three.inc"
sphere { 0, 1 pigment { Red } }
`;
    const scene = glint.open({texts: [{name: 'my/main.pov', text}]});
    assert.deepEqual(scene.report.missing, ['my/one.inc', 'my/two.inc', 'my/three.inc']);
    assert.deepEqual(scene.report.diagnostics.map(({line, message}) => `${line} ${message}`),
        ["2 'one.inc': no such file", "3 'two.inc': no such file", "6 'three.inc': no such file"]);
    scene.close();
    const own = glint.open({texts: [{name: 'main.pov', text: '#include "colors.inc"\nsphere { 0 }\n'}]});
    assert.equal(own.report.ready, false);
    assert.equal(own.report.missing, undefined);
    own.close();
});

test('a setting that is none has the same message, with the likeliest one, when a scene is opened and when it is prepared', () => {
    const words = 'no setting is called \'shadin\'; did you mean `shading`?';
    const opened = glint.open({...request(['cgfs/three_mirrors.cgfs'], {shadin: 'phong'})});
    assert.equal(opened.report.diagnostics[0].message, words);
    opened.close();
    const {scene} = open(['cgfs/three_mirrors.cgfs'], {});
    assert.throws(() => scene.prepare({settings: {shadin: 'phong'}}), {message: words});
    scene.close();
});

test('the report is that of the last request', () => {
    const {scene} = open(...tiled);
    assert.throws(() => scene.render(0, 0, 500, 1), /./);
    assert.match(scene.report.error, /./);
    scene.prepare({settings: {size: '40x30'}});
    assert.deepEqual([scene.report.width, scene.report.height, scene.report.error], [40, 30, undefined]);
    scene.close();
});

test('pictures are compared, and causes found', () => {
    const reference = open(['cgfs/three_mirrors.cgfs'], {size: '60x60'}).scene;
    const text = read('cgfs/three_mirrors.cgfs').text;
    const other = glint.open({texts: [{name: 'a.cgfs', text: text.replace(/light { type = ambient.*/, '')}], settings: {size: '60x60'}});
    assert.deepEqual(reference.compare(reference), {
        pixels: 3600, equal: 3600, within_1: 3600, within: 3600, mean: 0, rms: 0, psnr: null, ssim: 1, largest: {value: 0, x: 0, y: 0}});
    const {equal, mean, causes} = other.compare(reference, {causes: true});
    assert.ok(equal < 3600 && mean > 5);
    assert.equal(causes[0].name, 'ambient-missing');
    const small = open(['cgfs/three_mirrors.cgfs'], {size: '50x60'}).scene;
    assert.throws(() => small.compare(reference), /./);
    for (const scene of [reference, other, small]) scene.close();
});

test('a picture of another program is compared, and causes found', () => {
    const {scene} = open(['cgfs/three_mirrors.cgfs'], {size: '60x60'});
    const text = read('cgfs/three_mirrors.cgfs').text;
    const other = glint.open({texts: [{name: 'a.cgfs', text: text.replace(/light { type = ambient.*/, '')}], settings: {size: '60x60'}});
    const {pixels} = other.renderPixels(0, 0, 60, 60), picture = {pixels, width: 60, height: 60};
    assert.deepEqual(scene.comparePicture(picture, {causes: true}), other.compare(scene, {causes: true}));
    assert.equal(scene.comparePicture({...picture, ...scene.renderPixels(0, 0, 60, 60)}).equal, 3600);
    assert.equal(scene.comparePicture(picture, {causes: true}).causes[0].name, 'ambient-missing');
    assert.throws(() => scene.comparePicture({pixels: pixels.subarray(0, 4 * 50 * 60), width: 50, height: 60}), /50x60 pixels, and the scene's has 60x60/);
    assert.throws(() => scene.comparePicture({...picture, width: 61}), TypeError);
    assert.throws(() => scene.comparePicture({...picture, width: 59.5, height: 60.5}), TypeError);
    other.close();
    scene.close();
});

test('the log of a ray tracer is diagnosed, as natively', () => {
    const {scene} = open(['epfl/castle.json'], {size: '80x80'});
    const numbers = (key, values) => `${key} ${[values].flat().join(' ')}\n`;
    const log = [[40, 30], [10, 45], [65, 50], [50, 37]].map(([x, y]) => {
        const {rays: [{origin, direction, t, hit}]} = scene.explain(x, y);
        const lines = [numbers('pixel', [x, y]), 'ray camera\n', numbers('origin', origin), numbers('direction', direction)];
        if (!hit) return `${lines.join('')}miss\n`;
        lines.push(numbers('shape', hit.shape.index + 1), numbers('t', t), numbers('P', hit.point), numbers('N', hit.normal));
        // The mistake: L is not of unit length.
        for (const {light, to_light: l, n_l} of hit.lights) lines.push(numbers('light', light.index + 1), numbers('L', l), numbers('N.L', n_l * Math.hypot(...l)));
        return lines.join('');
    }).join('');
    const found = scene.diagnose(log, {name: 'mine.log'}), file = join(mkdtempSync(join(tmpdir(), 'glint-wasm-')), 'mine.log');
    writeFileSync(file, log);
    const {diagnosis, diagnostics} = JSON.parse(native(request(['epfl/castle.json'], {size: '80x80'}), 'diagnose', file));
    rmSync(dirname(file), {recursive: true});
    assert.deepEqual(found, {...diagnosis, diagnostics});
    assert.equal(found.findings[0].quantity, 'N.L');
    assert.equal(found.findings[0].word, 'N.L');
    assert.equal(found.findings[0].causes[0].id, 'light-not-unit');
    assert.ok(found.rows.some(({light, verdict}) => light && verdict === 'wrong'));
    assert.deepEqual(scene.diagnose(new TextEncoder().encode(log), {name: 'mine.log'}), found);
    assert.match(scene.diagnose(`${log}mood 3\n`).diagnostics[0].message, /mood/);
    assert.throws(() => scene.diagnose('pixel 1 2\nN 0 1\n', {name: 'bad.log'}), /^Error: bad\.log:2:/);
    assert.throws(() => scene.diagnose('pixel 900 2\nray camera\norigin 0 0 0\n'), /no pixel of the log is in the picture of 80x80/);
    assert.throws(() => scene.diagnose(5), TypeError);
    scene.close();
    const bad = glint.open({texts: [{name: 'a.glint', text: 'oops'}]});
    assert.throws(() => bad.diagnose(log), /the scene has errors/);
    bad.close();
});

test('likely mistakes are found, as natively', () => {
    const {scene} = open(['faults/black.glint']);
    const found = scene.check();
    assert.deepEqual(found, JSON.parse(native(request(['faults/black.glint']), 'check')));
    assert.ok(found.length > 0 && found[0].remedy && found[0].line > 0);
    assert.equal(found[0].note, false);
    scene.close();
});

test('a converted scene names the texts that it was read from', () => {
    const {scene} = open(['cgfs/three_mirrors.cgfs']);
    assert.match(scene.toGlint(), /^# Converted from three_mirrors\.cgfs \(cgfs\) by glint/);
    const temple = open(['glint/temple.glint']).scene;
    assert.match(temple.toGlint(), /^# Converted from temple\.glint \(glint\), column\.glint \(glint\) by glint/);
    scene.close();
    temple.close();
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

test('reading a scene has a limit of memory', () => {
    const texts = [{name: 'a.pov', text: '#declare A = array[4000000]; sphere { 0, 1 }'}];
    const limited = glint.open({texts, maxMemory: 1e6});
    assert.equal(limited.report.ready, false);
    assert.match(limited.report.diagnostics[0].message, /takes more than .* of memory, the limit that was given/);
    limited.close();
    const usual = glint.open({texts: [{name: 'a.pov', text: 'union { #while(1) sphere { 0, 1 } #end }'}]});
    assert.match(usual.report.diagnostics[0].message, /takes more than 384 MiB of memory/);
    usual.close();
});

test('objects that glint does not render are left out if the request asks for it', () => {
    const texts = [{name: 'a.pov', text: 'blob { } sphere { 0, 1 }'}];
    const whole = glint.open({texts});
    assert.equal(whole.report.ready, false);
    assert.match(whole.report.diagnostics[0].message, /does not render `blob`.*the option skip-unsupported leaves it out/);
    assert.equal(whole.report.diagnostics[0].can_skip, true);
    whole.close();
    const rest = glint.open({texts, skipUnsupported: true});
    assert.equal(rest.report.ready, true);
    assert.match(rest.report.diagnostics[0].message, /left out 1 object that glint does not render: `blob`/);
    assert.equal(rest.report.diagnostics[0].can_skip, false);
    rest.close();
});

test('an instance whose memory runs out ends', async () => {
    const ended = await load(pathToFileURL(process.env.GLINT_WASM));
    const text = ' '.repeat(4e8);  // several copies of it exist while it is read
    assert.throws(() => ended.open({texts: [{name: 'a.cgfs', text}]}), InstanceError);
    assert.ok(ended.memoryBytes <= 2 ** 31);
    assert.throws(() => ended.version, /has ended, most likely because its memory ran out/);
    assert.throws(() => ended.open({texts: []}), InstanceError);
});

test('the version is the project’s', () => {
    assert.match(glint.version, /^\d+\.\d+\.\d+$/);
});
