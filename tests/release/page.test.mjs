// SPDX-License-Identifier: Apache-2.0
// The page of a release, unzipped in the folder PAGE, draws the castle with the bytes of the command GLINT. tools/test-release
// runs this.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {test} from 'node:test';

import {choose, picture, scenes, settled, withBrowserPage} from '../web/browser.mjs';

test('the page draws the castle as the command does', () => withBrowserPage(process.env.PAGE, async (page) => {
    await settled(page);
    await choose(page, 'castle.json');
    const {size, hash} = await picture(page);
    const file = join(mkdtempSync(join(tmpdir(), 'glint-page-')), 'castle.ppm');
    execFileSync(process.env.GLINT, ['render', join(scenes, 'epfl/castle.json'), '-s', size, '--quiet', '-o', file]);
    const ppm = readFileSync(file);
    rmSync(dirname(file), {recursive: true});
    const header = /^P6\s\d+\s\d+\s255\s/.exec(ppm.subarray(0, 40).toString('latin1'));
    assert.equal(hash, createHash('sha256').update(ppm.subarray(header[0].length)).digest('hex'));
}));
