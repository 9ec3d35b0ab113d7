// SPDX-License-Identifier: Apache-2.0
// Saves the page's files.
import {Stopped} from './engine/pool';
import type {Shown} from './engine/view';
import {numbersOf} from './store/floats';
import {fetchLater} from './store/later';
import {comparison, documentId, fileName, isPictureOfScene, notice, services, settingOf} from './store/state';
import {canvases, pixelsOf} from './ui/pictures';

function save(blob: Blob, name: string) {
    const anchor = document.createElement('a');
    anchor.href = URL.createObjectURL(blob);
    anchor.download = name.length > 120 ? name.slice(-120) : name;
    anchor.click();
    setTimeout(() => URL.revokeObjectURL(anchor.href), 10_000);
}

/** "castle" of "epfl/castle.json". */
export const baseName = () => fileName.value.split('/').at(-1)!.replace(/\.\w+$/, '') || 'picture';

/** A setting of the first picture. */
const shownSetting = (key: string) => (comparison.value?.key === key ? comparison.value.a : (settingOf(key)?.value ?? ''));

export type PictureKind = 'png' | 'exr';

/** castle_BlinnPhong.png, the naming scheme of the course's page. */
export function pictureName(kind: PictureKind = 'png'): string {
    const words = shownSetting('shading').split('-').map((word) => word.charAt(0).toUpperCase() + word.slice(1));
    return `${baseName()}_${words.join('')}.${kind}`;
}

const pngWriter = () => import('glint-wasm/png'), exrWriter = () => import('glint-wasm/exr');
fetchLater(() => Promise.all([pngWriter(), exrWriter()]));

// What is shown is taken before the writer is there: that may take a while.
async function pngOf(): Promise<Blob> {
    const {data, width, height} = pixelsOf(canvases.first);
    const options = {alpha: shownSetting('alpha') === 'true', srgb: shownSetting('transfer') === 'srgb'};
    const {encodePng} = await pngWriter();
    return new Blob([encodePng(data, width, height, options)], {type: 'image/png'});
}

/** Renders the first picture again, since the canvas has bytes only. */
async function exrOf(shown: Shown): Promise<Blob> {
    const {rgb, alpha} = await numbersOf(shown, shownSetting('alpha') === 'true');
    const {encodeExr} = await exrWriter();
    return new Blob([encodeExr(rgb, shown.width, shown.height, {alpha})], {type: 'image/x-exr'});
}

export async function savePicture(kind: PictureKind) {
    const shown = services.first?.current;
    if (!isPictureOfScene.value || !shown) {
        notice.value = 'There is no picture of this scene yet.';
        return;
    }
    const name = pictureName(kind), scene = documentId.value;
    try {
        save(await (kind === 'png' ? pngOf() : exrOf(shown)), name);
    } catch (error) {
        const why = error instanceof Stopped && error.message === '' ? 'the scene has changed' : error instanceof Error ? error.message : String(error);
        if (scene === documentId.value) notice.value = `The picture is not saved: ${why}.`;
    }
}

export function saveScene(text: string) {
    save(new Blob([text], {type: 'text/plain'}), fileName.value.split('/').at(-1)!);
}
