// SPDX-License-Identifier: Apache-2.0
// The inspector: its numbers add up to the pixel, and its lines lead to the text.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {choose, clickPicture, drop, nativeText, picture, sceneText, settled, withPage} from './browser.mjs';

/** The numbers of a table's row. */
async function numbers(row) {
    return (await row.locator('td').allInnerTexts()).map((text) => Number(text.replace('−', '-')));
}

for (const [scene, x, y] of [['cgfs/three_mirrors.cgfs', 0.5, 0.85], ['glint/glass.glint', 0.25, 0.5], ['epfl/mirror_room.json', 0.3, 0.6]]) {
    test(`a pixel of ${scene} is the sum of its parts`, () => withPage(async (page) => {
        await choose(page, scene);
        await clickPicture(page, x, y);
        const inspector = page.locator('.inspector');
        await inspector.waitFor();
        const [px, py] = (await inspector.getAttribute('data-pixel')).split(',').map(Number);
        const shown = await page.evaluate(([i, j]) => {
            const canvas = document.querySelector('.frame canvas');
            return [...canvas.getContext('2d').getImageData(i, j, 1, 1).data].slice(0, 3);
        }, [px, py]);
        const rows = inspector.locator('.layers tbody tr');
        const sum = [0, 0, 0];
        for (let i = 0; i < await rows.count(); ++i) (await numbers(rows.nth(i))).forEach((value, c) => (sum[c] += value));
        const total = await numbers(inspector.locator('[data-sum]'));
        // The table shows four digits.
        sum.forEach((value, c) => assert.ok(Math.abs(value - total[c]) < 1e-3, `${sum} ${total}`));
        assert.deepEqual(await numbers(inspector.locator('.layers tfoot tr').last()), shown);
        assert.ok(await rows.count() >= 2);
    }));
}

test('the ray tree opens and closes, and its terms lead to their lines', () => withPage(async (page) => {
    await clickPicture(page, 0.5, 0.62);
    await page.locator('.inspector').waitFor();
    const root = page.locator('.ray-node').first();
    assert.ok(await page.locator('.ray-node .ray-node').count() > 0, 'a mirror ray');
    assert.match(await root.locator('> summary').innerText(), /Camera ray hits sphere, line 6/);
    await root.locator('> summary').click();
    assert.equal(await root.getAttribute('open'), null);
    await root.locator('> summary').click();
    await page.locator('.light-terms').first().getByRole('button', {name: 'the light'}).click();
    await page.waitForFunction(() => document.querySelector('.editor').shadowRoot.querySelector('.cm-activeLine').textContent.includes('point'));
    await root.getByRole('button', {name: 'object'}).first().click();
    await page.waitForFunction(() => document.querySelector('.editor').shadowRoot.querySelector('.cm-activeLine').textContent.includes('(255, 0, 0)'));
    assert.ok(await page.locator('.frame .ray.mirror').count() > 0);
    assert.ok(await page.locator('.frame .ray.light').count() > 0);
    const angles = await page.locator('.angles dd').allInnerTexts();
    assert.equal(angles.length, 4);
    angles.forEach((angle) => assert.match(angle, /^\d+\.\d°$/));
}));

test('the view from above can be turned', () => withPage(async (page) => {
    await clickPicture(page, 0.5, 0.62);
    const top = page.locator('.top-frame');
    await top.scrollIntoViewIfNeeded();
    await page.waitForFunction(() => {
        const canvas = document.querySelector('.top-frame canvas');
        return new Set(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data).size > 20;
    });
    const before = await top.locator('line').first().getAttribute('x1');
    await top.focus();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowLeft');
    await page.waitForFunction((x) => document.querySelector('.top-frame line').getAttribute('x1') !== x, before);
}));

