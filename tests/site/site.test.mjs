// SPDX-License-Identifier: Apache-2.0
// build/site: no link leads nowhere, and it works in a folder of a server.
import assert from 'node:assert/strict';
import {existsSync, readFileSync, readdirSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join, posix, relative, sep} from 'node:path';
import {test} from 'node:test';

import {project, settled, shoot, withBrowserPage} from '../web/browser.mjs';

const site = join(project, 'build/site');
const axe = readFileSync(createRequire(join(project, 'web/package.json')).resolve('axe-core/axe.min.js'), 'utf8');
const pages = readdirSync(site, {recursive: true, withFileTypes: true}).filter((entry) => entry.isFile() && entry.name.endsWith('.html'))
    .map((entry) => relative(site, join(entry.parentPath ?? entry.path, entry.name)).split(sep).join('/'));
const textOf = new Map(pages.map((page) => [page, readFileSync(join(site, page), 'utf8')]));
const idsOf = (page) => new Set([...textOf.get(page).matchAll(/\s(?:id|name)="([^"]*)"/g)].map(([, id]) => id));

test('every link leads somewhere within the site, or to https', () => {
    const wrong = [], ids = new Map();
    let count = 0;
    for (const page of pages) {
        for (const [, found] of textOf.get(page).replace(/<script[^]*?<\/script>|<pre[^]*?<\/pre>/g, '').matchAll(/<[a-z][^>]*?\s(?:href|src)="([^"]*)"/g)) {
            const link = found.replaceAll('&amp;', '&');
            if (/^(https:|data:|mailto:|javascript:)/.test(link)) continue;
            ++count;
            const [path, fragment] = link.split('#');
            const target = path === '' ? page : posix.join(posix.dirname(page), decodeURIComponent(path));
            if (/^[a-z]+:|^\//.test(link) || target.startsWith('..') || !existsSync(join(site, target))) {
                wrong.push(`${page}: ${link}`);
            } else if (fragment && textOf.has(target) && !/^(1|lesson)=/.test(fragment)) {
                if (!ids.has(target)) ids.set(target, idsOf(target));
                if (!ids.get(target).has(decodeURIComponent(fragment))) wrong.push(`${page}: ${link}: no such place`);
            }
        }
    }
    assert.deepEqual(wrong, []);
    assert.ok(pages.length > 100 && count > 1000, `${pages.length} pages, ${count} links`);
});

test('every lesson and every document is reached from the first page', () => {
    const reached = new Set(['index.html']), waiting = ['index.html'];
    while (waiting.length > 0) {
        const page = waiting.pop();
        for (const [, link] of textOf.get(page).matchAll(/<a [^>]*?href="([^"#:]*)[^"]*"/g)) {
            const target = posix.join(dirname(page), link);
            if (link === '' || !textOf.has(target) || reached.has(target)) continue;
            reached.add(target);
            waiting.push(target);
        }
    }
    for (const folder of ['docs', 'docs/lessons', 'docs/formats']) {
        for (const file of readdirSync(join(project, folder)).filter((name) => name.endsWith('.md')))
            assert.ok(reached.has(posix.join(folder, file.replace('.md', '.html'))), `${folder}/${file}`);
    }
    assert.ok(reached.has('reference/index.html') && [...reached].some((page) => /^reference\/structglint_1_1/.test(page)));
});

test('a newcomer finds installing, the first picture, a lesson and the reference from the first page', () => withBrowserPage(join(project, 'build'), async (page) => {
    for (const heading of ['Install', 'The first picture', 'The first lesson', 'Reference'])
        await page.getByRole('heading', {name: heading, exact: true}).waitFor();
    const check = async (name) => {
        for (const colorScheme of ['light', 'dark']) {
            await page.emulateMedia({colorScheme});
            await page.evaluate(axe);
            const {violations} = await page.evaluate(() => axe.run());
            assert.deepEqual(violations.map(({id, nodes}) => `${name} ${colorScheme} ${id}: ${nodes[0].html}`), []);
            await shoot(page, `site_${name}_${colorScheme}.png`);
        }
        assert.ok(await page.evaluate(() => [...document.images].every((image) => image.complete && image.naturalWidth > 0)));
    };
    await check('first');
    const first = page.url();
    const follow = async (name) => {
        await page.goto(first);
        await page.getByRole('main').getByRole('link', {name, exact: true}).click();
    };
    await follow('C++ reference');
    await page.getByText('The C++ library').first().waitFor();
    await shoot(page, 'site_reference.png');
    await follow('The lighting equation');
    await check('document');
    await follow('thirteen lessons');
    await page.getByRole('link', {name: 'Diffuse light and N·L'}).click();
    await check('lesson');
    await page.getByRole('link', {name: 'Open this scene in the playground'}).first().click();
    await settled(page);
    assert.equal(await page.locator('.file-name').innerText(), 'diffuse.glint');
    await follow('Ambient light');
    await settled(page);
    await page.getByRole('heading', {name: 'Ambient light'}).waitFor();
    assert.equal(new URL(page.url()).hash, '#lesson=01_ambient');  // a reload and a bookmark return to it
}, 'site/index.html', /favicon\.ico/));  // Doxygen's pages have no icon
