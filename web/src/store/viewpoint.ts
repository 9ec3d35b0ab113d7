// SPDX-License-Identifier: Apache-2.0
// Moves the camera by editing the text.
import type {CameraInfo} from 'glint-wasm';

import {type Move, moved} from '../camera';
import {isHere, offsetOf} from './places';
import {documentId, format, info, services, notice, text} from './state';

/** The camera of each scene when it was opened: the last one. */
let original: {id: number; camera: CameraInfo} | null = null;

/** A scene was read without errors. */
export function wasOpened(camera: CameraInfo, id: number) {
    if (original?.id !== id) original = {id, camera};
}

/** Moves the camera to where it was when the scene was opened. */
export function resetCamera() {
    if (original?.id === documentId.value) moveCamera(original.camera, 1);
}

/** The camera after a move, until the scene is read again. */
let aimed: {text: string; camera: CameraInfo} | null = null;

/** The camera in the present text: moves may be faster than rendering. */
export function cameraNow(): CameraInfo | undefined {
    return aimed?.text === text.value ? aimed.camera : info.value?.camera;
}

function editsFor(camera: CameraInfo) {
    const {place} = camera;
    if (!place) return format.value?.camera(text.value, null, camera) ?? null;
    const offset = isHere(place) ? offsetOf(place) : null;
    return offset === null ? null : (format.value?.camera(text.value, offset, camera) ?? null);
}

/** Moves the camera. `distance`: that of the target, if the camera has none. */
export function moveCamera(from: CameraInfo, distance: number, ...moves: Move[]) {
    const now = info.value?.camera;
    if (!now) return;
    const camera = {...moves.reduce((camera, move) => moved(camera, move, distance), from), place: now.place};
    const edits = editsFor(camera);
    if (!edits) {
        notice.value = 'The camera cannot be changed in this text. Convert it to .glint first.';
        return;
    }
    services.editor?.apply(edits);
    aimed = {text: text.value, camera};
}
