// SPDX-License-Identifier: Apache-2.0
// The built page in Chromium, and the native command to compare it with. Environment: CHROMIUM, its path; SHOTS, a folder for
// screenshots.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {basename, join} from 'node:path';
import {after, test} from 'node:test';
import {fileURLToPath} from 'node:url';

import {serve} from '../../web/tools/serve.mjs';

const {chromium} = createRequire(new URL('../../web/package.json', import.meta.url))('playwright-core');
export const project = fileURLToPath(new URL('../..', import.meta.url));
export const scenes = join(project, 'scenes');

const server = await serve(join(project, 'web/dist'), 0);
export const address = `http://127.0.0.1:${server.address().port}/`;
const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'].find(existsSync),
    args: process.getuid?.() === 0 ? ['--no-sandbox'] : [],
});
const folder = mkdtempSync(join(tmpdir(), 'glint-web-'));
after(async () => {
    await browser.close();
    server.close();
    server.closeAllConnections();
    rmSync(folder, {recursive: true});
});

/** The time, in milliseconds, in which anything but rendering happens even on a busy machine. */
export const patience = 90_000;

/** Opens the page for a test, and checks afterwards that it reported no errors. */
export async function withPage(use, {width = 1440, height = 900, scheme = 'light', offline = false, path = '', ...more} = {}) {
    const context = await browser.newContext({
        viewport: {width, height}, colorScheme: scheme, acceptDownloads: true, serviceWorkers: offline ? 'allow' : 'block', ...more,
    });
    const page = await context.newPage();
    const complaints = [];
    page.on('pageerror', (error) => complaints.push(error.message));
    page.on('console', (message) => {
        // Messages that the tests themselves cause.
        const ours = /Service Worker registration blocked/.test(message.text());
        if (['error', 'warning'].includes(message.type()) && !ours) complaints.push(message.text());
    });
    try {
        context.setDefaultTimeout(patience);
        await page.goto(address + path);
        await settled(page);
        await use(page, context);
        assert.deepEqual(complaints, []);
    } finally {
        await context.close();
    }
}

/** Opens a page of another folder, and checks afterwards that it reported no errors but those expected. */
export async function withBrowserPage(root, use, path = '', expected = null) {
    const other = await serve(root, 0);
    const context = await browser.newContext();
    context.setDefaultTimeout(patience);
    const page = await context.newPage();
    const complaints = [];
    page.on('pageerror', (error) => complaints.push(error.message));
    page.on('console', (message) => {
        const complaint = `${message.text()} ${message.location().url}`;
        if (message.type() === 'error' && !expected?.test(complaint)) complaints.push(complaint);
    });
    try {
        await page.goto(`http://127.0.0.1:${other.address().port}/${path}`);
        await use(page, context);
        assert.deepEqual(complaints, []);
    } finally {
        await context.close();
        other.close();
        other.closeAllConnections();
    }
}

/** A test of several cases on one page, one after the other: each begins with a scene of its own. */
export function testOnOnePage(name, cases, use, options = {}) {
    test(name, (t) => withPage(async (page) => {
        for (const one of cases) await t.test(one[0], () => use(page, ...one));
    }, options));
}

/** Waits until the picture is complete, however long that takes: as long as it makes progress. */
export async function settled(page, ...states) {
    const wanted = states.length > 0 ? states : ['done'];
    for (let before = '';;) {
        try {
            await page.waitForSelector(wanted.map((state) => `[data-state=${state}]`).join(', '), {timeout: patience});
            return;
        } catch (error) {
            const now = await page.locator('[data-state]').innerText();
            if (!now.startsWith('rendering') || now === before) throw new Error(`the page says '${now}' instead of ${wanted.join(' or ')}`, {cause: error});
            before = now;
        }
    }
}

/** The same for both pictures of a comparison. */
export async function bothSettled(page) {
    await settled(page);
    await page.waitForSelector('.right-half[data-complete=true]');
}

/** Reads a value until it is as expected; returns the last one. */
export async function until(read, isExpected) {
    const end = Date.now() + patience;
    for (;;) {
        const value = await read();
        if (isExpected(value) || Date.now() > end) return value;
        await new Promise((next) => setTimeout(next, 50));
    }
}

/** What `read` gives once it has been the same for half a second. */
export async function steady(read) {
    let last, since = 0;
    return until(async () => {
        const value = await read();
        if (value !== last) [last, since] = [value, Date.now()];
        return value;
    }, () => Date.now() - since >= 500);
}

