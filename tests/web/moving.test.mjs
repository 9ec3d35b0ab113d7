// SPDX-License-Identifier: Apache-2.0
// Moving a shape in the text of each format, without a browser.
import assert from 'node:assert/strict';
import {createRequire} from 'node:module';
import {fileURLToPath} from 'node:url';
import {test} from 'node:test';

const require = createRequire(new URL('../../web/package.json', import.meta.url));
const {build} = createRequire(require.resolve('vite/package.json'))('esbuild');
const folder = fileURLToPath(new URL('../../web/src/text', import.meta.url));
const {outputFiles: [code]} = await build({
    stdin: {contents: 'export {formatOf} from "./formats"; export {edited} from "./moving";', resolveDir: folder, loader: 'ts'},
    bundle: true, format: 'esm', write: false,
});
const {edited, formatOf} = await import(`data:text/javascript;base64,${Buffer.from(code.contents).toString('base64')}`);

/** The text after the shape that begins with `start` is moved; null if it cannot be. */
function moved(name, text, start, by = [1, -2, 0.5]) {
    const edits = formatOf(name).moveShape(text, text.indexOf(start), by);
    return edits && edited(text, edits);
}

const cases = [
    ['a.cgfs', 'sphere { center = (0, -1, 3)  radius = 1 }', 'sphere { center = (1, -3, 3.5)  radius = 1 }'],
    ['a.glint', 'box "b" { min = (0, 0, 0)  max = (1, 1, 1) }', 'box "b" { min = (1, -2, 0.5)  max = (2, -1, 1.5) }'],
    ['a.glint', 'plane { point = (0, 0, 0)  normal = (0, 1, 0) }', 'plane { point = (1, -2, 0.5)  normal = (0, 1, 0) }'],
    ['a.glint', 'triangle { vertices = ((0, 0, 0), (1, 0, 0), (0, 1, 0)) }', 'triangle { vertices = ((1, -2, 0.5), (2, -2, 0.5), (1, -1, 0.5)) }'],
    ['a.glint', 'cone { from = (0, 0, 0)  to = (0, 1, 0)  radius = (1, 0) }', 'cone { from = (1, -2, 0.5)  to = (1, -1, 0.5)  radius = (1, 0) }'],
    ['a.glint', 'sphere { center = (0, 0, 0) radius = 1 scale = (1, 2, 1) }', 'sphere { center = (0, 0, 0) radius = 1 scale = (1, 2, 1)  translate = (1, -2, 0.5) }'],
    ['a.glint', 'sphere { center = (0, 0, 0) scale = 2 translate = (1, 1, 1) radius = 1 }', 'sphere { center = (0, 0, 0) scale = 2 translate = (2, -1, 1.5) radius = 1 }'],
    ['a.glint', 'sphere { scale = 2 translate = (1, 1, 1) rotate = (0, 9, 0) center = (0, 0, 0) radius = 1 }',
     'sphere { scale = 2 translate = (1, 1, 1) rotate = (0, 9, 0)  translate = (1, -2, 0.5) center = (0, 0, 0) radius = 1 }'],
    ['a.json', '{ "center": [0, 0, 1.1], "radius": 1 }', '{ "center": [1, -2, 1.6], "radius": 1 }'],
    ['a.js', '{center: [0, 0, 1.1], normal: [0, 0, 1]}', '{center: [1, -2, 1.6], normal: [0, 0, 1]}'],
    ['a.nff', 's 0 1.5 -2 0.4', 's 1 -0.5 -1.5 0.4'],
    ['a.pov', 'sphere { <0, 1, 2>, 0.5\n  pigment { color rgb <1, 0, 0> }\n}', 'sphere { <1, -1, 2.5>, 0.5\n  pigment { color rgb <1, 0, 0> }\n}'],
    ['a.pov', 'box { <-5, 0, -0.1>, <5, 5, 0.1>\n  pigment { color rgb <0.9, 0.9, 0.9> }\n}', 'box { <-4, -2, 0.4>, <6, 3, 0.6>\n  pigment { color rgb <0.9, 0.9, 0.9> }\n}'],
];
for (const [name, before, after] of cases) {
    test(`${name}: ${before.slice(0, 50)}`, () => {
        assert.equal(moved(name, before, before.slice(0, 3)), after);
        // Between other items, only the shape changes.
        const around = (text) => (name.endsWith('glint') || name.endsWith('cgfs') ? `# a comment\nlight { intensity = 1 }\n${text}\nsphere { center = (9, 9, 9) radius = 1 }\n` : `${text}\n\n${text}\n`);
        assert.equal(moved(name, around(before), before.slice(0, 12)), around(before).replace(before, after));
    });
}

test('shapes whose numbers are not the world’s are not moved', () => {
    const grouped = (keys) => `group "g" { ${keys} sphere { center = (0, 0, 0) radius = 1 } }`;
    assert.equal(moved('a.glint', grouped('rotate = (0, 90, 0)'), 'sphere'), null);
    assert.notEqual(moved('a.glint', grouped('material = gold'), 'sphere'), null);
    assert.equal(moved('a.pov', 'sphere { <0, 1, 2>, 0.5\n  scale 2\n}', 'sphere'), null);
    assert.equal(moved('a.nff', 'p 3\n0 0 0\n1 0 0\n0 1 0', 'p'), null);
});
