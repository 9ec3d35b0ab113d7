// SPDX-License-Identifier: Apache-2.0
// The log of the user's own ray tracer: what is found in it, its values beside what they should be, and the pixel in the picture.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';

import {book, choose, clickPicture, drop, paste, project, sceneText, settled, shoot, until, withPage} from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'glint-log-'));
after(() => rmSync(folder, {recursive: true}));

const castle = join(project, 'scenes/epfl/castle.json'), pixels = ['240,180', '60,270', '300,225', '390,300'];

/** The log that the ray tracer of tests/diagnose writes of the castle, with a mistake. */
function logged(mistake, width, ...of) {
    const file = join(folder, 'mine.log');
    execFileSync('node', [join(project, 'tests/diagnose/tracer.mjs'), width, width, castle].map(String), {
        env: {...process.env, MISTAKE: mistake, GLINT_PIXELS: of.join(';'), GLINT_LOG: file}, maxBuffer: 1 << 26,
    });
    return {name: 'mine.log', text: readFileSync(file, 'utf8')};
}

/** What the command finds in it. */
function byCommand({text}, ...args) {
    const file = join(folder, 'of_command.log');
    writeFileSync(file, text);
    try {
        execFileSync(join(project, 'build/release/glint'), ['diagnose', castle, file, '--json', ...args], {stdio: ['ignore', 'pipe', 'pipe']});
    } catch (error) {
        return JSON.parse(error.stdout);  // something differs
    }
    return null;
}

/** Opens the castle in the size of the logs. */
async function openCastle(page, size = 480) {
    await choose(page, 'castle.json');
    await page.getByRole('tab', {name: 'Controls'}).click();
    for (const label of ['Width', 'Height']) await page.getByRole('spinbutton', {name: label, exact: true}).first().fill(String(size));
    await settled(page);
    await page.waitForFunction((wanted) => document.querySelector('[data-state=done]')?.textContent.startsWith(`${wanted}×${wanted}`), size);
}

const answered = (page) => page.waitForSelector('.own-log[data-answered=true]', {timeout: 300_000});

