// SPDX-License-Identifier: Apache-2.0
// The keyboard's focus, what is announced, fingers on the view in space, and what undo takes back after a reload.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {book, choose, clickPicture, picture, sceneText, settled, steady, until, withPage} from './browser.mjs';

const focused = (page) => page.evaluate(() => {
    const {activeElement: now} = document;
    return now === document.body ? 'nothing' : (now.getAttribute('aria-label') ?? now.textContent ?? now.className);
});

test('the text, the picture and the panels are three keys apart', () => withPage(async (page) => {
    const inText = () => page.evaluate(() => document.activeElement.classList.contains('editor'));
    await page.keyboard.press('F6');
    assert.ok(await inText());
    await page.keyboard.press('F6');
    assert.match(await focused(page), /^Picture\. Arrow keys/);
    await page.keyboard.press('F6');
    assert.equal(await focused(page), 'Controls');
    await page.keyboard.press('F6');
    assert.ok(await inText());
    await page.keyboard.press('Shift+F6');
    assert.equal(await focused(page), 'Controls');
}));

test('the focus stays near what had it', () => withPage(async (page) => {
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+Home');
    await page.keyboard.type('# ');
    await settled(page);
    await page.getByRole('button', {name: 'Undo'}).focus();
    await page.keyboard.press('Enter');
    assert.equal(await until(() => focused(page), (now) => now === 'Redo'), 'Redo');
    // A dialog gives it back.
    const help = page.getByRole('button', {name: 'Help'});
    await help.focus();
    await page.keyboard.press('Enter');
    await page.locator('.help-text table').first().waitFor();
    await page.keyboard.press('Escape');
    assert.equal(await until(() => focused(page), (now) => now === 'Help'), 'Help');
    // A notice leaves it on the picture.
    await page.getByRole('button', {name: 'Copy as command'}).click();
    await page.getByRole('button', {name: 'Dismiss'}).last().focus();
    await page.keyboard.press('Enter');
    assert.match(await until(() => focused(page), (now) => now.startsWith('Picture.')), /^Picture\./);
    // Explaining a pixel by the keyboard leaves it on the picture, and the explanation is announced.
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    await page.locator('.inspector').waitFor();
    assert.match(await focused(page), /^Picture\./);
    const said = page.getByRole('status', {name: 'Explanation'});
    assert.match(await said.textContent(), /^Pixel 300, 301: .+\.$/);
    assert.equal((await said.textContent()).replace(/^Pixel [\d, ]+: /, ''), await page.locator('.inspector .sentence').innerText());
    for (const name of ['Large', 'Back to the picture']) {
        await page.getByRole('button', {name, exact: true}).focus();
        await page.keyboard.press('Enter');
        const other = name === 'Large' ? 'Back to the picture' : 'Large';
        assert.equal(await until(() => focused(page), (now) => now === other), other);
    }
    await page.getByRole('button', {name: 'Unpin the pixel'}).focus();
    await page.keyboard.press('Enter');
    assert.notEqual(await until(() => focused(page), (now) => now !== 'nothing' && now !== 'Unpin the pixel'), 'nothing');
    // The next step of a lesson.
    await page.getByRole('tab', {name: 'Learn'}).click();
    await page.locator('[data-lesson]').first().click();
    await page.getByRole('button', {name: 'Next step'}).focus();
    await page.keyboard.press('Enter');
    assert.match(await until(() => focused(page), (now) => now.startsWith('2. ')), /^2\. /);
}));

test('what the picture takes is said in full', async () => {
    for (const [width, height] of [[360, 740], [1366, 768], [1920, 1080]]) {
        await withPage(async (page) => {
            const line = page.locator('.pixel-line');
            assert.match(await line.innerText(), /with Shift to shift it\.$/);
            const [wanted, given] = await line.evaluate((one) => [one.scrollWidth, one.clientWidth]);
            assert.ok(wanted <= given, `${wanted} in ${given} pixels at ${width}`);
            const {height: tall} = await line.boundingBox();
            assert.ok(await line.evaluate((one) => one.scrollHeight) <= tall + 1);
        }, {width, height});
    }
});

