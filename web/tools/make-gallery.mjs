// SPDX-License-Identifier: Apache-2.0
// Creates src/gallery/: a list of the scenes in ../scenes, and a thumbnail of each, rendered by glint.
import {mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join, relative, sep} from 'node:path';
import {fileURLToPath} from 'node:url';

import {load} from 'glint-wasm';
import {encodePng} from 'glint-wasm/png';

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
        // Numbers in base64 are no text to read and change.
        if (path.startsWith('gltf/')) continue;
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

const glint = await load();
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
    writeFileSync(join(out, file), encodePng(scene.renderPixels(0, 0, ...size).pixels, ...size));
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