const balls = {
    'left-handed.cgfs': `
sphere { center = (-1, 0, 5) radius = 1 color = (255, 0, 0) }
sphere { center = (1.5, 0, 5) radius = 1 color = (0, 255, 0) }
light { type = ambient intensity = 1 }
light { type = point intensity = 0.1 position = (2, 2, 1) }
`,
    'right-handed.glint': `
camera { position = (5, 0, 0)  look_at = (0, 0, 0)  up = (0, 0, 1) }
sphere { center = (0, -1, 0)  radius = 1  color = (1, 0, 0)  ambient = 1 }
sphere { center = (0, 1.5, 0)  radius = 1  color = (0, 1, 0)  ambient = 1 }
light { type = ambient  intensity = 1 }
light { type = point  intensity = 0.1  position = (4, 2, 2) }
`,
};
for (const [name, text] of Object.entries(balls)) {
    test(`from above, what is at the right is at the right: ${name}`, () => withPage(async (page) => {
        await drop(page, {name, text});
        await page.waitForFunction((wanted) => document.querySelector('.file-name').textContent === wanted, name);
        await settled(page);
        await clickPicture(page, 0.4, 0.5);
        await page.locator('.top-frame').scrollIntoViewIfNeeded();
        const sides = () => page.evaluate(() => {
            const canvas = document.querySelector('.top-frame canvas');
            const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
            const sum = [0, 0], count = [0, 0];
            for (let i = 0; i < data.length; i += 4) {
                const ball = data[i] > 2 * data[i + 1] ? 0 : data[i + 1] > 2 * data[i] ? 1 : -1;
                if (ball < 0) continue;
                sum[ball] += (i / 4) % canvas.width;
                ++count[ball];
            }
            return sum.map((x, ball) => x / count[ball]);
        });
        await page.waitForFunction(() => {
            const canvas = document.querySelector('.top-frame canvas');
            return new Set(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data).size > 4;
        });
        const [red, green] = await sides();
        assert.ok(red + 20 < green, `red at ${red}, green at ${green}`);
        const light = page.locator('.top-frame line.light').first();
        assert.ok(Number(await light.getAttribute('x2')) > Number(await light.getAttribute('x1')) + 10);
        // The camera ray starts at the camera and goes up.
        const ray = page.locator('.top-frame line.camera').first();
        assert.ok(Number(await ray.getAttribute('y2')) < Number(await ray.getAttribute('y1')) - 10);
    }));
}

test('the view from above is of the scene that is open', () => withPage(async (page) => {
    const yellow = () => page.waitForFunction(() => {
        const canvas = document.querySelector('.top-frame canvas');
        const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        let count = 0;
        for (let i = 0; i < data.length; i += 4) count += data[i] > 100 && data[i + 1] === data[i] && data[i + 2] === 0;
        return count > data.length / 16;
    });
    await choose(page, 'glint/hall_of_mirrors.glint');
    await clickPicture(page, 0.5, 0.5);
    await page.locator('.top-frame').waitFor();
    await page.waitForTimeout(500);
    await choose(page, 'cgfs/three_mirrors.cgfs');
    await clickPicture(page, 0.5, 0.6);
    await page.locator('.top-frame').waitFor();
    await yellow();
}));

test('in a comparison, a pixel is explained in the picture it is seen in', () => withPage(async (page) => {
    await page.getByRole('tab', {name: 'Compare'}).click();
    await page.getByRole('button', {name: '0 | 3 reflections'}).click();
    await page.waitForSelector('.right-half canvas');
    await settled(page);
    const bytes = (index, x, y) => page.evaluate(([i, fx, fy]) => {
        const canvas = document.querySelectorAll('.frame canvas')[i];
        const at = (fraction, size) => Math.floor(fraction * size);
        return [...canvas.getContext('2d').getImageData(at(fx, canvas.width), at(fy, canvas.height), 1, 1).data].slice(0, 3).join(' ');
    }, [index, x, y]);
    await page.waitForFunction(() => document.querySelectorAll('.frame canvas')[1].width === 600);
    await page.waitForTimeout(1500);
    for (const [side, x, name] of [[0, 0.2, 'left'], [1, 0.8, 'right']]) {
        const expected = await bytes(side, x, 0.9);
        assert.notEqual(expected, await bytes(1 - side, x, 0.9));
        await clickPicture(page, x, 0.9);
        await page.waitForFunction((words) => document.querySelector('.inspector .mono')?.textContent === words, expected);
        assert.match(await page.locator('.inspector > .note').innerText(), new RegExp(`${name} picture: reflections = ${3 * side}`));
    }
    await page.getByRole('tab', {name: 'Compare'}).click();
    await page.getByRole('button', {name: '0 | 3 reflections'}).click();
    await page.getByRole('textbox', {name: 'Left'}).fill('1');
    await page.getByRole('textbox', {name: 'Right'}).fill('-7');
    await page.getByRole('textbox', {name: 'Right'}).blur();
    await page.waitForFunction(() => /expected a whole number/.test(document.querySelector('[role=alert]')?.textContent));
    assert.match(await page.locator('.tag.right').innerText(), /not rendered/);
    await page.getByRole('textbox', {name: 'Right'}).fill('2');
    await page.getByRole('textbox', {name: 'Right'}).blur();
    await page.waitForFunction(() => !document.querySelector('[role=alert]'));
}));

