// SPDX-License-Identifier: Apache-2.0
// The page in an iframe of another page: chosen controls, its height, and messages of the right origin only.
import assert from 'node:assert/strict';
import {copyFileSync, mkdtempSync, rmSync, symlinkSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';

import {address, hashOf, native, nativeText, project, scenes, shoot, withBrowserPage} from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'glint-embed-'));
after(() => rmSync(folder, {recursive: true}));
copyFileSync(join(project, 'examples/embedding/index.html'), join(folder, 'index.html'));
symlinkSync(join(project, 'web/dist'), join(folder, 'playground'));
writeFileSync(join(folder, 'empty.html'), '<!doctype html><link rel="icon" href="data:,"><title>Empty</title>');

const framePicture = (frame) => hashOf(frame.locator('.frame canvas').first());
const rendered = (page, count) => page.waitForFunction((n) => globalThis.messages.filter(({glint}) => glint === 'rendered').length >= n, count);

/** Collects the messages that a page receives, with their origins. */
const collect = () => {
    globalThis.messages = [];
    addEventListener('message', ({data, origin}) => globalThis.messages.push({...data, origin}));
};

test('the example: its scene, chosen controls, the height of its content, a button to the whole page', () => withBrowserPage(folder, async (page, context) => {
    const frame = page.frameLocator('iframe');
    await page.getByText('The picture has 480 × 320 pixels.').waitFor();
    await frame.locator('[data-light="1"]').waitFor();
    const text = await page.evaluate('scene.text');
    assert.deepEqual(await framePicture(frame), nativeText('highlight.glint', text));
    await page.evaluate(collect);
    await page.getByRole('button', {name: 'Blinn-Phong’s highlight'}).click();
    await rendered(page, 1);
    assert.deepEqual(await framePicture(frame), nativeText('highlight.glint', text.replace('shading = phong', 'shading = blinn-phong')));
    assert.equal(await frame.getByRole('combobox', {name: 'Shading'}).inputValue(), 'blinn-phong');
    for (const heading of ['Classic faults', 'Picture', 'Conventions']) assert.equal(await frame.getByRole('heading', {name: heading}).count(), 0);
    assert.equal(await frame.locator('.editor').isVisible(), false);
    // All of it is visible without scrolling in the frame, at any width.
    for (const width of [1280, 360]) {
        await page.setViewportSize({width, height: 800});
        await page.waitForFunction(() => {
            const {contentDocument: inner, clientHeight} = document.querySelector('iframe');
            return Math.abs(inner.querySelector('.embed').offsetHeight - clientHeight) <= 3 && inner.documentElement.scrollWidth <= inner.documentElement.clientWidth;
        });
        await shoot(page, `embedding_${width}.png`);
    }
    const [whole] = await Promise.all([context.waitForEvent('page'), frame.getByRole('link', {name: 'Open in glint'}).click()]);
    await whole.waitForSelector('[data-state=done]');
    assert.equal(new URL(whole.url()).search, '');
    assert.equal(await whole.locator('.file-name').innerText(), 'highlight.glint');
    assert.equal(await whole.getByRole('combobox', {name: 'Shading'}).inputValue(), 'blinn-phong');
    await page.bringToFront();
    // The frame keeps nothing of what it shows.
    assert.equal(await page.evaluate(() => document.querySelector('iframe').contentWindow.sessionStorage.getItem('glint.page')), null);
}));

test('messages: only of the named origin and of the right form; mistakes are told', () => withBrowserPage(folder, async (page) => {
    // The host has another port than the playground, which makes it another origin.
    const host = new URL(page.url()).origin, playground = new URL(address).origin;
    assert.notEqual(host, playground);
    await page.evaluate(collect);
    const show = (origin) => page.evaluate((src) => {
        globalThis.messages.length = 0;
        document.body.innerHTML = '<iframe width="500" height="600"></iframe>';
        document.querySelector('iframe').src = src;
    }, `${address}?embed=camera&origin=${origin}`);
    const post = (message) => page.evaluate(([data, to]) => document.querySelector('iframe').contentWindow.postMessage(data, to), [message, playground]);
    const messages = (kind) => page.evaluate((glint) => globalThis.messages.filter((one) => one.glint === glint), kind);
    await show(host);
    await rendered(page, 1);
    assert.deepEqual((await messages('ready')).map(({origin}) => origin), [playground]);
    const frame = page.frameLocator('iframe');
    const before = await framePicture(frame);
    assert.deepEqual(before, native(join(scenes, 'cgfs/three_mirrors.cgfs')));
    const wrong = [{glint: 'open'}, {glint: 'open', scene: {name: 5, text: ''}}, {glint: 'set', name: 'nothing', value: '1'},
                   {glint: 'set', name: 'aa', value: 3}, {glint: 'run', text: 'alert(1)'}];
    for (const message of [...wrong, 'open', null, {other: 1}]) await post(message);
    await page.waitForFunction((n) => globalThis.messages.filter(({glint}) => glint === 'refused').length === n, wrong.length);
    assert.match((await messages('refused'))[2].why, /^set: no setting is called nothing; they are .*shading, /);
    // A name and a text are shown as they are.
    const name = `<img src=x onerror="parent.postMessage({glint: 'run'}, '*')">.cgfs`;
    await post({glint: 'open', scene: {name, text: '<script>parent.postMessage({glint: "run"}, "*")</script>'}});
    await page.waitForFunction(() => globalThis.messages.some(({glint}) => glint === 'errors'));
    assert.match((await messages('errors'))[0].messages[0], /:1:1: error: /);
    await post({glint: 'open', scene: {name: 'one.cgfs', text: 'sphere { center = (0, 0, 3) radius = 1 color = (9, 9, 9) }', overrides: {size: '40x30'}}});
    await rendered(page, 2);
    assert.deepEqual((await messages('rendered')).at(-1), {glint: 'rendered', width: 40, height: 30, origin: playground});
    await post({glint: 'get'});
    await page.waitForFunction(() => globalThis.messages.some(({glint}) => glint === 'scene'));
    assert.deepEqual((await messages('scene'))[0].scene.overrides, {size: '40x30'});
    assert.deepEqual(await messages('run'), []);
    // The wheel alone scrolls the page around.
    await page.mouse.move(60, 60);
    await page.mouse.wheel(0, 300);
    await post({glint: 'get'});
    await page.waitForFunction(() => globalThis.messages.filter(({glint}) => glint === 'scene').length === 2);
    assert.equal((await messages('scene'))[1].scene.text, (await messages('scene'))[0].scene.text);
    // A frame for another page neither hears nor tells anything.
    await show('https://example.org');
    await frame.locator('[data-state=done]').waitFor({state: 'attached'});
    await post({glint: 'open', scene: {name: 'one.cgfs', text: ''}});
    await page.waitForTimeout(300);
    assert.deepEqual(await framePicture(frame), before);
    assert.deepEqual(await page.evaluate(() => globalThis.messages), []);
}, 'empty.html', /target origin provided/));
