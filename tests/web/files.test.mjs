// SPDX-License-Identifier: Apache-2.0
// Files that the user gives: all missing texts at once, folders, .zip files, one line of JSON; and scenes that storage does not hold.
import assert from 'node:assert/strict';
import {mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {test} from 'node:test';

import {address, choose, clickPicture, drop, native, nativeText, paste, picture, sceneText, scenes, settled, shoot, withPage} from './browser.mjs';
import {pageModule} from './page_module.mjs';

const {zipSync} = createRequire(new URL('../../web/package.json', import.meta.url))('fflate');

const named = (page, name) => page.waitForFunction((wanted) => document.querySelector('.file-name').textContent === wanted, name);

/** A scene of several texts in folders, as people keep them. */
const project = {
    'tower/main.pov': `#include "colors.inc"
#include "parts/ball.inc"
#include "parts/lights.inc"
camera { location -6*z look_at 0 angle 40 }
Ball(0)
`,
    'tower/parts/ball.inc': '#include "common/paint.inc"\n#macro Ball(X) sphere { <X, 0, 0>, 1 pigment { Paint } } #end\n',
    'tower/parts/lights.inc': 'light_source { <5, 6, -8>, rgb 1 }\n',
    'tower/common/paint.inc': '#declare Paint = color rgb <0.9, 0.3, 0.1>;\n',
    'tower/other.pov': 'camera { location -5*z look_at 0 }\nlight_source { <5, 6, -8>, rgb 1 }\nbox { -1, 1 pigment { rgb 1 } }\n',
    'tower/notes.txt': 'nothing for glint',
};

function inFolder(files, use) {
    const folder = mkdtempSync(join(tmpdir(), 'glint-files-'));
    for (const [name, text] of Object.entries(files)) {
        mkdirSync(dirname(join(folder, name)), {recursive: true});
        writeFileSync(join(folder, name), text);
    }
    return Promise.resolve(use(folder)).finally(() => rmSync(folder, {recursive: true}));
}

test('missing texts are asked for at once, and none that glint has of its own', () => withPage((page) => inFolder(project, async (folder) => {
    await drop(page, {name: 'main.pov', text: project['tower/main.pov']});
    await named(page, 'main.pov');
    await settled(page, 'error');
    const asked = page.locator('.messages p').first();
    assert.match(await asked.innerText(), /^parts\/ball\.inc, parts\/lights\.inc are not here\. Drop them/);
    await page.locator('.messages').getByLabel('choose a folder…').setInputFiles(join(folder, 'tower'));
    await settled(page);
    assert.equal(await sceneText(page), project['tower/main.pov']);
    assert.deepEqual(await picture(page), native(join(folder, 'tower/main.pov')));
})));

test('a .zip is opened: the scene that no other one includes, and a menu of the others', () => withPage((page) => inFolder(project, async (folder) => {
    const zip = zipSync(Object.fromEntries(Object.entries(project).map(([name, text]) => [name, new TextEncoder().encode(text)])));
    await drop(page, {name: 'tower.zip', text: Buffer.from(zip)});
    await named(page, 'main.pov');
    await settled(page);
    assert.deepEqual(await picture(page), native(join(folder, 'tower/main.pov')));
    assert.match(await page.locator('.notice').innerText(), /main\.pov is opened, one of 2 scenes here/);
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+Home');
    await page.keyboard.type('// mine\n');
    const files = page.getByRole('combobox', {name: 'File', exact: true});
    await files.selectOption('tower/other.pov');
    await named(page, 'other.pov');
    await settled(page);
    assert.deepEqual(await picture(page), native(join(folder, 'tower/other.pov')));
    await files.selectOption('tower/main.pov');
    await named(page, 'main.pov');
    await settled(page);
    assert.equal(await sceneText(page), `// mine\n${project['tower/main.pov']}`);
    await drop(page, {name: 'broken.zip', text: 'no archive'});
    await page.locator('.notice').getByText('broken.zip is not opened').waitFor();
})));

/** A binary .ply file: a fan of triangles. */
function fan(count = 12) {
    const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${count + 1}\nproperty float x\nproperty float y\nproperty float z\nelement face ${count - 1}\nproperty list uchar int vertex_indices\nend_header\n`;
    const points = Array.from({length: count}, (_, i) => [Math.cos(i / 2), Math.sin(i / 2), i / 9]);
    const vertices = Buffer.from(new Float32Array([[0, 0, 1], ...points].flat()).buffer);
    const faces = Array.from({length: count - 1}, (_, i) => {
        const face = Buffer.alloc(13, 3);
        [0, i + 1, i + 2].forEach((v, k) => face.writeInt32LE(v, 1 + 4 * k));
        return face;
    });
    return Buffer.concat([Buffer.from(header), vertices, ...faces]);
}

test('a .ply is opened as a scene that refers to it, and scenes find theirs', () => withPage((page) => inFolder({'fan.ply': fan(), 'two/a.glint': `camera { position = (0, 1, 8)  look_at = (0, 0, 0)  fov_x = 40 }
light { type = point  position = (3, 4, 6) }
mesh { file = "fan.ply" }
`, 'two/fan.ply': fan()}, async (folder) => {
    await drop(page, {name: 'fan.ply', text: fan()});
    await named(page, 'fan.glint');
    await settled(page);
    assert.match(await sceneText(page), /mesh \{ file = "fan\.ply" \}/);
    assert.deepEqual(await picture(page), native(join(folder, 'fan.ply')));
    await shoot(page, 'mesh.png');
    await drop(page, {name: 'bad.ply', text: 'ply\nformat ascii 1.0\nend_header\n'});
    await page.locator('.notice').getByText('bad.ply is not opened').waitFor();
    await drop(page, {name: 'a.glint', text: readFileSync(join(folder, 'two/a.glint'), 'utf8')});
    await named(page, 'a.glint');
    await settled(page, 'error');
    await page.locator('.messages').getByLabel('choose a folder…').setInputFiles(join(folder, 'two'));
    await settled(page);
    assert.deepEqual(await picture(page), native(join(folder, 'two/a.glint')));
})));

/** A P6 of 2 x 2 texels. */
const texels = Buffer.concat([Buffer.from('P6 2 2 255\n'), Buffer.from([255, 0, 0, 255, 255, 255, 255, 255, 255, 0, 0, 255])]);
const textured = {
    'room/a.glint': `camera { position = (0, 1, 8)  look_at = (0, 0, 0)  fov_x = 40 }
light { type = ambient }
render { size = 80 x 60 }
texture board { file = "pictures/board.ppm"  mapping = planar }
sphere { center = (0, 0, 0)  radius = 2  texture = board }
`,
    'room/pictures/board.ppm': texels,
    'room/b.obj': 'mtllib b.mtl\nv -1 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl m\nf 1/1 2/2 3/3\n',
    'room/b.mtl': 'newmtl m\nmap_Kd -s 2 2 1 -clamp off pictures/board.ppm\n',
};

test('a scene finds the pictures of its textures: in its folder, or dropped when it lacks them', () => withPage((page) => inFolder(textured, async (folder) => {
    await drop(page, {name: 'a.glint', text: textured['room/a.glint']});
    await named(page, 'a.glint');
    await settled(page, 'error');
    assert.match(await page.locator('.messages p').first().innerText(), /pictures\/board\.ppm is not here/);
    await drop(page, {name: 'board.ppm', text: texels});
    await settled(page);
    assert.deepEqual(await picture(page), native(join(folder, 'room/a.glint')));
})));

test('an .obj in a .zip has its .mtl and its pictures', () => withPage((page) => inFolder(textured, async (folder) => {
    const some = Object.entries(textured).filter(([name]) => !name.endsWith('.glint'));
    await drop(page, {name: 'room.zip', text: Buffer.from(zipSync(Object.fromEntries(some.map(([name, text]) => [name, new Uint8Array(Buffer.from(text))]))))});
    await named(page, 'b.glint');
    await settled(page);
    writeFileSync(join(folder, 'room/b.glint'), await sceneText(page));
    assert.deepEqual(await picture(page), native(join(folder, 'room/b.glint')));
    assert.match(await sceneText(page), /texture/);
})));

test('the page says how much of a large file is read', () => withPage(async (page) => {
    await page.evaluate(() => {
        window.said = [];
        const note = () => {
            for (const one of document.querySelectorAll('.notice, [data-state]')) window.said.push(one.textContent);
        };
        new MutationObserver(note).observe(document.body, {subtree: true, childList: true, characterData: true});
    });
    await drop(page, {name: 'fan.ply', text: fan(600_000)});
    await named(page, 'fan.glint');
    await settled(page);
    const said = await page.evaluate(() => window.said);
    const parts = said.map((text) => /^Reading fan\.ply: (\d+)%/.exec(text)?.[1]).filter(Boolean).map(Number);
    assert.ok(parts.length > 0 && parts.every((part, i) => i === 0 || part >= parts[i - 1]), parts.join(' '));
    assert.ok(said.some((text) => /^reading · \d+%$/.test(text)));
    assert.ok(!/Reading/.test((await page.locator('.notice').allInnerTexts()).join()));
}));

test('a shape of an included text names that text, which opens and can be changed', () => withPage(async (page) => {
    const text = 'include "parts/ball.glint"\nrender { size = 80 x 60 }\ncamera { position = (0, 0, 6)  look_at = (0, 0, 0) }\nlight { type = ambient  intensity = 1 }\n';
    const ball = '# the ball\nsphere { center = (0, 0, 0)  radius = 2  color = (0.8, 0.2, 0.1) }\n';
    await drop(page, {name: 'main.glint', text}, {name: 'ball.glint', text: ball});
    await named(page, 'main.glint');
    await settled(page);
    await page.getByRole('tab', {name: 'Inspect'}).click();
    await clickPicture(page, 0.5, 0.5);
    const link = page.locator('.pixel-line .link');
    assert.equal(await link.innerText(), 'sphere, line 2 of parts/ball.glint');
    await link.click();
    const isColored = (most) => page.waitForFunction((c) => {
        const {data} = document.querySelector('.frame canvas').getContext('2d').getImageData(40, 30, 1, 1);
        return data[c] > 2 * data[2 - c];
    }, most);
    const area = page.getByRole('textbox', {name: 'Text of parts/ball.glint'});
    assert.equal(await area.inputValue(), ball);
    assert.equal(await area.evaluate((one) => one.value.slice(one.selectionStart, one.selectionEnd)), ball.split('\n')[1]);
    await shoot(page, 'included.png');
    await area.fill(ball.replace('0.8, 0.2, 0.1', '0.1, 0.2, 0.8'));
    await settled(page);
    await isColored(2);
    await page.getByRole('button', {name: 'Back to the scene’s text'}).click();
    await page.getByRole('button', {name: 'Undo'}).click();
    await isColored(0);
    assert.equal(await sceneText(page), text);
    // Another scene does not have it.
    await link.click();
    await area.waitFor();
    await choose(page, 'cgfs/three_mirrors.cgfs');
    await area.waitFor({state: 'detached'});
    await page.locator('.cm-content').waitFor();
}));

test('one line of JSON of any length is opened, by file and by pasting', () => withPage(async (page) => {
    const castle = JSON.parse(readFileSync(join(scenes, 'epfl/castle.json'), 'utf8'));
    castle.objects ??= [];
    const line = JSON.stringify({...castle, note: Array(9000).fill(1.25)});
    assert.ok(line.length > 40_000);
    await drop(page, {name: 'line.json', text: line});
    await named(page, 'line.json');
    await settled(page);
    assert.match(await page.locator('.notice').innerText(), /line of more than 20000 characters.*the scene is the same/);
    const text = await sceneText(page);
    assert.ok(Math.max(...text.split('\n').map((one) => one.length)) < 200);
    assert.equal(JSON.stringify(JSON.parse(text)), line);
    assert.deepEqual(await picture(page), nativeText('line.json', line));
    await page.locator('.cm-content').click();
    await paste(page, line);
    await settled(page);
    assert.equal(await sceneText(page), text);
}));

test('lines are divided only where the meaning stays', async () => {
    const {withShortLines} = await pageModule('text/long_lines.ts');
    const long = `'${'x'.repeat(20_000)}'`;
    const data = `scenes = [{name: 'a, {b', // c, {d\n s: ${long}, t: [1,2]}, /* e, [ */ {name: "f\\"}"}]`;
    const out = withShortLines('a.js', data);
    assert.notEqual(out, data);
    for (const kept of ["'a, {b'", '// c, {d\n', long, '/* e, [ */', '"f\\"}"']) assert.ok(out.includes(kept), kept);
    const bare = (text) => text.replaceAll(/\s/g, '');
    assert.equal(bare(out), bare(data));
    assert.equal(withShortLines('a.glint', long), long);
    assert.equal(withShortLines('a.json', '{"short": 1}'), '{"short": 1}');
});

/** A scene of more characters than storage holds. */
const large = `render { size = 40 x 30 }\ncamera { position = (0, 0, -5)  look_at = (0, 0, 0) }\n${`# ${'-'.repeat(198)}\n`.repeat(14_000)}light { type = ambient  intensity = 1 }\nsphere { center = (0, 0, 3)  radius = 1 }\n`;

test('a scene larger than storage comes back after a reload, and is among the recent ones', () => withPage(async (page) => {
    await drop(page, {name: 'large.glint', text: large});
    await named(page, 'large.glint');
    await settled(page);
    await page.waitForFunction(() => sessionStorage.getItem('glint.page')?.includes('"large"'));
    assert.equal(await page.locator('.notice').count(), 0);
    await page.reload();
    await settled(page);
    await named(page, 'large.glint');
    assert.equal((await sceneText(page)).length, large.length);
    await drop(page, {name: 'small.glint', text: 'render { size = 20 x 20 }\ncamera { position = (0, 0, -5)  look_at = (0, 0, 0) }\n'});
    await named(page, 'small.glint');
    await page.waitForFunction(() => localStorage.getItem('glint.recent')?.includes('large.glint'));
    await page.goto(address);
    await settled(page);
    await page.getByRole('button', {name: 'Scenes', exact: true}).click();
    await page.locator('.recent').getByText('large.glint').click();
    await named(page, 'large.glint');
    await settled(page);
    assert.equal((await sceneText(page)).length, large.length);
}));

test('without room the page says that a reload would lose the scene', () => withPage(async (page) => {
    await page.addInitScript(() => {
        indexedDB.open = () => {
            throw new Error('forbidden');
        };
    });
    await page.reload();
    await settled(page);
    await drop(page, {name: 'large.glint', text: large});
    await page.locator('.notice').getByText(/no room for this scene \(2\.\d MB\): a reload would lose your changes\. Save scene/).waitFor();
}));
