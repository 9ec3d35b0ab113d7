// SPDX-License-Identifier: Apache-2.0
// Reads OpenEXR files that are uncompressed or compressed as ZIP, by lines, with half or float channels: what glint and most programs
// write (https://openexr.com/en/latest/OpenEXRFileLayout.html). Errors name the byte of the file.

export interface ExrPicture {
    width: number;
    height: number;
    /** Linear red, green and blue of each pixel; 0 where the file has no pixel. */
    rgb: Float32Array;
}

const compressions = ['none', 'RLE', 'ZIPS', 'ZIP', 'PIZ', 'PXR24', 'B44', 'B44A', 'DWAA', 'DWAB'];
/** Lines that are compressed together, of those that are read. */
const blockLines: Record<string, number> = {none: 1, ZIPS: 1, ZIP: 16};
/** More than the largest picture has in 16 lines of six channels. */
const mostBlockBytes = 2 ** 26;
const tiledFlag = 0x200, deepFlag = 0x800, partsFlag = 0x1000;

class Reader {
    readonly view: DataView;
    at = 0;

    constructor(readonly bytes: Uint8Array) {
        this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    }
    fail(what: string, at = this.at): never {
        throw new Error(`byte ${at}: ${what}`);
    }
    /** Goes past so many bytes; the place of the first one. */
    take(count: number): number {
        const {at} = this;
        if (count > this.bytes.length - at) this.fail('the file is cut off', this.bytes.length);
        this.at += count;
        return at;
    }
    integer = () => this.view.getInt32(this.take(4), true);
    offset = () => Number(this.view.getBigUint64(this.take(8), true));
    text(): string {
        const end = this.bytes.indexOf(0, this.at);
        if (end < 0 || end - this.at > 255) this.fail('expected a name');
        const text = String.fromCharCode(...this.bytes.subarray(this.at, end));
        this.at = end + 1;
        return text;
    }
}

interface Window {
    x: number;
    y: number;
    width: number;
    height: number;
}
interface Channel {
    name: string;
    /** 1: half, 2: float; 0: whole numbers. */
    type: number;
    /** The distance from the start of a line, in bytes for each pixel of its width. */
    before: number;
}
interface Part {
    data: Window;
    shown: Window;
    channels: Channel[];
    bytesPerPixel: number;
    compression: string;
}

function windowOf(reader: Reader, mostPixels: number): Window {
    const at = reader.at, [x, y, right, bottom] = Array.from({length: 4}, reader.integer) as [number, number, number, number];
    const width = right - x + 1, height = bottom - y + 1;
    if (width < 1 || height < 1) reader.fail('the picture has no pixels', at);
    if (width > 65_536 || height > 65_536 || width * height > mostPixels) reader.fail(`${width} × ${height} pixels are too many`, at);
    return {x, y, width, height};
}

function channelsOf(reader: Reader): {channels: Channel[]; bytesPerPixel: number} {
    const channels: Channel[] = [];
    let bytesPerPixel = 0;
    for (let {at} = reader, name = reader.text(); name !== ''; at = reader.at, name = reader.text()) {
        const type = reader.integer();
        reader.take(4);
        if (type < 0 || type > 2) reader.fail(`channel ${name} has no known type`, at);
        if (reader.integer() !== 1 || reader.integer() !== 1) reader.fail(`channel ${name} has fewer numbers than the picture has pixels`, at);
        channels.push({name, type, before: bytesPerPixel});
        bytesPerPixel += type === 1 ? 2 : 4;
    }
    return {channels, bytesPerPixel};
}

/** The attributes of one part, up to the empty name. */
function readPart(reader: Reader, mostPixels: number): Part {
    const start = reader.at, part: Partial<Part> = {};
    for (let name = reader.text(); name !== ''; name = reader.text()) {
        reader.text();  // its type
        const length = reader.integer(), at = reader.at;
        if (length < 0) reader.fail(`${name} has no length`, at - 4);
        const end = reader.take(length) + length;
        reader.at = at;
        if (name === 'dataWindow') part.data = windowOf(reader, mostPixels);
        if (name === 'displayWindow') part.shown = windowOf(reader, mostPixels);
        if (name === 'channels') Object.assign(part, channelsOf(reader));
        if (name === 'compression') {
            part.compression = compressions[reader.bytes[reader.take(1)]!] ?? 'unknown';
            if (!(part.compression in blockLines)) reader.fail(`its compression is ${part.compression}: expected none, ZIPS or ZIP`, at);
        }
        reader.at = end;
    }
    const {data, shown, channels, bytesPerPixel, compression} = part;
    if (!data || !shown || !channels || !bytesPerPixel || !compression) reader.fail('the header lacks a window, the channels or the compression', start);
    return {data, shown, channels, bytesPerPixel, compression};
}

