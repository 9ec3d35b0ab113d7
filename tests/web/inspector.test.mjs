// SPDX-License-Identifier: Apache-2.0
// The inspector: its numbers add up to the pixel, and its lines lead to the text.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {bothSettled, choose, clickPicture, drop, nativeText, picture, sceneText, settled, withPage} from './browser.mjs';

/** The numbers of a table's row. */
async function numbers(row) {
    return (await row.locator('td').allInnerTexts()).map((text) => Number(text.replace('−', '-')));
}

for (const [scene, x, y] of [['cgfs/three_mirrors.cgfs', 0.5, 0.85], ['glint/glass.glint', 0.25, 0.5], ['epfl/mirror_room.json', 0.3, 0.6]]) {
    test(`a pixel of ${scene} is the sum of its parts`, () => withPage(async (page) => {
        await choose(page, scene);
        await clickPicture(page, x, y);
        const inspector = page.locator('.inspector');
        await inspector.waitFor();
        const [px, py] = (await inspector.getAttribute('data-pixel')).split(',').map(Number);
        const shown = await page.evaluate(([i, j]) => {
            const canvas = document.querySelector('.frame canvas');
            return [...canvas.getContext('2d').getImageData(i, j, 1, 1).data].slice(0, 3);
        }, [px, py]);
        const rows = inspector.locator('.layers tbody tr');
        const sum = [0, 0, 0];
        for (let i = 0; i < await rows.count(); ++i) (await numbers(rows.nth(i))).forEach((value, c) => (sum[c] += value));
        const total = await numbers(inspector.locator('[data-sum]'));
        // The table shows four digits.
        sum.forEach((value, c) => assert.ok(Math.abs(value - total[c]) < 1e-3, `${sum} ${total}`));
        assert.deepEqual(await numbers(inspector.locator('.layers tfoot tr').last()), shown);
        assert.ok(await rows.count() >= 2);
    }));
}

test('the ray tree opens and closes, and its terms lead to their lines', () => withPage(async (page) => {
    await clickPicture(page, 0.5, 0.62);
    await page.locator('.inspector').waitFor();
    const root = page.locator('.ray-node').first();
    assert.ok(await page.locator('.ray-node .ray-node').count() > 0, 'a mirror ray');
    assert.match(await root.locator('> summary').innerText(), /Camera ray hits sphere, line 6/);
    await root.locator('> summary').click();
    assert.equal(await root.getAttribute('open'), null);
    await root.locator('> summary').click();
    await page.locator('.light-terms').first().getByRole('button', {name: 'the light'}).click();
    await page.waitForFunction(() => document.querySelector('.editor').shadowRoot.querySelector('.cm-activeLine').textContent.includes('point'));
    await root.getByRole('button', {name: 'object'}).first().click();
    await page.waitForFunction(() => document.querySelector('.editor').shadowRoot.querySelector('.cm-activeLine').textContent.includes('(255, 0, 0)'));
    assert.ok(await page.locator('.frame .ray.mirror').count() > 0);
    assert.ok(await page.locator('.frame .ray.light').count() > 0);
    const angles = await page.locator('.angles dd').allInnerTexts();
    assert.equal(angles.length, 4);
    angles.forEach((angle) => assert.match(angle, /^\d+\.\d°$/));
}));

test('to point at the picture does not move it', () => withPage(async (page) => {
    await choose(page, 'cgfs/three_mirrors.cgfs');
    await page.locator('.pixel-line.how').waitFor();
    const before = await page.locator('.frame').boundingBox();
    await page.mouse.move(before.x + before.width / 2, before.y + before.height / 2);
    await page.locator('.pixel-line:not(.how)').waitFor();
    assert.deepEqual(await page.locator('.frame').boundingBox(), before);
}));

test('a pixel that is clicked before the picture of a new scene is explained in that picture', () => withPage(async (page) => {
    // The workers get no message until the click is over.
    await page.evaluate(() => {
        const send = Worker.prototype.postMessage, held = [];
        Worker.prototype.postMessage = function (...message) {
            held.push(() => send.apply(this, message));
        };
        globalThis.release = () => {
            Worker.prototype.postMessage = send;
            held.forEach((one) => one());
        };
    });
    await page.getByRole('button', {name: 'Scenes', exact: true}).click();
    await page.locator('[data-scene$="glint/glass.glint"]').click();
    await clickPicture(page, 0.25, 0.35);
    await page.evaluate(() => globalThis.release());
    await page.locator('.inspector').waitFor();
    assert.match(await page.locator('.ray-node > summary').first().innerText(), /Camera ray hits sphere “lens”/);
    assert.equal(await page.getByRole('tab', {name: 'Inspect'}).getAttribute('aria-selected'), 'true');
}));

