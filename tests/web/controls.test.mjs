// SPDX-License-Identifier: Apache-2.0
// The controls: each edits its value in the text or the overrides, and the picture equals the native one.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {book, bothSettled, choose, drop, native, nativeText, paste, picture, sceneText, scenes, settled, testOnOnePage, withPage} from './browser.mjs';

const still = readFileSync(join(scenes, 'glint/still_life.glint'), 'utf8').replace('640 x 480  aa = 2', '120 x 90  aa = 1');

/** Sets a slider, as dragging it does. */
async function slide(page, slider, value) {
    await slider.evaluate((input, to) => {
        input.value = to;
        input.dispatchEvent(new Event('input', {bubbles: true}));
        input.dispatchEvent(new Event('change', {bubbles: true}));
    }, String(value));
}

const flip = (page, label) => page.getByRole('switch', {name: label, exact: true}).click({force: true});

/** The control and its effect on the text of `still`; nothing else may change. */
const edits = [
    ['shading', (page) => page.getByRole('combobox', {name: 'Shading'}).selectOption('normals'), / shading = normals /, null],
    ['reflections', (page) => slide(page, page.getByRole('slider', {name: 'Reflections'}), 2), /reflections = 2 /, /reflections = 5 /],
    ['samples', (page) => slide(page, page.getByRole('slider', {name: 'Samples'}), 2), / aa = 2 /, / aa = 1 /],
    ['jittered samples', async (page) => {
        await slide(page, page.getByRole('slider', {name: 'Samples'}), 2);
        await settled(page);
        await flip(page, 'Jittered');
    }, / aa = "2:jitter" /, / aa = 1 /, 2],
    ['adaptive samples', async (page) => {
        await slide(page, page.getByRole('slider', {name: 'Samples'}), 2);
        await settled(page);
        await flip(page, 'Only at edges');
    }, / aa = "adaptive:2:0\.05" /, / aa = 1 /, 2],
    ['fog', (page) => flip(page, 'In fog'), /^fog { type = exp  color = \(0\.7, 0\.75, 0\.8\)  density = 0\.\d+ }$/m, null],
    ['size', (page) => page.getByRole('spinbutton', {name: 'Width'}).fill('100'), /size = 100 x 90/, /size = 120 x 90/],
    ['shadows', (page) => flip(page, 'Shadows'), / shadows = false /, null],
    ['a light off', (page) => page.locator('[data-light="1"]').getByRole('switch', {name: 'lamp', exact: true}).click({force: true}), /"lamp" .* intensity = 0 /, /intensity = 1\.2 /],
    ['intensity', (page) => slide(page, page.locator('[data-light="1"]').getByRole('slider', {name: 'Intensity'}), 0.5), /intensity = 0\.5 /, /intensity = 1\.2 /],
    ['an intensity that was not said', (page) => slide(page, page.locator('[data-light="0"]').getByRole('slider', {name: 'Intensity'}), 0.25), /type = ambient  intensity = 0\.25 /, null],
    ['position', (page) => page.locator('[data-light="1"]').getByRole('spinbutton', {name: 'Position y'}).fill('2.5'), /position = \(3\.5, 2\.5, 4\)/, /position = \(3\.5, 5, 4\)/],
    ['direction', (page) => page.locator('[data-light="2"]').getByRole('spinbutton', {name: 'Direction x'}).fill('1'), /to_light = \(1, 3, 2\)/, /to_light = \(-3, 3, 2\)/],
    ['attenuation', (page) => page.locator('[data-light="1"]').getByRole('spinbutton', {name: 'Attenuation c2'}).fill('0.05'), /"lamp" .* attenuation = \(1, 0, 0\.05\) /, null],
    ['epsilon', (page) => page.getByRole('spinbutton', {name: 'Epsilon'}).fill('0.25'), /conventions { epsilon = 0\.25 }/, null],
    ['no epsilon', (page) => flip(page, 'No epsilon'), /conventions { epsilon = 0 }/, null],
    ['N·L not clamped', (page) => flip(page, 'N·L not clamped'), /conventions { clamp_cosines = false }/, null],
    ['no normalisation', (page) => flip(page, 'No normalisation'), /conventions { normalize = false }/, null],
    ['specular without gate', (page) => flip(page, 'Specular without gate'), /conventions { specular_gate = false }/, null],
    ['shadows from beyond the light', (page) => flip(page, 'Shadows from beyond the light'), /conventions { shadow_stops_at_light = false }/, null],
    ['a convention', async (page) => {
        await page.getByText('Conventions', {exact: true}).click();
        await page.getByRole('combobox', {name: 'mirror', exact: true}).selectOption('add');
    }, /conventions { mirror = add }/, null],
];