test('the first wrong quantity of a log is named as by the command, and its values are shown beside what they should be', () => withPage(async (page) => {
    await openCastle(page);
    const log = logged('light-not-unit', 480, ...pixels), command = byCommand(log, '-s', '480x480');
    await drop(page, log);
    await answered(page);
    const own = page.locator('.own-log');
    assert.match(await own.locator('[role=status]').innerText(), /^\d+ values of \d+ rays in 4 pixels were compared.*quantities differ/);
    for (const sentence of command.conventions) assert.ok((await own.locator('.log-facts').innerText()).includes(sentence), sentence);
    const findings = own.locator('.log-finding');
    assert.deepEqual(await findings.evaluateAll((all) => all.map((one) => one.dataset.quantity)), command.findings.map(({quantity}) => quantity));
    const first = await findings.first().innerText();
    assert.match(first, /^N\.L is wrong in 4 of 4 pixels, in 4 as the first difference/);
    assert.ok(first.includes(`Cause: ${command.findings[0].causes[0].explanation}`), first);
    assert.match(first, /N\.L = the cosine of the unit vectors N and L; see LIGHT-5, The lighting equation/);

    const tree = own.locator('.log-tree');
    assert.equal(await tree.getAttribute('data-pixel'), command.findings[0].example.pixel.join());
    const rows = command.rows.filter(({pixel}) => pixel.join() === command.findings[0].example.pixel.join());
    assert.deepEqual(await tree.locator('tbody tr:not(.of)').evaluateAll((all) => all.map((one) => one.className.replace(' first', ''))), rows.map(({verdict}) => verdict));
    assert.equal(await tree.locator('tr.first').count(), 1);
    const [yours, expected] = await tree.locator('tr.first td').allInnerTexts();
    const wrong = rows.find(({verdict}) => verdict === 'wrong');
    assert.match(await tree.locator('tr.first th').innerText(), /^✗\s*N\.L/);
    assert.ok(Math.abs(Number(yours) / wrong.yours - 1) < 1e-3 && Math.abs(Number(expected) / wrong.expected - 1) < 1e-3, `${yours} ${expected}`);
    assert.deepEqual(await tree.locator('.of').first().allInnerTexts(), ['point light, line 19']);
    assert.match(await tree.locator('caption').first().innerText(), /Camera ray/);

    // The pixel is explained, and another one when it is chosen here or there.
    assert.equal(await page.locator('.logged').count(), 4);
    await page.waitForSelector('.pin');
    await tree.getByLabel('Pixel', {exact: true}).selectOption('60,270');
    await page.locator('.pixel-line', {hasText: '(60, 270)'}).waitFor();
    await own.locator('.space-frame').waitFor();
    await tree.getByRole('button', {name: 'The next wrong pixel'}).click();
    await page.locator('.pixel-line', {hasText: '(390, 300)'}).waitFor();
    await clickPicture(page, 302.5 / 480, 223.5 / 480);  // on the mark's edge
    await page.locator('.inspector[data-pixel="300,225"]').waitFor();
    await page.getByRole('tab', {name: 'Compare'}).click();
    assert.equal(await tree.getAttribute('data-pixel'), '300,225');

    // Its words lead to the help.
    await findings.first().getByRole('button', {name: 'The lighting equation'}).click();
    await page.getByRole('region', {name: 'The lighting equation'}).getByText('Term by term').waitFor();
    await page.keyboard.press('Escape');
    await findings.first().getByRole('button', {name: 'Show this value'}).click();
    assert.equal(await until(() => tree.getAttribute('data-pixel'), (at) => at === command.findings[0].example.pixel.join()), command.findings[0].example.pixel.join());
    await shoot(page, 'diagnose.png');
    await own.getByRole('button', {name: 'Close your log'}).click();
    assert.equal(await page.locator('.own-log, .logged').count(), 0);
}));

test('a ray that goes elsewhere is shown beside the one that is right', () => withPage(async (page) => {
    await openCastle(page);
    await drop(page, logged('mirror-direction-sign', 480, ...pixels));
    await answered(page);
    const finding = page.locator('.log-finding[data-quantity=direction]');
    await finding.getByRole('button', {name: 'Show this value'}).click();
    await page.locator('.own-log .space-frame .ray.yours').first().waitFor({state: 'attached'});
    assert.ok(await page.locator('.own-log .legend').getByText('yours').isVisible());
    assert.ok(await page.locator('.frame .ray.yours').count() > 0);
    // The row that is shown is the finding's.
    assert.match(await page.evaluate(() => document.activeElement?.textContent), /direction.*first difference/);
}));

