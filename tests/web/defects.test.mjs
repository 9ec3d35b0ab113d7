// SPDX-License-Identifier: Apache-2.0
// Defects of the page that were found by using it, each by its reproduction.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {deflateRawSync} from 'node:zlib';

import {address, book, choose, clickPicture, drop, native, nativeText, paste, picture, sceneText, scenes, settled, until, withPage} from './browser.mjs';

const fragment = (shared) => `#1=${deflateRawSync(Buffer.from(JSON.stringify(shared))).toString('base64url')}`;
const named = (page, name) => page.waitForFunction((wanted) => document.querySelector('.file-name').textContent === wanted, name);
const isCovered = (page, selector) => page.evaluate((wanted) => [...document.querySelectorAll(wanted)].filter((e) => e.checkVisibility()).filter((e) => {
    const box = e.getBoundingClientRect();
    const top = document.elementFromPoint(box.x + box.width / 2, box.y + box.height / 2);
    return !top || !(e.contains(top) || top.contains(e));
}).map((e) => e.ariaLabel ?? e.className), selector);

test('the wheel over the controls scrolls them, not the window', () => withPage(async (page) => {
    for (const [width, height] of [[1366, 768], [1280, 720], [1536, 730], [1440, 900]]) {
        await page.setViewportSize({width, height});
        await page.getByRole('combobox', {name: 'Shading'}).selectOption('blinn-phong');
        await page.getByText('Conventions', {exact: true}).click();
        const box = await page.locator('#panel-controls').boundingBox();
        await page.mouse.move(box.x + 100, box.y + 100);
        for (let i = 0; i < 30; ++i) await page.mouse.wheel(0, 400);
        await page.waitForFunction(() => {
            const panel = document.querySelector('#panel-controls');
            return panel.scrollTop > 0 && panel.scrollTop + panel.clientHeight >= panel.scrollHeight - 2;
        });
        assert.deepEqual(await page.evaluate(() => [scrollY, document.documentElement.scrollTop, document.documentElement.scrollHeight <= innerHeight]), [0, 0, true], `${width}x${height}`);
        assert.equal((await page.locator('.header').boundingBox()).y, 0);
        await page.getByText('Conventions', {exact: true}).click();
    }
}));

test('a file that cannot be read shows and saves nothing of another scene', () => withPage(async (page) => {
    await clickPicture(page, 0.5, 0.62);
    await page.locator('.inspector').waitFor();
    await drop(page, {name: 'mine.cgfs', text: 'sphere { radius = oops }\n'});
    await named(page, 'mine.cgfs');
    await settled(page, 'error');
    assert.equal(await page.locator('.frame .layer').first().evaluate((e) => getComputedStyle(e).visibility), 'hidden');
    assert.match(await page.locator('.no-picture').innerText(), /no picture/);
    assert.equal(await page.locator('.inspector').count(), 0);
    await page.getByRole('tab', {name: 'Controls'}).click();
    assert.equal(await page.locator('[data-light]').count(), 0);
    let downloads = 0;
    page.on('download', () => ++downloads);
    await page.getByRole('button', {name: 'Save PNG'}).click();
    assert.match(await page.locator('.notice').innerText(), /no picture of this scene/);
    assert.equal(downloads, 0);
    // A correct text has its own picture; with a mistake again, that one stays.
    const text = 'sphere { center = (0, 0, 3) radius = 1 color = (0, 0, 255) }\nlight { type = ambient intensity = 1 }\n';
    await paste(page, text);
    await settled(page);
    const own = nativeText('mine.cgfs', text);
    assert.deepEqual(await picture(page), own);
    await paste(page, 'sphere { oops');
    await settled(page, 'error');
    assert.deepEqual(await picture(page), own);
    assert.equal(await page.locator('.frame .layer').first().evaluate((e) => getComputedStyle(e).visibility), 'visible');
    await page.getByRole('button', {name: 'Undo'}).click();
    await settled(page);
    assert.deepEqual(await picture(page), own);
}));