test('in a comparison, a pixel is explained in the picture it is seen in', () => withPage(async (page) => {
    await page.getByRole('tab', {name: 'Compare'}).click();
    await page.getByRole('button', {name: '0 | 3 reflections'}).click();
    await bothSettled(page);
    const bytes = (index, x, y) => page.evaluate(([i, fx, fy]) => {
        const canvas = document.querySelectorAll('.frame canvas')[i];
        const at = (fraction, size) => Math.floor(fraction * size);
        return [...canvas.getContext('2d').getImageData(at(fx, canvas.width), at(fy, canvas.height), 1, 1).data].slice(0, 3).join(' ');
    }, [index, x, y]);
    for (const [side, x, name] of [[0, 0.2, 'left'], [1, 0.8, 'right']]) {
        const expected = await bytes(side, x, 0.9);
        assert.notEqual(expected, await bytes(1 - side, x, 0.9));
        await clickPicture(page, x, 0.9);
        await page.waitForFunction((words) => document.querySelector('.inspector .mono')?.textContent === words, expected);
        assert.match(await page.locator('.inspector > .note').innerText(), new RegExp(`${name} picture: reflections = ${3 * side}`));
    }
    await page.getByRole('tab', {name: 'Compare'}).click();
    await page.getByRole('button', {name: '0 | 3 reflections'}).click();
    await page.getByRole('textbox', {name: 'Left'}).fill('1');
    await page.getByRole('textbox', {name: 'Right'}).fill('-7');
    await page.getByRole('textbox', {name: 'Right'}).blur();
    await page.waitForFunction(() => /expected a whole number/.test(document.querySelector('[role=alert]')?.textContent));
    assert.match(await page.locator('.tag.right').innerText(), /not rendered/);
    await page.getByRole('textbox', {name: 'Right'}).fill('2');
    await page.getByRole('textbox', {name: 'Right'}).blur();
    await page.waitForFunction(() => !document.querySelector('[role=alert]'));
}));

test('pointing at a pixel says what is there; a changed scene is explained anew', () => withPage(async (page) => {
    const box = await page.locator('.frame').boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.7);
    await page.waitForFunction(() => /sphere, line 6/.test(document.querySelector('.pixel-line').textContent));
    await page.mouse.move(box.x + box.width / 2, box.y + 10);
    await page.waitForFunction(() => /background/.test(document.querySelector('.pixel-line').textContent));
    await clickPicture(page, 0.5, 0.7);
    const sum = page.locator('[data-sum]');
    const before = await sum.innerText();
    await page.getByRole('tab', {name: 'Controls'}).click();
    await page.locator('[data-light="0"]').getByRole('spinbutton', {name: 'Intensity'}).fill('0.4');
    await settled(page);
    await page.getByRole('tab', {name: 'Inspect'}).click();
    await page.waitForFunction((text) => document.querySelector('[data-sum]').innerText !== text, before);
}));

test('the inspector begins with a sentence, and its curves mark the present angle', () => withPage(async (page) => {
    await choose(page, 'cgfs/three_mirrors.cgfs');
    const sentenceAt = async (x, y, pattern) => {
        await clickPicture(page, x, y);
        await page.waitForFunction((source) => new RegExp(source).test(document.querySelector('.sentence')?.textContent), pattern);
    };
    await sentenceAt(0.0508, 0.6342, '^(?=.*green diffuse light)(?=.*% is the sphere on line 9 in the mirror).*\\.$');
    await sentenceAt(0.5, 0.02, '^The ray hits nothing: this is the background\\.$');
    await drop(page, {name: 'plot.glint', text: `render { size = 100 x 100  shading = phong }
camera { position = (0, 0, 6) look_at = (0, 0, 0) }
light { position = (0, 0, 6) }
light "high" { position = (0, 9, 0) }
sphere { center = (0, 0, 0) radius = 2 color = (0, 1, 0) specular_color = (1, 1, 1) shininess = 7 }
sphere "lid" { center = (0, 5, 0.5) radius = 2 }\n`});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'plot.glint');
    await settled(page);
    await sentenceAt(0.502, 0.35, 'green diffuse light.*; the light “high” is blocked by the sphere “lid”');
    const captions = await page.locator('.plot figcaption').allInnerTexts();
    const angles = await page.locator('.angles dd').allInnerTexts();
    assert.equal(captions.length, 2);
    assert.match(captions[1], /\(R·V\)\^7/);
    assert.ok(captions[0].includes(angles[0]) && captions[1].includes(angles[2]), `${captions} ${angles}`);
    assert.equal(await page.locator('.plot .now').count(), 2);
    // At an edge three of four samples see the ball, and the first does not.
    await drop(page, {name: 'edge.glint', text: `render { size = 4 x 4  aa = 2  shading = phong }
camera { projection = orthographic  width = 4  position = (0, 0, 9) look_at = (0, 0, 0) }
light { type = ambient }
box { min = (-0.9, -3, -1) max = (3, 0.4, 1)  color = (1, 0, 0) ambient = 1 }\n`});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'edge.glint');
    await settled(page);
    await sentenceAt(0.375, 0.375, 'red ambient light; the pixel is the mean of 4 samples, which see different things; this is of the box on line 4\\.$');
}));

