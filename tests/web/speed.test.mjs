// SPDX-License-Identifier: Apache-2.0
// Pictures come soon, and while something is dragged they keep coming, in the book's scene at 600 x 600. The times are judged only
// while nothing else uses the machine; tools/run-tests runs this file by itself.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {nativeText, picture, sceneText, settled, withPage} from './browser.mjs';
import {judged} from './machine.mjs';

/** Notes in `shown` when pixels of the picture were drawn, from the page's first script on. */
function noteDrawing() {
    globalThis.shown = [];
    for (const name of ['putImageData', 'drawImage']) {
        const real = CanvasRenderingContext2D.prototype[name];
        CanvasRenderingContext2D.prototype[name] = function(...parts) {
            if (this.canvas.closest?.('.frame')) globalThis.shown.push(performance.now());
            return real.apply(this, parts);
        };
    }
}

/** Calls the page's function moveTo() in each frame until there were so many pictures: those a second. */
const drag = (page) => page.evaluate(async () => {
    const first = 10, count = 40;  // the first ones may be slower
    const begin = performance.now();
    let pictures = 0, from = begin, last = 0;
    while (pictures < count) {
        const now = performance.now();
        if (now - begin > 90_000) throw new Error(`only ${pictures} pictures while something is dragged`);
        globalThis.moveTo((now - begin) / 700);
        await new Promise((next) => requestAnimationFrame(next));
        const newest = globalThis.shown.at(-1) ?? 0;
        if (newest <= last) continue;
        last = newest;
        if (++pictures === first) from = performance.now();
    }
    return 1000 * (count - first) / (performance.now() - from);
});

test('while a slider is dragged, pictures keep coming: more than 15 a second', () => withPage(async (page) => {
    await page.evaluate(noteDrawing);
    await page.evaluate(() => {
        const slider = [...document.querySelectorAll('[data-light="1"] input[type=range]')][1];
        globalThis.moveTo = (angle) => {
            slider.value = String(2 * Math.sin(3 * angle));
            slider.dispatchEvent(new Event('input', {bubbles: true}));
        };
    });
    const {isGood, words} = await judged('pictures a second while a slider is dragged', (figure) => figure > 15, () => drag(page));
    assert.ok(isGood, words);
    await settled(page);
    assert.deepEqual(await picture(page), nativeText('three_mirrors.cgfs', await sceneText(page)));
}));

test('while the camera is dragged, pictures keep coming: more than 10 a second', () => withPage(async (page) => {
    await page.evaluate(noteDrawing);
    const box = await page.locator('.frame').boundingBox();
    const middle = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(...middle);
    await page.mouse.down();
    await page.mouse.move(middle[0] + 10, middle[1]);
    await page.evaluate(([x, y]) => {
        const frame = document.querySelector('.frame');
        globalThis.moveTo = (angle) => frame.dispatchEvent(new PointerEvent('pointermove', {
            pointerId: 1, buttons: 1, bubbles: true, clientX: x + 120 * Math.sin(angle), clientY: y + 40 * Math.cos(angle),
        }));
    }, middle);
    const {isGood, words} = await judged('pictures a second while the camera is dragged', (figure) => figure > 10, () => drag(page));
    assert.ok(isGood, words);
    await page.mouse.up();
    await settled(page);
}));

test('the first picture comes soon', () => withPage(async (page, context) => {
    // The page once more, with the code compiled as in a second visit.
    const {isGood, words} = await judged('seconds to the first picture', (seconds) => seconds < 1.5, async () => {
        const fresh = await context.newPage();
        await fresh.addInitScript(noteDrawing);
        await fresh.goto(page.url());
        await settled(fresh);
        const [first] = await fresh.evaluate(() => globalThis.shown);
        await fresh.close();
        return first / 1000;
    });
    assert.ok(isGood, words);
}));