test('pointing at a pixel says what is there; a changed scene is explained anew', () => withPage(async (page) => {
    const box = await page.locator('.frame').boundingBox();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.7);
    await page.waitForFunction(() => /sphere, line 6/.test(document.querySelector('.pixel-line').textContent));
    await page.mouse.move(box.x + box.width / 2, box.y + 10);
    await page.waitForFunction(() => /background/.test(document.querySelector('.pixel-line').textContent));
    await clickPicture(page, 0.5, 0.7);
    const sum = page.locator('[data-sum]');
    const before = await sum.innerText();
    await page.getByRole('tab', {name: 'Controls'}).click();
    await page.locator('[data-light="0"]').getByRole('spinbutton', {name: 'Intensity'}).fill('0.4');
    await settled(page);
    await page.getByRole('tab', {name: 'Inspect'}).click();
    await page.waitForFunction((text) => document.querySelector('[data-sum]').innerText !== text, before);
}));

test('the inspector begins with a sentence, and its curves mark the present angle', () => withPage(async (page) => {
    await choose(page, 'cgfs/three_mirrors.cgfs');
    const sentenceAt = async (x, y, pattern) => {
        await clickPicture(page, x, y);
        await page.waitForFunction((source) => new RegExp(source).test(document.querySelector('.sentence')?.textContent), pattern);
    };
    await sentenceAt(0.0508, 0.6342, 'green (diffuse|ambient) light.*% is the sphere on line 9 in the mirror');
    await sentenceAt(0.5, 0.02, '^The ray hits nothing: this is the background\\.$');
    await drop(page, {name: 'plot.glint', text: `render { size = 100 x 100  shading = phong }
camera { position = (0, 0, 6) look_at = (0, 0, 0) }
light { position = (0, 0, 6) }
light "high" { position = (0, 9, 0) }
sphere { center = (0, 0, 0) radius = 2 color = (0, 1, 0) specular_color = (1, 1, 1) shininess = 7 }
sphere "lid" { center = (0, 5, 0.5) radius = 2 }\n`});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'plot.glint');
    await settled(page);
    await sentenceAt(0.502, 0.35, 'green diffuse light; the light “high” is blocked by the sphere “lid”');
    const captions = await page.locator('.plot figcaption').allInnerTexts();
    const angles = await page.locator('.angles dd').allInnerTexts();
    assert.equal(captions.length, 2);
    assert.match(captions[1], /\(R·V\)\^7/);
    assert.ok(captions[0].includes(angles[0]) && captions[1].includes(angles[2]), `${captions} ${angles}`);
    assert.equal(await page.locator('.plot .now').count(), 2);
}));

test('the object that is clicked has controls, which change its numbers in the text', () => withPage(async (page) => {
    const text = `render { size = 100 x 100 }
camera { position = (0, 0, 6) look_at = (0, 0, 0) }
light { position = (0, 0, 6) }
material red { color = rgb255(200, 30, 20)  shininess = 7 }
sphere "ball" { center = (0, 0, 0)  radius = 2  material = red }\n`;
    await drop(page, {name: 'object.glint', text});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'object.glint');
    await settled(page);
    await clickPicture(page, 0.5, 0.5);
    const controls = page.locator('.object-controls');
    await controls.getByRole('spinbutton', {name: 'sphere: radius'}).fill('1.5');
    await settled(page);
    await controls.getByRole('spinbutton', {name: 'material red: color 2'}).fill('90');
    await settled(page);
    const now = text.replace('radius = 2', 'radius = 1.5').replace('200, 30, 20', '200, 90, 20');
    assert.equal(await sceneText(page), now);
    assert.deepEqual(await picture(page), nativeText('object.glint', now));
}));
