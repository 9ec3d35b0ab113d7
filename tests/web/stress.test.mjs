// SPDX-License-Identifier: Apache-2.0
// Many edits, hostile texts, scenes that take very long.
import assert from 'node:assert/strict';
import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {book, choose, drop, native, nativeText, paste, picture, project, sceneText, scenes, settled, until, withPage} from './browser.mjs';

test('fifty rapid edits leave the picture of the last, and nothing behind', () => withPage(async (page, context) => {
    const session = await context.newCDPSession(page);
    await session.send('Performance.enable');
    const heap = async () => {
        await session.send('HeapProfiler.collectGarbage');
        const {metrics} = await session.send('Performance.getMetrics');
        const value = (name) => metrics.find((one) => one.name === name).value;
        return {bytes: value('JSHeapUsedSize'), nodes: value('Nodes')};
    };
    const edit = async () => {
        const intensity = page.locator('[data-light="1"]').getByRole('slider', {name: 'Intensity'});
        await intensity.evaluate(async (input) => {
            for (let i = 1; i <= 50; ++i) {
                input.value = String(i / 40);
                input.dispatchEvent(new Event('input', {bubbles: true}));
                if (i % 5 === 0) await new Promise((next) => setTimeout(next, 7 * (i % 3)));
            }
        });
        await settled(page);
    };
    await edit();
    const before = await heap();
    const workers = page.workers().length;
    for (let i = 0; i < 4; ++i) await edit();
    const text = await sceneText(page);
    assert.equal(text, book.replace('intensity = 0.6', 'intensity = 1.25'));
    assert.deepEqual(await picture(page), nativeText('three_mirrors.cgfs', text));
    const now = await until(heap, ({bytes, nodes}) => bytes < before.bytes + 4e6 && nodes < before.nodes + 200);
    assert.ok(now.bytes < before.bytes + 4e6, `${before.bytes} bytes, then ${now.bytes}`);
    assert.ok(now.nodes < before.nodes + 200, `${before.nodes} nodes, then ${now.nodes}`);
    assert.equal(page.workers().length, workers);
}));

const corpus = join(project, 'tests/fuzz/corpus');
const extensions = {cgfs: 'cgfs', csc473: 'pov', epfl: 'json', glint: 'glint', nff: 'nff'};

test('hostile texts neither hang the page nor cost it a worker', () => withPage(async (page) => {
    const workers = page.workers().length;
    let opened = 0;
    for (const family of readdirSync(corpus)) {
        for (const name of readdirSync(join(corpus, family))) {
            const text = readFileSync(join(corpus, family, name));
            const file = `${name}.${extensions[family] ?? 'glint'}`;
            await drop(page, {name: file, text});
            await page.waitForFunction((wanted) => document.querySelector('.file-name').textContent === wanted, file);
            await settled(page, 'done', 'error');
            ++opened;
        }
    }
    assert.ok(opened > 70, `${opened}`);
    await choose(page, 'cgfs/three_mirrors.cgfs');
    assert.deepEqual(await picture(page), native(join(scenes, 'cgfs/three_mirrors.cgfs')));
    assert.equal(page.workers().length, workers);
}));

test('a picture that would take hours is seen at once, coarse, and gives way to the next one', () => withPage(async (page) => {
    await choose(page, 'glint/hall_of_mirrors.glint');
    const hall = readFileSync(join(scenes, 'glint/hall_of_mirrors.glint'), 'utf8');
    await paste(page, hall.replace(/size.*reflections = 64/, 'size = 4000 x 3000  reflections = 1000  aa = 64'));
    await page.waitForFunction(() => document.querySelector('.frame canvas').width === 4000);
    await page.waitForFunction(() => /^rendering · [01]% · \d+\.\d M rays\/s/.test(document.querySelector('[data-state]').textContent));
    await paste(page, hall.replace(/size.*reflections = 64/, 'size = 60 x 45  reflections = 4'));
    await page.waitForFunction(() => document.querySelector('.frame canvas').width === 60);
    await settled(page);
    assert.deepEqual(await picture(page), nativeText('hall_of_mirrors.glint', await sceneText(page)));
}));

test('a picture too large for a page is drawn smaller', () => withPage(async (page) => {
    await paste(page, 'sphere { center = (0, 0, 3) radius = 1 color = (255, 0, 0) }\nlight { type = ambient intensity = 1 }\n');
    await settled(page);
    await page.getByRole('spinbutton', {name: 'Width'}).fill('65536');
    await page.waitForFunction(() => document.querySelector('.frame canvas').width > 10_000);
    await page.getByRole('spinbutton', {name: 'Height'}).fill('65536');
    await page.waitForFunction(() => document.querySelector('.frame canvas').width === 4096);
    await choose(page, 'cgfs/three_mirrors.cgfs');
    assert.deepEqual(await picture(page), native(join(scenes, 'cgfs/three_mirrors.cgfs')));
}));
