// SPDX-License-Identifier: Apache-2.0
// The words of textures in the browser build are those of the native one: tests/image/textures/words.
// GLINT_TEXTURE_WORDS: the module of texture_words.cpp; GLINT_TEXTURES: the folder tests/image/textures.
import assert from 'node:assert/strict';
import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {instanceOf, textAt} from './module.mjs';

const folder = process.env.GLINT_TEXTURES;
const known = new Map(readFileSync(join(folder, 'words'), 'utf8').trim().split('\n').map((line) => line.split(': ')));
const exports = instanceOf(readFileSync(process.env.GLINT_TEXTURE_WORDS));

function wordsOf(bytes) {
    const at = exports.texture_allocate(bytes.length);
    new Uint8Array(exports.memory.buffer).set(bytes, at);
    return textAt(exports, exports.texture_words(at, bytes.length));
}

for (const name of readdirSync(folder).filter((file) => file !== 'words')) {
    test(`the words of a texture: ${name}`, () => assert.equal(wordsOf(readFileSync(join(folder, name))), known.get(name)));
}

test('a texture that is cut off is an error', () => {
    for (const name of ['rgba.png', 'jpeg_progressive.jpg', 'type10.tga', 'p6.ppm']) {
        const file = readFileSync(join(folder, name));
        for (let length = 1; length < file.length - 26; length += 7) assert.doesNotMatch(wordsOf(file.subarray(0, length)), /bits/);
    }
    assert.equal(wordsOf(Buffer.from('P6 2 2 255 abc')), 'the PPM file is cut off');
});