testOnOnePage('a control edits the text, and undo takes it back', edits, async (page, name, act, now, then, steps = 1) => {
    const file = `still_${edits.findIndex((one) => one[0] === name)}.glint`;
    await drop(page, {name: file, text: still});
    await page.waitForFunction((wanted) => document.querySelector('.file-name').textContent === wanted, file);
    await settled(page);
    const before = await picture(page);
    await act(page);
    await settled(page);
    const text = await sceneText(page);
    assert.match(text, now);
    if (then) assert.doesNotMatch(text, then);
    assert.deepEqual(await picture(page), nativeText(file, text));
    assert.equal(await page.locator('.outside').count(), 0);
    // Two steps in quick succession are undone together.
    for (let i = 0; i < steps && await sceneText(page) !== still; ++i) await page.getByRole('button', {name: 'Undo'}).click();
    await settled(page);
    assert.equal(await sceneText(page), still);
    assert.deepEqual(await picture(page), before);
});

test('fog is changed in its block, and taken away', () => withPage(async (page) => {
    await drop(page, {name: 'still.glint', text: still});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'still.glint');
    await settled(page);
    await flip(page, 'In fog');
    await settled(page);
    await page.getByRole('combobox', {name: 'Kind of fog'}).selectOption('linear');
    await settled(page);
    await page.getByRole('spinbutton', {name: 'Fog end'}).fill('12');
    await settled(page);
    const text = await sceneText(page);
    assert.match(text, /^fog { type = linear .* end = 12 }$/m);
    assert.deepEqual(await picture(page), nativeText('still.glint', text));
    await flip(page, 'In fog');
    await settled(page);
    assert.equal(await sceneText(page), still);
}));

test('a transparent background has the file’s alpha', () => withPage(async (page) => {
    await drop(page, {name: 'still.glint', text: still});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'still.glint');
    await settled(page);
    await flip(page, 'Transparent background');
    await settled(page);
    assert.match(await sceneText(page), / alpha = true /);
    const alphas = await page.locator('.frame canvas').first().evaluate((canvas) => {
        const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        return [...new Set(data.filter((_, i) => i % 4 === 3))].sort((a, b) => a - b);
    });
    assert.equal(alphas[0], 0);
    assert.equal(alphas.at(-1), 255);
}));

test('a fault that is taken back is as it was', () => withPage(async (page) => {
    await drop(page, {name: 'still.glint', text: still});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'still.glint');
    await settled(page);
    const before = await picture(page);
    await flip(page, 'No epsilon');
    await settled(page);
    assert.notDeepEqual(await picture(page), before);
    await flip(page, 'No epsilon');
    await settled(page);
    assert.deepEqual(await picture(page), before);
}));

test('a light that was off is as bright again', () => withPage(async (page) => {
    const light = page.locator('[data-light="1"]').getByRole('switch').first();
    await light.click({force: true});
    await settled(page);
    assert.match(await sceneText(page), /type = point {8}intensity = 0 /);
    await light.click({force: true});
    await settled(page);
    assert.equal(await sceneText(page), book);
}));

