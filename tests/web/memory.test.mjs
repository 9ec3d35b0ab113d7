// SPDX-License-Identifier: Apache-2.0
// Nothing is lost: reload, recent scenes, missing files; and the layout that the user chooses.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {address, book, choose, clickPicture, drop, native, nativeText, picture, sceneText, scenes, settled, shoot, until, withPage} from './browser.mjs';

const named = (page, name) => page.waitForFunction((wanted) => document.querySelector('.file-name').textContent === wanted, name);

test('a reload comes back as it was', () => withPage(async (page, context) => {
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+Home');
    await page.keyboard.type('# my own work\n');
    await page.getByRole('combobox', {name: 'Shading'}).selectOption('blinn-phong');
    await settled(page);
    await clickPicture(page, 0.5, 0.62);
    await page.locator('.inspector').waitFor();
    const pixel = await page.locator('.inspector').getAttribute('data-pixel');
    const before = await picture(page);
    const isBack = async (where) => {
        await settled(where);
        assert.equal(await sceneText(where), `# my own work\n${book}`);
        assert.deepEqual(await picture(where), before);
        assert.match(await where.locator('.outside').innerText(), /shading = blinn-phong/);
        await where.locator('.inspector').waitFor();
        assert.equal(await where.locator('.inspector').getAttribute('data-pixel'), pixel);
        assert.equal(await where.locator('.welcome').count(), 0);
    };
    await page.reload();
    await page.reload();  // before the picture is complete
    await isBack(page);
    const other = await context.newPage();
    await other.goto(address);
    await isBack(other);
    await other.close();
    // After a link was made and the scene changed again, a reload has the change.
    await page.getByRole('button', {name: 'Share link'}).click();
    await page.waitForFunction(() => location.hash.startsWith('#1='));
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+Home');
    await page.keyboard.type('# and more\n');
    await settled(page);
    await page.reload();
    await settled(page);
    assert.equal(await sceneText(page), `# and more\n# my own work\n${book}`);
}));

test('recent scenes are kept, also when a link is opened', () => withPage(async (page) => {
    const text = 'sphere { center = (0, 0, 3) radius = 1 color = (0, 0, 255) }\nlight { type = ambient intensity = 1 }\n';
    await drop(page, {name: 'mine.cgfs', text});
    await named(page, 'mine.cgfs');
    await settled(page);
    await choose(page, 'glint/temple.glint');
    await page.reload();
    await settled(page);
    await page.getByRole('button', {name: 'Scenes', exact: true}).click();
    assert.deepEqual(await page.locator('.recent').allInnerTexts(), ['mine.cgfs']);
    await page.locator('.recent').click();
    await named(page, 'mine.cgfs');
    await settled(page);
    assert.deepEqual(await picture(page), nativeText('mine.cgfs', text));
}));

test('a missing include is supplied by dropping it', () => withPage(async (page) => {
    const read = (name) => readFileSync(join(scenes, name), 'utf8');
    await drop(page, {name: 'temple.glint', text: read('glint/temple.glint')});
    await named(page, 'temple.glint');
    await settled(page, 'error');
    assert.match(await page.locator('.messages').innerText(), /parts\/column\.glint is not here\. Drop it/);
    await drop(page, {name: 'column.glint', text: read('glint/parts/column.glint')});
    await settled(page);
    assert.equal(await page.locator('.file-name').innerText(), 'temple.glint');
    assert.deepEqual(await picture(page), native(join(scenes, 'glint/temple.glint')));
    await page.reload();
    await settled(page);
    assert.deepEqual(await picture(page), native(join(scenes, 'glint/temple.glint')));
}));

test('the first visit says what this is; the layout is the user’s', () => withPage(async (page) => {
    assert.match(await page.locator('.welcome').innerText(), /ray tracing/);
    await shoot(page, 'welcome.png');
    assert.match(await page.locator('.welcome').innerText(), /Computer Graphics from Scratch/);
    await page.locator('.welcome').getByRole('button', {name: 'Take a pixel apart'}).click();
    await page.locator('.inspector .sentence').waitFor();
    assert.equal(await page.locator('.welcome').count(), 0);
    const columns = () => page.evaluate(() => ['.text-pane', '.stage', '.side'].map((one) => document.querySelector(one).getBoundingClientRect()).map(({x, width, y}) => [Math.round(x), Math.round(width), Math.round(y)]));
    // Three columns.
    await page.setViewportSize({width: 1012, height: 700});
    const narrow = await columns();
    assert.ok(narrow[0][0] < narrow[1][0] && narrow[1][0] < narrow[2][0] && narrow[0][2] === narrow[2][2], JSON.stringify(narrow));
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 1012);
    await page.setViewportSize({width: 1600, height: 900});
    const splitter = page.getByRole('separator', {name: 'Width of the text'});
    const before = await columns();
    const box = await splitter.boundingBox();
    await page.mouse.move(box.x + 4, box.y + 300);
    await page.mouse.down();
    await page.mouse.move(box.x + 104, box.y + 300, {steps: 4});
    await page.mouse.up();
    const after = await columns();
    assert.ok(Math.abs(after[0][1] - before[0][1] - 100) < 4, JSON.stringify([before, after]));
    await page.getByRole('separator', {name: 'Width of the panels'}).focus();
    await page.keyboard.press('ArrowLeft');
    assert.ok((await columns())[2][1] > after[2][1]);
    const frame = () => page.locator('.frame').boundingBox();
    // The picture fits its space, or has its own size.
    const area = await page.locator('.stage-area').boundingBox();
    const isFitted = (fit) => Math.abs(Math.min(area.width - fit.width, area.height - fit.height)) < 2;
    const fit = await until(frame, isFitted);
    assert.ok(isFitted(fit), JSON.stringify([area, fit]));
    await page.getByRole('button', {name: '100%'}).click();
    assert.equal((await frame()).width, 600);
    await page.reload();
    await settled(page);
    assert.equal((await frame()).width, 600);
    assert.equal((await columns())[0][1], after[0][1]);
    await page.getByRole('button', {name: 'Fit'}).click();
    await page.getByRole('button', {name: 'Full screen'}).click();
    await page.waitForFunction(() => document.fullscreenElement?.classList.contains('stage'));
    await page.evaluate(() => document.exitFullscreen());
}));

test('the camera can be reset', () => withPage(async (page) => {
    for (const scene of ['glint/still_life.glint', 'epfl/castle.json']) {
        await choose(page, scene);
        const before = await picture(page);
        await page.getByRole('button', {name: 'Turn left'}).click();
        await settled(page);
        await page.getByRole('button', {name: 'Farther'}).click();
        await settled(page);
        assert.notDeepEqual(await picture(page), before);
        await page.getByRole('button', {name: 'Reset the camera'}).click();
        await settled(page);
        assert.deepEqual(await picture(page), before);
    }
}));
