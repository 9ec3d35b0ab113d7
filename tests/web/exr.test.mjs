// SPDX-License-Identifier: Apache-2.0
// OpenEXR pictures: the page saves the command's file, compares those that are dropped, and names what it does not read.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, test} from 'node:test';
import {deflateSync} from 'node:zlib';

import {book, choose, drop, project, saved, settled, withPage} from './browser.mjs';
import {pageModule} from './page_module.mjs';

const {bytesOf, readExr} = await pageModule('exr_file.ts');
const folder = mkdtempSync(join(tmpdir(), 'glint-exr-'));
after(() => rmSync(folder, {recursive: true}));
const most = 1 << 20;

/** The file that the command writes of a text. */
function native(text, name, ...args) {
    const scene = join(folder, name), file = join(folder, 'native.exr');
    writeFileSync(scene, text);
    execFileSync(join(project, 'build/release/glint'), ['render', scene, '-q', '-o', file, ...args]);
    return readFileSync(file);
}

test('the page saves the file of the command', () => withPage(async (page) => {
    const {name, bytes} = await saved(page, () => page.getByRole('button', {name: 'EXR'}).click());
    assert.equal(name, 'three_mirrors_Phong.exr');
    assert.ok(bytes.equals(native(book, 'book.cgfs')));
    const text = readFileSync(join(project, 'scenes/glint/still_life.glint'), 'utf8').replace('render {', 'render {\n    alpha = true');
    assert.match(text, /alpha = true/);
    await drop(page, {name: 'clear.glint', text});
    await page.waitForFunction(() => document.querySelector('[title="clear.glint"]'));
    await settled(page);
    const clear = await saved(page, () => page.getByRole('button', {name: 'EXR'}).click());
    assert.ok(clear.bytes.equals(native(text, 'clear.glint')));
}));

