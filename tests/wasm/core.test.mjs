// SPDX-License-Identifier: Apache-2.0
// glint-core.wasm, with which the page starts, gives the results of glint.wasm, or says that it leaves something out.
// GLINT_WASM: glint.wasm; GLINT_CORE: glint-core.wasm; GLINT_SCENES: the folder scenes/.
import assert from 'node:assert/strict';
import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {pathToFileURL} from 'node:url';
import {gzipSync} from 'node:zlib';

import {compile, instantiate} from '../../src/wasm/glint.mjs';

const [whole, core] = await Promise.all([process.env.GLINT_WASM, process.env.GLINT_CORE].map((file) => compile(pathToFileURL(file))));
const scenes = process.env.GLINT_SCENES;
const files = readdirSync(scenes, {recursive: true}).map(String).filter((name) => /[.]\w+$/.test(name));
const read = (name) => ({name, text: readFileSync(join(scenes, name), 'utf8')});
const includes = files.filter((name) => name.includes('/parts/')).map(read);

/** All results for a scene: as read, its picture, an explanation, the scene in .glint, and its difference from itself. */
function results(glint, texts) {
    const scene = glint.open({texts, includes, settings: {size: '40x30', aa: '1'}});
    const {report, info} = scene;
    const all = {report, info};
    if (report.ready) {
        Object.assign(all, {
            floats: scene.render(0, 0, 40, 30), rays: scene.renderPixels(0, 0, 40, 30).rays, explanation: scene.explain(20, 15),
            glint: scene.toGlint(), difference: scene.compare(scene),
        });
    }
    scene.close();
    return all;
}

const inCore = files.filter((name) => !name.includes('/parts/') && !name.includes('only_') && !/(solids|carved|quartics|glass_of_water|amber|marbles|pond)[.]glint$/.test(name) && !/[.](gltf|nff|pov)$/.test(name));
for (const name of inCore) {
    test(`the core has the results of the whole: ${name}`, async () => {
        const glint = await instantiate(core);
        assert.deepEqual(results(glint, [read(name)]), results(await instantiate(whole), [read(name)]));
        assert.equal(glint.leftOut, false);
    });
}

const ball = {name: 'ball.pov', text: '#declare R = 1; sphere { 0, R pigment { rgb 1 } } camera { location <0, 0, -4> look_at 0 }'};
test('the core says what it leaves out, and the whole does not', async () => {
    const cases = {
        "POV-Ray's language": (glint) => glint.open({texts: [ball]}),
        'the same in an included text': (glint) => glint.open({texts: [{name: 'a.glint', text: 'include "ball.pov"\n'}], includes: [ball]}),
        "Tachyon's scenes": (glint) => glint.open({texts: [{name: 'a.dat', text: 'BEGIN_SCENE\nRESOLUTION 4 3\nEND_SCENE\n'}]}),
        "CSC 473's scenes": (glint) => glint.open({texts: [read('csc473/cone_tower.pov')]}),
        solids: (glint) => glint.open({texts: [{name: 'a.glint', text: 'merge { sphere { center = (0, 0, 0) radius = 1 } }\n'}]}),
        'fog on the ground': (glint) => glint.open({texts: [{name: 'a.glint', text: 'camera { position = (0, 1, 4) look_at = (0, 0, 0) fov_x = 40 }\nfog { density = 0.1  falloff = 1 }\nsphere { center = (0, 0, 0) radius = 1 }\n'}]}).renderPixels(0, 0, 2, 2),
        'fog outside of objects': (glint) => glint.open({texts: [{name: 'a.glint', text: 'camera { position = (0, 0, 4) look_at = (0, 0, 0) fov_x = 40 }\nfog { density = 0.1 } conventions { fog_extent = outside_objects } sphere { center = (0, 0, 0) radius = 1 }\n'}]}).renderPixels(0, 0, 2, 2),
        '.nff': (glint) => glint.open({texts: [read('nff/pyramid.nff')]}),
        '.stl': (glint) => glint.open({texts: [{name: 'a.stl', text: 'solid a\nendsolid a\n'}]}),
        "Wavefront's meshes": (glint) => glint.open({texts: [{name: 'a.obj', text: 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n'}]}),
        glTF: (glint) => glint.open({texts: [{name: 'a.gltf', text: '{"asset": {"version": "2.0"}}'}]}),
        causes: (glint) => {
            const scene = glint.open({texts: [read('cgfs/three_mirrors.cgfs')], settings: {size: '40x30'}});
            const other = glint.open({texts: [read('cgfs/three_mirrors.cgfs')], settings: {size: '40x30', reflections: '0'}});
            return scene.compare(other, {causes: true});
        },
        diagnose: (glint) => glint.open({texts: [read('cgfs/three_mirrors.cgfs')]}).diagnose('pixel 3 4\nray camera\norigin 0 0 0\n'),
        check: (glint) => glint.open({texts: [read('cgfs/three_mirrors.cgfs')]}).check(),
    };
    for (const [what, act] of Object.entries(cases)) {
        const small = await instantiate(core), all = await instantiate(whole);
        try {
            act(small);
        } catch (error) {
            assert.match(error.message, /glint[.]wasm/, what);
        }
        assert.equal(small.leftOut, true, what);
        act(all);
        assert.equal(all.leftOut, false, what);
    }
});

test('the core is under half a megabyte, compressed', () => {
    const size = gzipSync(readFileSync(process.env.GLINT_CORE), {level: 9}).length;
    console.log(`# ${size} bytes`);
    assert.ok(size < 5e5, `${size} bytes`);
});
