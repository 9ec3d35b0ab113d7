// SPDX-License-Identifier: Apache-2.0
// Files of meshes, which a scene refers to, or which are opened as a scene of their own; and the bytes of files that are no text.
import type {SceneText} from 'glint-wasm';

import {isPictureName} from './picture_file';

export const meshExtensions = ['ply', 'stl', 'obj', 'gltf', 'glb'];
/** The buffers of .gltf. */
export const bufferExtensions = ['bin', 'glbin', 'glbuf'];
const meshes = new RegExp(`\\.(${meshExtensions.join('|')})$`, 'i');
const binary = new RegExp(`\\.(${[...meshExtensions, ...bufferExtensions].join('|')})$`, 'i');

export const isMeshName = (name: string) => meshes.test(name);

function base64(bytes: Uint8Array): string {
    let binary = '';
    for (let i = 0; i < bytes.length; i += 0x8000) binary += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
    return btoa(binary);
}

/** The text of a file, or the bytes of one that is no text. */
export async function readFile(name: string, file: File): Promise<SceneText> {
    if (!binary.test(name) && !isPictureName(name)) return {name, text: await file.text()};
    const bytes = new Uint8Array(await file.arrayBuffer());
    try {
        const text = new TextDecoder('utf-8', {fatal: true, ignoreBOM: true}).decode(bytes);
        if (!text.includes('\0')) return {name, text};
    } catch {
        // It is no text.
    }
    return {name, text: '', base64: base64(bytes)};
}
