// SPDX-License-Identifier: Apache-2.0
// A picture of the user's own ray tracer beside the scene's: its difference, and what glint says of it.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';

import {choose, clickPicture, drop, project, settled, shoot, withPage} from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'glint-own-'));
after(() => rmSync(folder, {recursive: true}));

const scene = readFileSync(join(project, 'scenes/cgfs/three_spheres.cgfs'), 'utf8');

/** The picture that the command draws of a text: what another program may have drawn. */
function drawn(text, name, ...args) {
    writeFileSync(join(folder, 'own.cgfs'), text);
    execFileSync(join(project, 'build/release/glint'), ['render', join(folder, 'own.cgfs'), '-q', '-o', join(folder, name), ...args]);
    return {name, text: readFileSync(join(folder, name))};
}

const answered = (page) => page.waitForSelector('.own[data-answered=true]', {timeout: 300_000});

test('a picture without ambient light is compared, and glint says what is missing', () => withPage(async (page) => {
    await choose(page, 'cgfs/three_spheres.cgfs');
    await drop(page, drawn(scene.replace(/light { type = ambient.*\n/, ''), 'mine.png'));
    await answered(page);
    const own = page.locator('.own');
    assert.match(await own.innerText(), /% of the pixels are equal.*on average/s);
    assert.match(await own.locator('.hints li').first().innerText(), /ambient/i);
    assert.match(await page.locator('.tag.right').innerText(), /mine\.png/);
    await clickPicture(page, 0.5, 0.6);
    await page.locator('.pixel-line', {hasText: 'yours'}).waitFor();
    await page.getByRole('tab', {name: 'Compare'}).click();
    await shoot(page, 'own_picture.png');
    await page.getByText('Show the difference').click();
    await page.getByText('Shown four times as large.').waitFor();
    await page.getByText('Show the difference').click();
    await page.getByRole('button', {name: 'Close your picture'}).click();
    assert.equal(await page.locator('.tag.right').count(), 0);
}));

test('right pictures of any kind agree, also in another size', () => withPage(async (page) => {
    await choose(page, 'cgfs/three_spheres.cgfs');
    const ppm = drawn(scene, 'mine.ppm', '-s', '90x90');
    const numbers = [...ppm.text.subarray(ppm.text.length - 3 * 90 * 90)];
    await drop(page, ppm);
    await page.getByText(/Your picture has 90 × 90 pixels/).waitFor();
    await page.getByRole('button', {name: 'Render at 90 × 90'}).click();
    await settled(page);
    await page.getByText('All pixels are equal.').waitFor();
    for (const file of [drawn(scene, 'mine.png', '-s', '90x90'), {name: 'plain.ppm', text: `P3\n# by hand\n90 90 255\n${numbers.join(' ')}\n`}]) {
        await drop(page, file);
        await page.locator('.own h2', {hasText: file.name}).waitFor();
        await page.getByText('All pixels are equal.').waitFor();
    }
    await choose(page, 'cgfs/three_mirrors.cgfs');
    assert.equal(await page.locator('.own').count(), 0, 'the picture was of another scene');
}));

test('pictures that cannot be read are named', () => withPage(async (page) => {
    for (const [file, why] of [
        [{name: 'a.png', text: 'no picture'}, /a\.png is not opened: the browser cannot read it/], [{name: 'a.ppm', text: 'P6 9 9 255 abc'}, /a\.ppm is not opened: it is cut off/],
        [{name: 'a.ppm', text: 'P5 9 9 255 abc'}, /no PPM of colors/], [{name: 'b.ppm', text: 'P3 0 9 255'}, /no width, height/], [{name: 'c.ppm', text: 'P3 1 1 255 1 x 2'}, /no number/],
        [{name: 'a.exr', text: ''}, /a\.exr is not opened: byte 0: the file is cut off/],
    ]) {
        await drop(page, file);
        await page.waitForFunction((source) => new RegExp(source).test(document.querySelector('.notice')?.textContent), why.source);
    }
}));