test('an area light, fog and the light from all directions are explained', () => withPage(async (page) => {
    await drop(page, {name: 'soft.glint', text: `render { size = 100 x 100  shading = phong }
fog { type = exp  color = (0.7, 0.75, 0.8)  density = 0.04 }
occlusion { samples = 16  color = (0.4, 0.4, 0.4) }
camera { position = (0, 0, 6)  look_at = (0, 0, 0)  fov_x = 60 }
light "lamp" { type = parallelogram  position = (0, 0, 6)  side_u = (2, 0, 0)  side_v = (0, 2, 0)  samples_u = 4  samples_v = 3 }
disc "veil" { center = (0, 0, 2)  normal = (0, 0, 1)  radius = 0.5  color = (1, 0, 0)  transmit = 0.5 }
sphere "ball" { center = (0, 0, 0)  radius = 1  color = (0, 1, 0)  emission = 0.3 }\n`});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'soft.glint');
    await settled(page);
    await clickPicture(page, 0.5, 0.5);
    const sentence = page.locator('.sentence');
    await page.waitForFunction(() => /% is the sphere “ball” on line 7 behind the transparent surface/.test(document.querySelector('.sentence')?.textContent));
    assert.match(await sentence.innerText(), /% is the fog’s own light.*% is light from all directions/);
    const rows = await page.locator('.layers tbody th').allInnerTexts();
    assert.deepEqual(rows, ['diffuse', 'transmission', 'sky', 'fog']);
    const [veil, ball] = [0, 1].map((i) => page.locator(`.ray-node[data-ray="${i}"]`));
    assert.match(await veil.locator('> .light-terms > summary').innerText(), /“lamp”: 12 of 12 samples add light/);
    assert.match(await veil.locator('> .why').first().innerText(), /^= weight × .*all diffuse.*sky\).* \+ fog$/);
    assert.match(await ball.locator('> .why').first().innerText(), /emission \+ sky/);
    await ball.locator('> .light-terms > summary').click();
    await ball.locator('> .light-terms > .light-terms > summary').first().click();
    assert.match(await ball.locator('> .light-terms > .light-terms').first().innerText(), /passes\s*disc “veil”, line 6, .* away: times/);
    await clickPicture(page, 0.02, 0.02);
    await page.waitForFunction(() => /hits nothing: this is the fog\.$/.test(document.querySelector('.sentence').textContent));
}));

test('holes of textures and backs of one-sided surfaces are listed before the hit', () => withPage(async (page) => {
    await drop(page, {name: 'holes.glint', text: `render { size = 100 x 100 }
camera { position = (0, 0, 6)  look_at = (0, 0, 0)  fov_x = 60 }
light { type = ambient }
texture leaf { texels = ("10203000 405060ff")  filter = nearest  alpha = mask  mapping = planar  scale = 4  translate = (-1, -2, 0) }
disc "sheet" { center = (0, 0, 2)  normal = (0, 0, 1)  radius = 1  texture = leaf }
disc "back" { center = (0, 0, 1)  normal = (0, 0, -1)  radius = 1  one_sided = true }
sphere "ball" { center = (0, 0, 0)  radius = 0.5  color = (0, 1, 0) }\n`});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'holes.glint');
    await settled(page);
    await clickPicture(page, 0.5, 0.5);
    await page.locator('.ray-node[data-ray="0"] > .term').first().waitFor();
    const lines = (await page.locator('.ray-node[data-ray="0"] > .term').allInnerTexts()).map((line) => line.replace(/\s+/g, ' '));
    assert.match(lines[0], /^passes t = 4(\.\d+)?, a hole of its texture: alpha 0 disc “sheet”, line 5$/);
    assert.match(lines[1], /^passes t = 5(\.\d+)?, its back: the material is one-sided disc “back”, line 6$/);
    assert.match(lines[2], /^object .*sphere “ball”, line 7$/);
}));

test('the object that is clicked has controls, which change its numbers in the text', () => withPage(async (page) => {
    const text = `render { size = 100 x 100 }
camera { position = (0, 0, 6) look_at = (0, 0, 0) }
light { position = (0, 0, 6) }
material red { color = rgb255(200, 30, 20)  shininess = 7 }
sphere "ball" { center = (0, 0, 0)  radius = 2  material = red }\n`;
    await drop(page, {name: 'object.glint', text});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'object.glint');
    await settled(page);
    await clickPicture(page, 0.5, 0.5);
    const controls = page.locator('.object-controls');
    await controls.getByRole('spinbutton', {name: 'sphere: radius'}).fill('1.5');
    await settled(page);
    await controls.getByRole('spinbutton', {name: 'material red: color 2'}).fill('90');
    await settled(page);
    const now = text.replace('radius = 2', 'radius = 1.5').replace('200, 30, 20', '200, 90, 20');
    assert.equal(await sceneText(page), now);
    assert.deepEqual(await picture(page), nativeText('object.glint', now));
}));
