// SPDX-License-Identifier: Apache-2.0
// Every scene of the gallery, opened by the page's menu, gives the native bytes.
import assert from 'node:assert/strict';
import {readdirSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {choose, native, picture, scenes, settled, withPage} from './browser.mjs';

const files = readdirSync(scenes, {withFileTypes: true})
    .flatMap((folder) => readdirSync(join(scenes, folder.name), {withFileTypes: true})
        .filter((entry) => entry.isFile()).map((entry) => `${folder.name}/${entry.name}`))
    .filter((file) => !file.startsWith('gltf/'));  // tools/make-gallery.mjs leaves them out

/** The page's name for a scene, and the native command's arguments for it. */
function pictures(file) {
    const path = join(scenes, file);
    if (file.endsWith('only_lights.cgfs')) return [];
    if (file.endsWith('only_spheres.cgfs')) return [['cgfs/two_listings.cgfs', [path, path.replace('only_spheres', 'only_lights')]]];
    if (file.endsWith('two_scenes.js')) return ['snowman', 'pipes'].map((name) => [name, [path, '--scene', name]]);
    return [[file, [path]]];
}

/** Scenes that take the page half a minute, and the size at which they are compared. */
const slow = new Map([['glint/peapod.glint', '160x105'], ['glint/figure.glint', '160x120']]);

/** Opens a scene, and makes its picture smaller when it has begun. */
async function openSlow(page, name, size) {
    await page.getByRole('button', {name: 'Scenes', exact: true}).click();
    await page.locator(`[data-scene$="${name}"]`).click();
    await page.waitForFunction((wanted) => document.querySelector('.file-name').textContent === wanted.split('/')[1] &&
        !document.querySelector('.frame').classList.contains('before'), name);
    const [width, height] = size.split('x');
    await page.getByRole('spinbutton', {name: 'Width'}).fill(width);
    await page.waitForFunction((now) => document.querySelector('.frame canvas').width === now, Number(width));
    await page.getByRole('spinbutton', {name: 'Height'}).fill(height);
    await settled(page);
}

for (const family of ['cgfs', 'csc473', 'epfl', 'glint', 'nff', 'faults']) {
    test(`the gallery: ${family}`, () => withPage(async (page) => {
        const list = files.filter((file) => file.startsWith(`${family}/`)).flatMap(pictures);
        assert.ok(list.length >= 2);
        for (const [name, args] of list) {
            if (slow.has(name)) {
                await openSlow(page, name, slow.get(name));
                args.push('-s', slow.get(name));
            } else {
                await choose(page, name);
            }
            assert.deepEqual(await picture(page), native(...args), name);
            assert.deepEqual(await page.locator('input:invalid').evaluateAll((all) => all.map((one) => one.labels[0]?.textContent)), [], name);
        }
        // The menu has no scene that is missing in this test.
        assert.equal(await page.locator('.thumb').count(), files.flatMap(pictures).length);
    }));
}