test('a log without mistakes has no finding; it is compared again after each change, and closed with its scene', () => withPage(async (page) => {
    await openCastle(page);
    await drop(page, logged('', 480, ...pixels));
    await page.getByText('Nothing differs: each value follows from the scene, up to rounding.').waitFor();
    assert.equal(await page.locator('.log-finding').count(), 0);
    assert.match(await page.locator('.log-choice option').first().innerText(), /240, 180: no difference/);
    // The light is elsewhere.
    const text = await sceneText(page);
    const moved = text.replace(/("position"\s*:\s*\[\s*)(-?[\d.]+)/, '$1-99');
    assert.notEqual(moved, text);
    await paste(page, moved);
    await page.locator('.log-finding').first().waitFor();
    await paste(page, `${moved}{`);
    await page.getByText('The scene has errors: the log is compared again when they are mended.').waitFor();
    assert.equal(await page.locator('.log-finding').count(), 0);
    await paste(page, text);
    await page.getByText('Nothing differs: each value follows from the scene, up to rounding.').waitFor();
    await choose(page, 'cgfs/three_spheres.cgfs');
    await page.locator('.notice', {hasText: 'mine.log is closed: it is the log of the scene before.'}).waitFor();
    assert.equal(await page.locator('.own-log').count(), 0);
}));

test('a log of another size is compared, and a button renders the scene at it', () => withPage(async (page) => {
    await openCastle(page);
    const {text} = logged('light-not-unit', 160, '80,60', '20,90', '100,75');
    await drop(page, {name: 'small.txt', text});
    await answered(page);
    assert.match(await page.locator('.log-finding h3').first().innerText(), /^N\.L is wrong in 3 of 3 pixels/);
    assert.equal(await page.locator('.logged').count(), 0);
    await page.getByRole('button', {name: 'Render at 160 × 160'}).click();
    await settled(page);
    await page.locator('.logged').first().waitFor({state: 'attached'});
    assert.match(await page.locator('.log-finding h3').first().innerText(), /^N\.L is wrong in 3 of 3 pixels/);
    await drop(page, {name: 'wide.log', text: text.replace('size 160 160', 'size 200 100')});
    await page.locator('.own-log [role=alert]', {hasText: 'wide.log: the log is of a picture of 200x100 pixels'}).waitFor();
    assert.ok(await page.getByRole('button', {name: 'Render at 200 × 100'}).isVisible());
}));

test('a bad line is named, and warnings are shown', () => withPage(async (page) => {
    await page.getByRole('tab', {name: 'Compare'}).click();
    for (const [name, text, said] of [
        ['bad.log', 'pixel 3 4\nray camera\norigin 0 0\n', /bad\.log:3:.*origin/], ['other.log', 'hello\n', /other\.log: the log has no line `pixel X Y`/],
        ['lines.jsonl', '{"pixel": [3, 4], "ray": "camera"}\n{"N": [0, "x", 1]}\n', /lines\.jsonl:2:/], ['far.log', 'pixel 9999 9999\nray camera\norigin 0 0 0\n', /no pixel of the log is in the picture/],
    ]) {
        await drop(page, {name, text});
        const error = page.locator('.own-log [role=alert]');
        assert.match(await until(async () => (await error.count() > 0 ? error.innerText() : ''), (words) => said.test(words)), said);
    }
    await drop(page, {name: 'odd.txt', text: 'pixel 3 4\nray camera\norigin 0 0 0\nmood 3\nmiss\n'});
    await page.locator('.own-log .message.warning', {hasText: 'mood'}).waitFor();
    await drop(page, {name: 'notes.txt', text: 'Ray tracer: to do\n'});
    await page.locator('.notice', {hasText: 'Not a scene: notes.txt'}).waitFor();
    assert.equal(await page.locator('.own-log h2').innerText(), 'odd.txt');
}));

test('a log that is dropped with its scene is opened beside it, and the keyboard reaches all of it', () => withPage(async (page) => {
    await drop(page, {name: 'own.cgfs', text: book}, {name: 'glint.log', text: 'pixel 300 300\nray camera\norigin 0 0 1\ndirection 0 0 1\npixel 1 2\nray camera\norigin 0 0 0\n'});
    await answered(page);
    assert.equal(await page.locator('.own-log h2').innerText(), 'glint.log');
    assert.match(await page.locator('.log-finding h3').first().innerText(), /^The origin is wrong in 1 of 2 pixels/);
    await page.locator('.log-finding').getByRole('button', {name: 'Show this value'}).first().focus();
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.activeElement?.matches('.log-table tr.first'));
    await page.locator('.log-choice select').focus();
    await page.keyboard.press('ArrowDown');
    assert.equal(await until(() => page.locator('.log-tree').getAttribute('data-pixel'), (at) => at === '1,2'), '1,2');
    await page.keyboard.press('Tab');
    await page.keyboard.press('Enter');
    assert.equal(await until(() => page.locator('.log-tree').getAttribute('data-pixel'), (at) => at === '300,300'), '300,300');
}));
