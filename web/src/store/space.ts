// SPDX-License-Identifier: Apache-2.0
// The view in space: how it is turned, and what is moved in it.
import {signal} from '@preact/signals';
import type {NamedItem, Vec3} from 'glint-wasm';

import {add} from '../camera';
import {type Turn, startTurn} from '../space/frame';
import type {Edit} from '../text/edit';
import {edited} from '../text/moving';
import {lightText} from './lights';
import {isHere, offsetOf} from './places';
import {fileName, format, info, notice, services, text} from './state';

export const turn = signal<Turn>(startTurn);
/** The last cut that the view chose itself, and what it showed: kept while the view moves between the inspector and the picture's place. */
export const ownCut = {about: '', cut: 0};
export const isOpen = signal(true);
/** It takes the place of the picture. */
export const isLarge = signal(false);

/** Scenes of so many shapes are shown in less detail, and their text changes only at the end of a drag. */
export const manyShapes = 100_000;
export const shapeCount = () => Object.values(info.value?.shapes ?? {}).reduce((sum, count) => sum + count, 0);

export type Movable = {kind: 'light'; index: number} | {kind: 'shape'; shape: NamedItem & {kind: string}};

/** The edits of the present text that move something by a vector; null if the text cannot say it. */
function moverOf(what: Movable): ((by: Vec3) => Edit[] | null) | null {
    const before = text.value, {value: facts} = info, said = format.value;
    if (what.kind === 'light') {
        const light = lightText(what.index), position = facts?.lights[what.index]?.position;
        const field = facts?.light_fields.find(({name}) => name === 'position');
        return light && field && position ? (by) => light.setField(field, add(position, by)) : null;
    }
    const {file, line, column} = what.shape;
    if (file === undefined || line === undefined || column === undefined || !isHere({file, line, column})) return null;
    const offset = offsetOf({line, column});
    return offset === null ? null : (by) => said?.moveShape?.(before, offset, by) ?? null;
}

/** Something is being moved. */
export const isMoving = signal(false);

/** A move in progress: `by` is from where it began. */
export interface Drag {
    to(by: Vec3): void;
    end(): void;
}

/** Begins to move a light or a shape: one change of the text, which undo takes back as a whole. Null: it cannot be moved. */
export function beginDrag(what: Movable): Drag | null {
    const before = text.value, mover = moverOf(what);
    if (!mover?.([1, 1, 1])) {
        notice.value = what.kind === 'shape' && what.shape.file !== undefined && what.shape.file !== fileName.value
            ? `That is in ${what.shape.file}, which this scene includes.`
            : 'That cannot be moved in this text: its format cannot say it, or a group transforms it. Convert it to .glint first, or edit the text.';
        return null;
    }
    let last = before;
    const apply = (by: Vec3) => {
        const edits = mover(by);
        if (!edits || text.value !== last) return;
        services.editor?.replaceBy(edited(before, edits), last !== before);
        last = text.value;
    };
    isMoving.value = true;
    const isLate = shapeCount() >= manyShapes;
    let wanted: Vec3 | null = null;
    return {
        to(by) {
            wanted = by;
            if (!isLate) apply(by);
        },
        end() {
            if (isLate && wanted) apply(wanted);
            isMoving.value = false;
            if (last !== before) services.editor?.endEdit();
        },
    };
}
