// SPDX-License-Identifier: Apache-2.0
// Links, files, and the page without a network.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {address, book, byCommand, choose, drop, native, picture, saved, sceneText, scenes, settled, shoot, withPage} from './browser.mjs';

test('a link holds the scene and its settings', () => withPage(async (page, context) => {
    await choose(page, 'epfl/castle.json');
    await page.getByRole('combobox', {name: 'Shading'}).selectOption('phong');
    await page.getByRole('spinbutton', {name: 'Width'}).fill('200');
    await settled(page);
    await page.getByRole('spinbutton', {name: 'Height'}).fill('150');
    await settled(page);
    await page.getByRole('button', {name: 'Share link'}).click();
    await page.waitForFunction(() => location.hash.startsWith('#1='));
    const link = page.url();
    assert.ok(link.length < 8000, `${link.length} characters`);
    const other = await context.newPage();
    await other.goto(link);
    await settled(other);
    assert.deepEqual(await picture(other), native(join(scenes, 'epfl/castle.json'), '--shading', 'phong', '-s', '200x150'));
    assert.equal(await sceneText(other), readFileSync(join(scenes, 'epfl/castle.json'), 'utf8'));
    assert.match(await other.locator('.outside').innerText(), /size = 200x150/);
}));

test('a link that holds nothing opens the book’s scene', () => withPage(async (page) => {
    assert.match(await page.locator('.notice').innerText(), /contains no scene/);
    assert.deepEqual(await picture(page), native(join(scenes, 'cgfs/three_mirrors.cgfs')));
}, {path: '#1=AAAA'}));

test('picture and scene are saved by button, the picture by key, too, under the course’s name, as the command saves it', () => withPage(async (page, context) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    const copied = async () => {
        await page.getByRole('button', {name: 'Copy as command'}).click();
        await page.waitForSelector('.notice');
        return page.evaluate(() => navigator.clipboard.readText());
    };
    await choose(page, 'epfl/castle.json');
    const byButton = await saved(page, () => page.getByRole('button', {name: 'Save PNG'}).click());
    assert.equal(byButton.name, 'castle_BlinnPhong.png');
    await page.locator('.frame').focus();
    const byKey = await saved(page, () => page.keyboard.press('s'));
    assert.equal(byKey.name, 'castle_BlinnPhong.png');
    assert.deepEqual(byKey.bytes, byButton.bytes);
    assert.ok(byKey.bytes.equals(byCommand(await copied(), 'castle.json', await sceneText(page))));
    const scene = await saved(page, () => page.getByRole('button', {name: 'Save scene'}).click());
    assert.equal(scene.name, 'castle.json');
    assert.deepEqual(scene.bytes, readFileSync(join(scenes, 'epfl/castle.json')));
    // Settings that the text cannot say, and a name that a shell would take apart.
    const name = "it's a $HOME.cgfs";
    await drop(page, {name, text: book});
    await page.waitForFunction((now) => document.querySelector('.file-name').textContent === now, name);
    await settled(page);
    await page.getByRole('combobox', {name: 'Shading'}).selectOption('blinn-phong');
    await page.getByRole('spinbutton', {name: 'Width'}).fill('90');
    await settled(page);
    await page.getByRole('spinbutton', {name: 'Height'}).fill('70');
    await settled(page);
    for (const label of ['Shadows', 'No epsilon', 'No normalisation']) await page.getByRole('switch', {name: label, exact: true}).click({force: true});
    await settled(page);
    const line = await copied();
    assert.match(line, /^glint render 'it'\\''s a \$HOME\.cgfs' --shading blinn-phong -s 90x70 --no-shadows --convention epsilon=0 /);
    const {bytes} = await saved(page, () => page.getByRole('button', {name: 'Save PNG'}).click());
    assert.ok(bytes.equals(byCommand(line, name, book)));
    // Of a file with several scenes.
    await choose(page, 'snowman');
    const snowman = await copied();
    assert.match(snowman, /^glint render two_scenes\.js --scene snowman$/);
    const picture = await saved(page, () => page.getByRole('button', {name: 'Save PNG'}).click());
    assert.ok(picture.bytes.equals(byCommand(snowman, 'two_scenes.js', await sceneText(page))));
    // A key within the text is a letter.
    await page.locator('.cm-content').click();
    await page.keyboard.press('s');
    assert.match(await page.locator('.cm-content').innerText(), /s/);
}));

