// SPDX-License-Identifier: Apache-2.0
// Creates src/gallery/: a list of the scenes in ../scenes, and a thumbnail of each, rendered by glint.
import {mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join, relative, sep} from 'node:path';
import {fileURLToPath} from 'node:url';
import {crc32, deflateSync} from 'node:zlib';

import {instantiate} from 'glint-wasm';

const web = fileURLToPath(new URL('..', import.meta.url));
const scenes = join(web, '..', 'scenes');
const out = join(web, 'src', 'gallery');

const files = readdirSync(scenes, {recursive: true, withFileTypes: true})
    .filter((entry) => entry.isFile())
    .map((entry) => relative(scenes, join(entry.parentPath ?? entry.path, entry.name)).split(sep).join('/'))
    .sort();
const read = (path) => ({name: path, text: readFileSync(join(scenes, path), 'utf8')});
const includes = files.filter((path) => path.includes('/parts/')).map(read);

/** One entry per picture: a file; two listings that form one scene; each scene of a file that has several. */
function* entries() {
    let faults = 0;
    for (const path of files) {
        if (path.includes('/parts/') || path.includes('only_lights')) continue;
        const {name, text} = read(path);
        if (path.includes('only_spheres')) {
            const lights = read(path.replace('only_spheres', 'only_lights'));
            yield {name: 'cgfs/two_listings.cgfs', text: `${text}\n${lights.text}`};
        } else if (path.endsWith('two_scenes.js')) {
            for (const scene of text.matchAll(/^ {8}name: '(\w+)'/gm)) yield {name, text, scene: scene[1]};
        } else if (path.startsWith('faults/')) {
            // To be found: neither the name nor the first comment says it.
            ++faults;
            yield {id: name, name: `faults/fault_${faults}.${name.split('.').at(-1)}`, text: text.replace(/^((#|\/\/).*\n)+/, '')};
        } else {
            yield {name, text};
        }
    }
}

/** A chunk of a PNG. */
function chunk(type, data) {
    const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
    const framed = Buffer.alloc(body.length + 8);
    framed.writeUInt32BE(data.length, 0);
    body.copy(framed, 4);
    framed.writeUInt32BE(checksum(body), body.length + 4);
    return framed;
}

/** The CRC of a chunk; node has its own only since version 20.15. */
function checksum(bytes) {
    if (crc32) return crc32(bytes);
    let sum = 0xffffffff;
    for (const byte of bytes) {
        sum ^= byte;
        for (let bit = 0; bit < 8; ++bit) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1;
    }
    return ~sum >>> 0;
}

function png(pixels, width, height) {
    const rows = Buffer.alloc(height * (3 * width + 1));
    for (let y = 0; y < height; ++y) {
        for (let x = 0; x < width; ++x) {
            for (let c = 0; c < 3; ++c) rows[y * (3 * width + 1) + 1 + 3 * x + c] = pixels[4 * (y * width + x) + c];
        }
    }
    const header = Buffer.alloc(13);
    header.writeUInt32BE(width, 0);
    header.writeUInt32BE(height, 4);
    header.set([8, 2, 0, 0, 0], 8);
    return Buffer.concat([Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'), chunk('IHDR', header),
                          chunk('IDAT', deflateSync(rows, {level: 9})), chunk('IEND', Buffer.alloc(0))]);
}

const wasm = readFileSync(fileURLToPath(import.meta.resolve('glint-wasm/glint.wasm')));
const glint = await instantiate(await WebAssembly.compile(wasm));
rmSync(out, {recursive: true, force: true});
mkdirSync(out, {recursive: true});
const list = [...entries()];
const imports = [];
list.forEach((entry, i) => {
    const scene = glint.open({texts: [{name: entry.name, text: entry.text}], includes, scene: entry.scene});
    const report = scene.report;
    if (!report.ready) throw new Error(report.diagnostics.map((message) => message.text).join(''));
    const long = 176;
    const scale = long / Math.max(report.width, report.height * 4 / 3);
    const width = Math.round(report.width * scale), height = Math.round(report.height * scale);
    // A picture at one world unit per pixel cannot be rendered at a smaller size.
    const whole = scene.info.settings.find((setting) => setting.name === 'pixel_sample').value === 'whole';
    const size = whole ? [report.width, report.height] : [width, height];
    scene.prepare({settings: {size: size.join('x'), ...(whole ? {} : {aa: '2'})}});
    const file = `${entry.scene ?? entry.name.split('/').pop().replace(/\.\w+$/, '')}.png`;
    writeFileSync(join(out, file), png(scene.renderPixels(0, 0, ...size).pixels, ...size));
    imports.push(`import picture${i} from './${file}';`);
    scene.close();
});
const items = list.map((entry, i) => `    {...${JSON.stringify(entry)}, picture: picture${i}},`);
writeFileSync(join(out, 'index.ts'), `// Made by tools/make-gallery.mjs.
${imports.join('\n')}

export interface GalleryScene {
    /** The path of its file, if that is not its name. */
    id?: string;
    name: string;
    text: string;
    scene?: string;
    picture: string;
}
export const gallery: GalleryScene[] = [
${items.join('\n')}
];
/** The texts that the gallery's scenes include. */
export const parts: {name: string; text: string}[] = ${JSON.stringify(includes)};
`);
console.log(`${list.length} scenes, ${includes.length} parts`);
