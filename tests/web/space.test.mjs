// SPDX-License-Identifier: Apache-2.0
// The view in space: it shows the scene that is open, turns, and moves lights and shapes in the text; stepping through the rays.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {choose, clickPicture, drop, nativeText, picture, sceneText, settled, until, withPage} from './browser.mjs';

/** Waits until the view shows the scene, and returns the middles of its red and its green, in its fractions. */
async function redAndGreen(page) {
    const at = () => page.evaluate(() => {
        const canvas = document.querySelector('.space-frame canvas');
        if (!canvas?.width) return null;
        const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
        copy.drawImage(canvas, 0, 0);
        const {data} = copy.getImageData(0, 0, canvas.width, canvas.height);
        const sum = [[0, 0], [0, 0]], count = [0, 0];
        for (let i = 0; i < data.length; i += 4) {
            const which = data[i] > 2 * data[i + 1] ? 0 : data[i + 1] > 2 * data[i] ? 1 : -1;
            if (which < 0) continue;
            sum[which][0] += ((i / 4) % canvas.width) / canvas.width;
            sum[which][1] += Math.floor(i / 4 / canvas.width) / canvas.height;
            ++count[which];
        }
        return Math.min(...count) > 20 ? sum.map((one, k) => one.map((c) => c / count[k])) : null;
    });
    let seen = null;
    const isSame = (next) => {
        const same = next !== null && JSON.stringify(next) === JSON.stringify(seen);
        seen = next;
        return same;
    };
    assert.ok(await until(at, isSame), 'the view shows both balls');
    return seen;
}

async function open(page, name, text) {
    await drop(page, {name, text});
    await page.waitForFunction((wanted) => document.querySelector('.file-name').textContent === wanted, name);
    await settled(page);
}

const leftHanded = `
sphere { center = (-1, 0, 5) radius = 1 color = (255, 0, 0) }
sphere { center = (1.5, 0, 5) radius = 1 color = (0, 255, 0) }
light { type = ambient intensity = 1 }
light { type = point intensity = 0.1 position = (2, 2, 1) }
`;
const rightHanded = `render { size = 200 x 200 }
camera { position = (5, 0, 0)  look_at = (0, 0, 0)  up = (0, 0, 1) }
sphere { center = (0, -1, 0)  radius = 1  color = (1, 0, 0)  ambient = 1 }
sphere "ball" { center = (0, 1.5, 0)  radius = 1  color = (0, 1, 0)  ambient = 1 }
light { type = ambient  intensity = 1 }
light "lamp" { type = point  intensity = 0.1  position = (4, 2, 2) }
`;

test('what is at the right is at the right, and the camera looks upwards in the view', () => withPage(async (page) => {
    for (const [name, text] of [['left.cgfs', leftHanded], ['right.glint', rightHanded]]) {
        await open(page, name, text);
        await clickPicture(page, 0.4, 0.5);
        await page.locator('.inspector .space-frame').waitFor();
        await page.locator('.space-body').scrollIntoViewIfNeeded();
        const [red, green] = await redAndGreen(page);
        assert.ok(red[0] + 0.06 < green[0], `${name}: red at ${red}, green at ${green}`);
        const x = (line, end) => line.getAttribute(`x${end}`).then(Number), y = (line, end) => line.getAttribute(`y${end}`).then(Number);
        const toLight = page.locator('.space-frame .ray.light');
        assert.ok(await x(toLight.last(), 2) > await x(toLight.first(), 1) + 10, name);
        const ray = page.locator('.space-frame .ray.camera');
        assert.ok(await y(ray.last(), 2) < await y(ray.first(), 1) - 10, name);
        assert.equal(await page.locator('.space-frame .frustum').count() >= 8, true);
    }
}));

