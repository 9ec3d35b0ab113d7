// SPDX-License-Identifier: Apache-2.0
// The camera, moved in the text by mouse, touch, wheel and buttons.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {choose, nativeText, picture, sceneText, settled, testOnOnePage, until, withPage} from './browser.mjs';

const cameras = ['cgfs/three_mirrors.cgfs', 'cgfs/from_the_side.cgfs', 'epfl/three_lights.json', 'snowman', 'csc473/glass_ball.pov',
                 'nff/pyramid.nff', 'glint/acne.glint', 'glint/lit_sphere.glint'];
testOnOnePage('orbit, pan and zoom move the camera', cameras.map((scene) => [scene]), async (page, scene) => {
    await choose(page, scene);
    const box = await page.locator('.frame').boundingBox();
    const at = [box.x + box.width / 2, box.y + box.height / 2];
    const seen = [await sceneText(page)];
    const drag = async (key) => {
        if (key) await page.keyboard.down(key);
        await page.mouse.move(...at);
        await page.mouse.down();
        for (let i = 1; i <= 5; ++i) await page.mouse.move(at[0] + 12 * i, at[1] + 6 * i);
        await page.mouse.up();
        if (key) await page.keyboard.up(key);
    };
    for (const act of [() => drag(), () => drag('Shift'), () => page.mouse.wheel(0, 300)]) {
        const before = await picture(page);
        const editor = page.locator('.cm-content');
        const visible = await editor.innerText();
        await page.mouse.move(...at);
        await act();
        await until(() => editor.innerText(), (now) => now !== visible);
        await settled(page);
        seen.push(await sceneText(page));
        assert.notEqual(seen.at(-1), seen.at(-2));
        assert.notDeepEqual(await picture(page), before);
    }
    assert.equal(await page.locator('.message.error').count(), 0);
    const name = await page.locator('.file-name').innerText();
    if (!name.includes(':')) assert.deepEqual(await picture(page), nativeText(name, seen.at(-1)));
});

test('what the camera looks at stays in the middle', () => withPage(async (page) => {
    await choose(page, 'glint/acne.glint');
    for (const name of ['Turn left', 'Turn left', 'Turn up', 'Nearer']) {
        await page.getByRole('button', {name}).click();
        await settled(page);
    }
    const text = await sceneText(page);
    assert.match(text, /look_at = \(0, 0\.8, 0\)/);
    const position = /position = \((.*?)\) {2}look_at/.exec(text)[1].split(', ').map(Number);
    const distance = Math.hypot(position[0], position[1] - 0.8, position[2]);
    assert.ok(Math.abs(distance - Math.hypot(1.4, 9) / 1.15) < 0.01, `${distance}`);
}));

/** The position of the camera of acne.glint. */
async function eye(page) {
    return /camera {[^}]*position = \((.*?)\)/.exec(await sceneText(page))[1].split(', ').map(Number);
}

test('moves that follow each other faster than pictures add up', () => withPage(async (page) => {
    await choose(page, 'glint/acne.glint');
    const start = await eye(page);
    await page.getByRole('button', {name: 'Turn left'}).evaluate((button) => {
        for (let i = 0; i < 5; ++i) button.click();
    });
    await settled(page);
    const end = await eye(page);
    const angle = ([x, , z]) => Math.atan2(x, z);
    const turned = Math.abs(angle(end) - angle(start));
    assert.ok(Math.abs(turned - 5 * 0.06 * Math.PI) < 0.01, `${turned}`);
}));

test('two fingers shift the camera and take it nearer; one turns it', () => withPage(async (page, context) => {
    await choose(page, 'glint/acne.glint');
    const touch = await context.newCDPSession(page);
    const box = await page.locator('.frame').boundingBox();
    const at = (x, y, id) => ({x: box.x + x * box.width, y: box.y + y * box.height, id});
    const send = (type, ...touchPoints) => touch.send('Input.dispatchTouchEvent', {type, touchPoints});
    const start = await eye(page);
    await send('touchStart', at(0.4, 0.5, 0));
    await send('touchStart', at(0.4, 0.5, 0), at(0.6, 0.5, 1));
    for (const d of [0.12, 0.15, 0.2]) await send('touchMove', at(0.5 - d, 0.5, 0), at(0.5 + d, 0.5, 1));
    await send('touchEnd', at(0.3, 0.5, 0));
    await send('touchMove', at(0.2, 0.2, 0));  // the finger that is left
    await send('touchEnd');
    await until(() => eye(page), (now) => now.join() !== start.join());
    await settled(page);
    const near = await eye(page);
    const range = ([x, y, z]) => Math.hypot(x, y - 0.8, z);
    assert.ok(Math.abs(range(near) / range(start) - 0.5) < 0.01, `${start} ${near}`);
    assert.match(await sceneText(page), /look_at = \(0, 0\.8, 0\)/);
    assert.equal(await page.locator('.inspector').count(), 0);
    await send('touchStart', at(0.5, 0.3, 0));
    for (const y of [0.4, 0.5, 0.6]) await send('touchMove', at(0.5, y, 0));
    await send('touchEnd');
    await until(() => eye(page), (now) => now.join() !== near.join());
    await settled(page);
    const over = await eye(page);
    assert.ok(over[1] > near[1] + 0.5 && Math.abs(range(over) / range(near) - 1) < 0.01, `${near} ${over}`);
    await page.touchscreen.tap(box.x + box.width / 2, box.y + box.height / 2);
    await page.locator('.inspector').waitFor();
}, {hasTouch: true}));

test('with Shift, the camera’s buttons shift it', () => withPage(async (page) => {
    await choose(page, 'glint/acne.glint');
    const start = await eye(page);
    await page.getByRole('button', {name: 'Turn right'}).focus();
    await page.keyboard.press('Shift+Enter');
    await settled(page);
    const end = await eye(page);
    assert.ok(end[0] > start[0] + 0.1 && Math.abs(end[2] - start[2]) < 1e-3, `${start} ${end}`);
}));