/** Deflate, then the differences of bytes, then bytes of even and of odd places. `length`: of the result. */
async function unpack(packed: Uint8Array<ArrayBuffer>, length: number): Promise<Uint8Array> {
    const sorted = new Uint8Array(length);
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate')).getReader();
    let count = 0;
    for (let next = await stream.read(); !next.done; next = await stream.read()) {
        if (next.value.length > length - count) {
            void stream.cancel().catch(() => {});
            throw new Error('it has too many bytes');
        }
        sorted.set(next.value, count);
        count += next.value.length;
    }
    if (count < length) throw new Error('it has too few bytes');
    for (let i = 1; i < length; ++i) sorted[i]! += sorted[i - 1]! + 128;
    const block = new Uint8Array(length), half = (length + 1) >> 1;
    for (let i = 0; i < length; ++i) block[i] = sorted[(i >> 1) + (i & 1 ? half : 0)]!;
    return block;
}

function half(bits: number): number {
    const sign = bits & 0x8000 ? -1 : 1, exponent = (bits >> 10) & 31, fraction = bits & 1023;
    if (exponent === 31) return fraction ? NaN : sign * Infinity;
    return sign * (exponent === 0 ? fraction * 2 ** -24 : (1024 + fraction) * 2 ** (exponent - 25));
}

/** The picture of a file; of several parts the first one, as glint writes the picture before its layers. */
export async function readExr(file: Uint8Array<ArrayBuffer>, mostPixels: number): Promise<ExrPicture> {
    const reader = new Reader(file);
    if (reader.integer() !== 0x01312f76) reader.fail('it is no OpenEXR file', 0);
    const version = reader.integer();
    if ((version & 255) !== 2) reader.fail('it has another version of OpenEXR', 4);
    if (version & tiledFlag) reader.fail('it is tiled: expected lines', 4);
    if (version & deepFlag) reader.fail('its pixels have several samples ("deep")', 4);
    const hasParts = (version & partsFlag) !== 0;
    const {data, shown, channels, bytesPerPixel, compression} = readPart(reader, mostPixels);
    while (hasParts && file[reader.at] !== 0) readPart(reader, mostPixels);
    if (hasParts) reader.take(1);
    const color = ['R', 'G', 'B'].map((name) => channels.find((one) => one.name === name) ?? channels.find((one) => one.name === 'Y'));
    if (color.some((one) => !one || one.type === 0)) reader.fail('the picture has no half or float channels R, G, B, and no Y', 8);

    const lines = blockLines[compression]!;
    if (Math.min(lines, data.height) * data.width * bytesPerPixel > mostBlockBytes) reader.fail('its blocks are too large', 8);
    const blocks = Array.from({length: Math.ceil(data.height / lines)}, reader.offset);
    const rgb = new Float32Array(3 * shown.width * shown.height);
    for (const [n, offset] of blocks.entries()) {
        const first = n * lines, count = Math.min(lines, data.height - first);
        reader.at = Math.min(offset, file.length);
        if (hasParts && reader.integer() !== 0) reader.fail('expected a block of the first part', offset);
        if (reader.integer() !== data.y + first) reader.fail(`expected the block of line ${data.y + first}`, offset);
        const length = reader.integer(), whole = count * data.width * bytesPerPixel;
        if (length < 0 || length > whole) reader.fail('the block has a wrong length', reader.at - 4);
        const from = reader.take(length), packed = file.subarray(from, from + length);
        if (length < whole && compression === 'none') reader.fail('the block has too few bytes', from);
        const block = length === whole ? packed : await unpack(packed, whole).catch((error: unknown) => reader.fail(
            `the compressed block is damaged: ${error instanceof Error ? error.message : String(error)}`, from));
        const view = new DataView(block.buffer, block.byteOffset, block.byteLength);
        for (let line = 0; line < count; ++line) {
            const y = data.y + first + line - shown.y;
            if (y < 0 || y >= shown.height) continue;
            for (const [c, channel] of color.entries()) {
                const start = line * data.width * bytesPerPixel + channel!.before * data.width;
                const left = Math.max(0, data.x - shown.x), right = Math.min(shown.width, data.x + data.width - shown.x);
                for (let x = left; x < right; ++x) {
                    const i = x + shown.x - data.x;
                    rgb[3 * (y * shown.width + x) + c] = channel!.type === 1 ? half(view.getUint16(start + 2 * i, true)) : view.getFloat32(start + 4 * i, true);
                }
            }
        }
    }
    return {width: shown.width, height: shown.height, rgb};
}

/** The bytes that glint compares: clamped to 0 to 1, times 255, to the nearest, of two the even one. What is no number is 0. */
export function bytesOf({width, height, rgb}: ExrPicture): ImageData {
    const image = new ImageData(width, height);
    for (let i = 0, to = 0; i < rgb.length; ++i, ++to) {
        const value = 255 * Math.min(1, Math.max(0, rgb[i]!)), low = Math.floor(value), above = value - low;
        image.data[to] = above > 0.5 || (above === 0.5 && low % 2 === 1) ? low + 1 : low;
        if (i % 3 === 2) image.data[++to] = 255;
    }
    return image;
}
