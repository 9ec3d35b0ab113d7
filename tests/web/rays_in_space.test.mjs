// SPDX-License-Identifier: Apache-2.0
// The view in space: its own buttons for the rays, labels that cover nothing, and a look into a closed room.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {choose, clickPicture, shoot, until, withPage} from './browser.mjs';
import {pageModule} from './page_module.mjs';

const explain = async (page, x, y) => {
    await page.getByRole('tab', {name: 'Inspect'}).click();
    await clickPicture(page, x, y);
    await page.locator('.inspector').waitFor();
    await page.getByRole('button', {name: 'Large', exact: true}).click();
    await page.locator('.stage .space-frame').waitFor();
};

test('the view’s own buttons go through the rays, and play them', () => withPage(async (page) => {
    await explain(page, 0.2, 0.6);
    const words = page.locator('.stage .step-buttons span');
    assert.equal(await words.innerText(), '3 rays');
    const forward = page.getByRole('button', {name: 'Step forward'});
    await forward.click();
    assert.match(await words.innerText(), /^1 of 3: camera ray hits sphere, line 7$/);
    // The camera ray runs; those of later rays are faint.
    const now = page.locator('.stage .space-frame .ray.now.camera');
    assert.equal(await now.first().evaluate((one) => getComputedStyle(one).animationName), 'run');
    assert.ok(await page.locator('.stage .space-frame .ray.later').count() > 0);
    await forward.click();
    assert.match(await words.innerText(), /^2 of 3: mirror ray /);
    await page.getByRole('button', {name: 'Step back'}).click();
    assert.match(await words.innerText(), /^1 of 3/);
    await page.getByRole('button', {name: 'Play', exact: true}).click();
    await page.getByRole('button', {name: 'Stop', exact: true}).waitFor();
    await words.getByText(/^2 of 3/).waitFor();
    await words.getByText(/^3 of 3/).waitFor();
    await page.getByRole('button', {name: 'Play', exact: true}).waitFor();
    assert.match(await words.innerText(), /^3 of 3/);
}));

test('who asks for less motion sees no running rays', () => withPage(async (page) => {
    await explain(page, 0.2, 0.6);
    await page.getByRole('button', {name: 'Step forward'}).click();
    assert.equal(await page.locator('.stage .space-frame .ray.now.camera').first().evaluate((one) => getComputedStyle(one).animationName), 'none');
}, {reducedMotion: 'reduce'}));

test('labels are in the view, and cover no other label and no handle', async () => {
    const {placeLabels} = await pageModule('space/labels.ts');
    const view = {width: 340, height: 255};
    const lines = ['sphere, line 7', 'blocks directional light, line 13'];
    const points = [[20, 20], [25, 24], [330, 20], [330, 250], [170, 120], [172, 122]];
    const taken = [{x: 157, y: 107, width: 26, height: 26}];
    const boxes = placeLabels(points.map(([x, y]) => ({x, y, lines})), view, taken);
    assert.ok(boxes.filter(Boolean).length >= 5, JSON.stringify(boxes));
    const all = [...boxes.filter(Boolean), ...taken];
    for (const [i, a] of all.entries()) {
        assert.ok(a.x >= 0 && a.y >= 0 && a.x + a.width <= view.width && a.y + a.height <= view.height, JSON.stringify(a));
        for (const b of all.slice(i + 1)) assert.ok(a.x >= b.x + b.width || b.x >= a.x + a.width || a.y >= b.y + b.height || b.y >= a.y + a.height, JSON.stringify([a, b]));
    }
    assert.deepEqual(placeLabels([{x: -5, y: 10, lines}, {x: 5, y: 10, lines: ['x'.repeat(80)]}], view, []), [null, null]);
});

test('the labels of the page are inside the view', () => withPage(async (page) => {
    await explain(page, 0.2, 0.6);
    const isInside = () => page.evaluate(() => {
        const outer = document.querySelector('.stage .space-body').getBoundingClientRect();
        const texts = [...document.querySelectorAll('.stage .blocker text')].map((one) => one.getBoundingClientRect());
        return texts.length > 0 && texts.every((one) => one.left >= outer.left && one.right <= outer.right && one.top >= outer.top && one.bottom <= outer.bottom);
    });
    assert.ok(await until(isInside, (inside) => inside));
}));

test('into a closed room the view looks from above, so that its rays are seen', () => withPage(async (page) => {
    await choose(page, 'epfl/mirror_room.json');
    await explain(page, 0.75, 0.35);
    const share = () => page.evaluate(() => {
        const long = (one) => Math.hypot(one.x2.baseVal.value - one.x1.baseVal.value, one.y2.baseVal.value - one.y1.baseVal.value);
        const rays = [...document.querySelectorAll('.stage .space-frame .ray:is(.camera, .mirror)')];
        const sum = (list) => list.reduce((all, one) => all + long(one), 0);
        return sum(rays.filter((one) => !one.classList.contains('hidden'))) / Math.max(1, sum(rays));
    });
    const slider = page.getByRole('slider', {name: 'Cut away'});
    assert.ok(Number(await until(() => slider.inputValue(), (now) => Number(now) > 0.6)) > 0.6);
    const seen = await until(share, (now) => now > 0.8 && now < 1);  // 1: before the depths are known
    assert.ok(seen > 0.8, `${seen} of the rays`);
    await shoot(page, 'mirror_room_in_space.png');
    // The cut was the view's own choice, so another scene begins without it.
    await choose(page, 'cgfs/three_spheres.cgfs');
    assert.equal(await until(() => slider.inputValue(), (now) => now === '0'), '0');
}));
