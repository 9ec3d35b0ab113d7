// SPDX-License-Identifier: Apache-2.0
// Uses each function of glint-wasm's types; compiled, never run.
import {type CameraInfo, type Cause, type Comparison, type Diagnosis, type Explanation, type Finding, type Scene, type SceneInfo, compile, instantiate, load} from 'glint-wasm';
import {encodeExr} from 'glint-wasm/exr';
import {encodePng} from 'glint-wasm/png';

const glint = await load();
const other = await instantiate(await compile('glint.wasm'));
const scene: Scene = glint.open({texts: [{name: 'a.glint', text: '', format: 'glint'}], settings: {size: '4x3'}, includes: []});
scene.prepare({settings: {aa: '2'}, camera: {position: [0, 0, 0], right: [1, 0, 0], up: [0, 1, 0], forward: [0, 0, 1]}});
const {ready, width = 0, height = 0, diagnostics, missing = []} = scene.report;
const {pixels, rays} = scene.renderPixels(0, 0, width, height);
const floats: number = scene.render(0, 0, 1, 1)[0] ?? 0;
const file = encodePng(pixels, width, height);
encodePng(pixels, width, height, {alpha: true, srgb: false});
const exr = encodeExr(scene.render(0, 0, width, height), width, height, {alpha: scene.renderLayers(['alpha'], 0, 0, width, height).layers.alpha});
const bytes: number = exr.length + file.length + pixels.length + rays;
const info: SceneInfo | null = scene.info;
const camera: CameraInfo | undefined = info?.camera;
const why: Explanation | null = scene.explain(0, 0);
const blocker: string | undefined = why?.rays[0]?.hit?.lights[0]?.blocker?.shape.name;
const comparison: Comparison = scene.compare(scene, {causes: true});
const causes: Cause[] = comparison.causes ?? [];
const findings: Finding[] = scene.check();
const diagnosis: Diagnosis = scene.diagnose('pixel 0 0\n', {name: 'mine.log'});
const firstWrong: string | undefined = scene.diagnose(new Uint8Array(4)).findings[0]?.causes[0]?.id ?? diagnosis.rows[0]?.quantity;
const texts: string[] = [scene.toGlint(), glint.version, diagnostics[0]?.text ?? '', ...missing, findings[0]?.remedy ?? ''];
scene.close();
// @ts-expect-error a size is a text
other.open({texts: [], settings: {size: 5}});
// @ts-expect-error a picture has a height
encodePng(pixels, width);
// @ts-expect-error
encodePng(pixels, width, height, {srgb: 1});
// @ts-expect-error alpha has a number for each pixel
encodeExr([0, 0, 0], 1, 1, {alpha: true});
export {ready, floats, bytes, camera, blocker, causes, firstWrong, texts};
