// SPDX-License-Identifier: Apache-2.0
// For a class: the page on a projector, the code that shows a scene in another page, and long links.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {address, clickPicture, drop, nativeText, picture, saved, sceneText, settled, shoot, until, withPage} from './browser.mjs';

const box = (page, selector) => page.locator(selector).boundingBox();

test('on a projector, task, picture and explanation are side by side in large type', async () => {
    for (const [width, height] of [[1366, 768], [1920, 1080]]) {
        await withPage(async (page) => {
            await clickPicture(page, 0.5, 0.72);
            await page.locator('.inspector').waitFor();
            await page.getByRole('button', {name: 'Next step'}).waitFor();
            const task = await box(page, '#panel-learn'), stage = await box(page, '.stage'), side = await box(page, '#panel-inspect'), text = await box(page, '.text-pane');
            assert.ok(task.x + task.width <= stage.x + 1 && stage.x + stage.width <= side.x + 1, JSON.stringify([task, stage, side]));
            assert.ok(text.y >= task.y + task.height - 1 && text.y + text.height <= height + 1);
            assert.ok(stage.width > 0.35 * width);
            // Letters of task and explanation are at least half as large again as on the page else.
            for (const selector of ['.step[aria-current] .lesson-text', '.inspector .sentence']) {
                const size = await page.locator(selector).first().evaluate((one) => parseFloat(getComputedStyle(one).fontSize) * (one.currentCSSZoom ?? 1.5));
                assert.ok(size >= 20, `${selector}: ${size}`);
            }
            // The step is in sight.
            const step = await box(page, '.step[aria-current]');
            assert.ok(step.y < task.y + task.height - 100, JSON.stringify([step, task]));
            if (width === 1920) await shoot(page, 'projector.png');
            // The rays are stepped through by keys, too.
            await page.locator('.frame').focus();
            await page.keyboard.press('n');
            await page.locator('.stepper').getByText(/^Ray 1 of/).waitFor();
            await page.keyboard.press('l');
            await page.waitForFunction(() => !document.querySelector('.shell.projector') && location.search === '');
            await page.getByRole('tab', {name: 'Learn'}).waitFor();
            await page.getByRole('button', {name: 'For a projector'}).click();
            await page.waitForFunction(() => location.search === '?projector' && location.hash === '#lesson=01_ambient');
            await page.reload();
            await settled(page);
            await page.locator('.shell.projector.with-task').waitFor();
            // Without a task, the scene's text is in its place.
            await page.getByRole('link', {name: 'the book’s scene'}).click();
            await page.locator('.shell.projector:not(.with-task)').waitFor();
            await settled(page);
            const whole = await until(() => box(page, '.text-pane'), ({height: tall}) => tall > 0.8 * height);
            assert.ok(whole.height > 0.8 * height);
        }, {width, height, path: '?projector#lesson=01_ambient'});
    }
});

test('the code for another page is that of a frame with the scene and the chosen controls', () => withPage(async (page, context) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    const text = 'sphere { center = (0, 0, 3) radius = 1 color = (0, 0, 255) }\nlight { type = ambient intensity = 1 }\n';
    await drop(page, {name: 'a "ball" & more.cgfs', text});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent.startsWith('a "ball"'));
    await settled(page);
    await page.getByRole('button', {name: 'Embed…'}).click();
    const dialog = page.getByRole('dialog', {name: 'Share'});
    await dialog.getByText(/^The link has \d+ characters, and holds/).waitFor();
    await dialog.getByRole('checkbox', {name: 'shading'}).check();
    await dialog.getByRole('checkbox', {name: 'lights'}).check();
    await shoot(page, 'embed.png');
    await dialog.getByRole('button', {name: 'Copy the code'}).click();
    await dialog.getByText('Copied.').waitFor();
    const code = await page.evaluate(() => navigator.clipboard.readText());
    assert.match(code, /^<iframe src="[^"]+\?embed=camera,shading,lights#1=[\w-]+" title="a &quot;ball&quot; &amp; more\.cgfs in glint" width="600" height="1030" loading="lazy"><\/iframe>$/);
    await dialog.getByRole('button', {name: 'Close'}).click();
    const frame = await context.newPage();
    await frame.goto(/src="([^"]+)"/.exec(code)[1]);
    await settled(frame);
    assert.deepEqual(await picture(frame), nativeText('ball.cgfs', text));
    assert.equal(await frame.getByRole('combobox', {name: 'Shading'}).count(), 1);
    assert.equal(await frame.getByRole('switch', {name: 'No epsilon'}).count(), 0);
    await frame.close();
}));

test('on a phone the code is made by the menu Save', () => withPage(async (page) => {
    await page.locator('.more summary').click();
    await page.getByRole('button', {name: 'Embed…'}).click();
    const dialog = page.getByRole('dialog', {name: 'Share'});
    await dialog.getByRole('checkbox', {name: 'inspect'}).check();
    const {width, height} = await dialog.boundingBox();
    assert.ok(width <= 360 && height <= 740);
    assert.match(await dialog.getByRole('textbox', {name: 'Code of the frame'}).inputValue(), /embed=camera,inspect#/);
}, {width: 360, height: 740}));

test('of a long link its length is said, and a file is offered', () => withPage(async (page) => {
    let seed = 7;
    const random = () => (seed = (seed * 48271) % 2147483647).toString(36);
    const text = `render { size = 40 x 30 }\ncamera { position = (0, 0, 5)  look_at = (0, 0, 0) }\n${Array.from({length: 2000}, () => `# ${random()}\n`).join('')}`;
    await drop(page, {name: 'long.glint', text});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'long.glint');
    await settled(page);
    await page.getByRole('button', {name: 'Share link'}).click();
    const dialog = page.getByRole('dialog', {name: 'Share'});
    const note = await dialog.getByText(/^The link has [\d,]+ characters: some programs cut/).innerText();
    const length = Number(/[\d,]+/.exec(note)[0].replaceAll(',', ''));
    assert.equal(length, page.url().length);
    assert.equal(await dialog.getByRole('textbox', {name: 'Link'}).inputValue(), page.url());
    const file = await saved(page, () => dialog.getByRole('button', {name: 'Save scene as a file'}).click());
    assert.equal(file.name, 'long.glint');
    assert.equal(file.bytes.toString(), text);
    await page.keyboard.press('Escape');
    await dialog.waitFor({state: 'detached'});
    assert.equal(await sceneText(page), text);
    assert.ok(page.url().startsWith(address));
}));
