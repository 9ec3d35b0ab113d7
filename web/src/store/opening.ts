// SPDX-License-Identifier: Apache-2.0
// What the user drops or chooses: scenes with what they include, also in a folder or a .zip, or a picture or a log of the present
// scene.
import {computed, effect, signal} from '@preact/signals';
import type {SceneText} from 'glint-wasm';

import {type GivenFile, unpacker, withoutArchives} from '../given_files';
import {isMeshName, meshExtensions, readFile} from '../mesh_file';
import {isPictureName} from '../picture_file';
import {isLog} from '../log_file';
import {extensions, formatOf} from '../text/formats';
import {folderOf, namesIncludedBy, placedIn, rootsOf, textsFor} from '../text/includes';
import {keepForBack, setAddress} from './address';
import {fetchLater} from './later';
import {openPicture} from './own';
import {openLog} from './own_log';
import {openScene, sceneOfMesh, shortName} from './scene';
import {currentDocumentState, documentId, fileName, includes, missing, notice, services, text} from './state';

/** The texts that were given with the present scene. */
const folder = signal<SceneText[]>([]);

/** The names of the scenes among them; none if the present scene is another one. */
export const folderScenes = computed(() => {
    const names = folder.value.filter(({name}) => formatOf(name)).map(({name}) => name);
    return names.includes(fileName.value) ? names : [];
});

export async function openFiles(given: readonly GivenFile[]) {
    let files: GivenFile[];
    try {
        files = await withoutArchives(given);
    } catch (error) {
        notice.value = error instanceof Error ? error.message : String(error);
        return;
    }
    const areLogs = await Promise.all(files.map(({file}) => isLog(file)));
    const log = files.find((_, i) => areLogs[i]), picture = files.find(({path}) => isPictureName(path));
    const others = files.filter((_, i) => !areLogs[i]);
    // Pictures beside a scene, or that the present one lacks, are of its textures.
    if (!others.every(({path}) => isPictureName(path)) || (!log && !picture)) await openTexts(others, given);
    else if (picture && !(await supplyPictures(others))) await openPicture(picture.file);
    if (log) await openLog(log.file);
}

/** Supplies the pictures that the present scene lacks. False if these are none of them. */
async function supplyPictures(files: readonly GivenFile[]) {
    if (missing.value.length === 0) return false;
    return supply(textsFor(missing.value, fileName.value, await Promise.all(files.map(({path, file}) => readFile(path, file)))));
}

/** Supplies the texts that the present scene lacks, if they are among these; else opens the first scene, with those that it includes. */
async function openTexts(files: readonly GivenFile[], given: readonly GivenFile[]) {
    const texts = await Promise.all(files.map(({path, file}) => readFile(path, file)));
    if (supply(textsFor(missing.value, fileName.value, texts))) return;
    const scenes = texts.filter(({name}) => formatOf(name)), [main, ...others] = rootsOf(scenes);
    const mesh = texts.find(({name}) => isMeshName(name));
    if (!main && mesh) {
        await openMesh(mesh, texts);
        return;
    }
    if (!main) {
        notice.value = `Not a scene: ${given.map(({file}) => shortName(file.name)).join(', ')}. Scenes end in .${[...extensions, ...meshExtensions].join(', .')}.`;
        return;
    }
    folder.value = texts;
    openFromFolder(main);
    if (others.length > 0 && notice.value === '') notice.value = `${shortName(main.name)} is opened, one of ${others.length + 1} scenes here; the menu above the text has the others.`;
}

/** Opens a mesh as a scene that has it, with the camera and the lights that glint gives a mesh by itself. */
async function openMesh(mesh: SceneText, texts: readonly SceneText[]) {
    const scene = await sceneOfMesh({texts: [mesh], includes: texts.filter((one) => one !== mesh)});
    if ('error' in scene) {
        notice.value = `${shortName(mesh.name)} is not opened: ${scene.error}`;
        return;
    }
    folder.value = [...texts];
    openFromFolder({name: mesh.name.replace(/\.\w+$/, '') + '.glint', text: placedIn(folderOf(mesh.name), scene.text)});
}

function openFromFolder(file: SceneText) {
    keepForBack();
    openScene({...file, includes: textsFor(namesIncludedBy(file), file.name, folder.value)});
    setAddress(null);
}

/** Opens another scene of the folder; the present one keeps its changes there. */
export function chooseFile(name: string) {
    folder.value = folder.value.map((one) => (one.name === fileName.value ? {name: one.name, text: text.value} : one));
    const file = folder.value.find((one) => one.name === name);
    if (file && name !== fileName.value) openFromFolder(file);
}

/** Gives the present scene more texts that it may include. False if there are none. */
function supply(found: readonly SceneText[]): boolean {
    if (found.length === 0) return false;
    const others = includes.value.filter((one) => !found.some(({name}) => name === one.name));
    services.editor?.setDocumentState({...currentDocumentState(), includes: [...others, ...found]});
    return true;
}

/** Texts whose names a scene computes are found in its folder, too. */
export function followMissing() {
    fetchLater(unpacker);
    effect(() => {
        const names = missing.value.filter((name) => !includes.peek().some((one) => one.name === name));
        if (folderScenes.peek().length === 0 || names.length === 0) return;
        const found = textsFor(names, fileName.peek(), folder.peek()), id = documentId.peek();
        if (found.length > 0) queueMicrotask(() => id === documentId.peek() && supply(found));
    });
}
