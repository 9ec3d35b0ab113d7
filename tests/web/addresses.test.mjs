// SPDX-License-Identifier: Apache-2.0
// Each scene, lesson, step and challenge has an address, which Back, a reload and a link to it keep.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {address, choose, clickPicture, paste, sceneText, settled, withPage} from './browser.mjs';

const hash = (page) => page.evaluate(() => location.hash);
const named = (page, name) => page.waitForFunction((wanted) => document.querySelector('.file-name').textContent === wanted, name);

test('Back and forward go through scenes, a lesson’s steps and a challenge, with what was changed', () => withPage(async (page) => {
    await choose(page, 'epfl/castle.json');
    assert.equal(await hash(page), '#scene=epfl/castle.json');
    const changed = (await sceneText(page)).replace('"fov": 50', '"fov": 40');
    await paste(page, changed);
    await settled(page);
    await page.getByRole('tab', {name: 'Learn'}).click();
    await page.locator('[data-lesson="02_diffuse"]').click();
    await named(page, 'diffuse.glint');
    assert.equal(await hash(page), '#lesson=02_diffuse');
    await page.getByRole('button', {name: 'Next step'}).click();
    assert.equal(await hash(page), '#lesson=02_diffuse/2');
    await page.goBack();
    await page.locator('.step[data-step="0"][aria-current=step]').waitFor();
    await page.goBack();
    await named(page, 'castle.json');
    assert.equal(await sceneText(page), changed, 'as it was left');
    assert.equal(await page.locator('.lesson').count(), 0);
    await page.goForward();
    await page.locator('.lesson[data-open="02_diffuse"]').waitFor();
    await page.getByRole('button', {name: 'All lessons and challenges'}).click();
    assert.equal(await hash(page), '');
    await page.locator('[data-challenge="c03"]').click();
    assert.equal(await hash(page), '#challenge=c03');
    await named(page, 'c03.glint');
    await page.goBack();
    await page.goBack();
    await page.locator('.lesson[data-open="02_diffuse"]').waitFor();
    await named(page, 'diffuse.glint');
}));

test('a reload keeps the step and the text', () => withPage(async (page) => {
    await page.getByRole('tab', {name: 'Learn'}).click();
    await page.locator('[data-lesson="01_ambient"]').click();
    await named(page, 'ambient.glint');
    await page.getByRole('button', {name: 'Next step'}).click();
    const changed = (await sceneText(page)).replace('intensity = 0.2', 'intensity = 0.9');
    await paste(page, changed);
    await settled(page);
    await page.reload();
    await settled(page);
    await page.locator('.lesson[data-open="01_ambient"] .step[data-step="1"][aria-current=step]').waitFor();
    assert.equal(await sceneText(page), changed);
}));

test('addresses open what they name', () => withPage(async (page, context) => {
    for (const [fragment, file, selector] of [
        ['#scene=epfl/two_scenes.js/pipes', 'two_scenes.js: pipes', null], ['#challenge=case_02', 'case_02.glint', '.challenge[data-open="case_02"]'],
        ['#lesson=03_specular/3', 'specular.glint', '.step[data-step="2"][aria-current=step]'],
    ]) {
        const other = await context.newPage();
        await other.goto(address + fragment);
        await settled(other);
        await named(other, file);
        if (selector) await other.locator(selector).waitFor();
        // A step begins with what the steps before have left.
        if (fragment.startsWith('#lesson')) assert.match(await sceneText(other), /shininess = 200 {2}specular_color/);
        await other.close();
    }
    await page.locator('.brand a').click();
    await named(page, 'three_mirrors.cgfs');
    // An address of nothing shows a scene, and says so.
    const other = await context.newPage();
    await other.goto(`${address}#scene=old_name.glint`);
    await settled(other);
    assert.match(await other.locator('.notice').innerText(), /no scene old_name\.glint/);
    // One that is written in another way is put right, and does not trap Back.
    await other.goto(`${address}#lesson=01_ambient/1`);
    await named(other, 'ambient.glint');
    assert.equal(await hash(other), '#lesson=01_ambient');
    await other.goBack();
    await other.waitForFunction(() => !location.hash.startsWith('#lesson'));
    await other.close();
}));

test('another scene ends the lesson', () => withPage(async (page) => {
    await page.locator('.welcome').getByRole('button', {name: 'A lesson'}).click();
    await page.locator('.lesson').waitFor();
    await choose(page, 'epfl/castle.json');
    await page.getByRole('tab', {name: 'Learn'}).click();
    await page.locator('.learn-list').first().waitFor();
    assert.equal(await page.locator('.lesson').count(), 0);
}));

test('a link carries the pixel, the panel and the ray', () => withPage(async (page, context) => {
    await choose(page, 'cgfs/three_mirrors.cgfs');
    await clickPicture(page, 0.5, 0.75);
    await page.getByRole('button', {name: 'Next ray'}).click();
    const pixel = await page.locator('.inspector').getAttribute('data-pixel'), step = await page.locator('.stepper p').innerText();
    assert.match(step, /^Ray 1 of/);
    await page.getByRole('button', {name: 'Share link'}).click();
    await page.waitForFunction(() => location.hash.startsWith('#1='));
    const other = await context.newPage();
    await other.goto(page.url());
    await settled(other);
    await other.locator(`.inspector[data-pixel="${pixel}"]`).waitFor();
    assert.equal(await other.locator('.stepper p').innerText(), step);
    await other.close();
}));
