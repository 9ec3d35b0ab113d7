// SPDX-License-Identifier: Apache-2.0
// Saves the page's files.
import {Stopped} from './engine/pool';
import {numbersOf} from './store/floats';
import {fetchLater} from './store/later';
import {comparison, documentId, fileName, isPictureOfScene, notice, settingOf} from './store/state';
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

async function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
    const {encodePng} = await pngWriter();
    const {data, width, height} = pixelsOf(canvas);
    return new Blob([encodePng(data, width, height, {alpha: shownSetting('alpha') === 'true', srgb: shownSetting('transfer') === 'srgb'})], {type: 'image/png'});
}

/** Renders the first picture again, since the canvas has bytes only. */
async function exrOf({width, height}: HTMLCanvasElement): Promise<Blob> {
    const {encodeExr} = await exrWriter();
    const {rgb, alpha} = await numbersOf(width, height, shownSetting('alpha') === 'true');
    return new Blob([encodeExr(rgb, width, height, {alpha})], {type: 'image/x-exr'});
}

export async function savePicture(kind: PictureKind) {
    if (!isPictureOfScene.value) {
        notice.value = 'There is no picture of this scene yet.';
        return;
    }
    const name = pictureName(kind), scene = documentId.value;
    try {
        save(await (kind === 'png' ? pngOf : exrOf)(canvases.first), name);
    } catch (error) {
        const why = error instanceof Stopped && error.message === '' ? 'the scene has changed' : error instanceof Error ? error.message : String(error);
        if (scene === documentId.value) notice.value = `The picture is not saved: ${why}.`;
    }
}

export function saveScene(text: string) {
    save(new Blob([text], {type: 'text/plain'}), fileName.value.split('/').at(-1)!);
}
