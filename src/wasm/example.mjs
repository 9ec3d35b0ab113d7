// SPDX-License-Identifier: Apache-2.0
// node example.mjs [SCENE]: renders a scene in the terminal and explains the pixel in the middle.
import {readFileSync} from 'node:fs';

import {load} from './glint.mjs';

const glint = await load();
const text = process.argv[2] ? readFileSync(process.argv[2], 'utf8') : `
    sphere { center = (0, 0, 3)  radius = 1  color = (220, 60, 40)  specular = 50 }
    light { type = ambient  intensity = 0.2 }
    light { type = point  intensity = 0.8  position = (2, 2, 0) }`;
const scene = glint.open({texts: [{name: process.argv[2] ?? 'ball.cgfs', text}], settings: {size: '60x60'}});
for (const message of scene.report.diagnostics) console.error(message.text);
if (!scene.report.ready) process.exit(1);

const {pixels} = scene.renderPixels(0, 0, 60, 60);
for (let y = 0; y < 60; y += 2) {
    let line = '';
    for (let x = 0; x < 60; ++x) {
        const color = (row) => pixels.subarray(4 * (row * 60 + x), 4 * (row * 60 + x) + 3).join(';');
        line += `\x1b[38;2;${color(y)}m\x1b[48;2;${color(y + 1)}m▀`;
    }
    console.log(`${line}\x1b[0m`);
}
const {value, layers} = scene.explain(30, 30);
console.log('pixel (30, 30) is', value, 'the sum of', layers);
scene.close();
