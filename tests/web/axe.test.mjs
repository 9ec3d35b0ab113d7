// SPDX-License-Identifier: Apache-2.0
// axe-core finds no violation in any view, in both themes, wide and narrow; and the page is small.
import assert from 'node:assert/strict';
import {readdirSync, readFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {test} from 'node:test';
import {gzipSync} from 'node:zlib';

import {address, clickPicture, drop, project, settled, shoot, until, withPage} from './browser.mjs';

const axe = readFileSync(createRequire(new URL('../../web/package.json', import.meta.url)).resolve('axe-core/axe.min.js'), 'utf8');

/** The violations of the present view. */
async function violations(page) {
    const {list} = await page.evaluate(async () => {
        const found = await globalThis.axe.run(document, {
            runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa', 'best-practice'],
            rules: {'label-content-name-mismatch': {enabled: true}, 'target-size': {enabled: true}},
            resultTypes: ['violations'],
        });
        return {list: found.violations.map(({id, nodes}) => `${id}: ${nodes.slice(0, 3).map((node) => `${node.target} ${node.html.slice(0, 90)}`).join(' | ')} (${nodes.length})`)};
    });
    return list;
}

/** Of the book's scene, with a wrong P and a key that glint does not know. */
const wrongLog = 'pixel 300 400\nray camera\norigin 0 0 0\ndirection 0.000833 -0.167 1\nP 0 1 2\nN 0 1 0\nlight 2\nN.L 0.3\nmood 1\npixel 9 9\nray camera\norigin 0 0 0\nmiss\n';

const views = [
    ['the first visit', () => {}],
    ['a message', async (page) => {
        await drop(page, {name: 'notes.txt', text: ''});
        await page.locator('.notice').waitFor();
    }],
    ['Inspect', async (page) => {
        await page.getByRole('button', {name: 'Dismiss'}).last().click();
        await clickPicture(page, 0.5, 0.62);
        await page.locator('.inspector').waitFor();
        await page.locator('.space-frame').waitFor();
        await page.getByRole('button', {name: 'Next ray'}).click();
    }],
    ['In space', async (page) => {
        await page.getByRole('button', {name: 'Large'}).click();
        await page.locator('.stage > .space .space-frame').waitFor();
        await page.waitForTimeout(600);
    }],
    ['Controls', async (page) => {
        await page.getByRole('button', {name: 'Back to the picture'}).click();
        await page.getByRole('tab', {name: 'Controls'}).click();
        await page.getByText('Conventions', {exact: true}).click();
        await page.getByRole('combobox', {name: 'Shading', exact: true}).selectOption('blinn-phong');
        await settled(page);
    }],
    ['Compare', async (page) => {
        await page.getByRole('tab', {name: 'Compare'}).click();
        await page.getByRole('button', {name: '0 | 3 reflections'}).click();
        await settled(page);
    }],
    ['your log', async (page) => {
        await page.getByRole('button', {name: 'End the comparison'}).click();
        await drop(page, {name: 'mine.log', text: wrongLog});
        await page.locator('.log-finding').first().waitFor();
        await page.locator('.own-log .space-frame').waitFor();
        await page.getByRole('button', {name: 'Show this value'}).first().click();
        await page.waitForTimeout(600);
    }],
    ['a bad log', async (page) => {
        await drop(page, {name: 'bad.log', text: 'pixel 1 2\nray\n'});
        await page.locator('.own-log [role=alert]').waitFor();
        await page.evaluate(() => scrollTo(0, 0));
    }],
    ['Learn', async (page) => {
        await page.getByRole('button', {name: 'Close your log'}).click();
        await page.getByRole('tab', {name: 'Learn'}).click();
        await page.getByText('Your own challenge').click();
    }],
    ['a lesson', async (page) => {
        await page.locator('[data-lesson="05_attenuation"]').click();
        await page.locator('.lesson').waitFor();
        await settled(page);
        await page.getByText('Solution').click();
    }],
    ['a challenge', async (page) => {
        await page.getByRole('button', {name: 'All lessons and challenges'}).click();
        await page.locator('[data-challenge="case_01"]').click();
        await page.waitForFunction(() => /differ/.test(document.querySelector('.difference')?.textContent));
    }],
    ['on a projector', async (page) => {
        if (page.viewportSize().width < 1012) return;  // phones have no button for it
        await page.getByRole('button', {name: 'For a projector'}).click();
        await page.locator('.shell.projector.with-task').waitFor();
    }],
    ['Share', async (page) => {
        if (page.viewportSize().width < 1012) await page.locator('.more summary').click();
        else await page.getByRole('button', {name: 'For a projector'}).click();
        await page.getByRole('button', {name: 'Embed…'}).click();
        await page.getByRole('dialog', {name: 'Share'}).waitFor();
    }],
    ['an included text', async (page) => {
        await page.keyboard.press('Escape');
        const text = 'include "ball.glint"\nrender { size = 80 x 60 }\ncamera { position = (0, 0, 6)  look_at = (0, 0, 0) }\nlight { position = (4, 4, 4) }\n';
        await drop(page, {name: 'main.glint', text}, {name: 'ball.glint', text: 'sphere { center = (0, 0, 0)  radius = 2 }\n'});
        await page.waitForFunction(() => document.querySelector('[title="main.glint"]'));
        await settled(page);
        await clickPicture(page, 0.5, 0.5);
        await page.locator('.pixel-line .link').click();
        await page.getByRole('textbox', {name: 'Text of ball.glint'}).waitFor();
    }],
    ['Scenes', async (page) => {
        await page.getByRole('button', {name: 'Scenes', exact: true}).click();
    }],
    ['errors', async (page) => {
        await page.keyboard.press('Escape');
        await drop(page, {name: 'bad.glint', text: `include "gone.glint"\nsphere { oops = 1 }\n${'oops\n'.repeat(30)}`});
        await settled(page, 'error');
        if (page.viewportSize().width < 1012) await page.getByRole('tab', {name: 'Text'}).click();
    }],
];

for (const scheme of ['light', 'dark']) {
    for (const width of [1440, 360]) {
        test(`no violation: ${scheme}, ${width} pixels`, () => withPage(async (page) => {
            await page.evaluate(axe);
            const found = [];
            for (const [name, open] of views) {
                await open(page);
                found.push(...(await violations(page)).map((one) => `${name}: ${one}`));
                await shoot(page, `view_${scheme}_${width}_${name.replaceAll(' ', '_')}.png`);
            }
            assert.deepEqual(found, []);
        }, {scheme, width, height: width === 360 ? 740 : 900}));
    }
}

const dist = join(project, 'web/dist');
const compressed = (names) => names.reduce((sum, name) => sum + gzipSync(readFileSync(join(dist, name)), {level: 9}).length, 0);

test('a first visit loads less than 700 kB, compressed, before its first picture', () => withPage(async (_, context) => {
    const page = await context.newPage();
    const wanted = new Set(), later = [];
    const nameOf = (request) => new URL(request.url()).pathname.slice(1) || 'index.html';
    page.on('request', (request) => {
        if (request.url().startsWith(address)) wanted.add(nameOf(request));
    });
    // What may come later is withheld: the first picture has to do without it.
    await page.route(/\/(glint-(?!core)[^/]*[.]wasm|(SpaceView|lessons|challenges|help|unzip|png|exr|exr_file|pako)-[^/]*)$/, (route) => void later.push(route.request()));
    await page.goto(address);
    await settled(page);
    await until(() => later.some((request) => request.url().endsWith('.wasm')), Boolean);
    for (const request of later) wanted.delete(nameOf(request));
    const files = [...wanted];
    for (const kind of ['index.html', '.css', '.js', 'worker-', 'glint-core']) assert.ok(files.some((name) => name.includes(kind)), `${kind} in ${files}`);
    const size = compressed(files);
    console.log(`# ${size} bytes: ${files.join(', ')}`);
    assert.ok(size < 700_000, `${size} bytes: ${files}`);
    await page.close();
}));

test('all that the page ever loads is under 1.7 MB, compressed', () => {
    const files = readdirSync(dist, {recursive: true}).map(String).filter((name) => /\.(html|js|css|wasm|svg)$/.test(name));
    assert.ok(files.filter((name) => name.endsWith('.wasm')).length === 2 && files.length > 5);
    const size = compressed(files);
    console.log(`# ${size} bytes`);
    assert.ok(size < 1.7e6, `${size} bytes`);
});
