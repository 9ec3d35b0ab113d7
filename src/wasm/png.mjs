// SPDX-License-Identifier: Apache-2.0
// PNG files with the bytes that `glint render` writes (src/image/encode_png.cpp): RGB or RGBA of 8 bits, rows filtered with
// Sub, and strips that are compressed separately, each to complete bytes of one deflate stream.
import {Deflate, constants} from './pako.mjs';

/** Rows of a strip: k_strip_rows of src/image/strip_encoder.h. */
const stripRows = 32;

const crcTable = Uint32Array.from({length: 256}, (_, n) => {
    for (let bit = 0; bit < 8; ++bit) n = n & 1 ? (n >>> 1) ^ 0xedb88320 : n >>> 1;
    return n;
});

function crc32(bytes) {
    let sum = 0xffffffff;
    for (const byte of bytes) sum = crcTable[(sum ^ byte) & 255] ^ (sum >>> 8);
    return ~sum;
}

/** Continues the Adler-32 checksum of zlib, whose start is 1. */
function adler32(sum, bytes) {
    let a = sum & 65535, b = sum >>> 16;
    for (let from = 0; from < bytes.length; from += 3800) {  // a and b stay below 2^31
        const to = Math.min(from + 3800, bytes.length);
        for (let i = from; i < to; ++i) {
            a += bytes[i];
            b += a;
        }
        a %= 65521;
        b %= 65521;
    }
    return b * 65536 + a;
}

function chunk(type, ...parts) {
    const length = parts.reduce((sum, part) => sum + part.length, 0);
    const bytes = new Uint8Array(length + 12), view = new DataView(bytes.buffer);
    view.setUint32(0, length);
    for (let i = 0; i < 4; ++i) bytes[4 + i] = type.charCodeAt(i);
    let at = 8;
    for (const part of parts) {
        bytes.set(part, at);
        at += part.length;
    }
    view.setInt32(at, crc32(bytes.subarray(4, at)));
    return bytes;
}

function bytesOf32(...numbers) {
    const view = new DataView(new ArrayBuffer(4 * numbers.length));
    for (const [i, value] of numbers.entries()) view.setUint32(4 * i, value);
    return new Uint8Array(view.buffer);
}

/** Rows of pixels as the PNG stores them: the filter's number, then each byte minus that of the pixel to its left. */
function filterRows(pixels, width, first, rows, alpha) {
    const filtered = new Uint8Array(rows * ((alpha ? 4 : 3) * width + 1));
    let to = 0;
    for (let y = first; y < first + rows; ++y) {
        filtered[to++] = 1;
        let r = 0, g = 0, b = 0, a = 0;
        for (let from = 4 * y * width; from < 4 * (y + 1) * width; from += 4) {
            filtered[to++] = pixels[from] - r;
            filtered[to++] = pixels[from + 1] - g;
            filtered[to++] = pixels[from + 2] - b;
            r = pixels[from];
            g = pixels[from + 1];
            b = pixels[from + 2];
            if (!alpha) continue;
            filtered[to++] = pixels[from + 3] - a;
            a = pixels[from + 3];
        }
    }
    return filtered;
}

function compress(strip, isLast) {
    const deflate = new Deflate({level: 1, memLevel: 9, raw: true, strategy: constants.Z_RLE});
    if (!deflate.push(strip, isLast ? constants.Z_FINISH : constants.Z_SYNC_FLUSH)) throw new Error(deflate.msg);
    if (isLast) return [deflate.result];
    return deflate.chunks;
}

/** Encodes a picture; png.d.mts describes the parameters. */
export function encodePng(pixels, width, height, {alpha = false, srgb = false} = {}) {
    for (const [name, value] of Object.entries({width, height})) {
        if (!(Number.isInteger(value) && value > 0 && value <= 65536))
            throw new TypeError(`${name}: expected a whole number from 1 to 65536, found ${String(value)}`);
    }
    if (pixels.length !== 4 * width * height)
        throw new TypeError(`pixels: expected ${4 * width * height} bytes, found ${pixels.length}`);
    const parts = [Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10),
                   chunk('IHDR', bytesOf32(width, height), Uint8Array.of(8, alpha ? 6 : 2, 0, 0, 0)),
                   ...(srgb ? [chunk('sRGB', Uint8Array.of(0))] : [])];
    let adler = 1;
    for (let y = 0; y < height; y += stripRows) {
        const isLast = y + stripRows >= height;
        const strip = filterRows(pixels, width, y, Math.min(stripRows, height - y), alpha);
        adler = adler32(adler, strip);
        parts.push(chunk('IDAT', ...(y === 0 ? [Uint8Array.of(0x78, 0x01)] : []), ...compress(strip, isLast),
                         ...(isLast ? [bytesOf32(adler)] : [])));
    }
    parts.push(chunk('IEND'));
    const file = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of parts) {
        file.set(part, at);
        at += part.length;
    }
    return file;
}