test('lights and shapes are moved by pointer and keys, each move one change of the text', () => withPage(async (page) => {
    await open(page, 'right.glint', rightHanded);
    await page.getByRole('tab', {name: 'Inspect'}).click();
    const [, green] = await redAndGreen(page);
    const body = page.locator('.space-body');
    await page.locator('.space-frame').waitFor();
    await body.scrollIntoViewIfNeeded();
    const box = await body.boundingBox();
    // The light, slowly: the history would take moves half a second apart as two.
    const lamp = page.getByRole('button', {name: 'Move point light “lamp”, line 6'});
    const from = await lamp.boundingBox();
    await page.mouse.move(from.x + 14, from.y + 14);
    await page.mouse.down();
    await page.mouse.move(from.x, from.y + 24, {steps: 3});
    await settled(page);
    await page.waitForTimeout(700);
    await page.mouse.move(from.x - 16, from.y + 34, {steps: 3});
    await page.mouse.up();
    await settled(page);
    const lit = await sceneText(page);
    assert.notEqual(lit, rightHanded);
    assert.equal(lit.replace(/position = \([^()]*\)\n?(?= })/g, ''), rightHanded.replace(/position = \([^()]*\)\n?(?= })/g, ''), 'nothing else changes');
    assert.deepEqual(await picture(page), nativeText('right.glint', lit));
    const after = await lamp.boundingBox();
    assert.ok(Math.abs(after.x - from.x + 30) < 2 && Math.abs(after.y - from.y - 20) < 2, 'the light is where it was dragged to');
    // A shape: clicked, then moved by keys; held down, they are one change.
    await page.mouse.click(box.x + green[0] * box.width, box.y + green[1] * box.height);
    const ball = page.getByRole('button', {name: 'Move sphere “ball”, line 4'});
    await ball.focus();
    await page.keyboard.down('ArrowRight');
    await page.keyboard.down('ArrowRight');
    await page.keyboard.down('PageUp');
    await page.keyboard.up('ArrowRight');
    await settled(page);
    const moved = await sceneText(page);
    assert.notEqual(moved, lit);
    assert.equal(moved.replace(/(?<="ball" { center = )\([^()]*\)/, ''), lit.replace(/(?<="ball" { center = )\([^()]*\)/, ''));
    assert.deepEqual(await picture(page), nativeText('right.glint', moved));
    const undo = page.getByRole('button', {name: 'Undo'});
    await undo.click();
    assert.equal(await sceneText(page), lit);
    await undo.click();
    assert.equal(await sceneText(page), rightHanded);
    // Turned and zoomed by keys; large, and back.
    await settled(page);
    const frame = page.locator('.space-frame');
    const edge = () => frame.locator('.frustum').first().getAttribute('x1');
    for (const key of ['ArrowLeft', 'Shift+ArrowUp', '+']) {
        const before = await frame.innerHTML();
        await frame.focus();
        await page.keyboard.press(key);
        await page.waitForFunction((old) => document.querySelector('.space-frame').innerHTML !== old, before);
    }
    const turned = await edge();
    await page.getByRole('button', {name: 'Large'}).click();
    await page.locator('.stage > .space .space-frame').waitFor();
    assert.ok((await body.boundingBox()).width > 1.3 * box.width);
    await page.keyboard.press('Escape');
    await page.locator('.inspector, .empty').locator('.space-frame').waitFor();
    await page.waitForFunction((old) => document.querySelector('.space-frame .frustum')?.getAttribute('x1') === old, turned);
    // A shape that a group moves cannot be moved in its own numbers.
    const grouped = rightHanded.replace(/sphere "ball".*\n/, (line) => `group { translate = (0, 0, 0)\n${line}}\n`);
    await open(page, 'grouped.glint', grouped);
    await page.getByRole('button', {name: 'Reset the view'}).click();
    const [, again] = await redAndGreen(page);
    const now = await body.boundingBox();
    await page.mouse.click(now.x + again[0] * now.width, now.y + again[1] * now.height);
    await page.getByRole('button', {name: 'Move sphere “ball”'}).press('ArrowLeft');
    await page.locator('.notice').getByText('cannot be moved').waitFor();
    assert.equal(await sceneText(page), grouped);
}));