test('what is dragged is undone at once', () => withPage(async (page) => {
    const undo = page.getByRole('button', {name: 'Undo'});
    const slider = page.locator('[data-light="1"]').getByRole('slider', {name: 'Position x'});
    await slider.evaluate(async (input) => {
        for (let i = 1; i <= 20; ++i) {
            input.value = String(2 + i / 10);
            input.dispatchEvent(new Event('input', {bubbles: true}));
            await new Promise((next) => setTimeout(next, i === 10 ? 700 : 20));  // once, the hand rests
        }
    });
    await settled(page);
    assert.equal(await sceneText(page), book.replace('(2, 1, 0)', '(4, 1, 0)'));
    await undo.click();
    assert.equal(await sceneText(page), book);
    const box = await page.locator('.frame').boundingBox();
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    for (let i = 1; i <= 10; ++i) {
        await page.mouse.move(box.x + 200 + 8 * i, box.y + 200);
        if (i === 5) await page.waitForTimeout(700);
    }
    await page.mouse.up();
    await settled(page);
    assert.match(await sceneText(page), /^camera {/m);
    await undo.click();
    assert.equal(await sceneText(page), book);
    assert.ok(await undo.isDisabled());
}));

test('while the text has a mistake, a light’s control still finds its light', () => withPage(async (page) => {
    for (const scene of ['cgfs/three_mirrors.cgfs', 'nff/pyramid.nff']) {
        await choose(page, scene);
        const before = await sceneText(page);
        await page.locator('.cm-content').click();
        await page.keyboard.press('Control+Home');
        await page.keyboard.type('oops 1 2\n');
        await settled(page, 'error');
        await page.locator('[data-light="1"]').getByRole('spinbutton', {name: 'Intensity'}).fill('0.75');
        const line = before.split('\n').filter((one) => /^(light|l) /.test(one))[1];
        const expected = scene.endsWith('nff') ? 'l 6 3 3 0.75 0.375 0.3' : line.replace('0.6', '0.75');
        assert.equal(await sceneText(page), `oops 1 2\n${before.replace(line, expected)}`);
        await page.locator('[data-light="1"]').getByRole('button', {name: /^line/}).click();
        await page.waitForFunction((words) => document.querySelector('.editor').shadowRoot.querySelector('.cm-activeLine').textContent === words, expected);
    }
    // Deleted items cannot be changed.
    await paste(page, 'nothing of it is left');
    await settled(page, 'error');
    assert.equal(await page.locator('[data-light="1"] input:enabled').count(), 0);
}));

const lights = [
    ['epfl/three_lights.json', 1, /"position": \[-3.4, 1, 3.4\], "color": \[0.5, 0.03125, 0.01875\]/],
    ['csc473/glass_ball.pov', 1, /light_source { <-12, 1, 14> color rgb <0.5, 0.47727, 0.43182> }/],
    ['nff/pyramid.nff', 0, /^l 3 1 6 0.5 0.5 0.44444$/m],
    ['snowman', 1, /position: \[6, 1, 9\], color: \[0.5, 0.425, 0.35\]/],
];
testOnOnePage('a light', lights, async (page, scene, index, expected) => {
    await choose(page, scene);
    const fields = page.locator(`[data-light="${index}"]`);
    await fields.getByRole('spinbutton', {name: 'Intensity'}).fill('0.5');
    await settled(page);
    await fields.getByRole('spinbutton', {name: 'Position y'}).fill('1');
    await settled(page);
    assert.match(await sceneText(page), expected);
    assert.equal(await page.locator('.message.error').count(), 0);
});

test('comparing: two renderings with a border between them, and their difference', () => withPage(async (page) => {
    await page.getByRole('tab', {name: 'Compare'}).click();
    await page.getByRole('button', {name: '0 | 3 reflections'}).click();
    await bothSettled(page);
    const mirrors = join(scenes, 'cgfs/three_mirrors.cgfs');
    assert.deepEqual(await picture(page, 0), native(mirrors, '--reflections', '0'));
    assert.deepEqual(await picture(page, 1), native(mirrors, '--reflections', '3'));
    const border = page.getByRole('slider', {name: 'Border between the pictures'});
    const box = await page.locator('.frame').boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + 100);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 4, box.y + 100, {steps: 4});
    await page.mouse.up();
    assert.ok(Math.abs(Number(await border.getAttribute('aria-valuenow')) - 25) <= 1);
    assert.match(await page.locator('.right-half').evaluate((half) => half.style.clipPath), /25(\.\d+)?%/);
    await page.getByRole('switch', {name: 'Show the difference'}).click({force: true});
    await page.waitForFunction(() => /differ/.test(document.querySelector('.figures')?.textContent));
    assert.match(await page.locator('.figures').innerText(), /^[1-9][\d.]*% of the pixels differ, by at most \d+ of 255/);
    await page.getByRole('button', {name: 'End the comparison'}).click();
    await settled(page);
    assert.deepEqual(await picture(page), native(mirrors));
}));