test('pictures with a transfer curve and with transparent parts are saved as the command saves them', () => withPage(async (page, context) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    const scene = (settings) => `render { size = 90 x 70  aa = 2 }\n${settings}
camera { position = (0, 1, 6)  look_at = (0, 0, 0) }\nlight { position = (3, 4, 5)  intensity = 0.9 }
sphere { center = (-0.5, 0, 0)  radius = 1.2  color = (0.9, 0.4, 0.2) }\n`;
    let count = 0;
    for (const settings of ['conventions { transfer = srgb }', 'conventions { gamma = 2.2 }', 'render { alpha = true }',
                            'render { alpha = true }\nconventions { transfer = srgb  rounding = down }', 'background = (0, 0, 1)']) {
        const name = `curve${++count}.glint`, text = scene(settings);
        await drop(page, {name, text});
        await page.waitForFunction((now) => document.querySelector('.file-name').textContent === now, name);
        await settled(page);
        await page.getByRole('button', {name: 'Copy as command'}).click();
        await page.waitForSelector('.notice');
        const line = await page.evaluate(() => navigator.clipboard.readText());
        const {bytes} = await saved(page, () => page.getByRole('button', {name: 'Save PNG'}).click());
        assert.ok(bytes.equals(byCommand(line, name, text)), settings);
    }
}));

test('dropped files are opened: the first scene, and what it includes', () => withPage(async (page) => {
    const text = '# two files\ninclude "other.cgfs"\nrender { size = 60 x 50 }\ncamera { position = (0, 0, -2)  look_at = (0, 0, 3) }\n';
    const other = 'sphere { center = (0, 0, 3) radius = 1 color = (200, 10, 10) }\nlight { type = ambient intensity = 1 }\n';
    await drop(page, {name: 'main.glint', text}, {name: 'other.cgfs', text: other});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'main.glint');
    await settled(page);
    assert.equal((await picture(page)).size, '60x50');
    assert.equal(await page.locator('.message').count(), 0);
    await drop(page, {name: 'notes.txt', text: 'no scene'});
    assert.match(await page.locator('.notice').innerText(), /Not a scene: notes\.txt/);
    assert.equal(await page.locator('.file-name').innerText(), 'main.glint');
}));

test('nothing but thumbnails is fetched after the page is loaded, and all only from itself', () => withPage(async (page) => {
    const requests = [];
    await page.goto('about:blank');
    page.on('request', (request) => requests.push(request.url()));
    await page.goto(address);
    await settled(page);
    assert.ok(requests.every((url) => url.startsWith(address) || url.startsWith('data:')), requests.join(' '));
    assert.ok(requests.some((url) => url.endsWith('.wasm')));
    // What the browser fetches when it is idle.
    await page.waitForFunction(() => ['lessons', 'challenges', 'help', 'SpaceView', 'RayLines'].every((name) => performance.getEntriesByType('resource').some((one) => one.name.includes(`/${name}-`))));
    await page.waitForLoadState('networkidle');
    const loaded = requests.length, isThumbnail = (url) => url.startsWith(`${address}assets/`) && url.endsWith('.png');
    assert.equal(requests.filter(isThumbnail).length, 0, 'before the gallery is opened');
    await choose(page, 'glint/temple.glint');
    await page.getByRole('tab', {name: 'Inspect'}).click();
    await page.locator('.frame').click();
    await page.locator('.inspector').waitFor();
    await page.getByRole('button', {name: 'Share link'}).click();
    await page.getByRole('button', {name: 'Help'}).click();
    await page.locator('.help-text table').first().waitFor();
    const later = requests.slice(loaded).filter((url) => !url.startsWith('data:'));
    assert.deepEqual(later.filter((url) => !isThumbnail(url)), []);
    assert.ok(later.length > 4, 'the gallery shows them');
}));

test('the help has the keys, and the words of each format', () => withPage(async (page) => {
    await page.getByRole('button', {name: 'Help'}).click();
    const text = page.locator('.help-text');
    await text.getByText('Ctrl+Shift+Z').waitFor();
    for (const [topic, word] of [['.glint', 'look_at'], ['.cgfs •', 'reflective'], ['POV-Ray', 'texture_list'], ['Conventions', 'specular_gate']]) {
        await page.getByRole('button', {name: topic, exact: true}).click();
        await text.getByText(word).first().waitFor();
        assert.equal(await text.locator('a').count(), 0);
    }
    await shoot(page, 'help.png');
    await page.locator('.help').getByRole('button', {name: 'Lessons'}).click();
    await page.locator('.learn-list').first().waitFor();
}));

test('once loaded, the page opens without its server', () => withPage(async (page, context) => {
    await page.evaluate(() => navigator.serviceWorker.ready);
    await context.setOffline(true);
    await page.reload();
    await settled(page);
    assert.deepEqual(await picture(page), native(join(scenes, 'cgfs/three_mirrors.cgfs')));
    await context.setOffline(false);
}, {offline: true}));