test('stepping goes through the rays, and the sum grows to the pixel', () => withPage(async (page) => {
    await clickPicture(page, 0.0508, 0.6342);
    const stepper = page.locator('.stepper');
    await stepper.waitFor();
    const sum = async () => (await page.locator('.growing').getAttribute('data-sum-so-far')).split(' ').map(Number);
    const total = (await page.locator('[data-sum] td').allInnerTexts()).map(Number);
    const isTotal = (now) => now.every((value, c) => Math.abs(value - total[c]) < 1e-3);
    assert.ok(isTotal(await sum()));
    const sums = [];
    await stepper.getByRole('button', {name: 'Next ray'}).click();
    for (;;) {
        sums.push(await sum());
        const words = await stepper.locator('p').innerText();
        const [, at, count] = /^Ray (\d+) of (\d+)/.exec(words);
        assert.equal(Number(at), sums.length);
        assert.equal(await page.locator('.tree summary[aria-current=step]').count(), 1);
        assert.ok(await page.locator('.tree summary[aria-current=step]').isVisible());
        assert.ok(await page.locator('.space-frame .ray.now').count() > 0);
        if (at === count) break;
        assert.ok(await page.locator('.space-frame .ray.later').count() > 0 && await page.locator('.frame .ray.later').count() > 0);
        await page.keyboard.press('n');
        await page.waitForFunction((old) => document.querySelector('.stepper p').textContent !== old, words);
    }
    assert.ok(sums.length > 2);
    sums.forEach((now, i) => i > 0 && now.forEach((value, c) => assert.ok(value >= sums[i - 1][c] - 1e-9)));
    assert.ok(!isTotal(sums[0]) && isTotal(sums.at(-1)), `${sums} ${total}`);
    await page.keyboard.press('p');
    await page.locator('.tree summary').first().click();
    assert.match(await stepper.locator('p').innerText(), /^Ray 1 of/);
    await stepper.getByRole('button', {name: 'All'}).click();
    assert.equal(await page.locator('.tree summary[aria-current=step]').count(), 0);
}));

test('the view is of the scene that is open, and says when it simplifies', () => withPage(async (page) => {
    await choose(page, 'glint/hall_of_mirrors.glint');
    await clickPicture(page, 0.5, 0.5);
    await page.locator('.space-frame').waitFor();
    await choose(page, 'cgfs/three_mirrors.cgfs');
    await clickPicture(page, 0.5, 0.6);
    await page.waitForFunction(() => {
        const canvas = document.querySelector('.space-frame canvas');
        if (!canvas?.width) return false;
        const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
        copy.drawImage(canvas, 0, 0);
        const {data} = copy.getImageData(0, 0, canvas.width, canvas.height);
        let yellow = 0;
        for (let i = 0; i < data.length; i += 4) yellow += data[i] > 100 && Math.abs(data[i + 1] - data[i]) < 3 && data[i + 2] < data[i] / 2;
        return yellow > data.length / 32;
    });
    assert.equal(await page.getByText('shown in less detail').count(), 0);
    const lines = Array.from({length: 100_000}, (_, i) => `s ${i % 100} ${Math.floor(i / 100) % 100} ${Math.floor(i / 10_000)} 0.4`);
    const text = `b 0 0 0\nv\nfrom 50 -60 40\nat 50 50 0\nup 0 0 1\nangle 60\nhither 1\nresolution 200 200\nl 50 0 60\nf 0.8 0.5 0.2 1 0 1 0 1\n${lines.join('\n')}\n`;
    await open(page, 'many.nff', text);
    await page.getByText('100,001 shapes: shown in less detail').or(page.getByText('100,000 shapes: shown in less detail')).waitFor();
    const lamp = page.getByRole('button', {name: 'Move point light, line 9'});
    await lamp.focus();
    await page.keyboard.down('ArrowUp');
    await page.keyboard.down('ArrowUp');
    assert.match(await page.locator('.cm-content').innerText(), /^l 50 0 60$/m);
    await page.keyboard.up('ArrowUp');
    await page.waitForFunction(() => !/^l 50 0 60$/m.test(document.querySelector('.editor').shadowRoot.querySelector('.cm-content').innerText));
    await settled(page);
}));