test('a picture that is dropped is compared, and what is none is named', () => withPage(async (page) => {
    await choose(page, 'cgfs/three_spheres.cgfs');
    const scene = readFileSync(join(project, 'scenes/cgfs/three_spheres.cgfs'), 'utf8');
    await drop(page, {name: 'mine.exr', text: native(scene, 'own.cgfs')});
    await page.getByText('All pixels are equal.').waitFor();
    await drop(page, {name: 'dark.exr', text: native(scene.replace(/light { type = ambient.*\n/, ''), 'own.cgfs')});
    await page.waitForFunction(() => /ambient/i.test(document.querySelector('.own .hints li')?.textContent ?? ''), null, {timeout: 300_000});
    await drop(page, {name: 'none.exr', text: Buffer.from('v/1\x01\x02\0\0\0channels', 'latin1')});
    await page.getByText('none.exr is not opened: byte 8: expected a name.').waitFor();
}));

test('the numbers are those that the command reads, also before layers', async () => {
    const ppm = join(folder, 'native.ppm');
    for (const args of [[], ['--alpha'], ['--aov', 'normal,depth']]) {
        const bytes = native(book, 'book.cgfs', '-s', '40x37', ...args);
        const {width, height, rgb} = await readExr(new Uint8Array(bytes), most);
        execFileSync(join(project, 'build/release/glint'), ['render', join(folder, 'book.cgfs'), '-q', '-s', '40x37', '-o', ppm]);
        globalThis.ImageData = class { constructor(w, h) { this.data = new Uint8ClampedArray(4 * w * h); } };
        const {data} = bytesOf({width, height, rgb});
        assert.deepEqual([...data].filter((_, i) => i % 4 !== 3), [...readFileSync(ppm).subarray(-3 * 40 * 37)], args.join());
    }
});

const integers = (...numbers) => Buffer.from(Int32Array.from(numbers).buffer);
const attribute = (name, type, value) => Buffer.concat([Buffer.from(`${name}\0${type}\0`), integers(value.length), value]);

/** A file of 3 x 2 pixels from (1, 1) of a picture of 4 x 4; type 1: half, with the bits of `values`; 2: float. */
function file({compression = 0, type = 1, names = ['B', 'G', 'R'], values = () => 0x3c00, sampling = 1, flags = 0, shown = [0, 0, 3, 3]} = {}) {
    const channels = Buffer.concat([...names.map((name) => Buffer.concat([Buffer.from(`${name}\0`), integers(type, 0, sampling, 1)])), Buffer.of(0)]);
    const header = Buffer.concat([integers(0x01312f76, 2 | flags), attribute('channels', 'chlist', channels),
        attribute('compression', 'compression', Buffer.of(compression)), attribute('dataWindow', 'box2i', integers(1, 1, 3, 2)),
        attribute('displayWindow', 'box2i', integers(...shown)), attribute('own', 'string', Buffer.from('ignored')), Buffer.of(0)]);
    const line = (y) => Buffer.concat(names.map((name) => Buffer.from(type === 1
        ? Uint16Array.from([0, 1, 2], (x) => values(name, x, y)).buffer : Float32Array.from([0, 1, 2], (x) => values(name, x, y)).buffer)));
    const packed = (bytes) => {
        if (compression === 0) return bytes;
        const sorted = [...bytes.filter((_, i) => i % 2 === 0), ...bytes.filter((_, i) => i % 2 === 1)];
        const small = deflateSync(Buffer.from(sorted.map((byte, i) => byte - (sorted[i - 1] ?? 128) + 128)));
        return small.length < bytes.length ? small : bytes;
    };
    const blocks = (compression === 3 ? [[1, Buffer.concat([line(0), line(1)])]] : [[1, line(0)], [2, line(1)]])
        .map(([y, bytes]) => [y, packed(bytes)]).map(([y, bytes]) => Buffer.concat([integers(y, bytes.length), bytes]));
    let at = header.length + 8 * blocks.length;
    const offsets = blocks.map((block) => {
        const here = Buffer.alloc(8);
        here.writeBigUInt64LE(BigInt(at));
        at += block.length;
        return here;
    });
    return new Uint8Array(Buffer.concat([header, ...offsets, ...blocks]));
}

test('half and float, uncompressed and ZIP, grey and color, and windows that differ', async () => {
    const bits = {R: [0x3c00, 0x3800, 0x0001], G: [0x7c00, 0xbc00, 0x7bff], B: [0x8000, 0x0400, 0x3555]};
    const numbers = {R: [1, 0.5, 2 ** -24], G: [Infinity, -1, 65504], B: [-0, 2 ** -14, 0.333251953125]};
    for (const compression of [0, 2, 3]) {
        for (const type of [1, 2]) {
            const values = (name, x) => (type === 1 ? bits : numbers)[name][x];
            const {width, height, rgb} = await readExr(file({compression, type, values}), most);
            assert.deepEqual([width, height], [4, 4]);
            const at = (x, y) => [...rgb.subarray(3 * (4 * y + x), 3 * (4 * y + x) + 3)];
            for (const y of [1, 2]) for (const x of [0, 1, 2]) assert.deepEqual(at(x + 1, y), ['R', 'G', 'B'].map((name) => Math.fround(numbers[name][x])));
            assert.deepEqual([at(0, 1), at(2, 0), at(2, 3)], [[0, 0, 0], [0, 0, 0], [0, 0, 0]]);
        }
    }
    const cut = await readExr(file({shown: [2, 2, 2, 2], values: (name, x) => bits[name][x]}), most);
    assert.deepEqual([...cut.rgb], [0.5, -1, 2 ** -14]);
    const grey = await readExr(file({names: ['Y', 'Z']}), most);
    assert.deepEqual([...grey.rgb.subarray(15, 18)], [1, 1, 1]);
});

test('what is not read is named, with its byte', async () => {
    const cases = [
        [file({compression: 4}), /byte \d+: its compression is PIZ: expected none, ZIPS or ZIP/], [file({compression: 77}), /compression is unknown/],
        [file({names: ['A']}), /no half or float channels/], [file({type: 0}), /no half or float channels/], [file({type: 3}), /channel B has no known type/],
        [file({sampling: 2}), /channel B has fewer numbers/], [file({flags: 0x200}), /byte 4: it is tiled/], [file({flags: 0x800}), /deep/],
        [file({shown: [0, 0, 70000, 0]}), /70001 × 1 pixels are too many/], [file({shown: [0, 0, -1, 0]}), /no pixels/], [Buffer.from('P6 no picture'), /byte 0: it is no OpenEXR/],
    ];
    for (const [bytes, what] of cases) await assert.rejects(readExr(new Uint8Array(bytes), most), what);
});

test('damaged files give a picture or a message, whatever is damaged', async () => {
    let seed = 7;
    const random = (n) => (seed = (seed * 48271) % 2147483647) % n;
    let refused = 0;
    const wholes = [file({compression: 0}), file({compression: 3, values: () => 0}), file({type: 2, names: ['A', 'B', 'G', 'R'], values: () => 1}), file({flags: 0x1000})];
    for (const whole of wholes) {
        const damaged = [...Array(whole.length).keys()].map((length) => whole.slice(0, length));
        for (let i = 0; i < 1500; ++i) {
            const bytes = whole.slice();
            for (let n = 1 + random(3); n > 0; --n) bytes[random(bytes.length)] = [0, 1, 127, 128, 255, random(256)][random(6)];
            damaged.push(bytes);
        }
        for (const bytes of damaged) {
            try {
                const {width, height, rgb} = await readExr(bytes, most);
                assert.equal(rgb.length, 3 * width * height);
            } catch (error) {
                assert.match(error.message, /^byte \d+: /, error.stack);
                ++refused;
            }
        }
    }
    assert.ok(refused > 1000, `${refused} refused`);
});
