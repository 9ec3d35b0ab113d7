// SPDX-License-Identifier: Apache-2.0
// OpenEXR files as `glint render` writes them (src/image/encode_exr.cpp): floats, blocks of lines compressed as ZIP
// (https://openexr.com/en/latest/OpenEXRFileLayout.html).
import {Deflate} from './pako.mjs';

/** Lines that are compressed together. */
const blockLines = 16;

/** Bytes of a file; texts end with a zero, numbers are little-endian. */
class Bytes {
    #parts = [];
    length = 0;

    add(bytes) {
        this.#parts.push(bytes);
        this.length += bytes.length;
        return this;
    }
    text(text) {
        return this.add(Uint8Array.from([...text, '\0'], (c) => c.charCodeAt(0)));
    }
    integers(...numbers) {
        return this.add(new Uint8Array(Int32Array.from(numbers).buffer));
    }
    floats(...numbers) {
        return this.add(new Uint8Array(Float32Array.from(numbers).buffer));
    }
    attribute(name, type, value) {
        return this.text(name).text(type).integers(value.length).add(value.whole());
    }
    whole() {
        const whole = new Uint8Array(this.length);
        let at = 0;
        for (const part of this.#parts) {
            whole.set(part, at);
            at += part.length;
        }
        return whole;
    }
}

const values = () => new Bytes();

function headerOf(channels, width, height) {
    const list = values();
    for (const name of channels) list.text(name).integers(2, 0, 1, 1);  // floats, of every pixel
    const window = () => values().integers(0, 0, width - 1, height - 1);
    return values().integers(0x01312f76, 2)
        .attribute('channels', 'chlist', list.add(Uint8Array.of(0)))
        .attribute('compression', 'compression', values().add(Uint8Array.of(3)))
        .attribute('dataWindow', 'box2i', window())
        .attribute('displayWindow', 'box2i', window())
        .attribute('lineOrder', 'lineOrder', values().add(Uint8Array.of(0)))
        .attribute('pixelAspectRatio', 'float', values().floats(1))
        .attribute('screenWindowCenter', 'v2f', values().floats(0, 0))
        .attribute('screenWindowWidth', 'float', values().floats(1))
        .add(Uint8Array.of(0));
}

/** Bytes of even places, then those of odd ones, each as its difference from the one before; then deflate. */
function compress(block) {
    const sorted = new Uint8Array(block.length), half = (block.length + 1) >> 1;
    for (let i = 0; i < block.length; ++i) sorted[(i >> 1) + (i & 1 ? half : 0)] = block[i];
    for (let i = block.length - 1; i > 0; --i) sorted[i] -= sorted[i - 1] + 128;
    const deflate = new Deflate({level: 4});
    if (!deflate.push(sorted, true)) throw new Error(deflate.msg);
    return deflate.result.length < block.length ? deflate.result : block;
}

/** Encodes a picture; exr.d.mts describes the parameters. */
export function encodeExr(rgb, width, height, {alpha = null} = {}) {
    for (const [name, value] of Object.entries({width, height})) {
        if (!(Number.isInteger(value) && value > 0 && value <= 65536))
            throw new TypeError(`${name}: expected a whole number from 1 to 65536, found ${String(value)}`);
    }
    if (rgb.length !== 3 * width * height) throw new TypeError(`rgb: expected ${3 * width * height} floats, found ${rgb.length}`);
    if (alpha && alpha.length !== width * height) throw new TypeError(`alpha: expected ${width * height} floats, found ${alpha.length}`);
    const channels = alpha ? ['A', 'B', 'G', 'R'] : ['B', 'G', 'R'];
    const file = headerOf(channels, width, height), blocks = values();
    const offsets = new BigUint64Array(Math.ceil(height / blockLines)), first = file.length + offsets.byteLength;
    for (let y = 0, n = 0; y < height; y += blockLines, ++n) {
        const lines = Math.min(blockLines, height - y), block = new Float32Array(lines * width * channels.length);
        let to = 0;
        for (let line = y; line < y + lines; ++line) {
            for (const name of channels) {
                const c = 'RGB'.indexOf(name);
                for (let i = line * width; i < (line + 1) * width; ++i) block[to++] = c < 0 ? alpha[i] : rgb[3 * i + c];
            }
        }
        const bytes = compress(new Uint8Array(block.buffer));
        offsets[n] = BigInt(first + blocks.length);
        blocks.integers(y, bytes.length).add(bytes);
    }
    return file.add(new Uint8Array(offsets.buffer)).add(blocks.whole()).whole();
}
