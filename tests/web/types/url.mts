// SPDX-License-Identifier: Apache-2.0
// The types of glint-wasm beside those of the DOM.
import {compile, load} from 'glint-wasm';
import {encodePng} from 'glint-wasm/png';

const glint = await load(new URL('https://example.org/glint.wasm'));
const module: WebAssembly.Module = await compile();
const scene = glint.open({texts: []});
const {pixels} = scene.renderPixels(0, 0, 4, 3);
const image = new ImageData(pixels, 4, 3);
const blob = new Blob([encodePng(image.data, 4, 3)]);
export {module, blob};
