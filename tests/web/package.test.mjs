// SPDX-License-Identifier: Apache-2.0
// The npm package as others use it: its README's first lines in node and in a browser, and its types.
import assert from 'node:assert/strict';
import {execFileSync, spawnSync} from 'node:child_process';
import {cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';

import {project, withBrowserPage} from './browser.mjs';

const folder = mkdtempSync(join(tmpdir(), 'glint-package-'));
after(() => rmSync(folder, {recursive: true}));
cpSync(join(project, 'build/wasm/glint-wasm'), join(folder, 'glint-wasm'), {recursive: true});
mkdirSync(join(folder, 'node_modules'));
symlinkSync('../glint-wasm', join(folder, 'node_modules/glint-wasm'));

/** The indented blocks of the README. */
const blocks = readFileSync(join(folder, 'glint-wasm/README.md'), 'utf8').match(/(^( {4}.*)?\n)+/gm)
    .filter((block) => block.trim()).map((block) => block.replace(/^ {4}/gm, ''));
const snippet = blocks[0], importMap = blocks[1];
/** What the lines log: the numbers of rays and of bytes, and the value of a pixel. */
let logged = '';

test('the README’s first lines run in node, and give the command’s bytes', () => {
    assert.match(snippet, /await load\(\)/);
    writeFileSync(join(folder, 'first.mjs'), `${snippet}\nimport {writeFileSync} from 'node:fs';\n`
        .replace('scene.close();', "writeFileSync('first.png', encodePng(scene.renderPixels(0, 0, 600, 600).pixels, 600, 600));\n    scene.close();"));
    logged = execFileSync(process.execPath, ['first.mjs'], {cwd: folder}).toString().trim();
    const [, text] = /text: `([^`]*)`/.exec(snippet);
    writeFileSync(join(folder, 'ball.cgfs'), text);
    execFileSync(join(project, 'build/release/glint'), ['render', 'ball.cgfs', '--quiet'], {cwd: folder});
    const png = readFileSync(join(folder, 'ball.png'));
    assert.ok(readFileSync(join(folder, 'first.png')).equals(png));
    assert.match(logged, new RegExp(`^\\d+ ${png.length} \\[`));
});

test('the README’s first lines run in a browser, by the import map', () => {
    writeFileSync(join(folder, 'index.html'), `<!doctype html><link rel="icon" href="data:,">${importMap}<script type="module">
        const lines = [];
        console.log = (...values) => lines.push(values.map((value) => (Array.isArray(value) ? JSON.stringify(value) : value)).join(' '));
        ${snippet}
        document.title = lines.join();
    </script>`);
    return withBrowserPage(folder, async (page) => {
        await page.waitForFunction(() => document.title !== '');
        const numbers = (text) => text.match(/[\d.]+/g).map(Number);
        assert.deepEqual(numbers(await page.title()), numbers(logged));
    });
});

// The page itself is compiled by the newer one with the DOM.
for (const [typescript, ...uses] of [['typescript', ['use.mts', 'es2022']], ['typescript-5.0', ['use.mts', 'es2022'], ['url.mts', 'es2022,dom']]]) {
    test(`the types are strict, without the DOM and with it: ${typescript}`, () => {
        const tsc = join(project, 'web/node_modules', typescript, 'bin/tsc');
        for (const [file, lib] of uses) {
            cpSync(join(project, 'tests/web/types', file), join(folder, file));
            const {status, stdout} = spawnSync(process.execPath, [tsc, '--strict', '--exactOptionalPropertyTypes', '--noUncheckedIndexedAccess',
                '--noEmit', '--target', 'es2022', '--module', 'nodenext', '--lib', lib, file], {cwd: folder, encoding: 'utf8'});
            assert.equal(stdout, '');
            assert.equal(status, 0);
        }
    });
}