/** SHA-256 of a canvas's red, green and blue bytes, and its size. */
export async function hashOf(locator) {
    const {width, height, bytes} = await locator.evaluate(async (canvas) => {
        const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
        const rgb = new Uint8Array((data.length / 4) * 3);
        for (let i = 0, o = 0; i < data.length; i += 4) {
            rgb[o++] = data[i];
            rgb[o++] = data[i + 1];
            rgb[o++] = data[i + 2];
        }
        const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', rgb));
        return {width: canvas.width, height: canvas.height, bytes: [...digest]};
    });
    return {size: `${width}x${height}`, hash: Buffer.from(bytes).toString('hex')};
}

/** That of the page's picture. */
export const picture = (page, which = 0) => hashOf(page.locator('.frame canvas').nth(which));

/** The same for the picture of the native command. */
export function native(...args) {
    const file = join(folder, 'native.ppm');
    execFileSync(join(project, 'build/release/glint'), ['render', ...args, '--quiet', '-o', file], {stdio: ['ignore', 'pipe', 'pipe']});
    const ppm = readFileSync(file);
    const header = /^P6\s(\d+)\s(\d+)\s255\s/.exec(ppm.subarray(0, 40).toString('latin1'));
    const hash = createHash('sha256').update(ppm.subarray(header[0].length)).digest('hex');
    return {size: `${header[1]}x${header[2]}`, hash};
}

/** The same for a text. */
export function nativeText(name, text, ...args) {
    const file = join(folder, basename(name));
    writeFileSync(file, text);
    return native(file, ...args);
}

/** The PNG that a copied line of the command writes, beside the saved scene. */
export function byCommand(line, name, text) {
    const own = mkdtempSync(join(folder, 'command-'));
    writeFileSync(join(own, name), text);
    execFileSync('sh', ['-c', line], {cwd: own, env: {PATH: `${join(project, 'build/release')}:${process.env.PATH}`}});
    return readFileSync(join(own, readdirSync(own).find((file) => file.endsWith('.png'))));
}

/** Opens a gallery scene by its menu: castle.json, or snowman. */
export async function choose(page, scene) {
    await page.getByRole('button', {name: 'Scenes', exact: true}).click();
    await page.locator(`[data-scene$="${scene}"]`).click();
    // Until then the page may still say that the scene before it is done. The names of faulty scenes are hidden.
    await page.waitForFunction((name) => {
        const shown = document.querySelector('.file-name').textContent;
        return shown.includes(name) || shown.startsWith('fault_');
    }, scene.split('/').at(-1));
    await settled(page);
}

/** Opens a text as a dropped file. */
export async function drop(page, ...files) {
    await page.evaluate((list) => {
        const transfer = new DataTransfer();
        for (const {name, base64} of list) {
            const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
            transfer.items.add(new File([bytes], name));
        }
        document.body.dispatchEvent(new DragEvent('drop', {dataTransfer: transfer, bubbles: true, cancelable: true}));
    }, files.map(({name, text}) => ({name, base64: Buffer.from(text).toString('base64')})));
}

/** Replaces the editor's text, as pasting does. */
export async function paste(page, text) {
    const content = page.locator('.cm-content');
    await content.click();
    await page.keyboard.press('Control+A');
    await content.evaluate((element, pasted) => {
        const clipboardData = new DataTransfer();
        clipboardData.setData('text/plain', pasted);
        element.dispatchEvent(new ClipboardEvent('paste', {clipboardData, bubbles: true, cancelable: true}));
    }, text);
}

/** The name and bytes of the file that a button saves. */
export async function saved(page, act) {
    const [download] = await Promise.all([page.waitForEvent('download'), act()]);
    const file = join(folder, 'download');
    await download.saveAs(file);
    return {name: download.suggestedFilename(), bytes: readFileSync(file)};
}

/** The editor's whole text: what the button "Save scene" saves, without the browser's download (sharing.test.mjs tests that). */
export function sceneText(page) {
    return page.evaluate(() => {
        const {createObjectURL} = URL, {click} = HTMLAnchorElement.prototype;
        let file = null;
        URL.createObjectURL = (blob) => {
            file = blob;
            return 'data:,';
        };
        HTMLAnchorElement.prototype.click = () => {};
        try {
            [...document.querySelectorAll('button')].find((button) => button.textContent === 'Save scene').click();
        } finally {
            URL.createObjectURL = createObjectURL;
            HTMLAnchorElement.prototype.click = click;
        }
        return file.text();
    });
}

/** Clicks a point of the picture, in fractions of its size. */
export async function clickPicture(page, x, y) {
    const box = await page.locator('.frame').boundingBox();
    await page.mouse.click(box.x + x * box.width, box.y + y * box.height);
}

export async function shoot(page, name) {
    if (process.env.SHOTS && existsSync(process.env.SHOTS)) await page.screenshot({path: join(process.env.SHOTS, name)});
}

export const book = readFileSync(join(scenes, 'cgfs/three_mirrors.cgfs'), 'utf8');