test('the name of the page opens the book’s scene, also where the address is its own', () => withPage(async (page) => {
    const before = await picture(page);
    const brand = page.getByRole('link', {name: 'the book’s scene'});
    await brand.click();
    await page.waitForFunction(() => location.hash === '#scene=cgfs/three_mirrors.cgfs');
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+A');
    await page.keyboard.press('Delete');
    await settled(page, 'error');
    await brand.click();
    await settled(page);
    assert.equal(await sceneText(page), book);
    assert.deepEqual(await picture(page), before);
}));

test('what undo takes back survives a reload', () => withPage(async (page) => {
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+Home');
    await page.keyboard.type('# mine ');
    await settled(page);
    await page.getByRole('combobox', {name: 'Shading'}).selectOption('blinn-phong');
    await settled(page);
    await choose(page, 'epfl/castle.json');
    const castle = await sceneText(page);
    await page.waitForFunction((name) => JSON.parse(sessionStorage.getItem('glint.page'))?.name === name, 'epfl/castle.json');
    await page.reload();
    await settled(page);
    assert.equal(await sceneText(page), castle);
    const undo = async (name) => {
        await page.getByRole('button', {name, exact: true}).click();
        await settled(page);
    };
    await undo('Undo');
    assert.equal(await page.locator('.file-name').innerText(), 'three_mirrors.cgfs');
    assert.match(await page.locator('.outside').innerText(), /shading = blinn-phong/);
    await undo('Undo');
    await page.locator('.outside').waitFor({state: 'detached'});
    assert.equal(await sceneText(page), `# mine ${book}`);
    await undo('Undo');
    assert.equal(await sceneText(page), book);
    await undo('Redo');
    assert.equal(await sceneText(page), `# mine ${book}`);
    // And again.
    await page.waitForFunction(() => JSON.parse(sessionStorage.getItem('glint.page'))?.text.startsWith('# mine'));
    await page.reload();
    await settled(page);
    await undo('Redo');
    await undo('Redo');
    assert.equal(await sceneText(page), castle);
    assert.equal(await page.locator('.file-name').innerText(), 'castle.json');
}));

test('on a touch screen one finger scrolls over the view in space, and two turn it', () => withPage(async (page, context) => {
    await page.locator('.tab-inspect').click();
    await clickPicture(page, 0.5, 0.72);
    const view = page.locator('.inspector .space-frame');
    await view.waitFor();
    await view.evaluate((one) => one.scrollIntoView({block: 'end'}));
    const touch = await context.newCDPSession(page);
    const box = await view.boundingBox();
    const at = (x, y, id) => ({x: box.x + x * box.width, y: box.y + y * box.height, id});
    const send = (type, ...touchPoints) => touch.send('Input.dispatchTouchEvent', {type, touchPoints});
    // Where the camera is drawn.
    const lines = () => page.locator('.space-frame .frustum').first().evaluate((one) => `${one.getAttribute('x1')} ${one.getAttribute('y1')}`);
    const before = await lines(), scrolled = await page.evaluate(() => scrollY);
    await send('touchStart', at(0.5, 0.9, 0));
    for (let y = 0.85; y > 0.3; y -= 0.05) await send('touchMove', at(0.5, y, 0));
    await send('touchEnd');
    assert.notEqual(await until(() => page.evaluate(() => scrollY), (now) => now > scrolled + 20), scrolled);
    assert.equal(await lines(), before);
    // A quick finger leaves the page scrolling for a while, and the next touch would only stop it.
    await steady(() => page.evaluate(() => scrollY));
    const now = await view.boundingBox();
    const then = (x, y, id) => ({x: now.x + x * now.width, y: now.y + y * now.height, id});
    await send('touchStart', then(0.3, 0.9, 0));
    await send('touchStart', then(0.3, 0.9, 0), then(0.6, 0.9, 1));
    for (const d of [0.03, 0.08, 0.14, 0.2]) await send('touchMove', then(0.3 + d, 0.9, 0), then(0.6 + d, 0.9, 1));
    await send('touchEnd');
    assert.notEqual(await until(lines, (place) => place !== before), before);
}, {width: 360, height: 740, hasTouch: true}));
