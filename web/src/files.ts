// SPDX-License-Identifier: Apache-2.0
// Saves the page's files.
import {fetchLater} from './store/later';
import {comparison, fileName, isPictureOfScene, notice, settingOf} from './store/state';
import {pixelsOf} from './ui/pictures';

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

/** castle_BlinnPhong.png, the naming scheme of the course's page. */
export function pictureName(): string {
    const words = shownSetting('shading').split('-').map((word) => word.charAt(0).toUpperCase() + word.slice(1));
    return `${baseName()}_${words.join('')}.png`;
}

const pictureWriter = () => import('glint-wasm/png');
fetchLater(pictureWriter);

export async function savePicture(canvas: HTMLCanvasElement) {
    try {
        const {encodePng} = await pictureWriter();
        if (!isPictureOfScene.value) {
            notice.value = 'There is no picture of this scene yet.';
            return;
        }
        const {data, width, height} = pixelsOf(canvas);
        const file = encodePng(data, width, height, {alpha: shownSetting('alpha') === 'true', srgb: shownSetting('transfer') === 'srgb'});
        save(new Blob([file], {type: 'image/png'}), pictureName());
    } catch (error) {
        notice.value = `The picture is not saved: ${error instanceof Error ? error.message : String(error)}`;
    }
}

export function saveScene(text: string) {
    save(new Blob([text], {type: 'text/plain'}), fileName.value.split('/').at(-1)!);
}
