// SPDX-License-Identifier: Apache-2.0
// What the user drops or chooses: scenes with what they include, or a picture of the present scene.
import {isPictureName} from '../picture_file';
import {openPicture} from './own';
import {openSceneFiles} from './scene';
import {notice} from './state';

export async function openFiles(files: File[]) {
    const picture = files.find(({name}) => isPictureName(name));
    if (picture && files.every(({name}) => isPictureName(name))) return openPicture(picture);
    if (files.every(({name}) => /\.exr$/i.test(name))) {
        notice.value = 'OpenEXR pictures are compared by the command: glint compare mine.exr reference.exr --scene SCENE.';
        return;
    }
    return openSceneFiles(files.filter(({name}) => !isPictureName(name)));
}
