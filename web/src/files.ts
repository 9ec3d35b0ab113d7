// SPDX-License-Identifier: Apache-2.0
// Saves the page's files.
import {encodePng} from 'glint-wasm/png';

import {comparison, fileName, isPictureOfScene, notice, settingOf} from './store/state';

function save(blob: Blob, name: string) {
    const anchor = document.createElement('a');
    anchor.href = URL.createObjectURL(blob);
    anchor.download = name.length > 120 ? name.slice(-120) : name;
    anchor.click();
    setTimeout(() => URL.revokeObjectURL(anchor.href), 10_000);
}

/** "castle" of "epfl/castle.json". */
export const baseName = () => fileName.value.split('/').at(-1)!.replace(/\.\w+$/, '') || 'picture';

/** castle_BlinnPhong.png, the naming scheme of the course's page. */
export function pictureName(): string {
    const shading = comparison.value?.key === 'shading' ? comparison.value.a : (settingOf('shading')?.value ?? '');
    const words = shading.split('-').map((word) => word.charAt(0).toUpperCase() + word.slice(1));
    return `${baseName()}_${words.join('')}.png`;
}

export function savePicture(canvas: HTMLCanvasElement) {
    if (!isPictureOfScene.value) {
        notice.value = 'There is no picture of this scene yet.';
        return;
    }
    const {data, width, height} = canvas.getContext('2d')!.getImageData(0, 0, canvas.width, canvas.height);
    save(new Blob([encodePng(data, width, height)], {type: 'image/png'}), pictureName());
}

export function saveScene(text: string) {
    save(new Blob([text], {type: 'text/plain'}), fileName.value.split('/').at(-1)!);
}
