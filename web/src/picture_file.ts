// SPDX-License-Identifier: Apache-2.0
// Reads pictures that the user drops: what the browser can read (PNG, JPEG, ...), PPM, which students' programs write, and OpenEXR.
import {fetchLater} from './store/later';

const pictures = /\.(png|jpe?g|tga|ppm|pgm|pnm|bmp|gif|webp|exr)$/i;

const exrReader = () => import('./exr_file');
fetchLater(exrReader);

export const isPictureName = (name: string) => pictures.test(name);

const mostPixels = 1 << 26;

/** The words of a PPM's header, and where its numbers begin. */
function ppmHeader(bytes: Uint8Array): {words: string[]; at: number} {
    const words: string[] = [];
    let at = 0;
    while (words.length < 4 && at < bytes.length) {
        const c = String.fromCharCode(bytes[at]!);
        if (c === '#') {
            while (at < bytes.length && bytes[at] !== 10) ++at;
        } else if (/\s/.test(c)) {
            ++at;
        } else {
            let word = '';
            while (at < bytes.length && !/[\s#]/.test(String.fromCharCode(bytes[at]!))) word += String.fromCharCode(bytes[at++]!);
            words.push(word);
        }
    }
    return {words, at: at + 1};
}

/** A PPM of bytes (P6) or of decimal numbers (P3). Throws an Error that says what is wrong. */
export function readPpm(bytes: Uint8Array): ImageData {
    const {words: [kind, ...sizes], at} = ppmHeader(bytes);
    const [width = 0, height = 0, most = 0] = sizes.map(Number);
    const isSize = (value: number) => Number.isInteger(value) && value > 0 && value <= 65_536;
    if (kind !== 'P3' && kind !== 'P6') throw new Error('it is no PPM of colors: it has to begin with P3 or P6');
    if (!isSize(width) || !isSize(height) || !(most >= 1 && most <= 65_535)) throw new Error('its header has no width, height and greatest number');
    if (width * height > mostPixels) throw new Error(`${width} × ${height} pixels are too many`);
    const count = 3 * width * height, wide = most > 255;
    let numbers: (i: number) => number;
    if (kind === 'P6') {
        if (bytes.length < at + count * (wide ? 2 : 1)) throw new Error('it is cut off');
        numbers = wide ? (i) => 256 * bytes[at + 2 * i]! + bytes[at + 2 * i + 1]! : (i) => bytes[at + i]!;
    } else {
        const list = new TextDecoder().decode(bytes.subarray(at)).split(/\s+/).filter(Boolean).map(Number);
        if (list.length < count || !list.every(Number.isFinite)) throw new Error('it is cut off, or has something that is no number');
        numbers = (i) => list[i]!;
    }
    const image = new ImageData(width, height);
    for (let i = 0; i < count; ++i) image.data[4 * Math.floor(i / 3) + (i % 3)] = Math.round((255 * numbers(i)) / most);
    for (let i = 3; i < image.data.length; i += 4) image.data[i] = 255;
    return image;
}

/** The bytes of a picture. Throws an Error that says what is wrong. */
export async function readPicture(file: File): Promise<ImageData> {
    if (/\.p[pn]m$/i.test(file.name)) return readPpm(new Uint8Array(await file.arrayBuffer()));
    if (/\.exr$/i.test(file.name)) {
        const {bytesOf, readExr} = await exrReader();
        return bytesOf(await readExr(new Uint8Array(await file.arrayBuffer()), mostPixels));
    }
    // The bytes as they are in the file: no color profile is applied.
    const bitmap = await createImageBitmap(file, {colorSpaceConversion: 'none', premultiplyAlpha: 'none'}).catch(() => {
        throw new Error('the browser cannot read it as a picture');
    });
    const {width, height} = bitmap;
    if (width * height > mostPixels) throw new Error(`${width} × ${height} pixels are too many`);
    const context = new OffscreenCanvas(width, height).getContext('2d', {willReadFrequently: true})!;
    context.drawImage(bitmap, 0, 0);
    bitmap.close();
    return context.getImageData(0, 0, width, height);
}