test('an edit and at once a mistake: the last good picture is completed', () => withPage(async (page) => {
    await choose(page, 'glint/hall_of_mirrors.glint');
    const text = (await sceneText(page)).replace(/size.*reflections = 64/, 'size = 240 x 180  reflections = 64  aa = 8');
    await paste(page, text);
    await page.waitForFunction(() => /\d% · \d+\.\d M rays/.test(document.querySelector('[data-state]').textContent));
    await page.keyboard.press('Control+Home');
    await page.keyboard.type('oops ');
    await settled(page, 'error');
    const expected = nativeText('hall_of_mirrors.glint', text);
    const whole = await until(() => picture(page), (now) => JSON.stringify(now) === JSON.stringify(expected));
    assert.deepEqual(whole, expected);
    assert.equal(await page.locator('[data-state]').getAttribute('data-state'), 'error');
}));

test('links and files that are too large are refused with a message', () => withPage(async (page) => {
    await page.goto('about:blank');
    await page.goto(address + fragment({name: 'a.cgfs', text: '#'.repeat(63e6)}));
    await settled(page);
    assert.match(await page.locator('.notice').innerText(), /larger than 4 MB/);
    await drop(page, {name: 'line.cgfs', text: `# ${'x'.repeat(10e6)}\n${book}`});
    await page.waitForFunction(() => /line 1 has more than \d+ characters/.test(document.querySelector('.notice')?.textContent));
    await paste(page, `${book}# ${'x'.repeat(10e6)}`);
    await page.waitForFunction(() => /Not inserted/.test(document.querySelector('.notice')?.textContent));
    assert.equal(await sceneText(page), book);
    assert.deepEqual(await picture(page), native(`${scenes}/cgfs/three_mirrors.cgfs`));
}));

test('a picture that is reduced says so', () => withPage(async (page) => {
    await page.goto('about:blank');
    await page.goto(address + fragment({name: 'large.cgfs', text: book, overrides: {size: '65536x65536'}}));
    await page.waitForFunction(() => /reduced from 65536×65536/.test(document.querySelector('[data-state]').textContent));
    await choose(page, 'cgfs/three_mirrors.cgfs');
    assert.doesNotMatch(await page.locator('[data-state]').innerText(), /reduced/);
}));

test('long messages and names push nothing away', () => withPage(async (page) => {
    for (const width of [1440, 1012, 360]) {
        await page.setViewportSize({width, height: 800});
        await drop(page, {name: `${'n'.repeat(5000)}.cgfs`, text: `${'x'.repeat(3000)} {`});
        await settled(page, 'error');
        if (width < 1012) await page.getByRole('tab', {name: 'Text'}).click();
        assert.deepEqual(await page.evaluate(() => [document.documentElement.scrollWidth, [...document.querySelectorAll('.shell *')]
            .filter((e) => e.checkVisibility() && e.getBoundingClientRect().right > innerWidth + 1 && !e.closest('.for-readers')).map((e) => e.className)]), [width, []]);
        assert.deepEqual(await isCovered(page, '.camera-buttons button'), []);
        if (width === 1012) {
            // The page still has the message of the round before when the file is dropped, and none while it reads it.
            const isCut = () => page.locator('.words').evaluate((e) => e.scrollWidth > e.clientWidth && getComputedStyle(e).textOverflow === 'ellipsis');
            assert.equal(await until(isCut, (now) => now), true);
        }
        // A message of the page is over the picture only.
        await drop(page, {name: `${'m'.repeat(5000)}.txt`, text: ''});
        await page.locator('.notice').waitFor();
        assert.deepEqual(await isCovered(page, '.camera-buttons button, .words, .header button, [role=tab]'), []);
        await page.getByRole('button', {name: 'Dismiss'}).click();
    }
}));

