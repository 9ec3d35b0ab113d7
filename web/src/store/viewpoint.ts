// SPDX-License-Identifier: Apache-2.0
// Moving the camera, in the text.
import type {CameraInfo} from 'glint-wasm';

import {type Move, moved} from '../camera';
import {isHere, offsetOf} from './places';
import {format, info, services, notice, text} from './state';

/** Where a move has put the camera, until the scene is read again. */
let aimed: {text: string; camera: CameraInfo} | null = null;

/** The camera as the text has it now: moves may follow each other faster than pictures do. */
export function cameraNow(): CameraInfo | undefined {
    return aimed?.text === text.value ? aimed.camera : info.value?.camera;
}

function editsFor(camera: CameraInfo) {
    const {place} = camera;
    if (!place) return format.value?.camera(text.value, null, camera) ?? null;
    const offset = isHere(place) ? offsetOf(place) : null;
    return offset === null ? null : (format.value?.camera(text.value, offset, camera) ?? null);
}

/** Moves the camera from where it was. `distance`: how far what it looks at is, if it does not say. */
export function moveCamera(from: CameraInfo, distance: number, ...moves: Move[]) {
    const now = info.value?.camera;
    if (!now) return;
    const camera = {...moves.reduce((camera, move) => moved(camera, move, distance), from), place: now.place};
    const edits = editsFor(camera);
    if (!edits) {
        notice.value = 'This text does not say where its camera is; as .glint it would.';
        return;
    }
    services.editor?.apply(edits);
    aimed = {text: text.value, camera};
}