test('a converted scene names the files that it was made of', () => withPage(async (page) => {
    await page.getByRole('button', {name: 'convert to .glint'}).click();
    await named(page, 'three_mirrors.glint');
    assert.match(await sceneText(page), /^# Converted from three_mirrors\.cgfs \(cgfs\) by glint/);
}));

test('the numbers of the inspector can be pasted into a text, and names are told apart', () => withPage(async (page) => {
    await clickPicture(page, 0.5, 0.85);
    await page.locator('.inspector').waitFor();
    assert.doesNotMatch(await page.locator('.inspector').innerText(), /−\d/);
    assert.match(await page.locator('.inspector').innerText(), /-\d/);
    await page.getByRole('tab', {name: 'Controls'}).click();
    await page.getByRole('slider', {name: 'Samples'}).fill('3');
    await settled(page);
    assert.match(await page.getByRole('slider', {name: 'Samples n×n'}).getAttribute('aria-valuetext'), /9 per pixel/);
    await page.getByRole('button', {name: 'Scenes', exact: true}).click();
    const titles = await page.locator('.thumb').allInnerTexts();
    assert.equal(new Set(titles).size, titles.length, 'no two scenes of one name');
    // Neither the name nor the text of a fault says what it is.
    await page.locator('[data-scene$="faults/grey.cgfs"]').click();
    await settled(page);
    assert.match(await page.locator('.file-name').innerText(), /^fault_\d\.cgfs$/);
    assert.doesNotMatch(await sceneText(page), /#/);
}));

test('the convention of the book is no fault in the book’s scene', () => withPage(async (page) => {
    await page.getByRole('switch', {name: 'No epsilon'}).waitFor();
    assert.equal(await page.getByRole('switch', {name: 'Specular without gate'}).count(), 0);
    await choose(page, 'epfl/castle.json');
    assert.equal(await page.getByRole('switch', {name: 'Specular without gate'}).isChecked(), false);
}));

test('a control that is used does not move', () => withPage(async (page) => {
    const slider = page.getByRole('slider', {name: 'Reflections'});
    const before = await slider.boundingBox();
    await slider.fill('1');
    await page.locator('.outside').waitFor();
    assert.deepEqual(await slider.boundingBox(), before);
}));

test('the wheel does not move the camera through an object', () => withPage(async (page) => {
    await drop(page, {name: 'near.glint', text: `camera { position = (0, 0, 9) look_at = (0, 0, -20) }
render { size = 400 x 300  aa = 4 }
sphere { center = (0, 0, 0) radius = 2 color = (1, 0, 0) ambient = 1 }
light { type = ambient intensity = 1 }\n`});
    await named(page, 'near.glint');
    await settled(page);
    const point = async () => {
        const box = await page.locator('.frame').boundingBox();
        await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
        await page.waitForFunction(() => /sphere/.test(document.querySelector('.pixel-line').textContent));
    };
    const distance = async () => Number(/position = \(\S+, \S+, (\S+)\)/.exec(await sceneText(page))[1]);
    await point();
    for (let i = 0; i < 12; ++i) {
        await page.mouse.wheel(0, -300);
        await settled(page);
    }
    const z = await distance();
    assert.ok(z > 2 && z < 9, `z = ${z}`);
    // Also if it is turned, and the pointer moves, faster than pictures and explanations come.
    await page.getByRole('button', {name: 'Reset the camera'}).click();
    await settled(page);
    assert.equal(await distance(), 9);
    await point();
    await page.locator('.frame').evaluate(async (frame) => {
        const box = frame.getBoundingClientRect();
        const at = {clientX: box.x + box.width / 2, clientY: box.y + box.height / 2, bubbles: true, cancelable: true};
        for (let i = 0; i < 14; ++i) {
            frame.dispatchEvent(new PointerEvent('pointermove', {pointerId: 1, ...at}));
            frame.dispatchEvent(new WheelEvent('wheel', {deltaY: -300, ...at}));
            await new Promise((next) => setTimeout(next, 5 * (i % 8)));
        }
    });
    await settled(page);
    const last = await distance();
    assert.ok(last >= 2 && last < 3, `z = ${last}`);
}));
