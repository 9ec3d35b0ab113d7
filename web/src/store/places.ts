// SPDX-License-Identifier: Apache-2.0
// Where items of the scene are in the text. The scene is from the last text without errors; the text may have
// changed since.
import type {Place} from 'glint-wasm';

import {spanOf} from '../text/places';
import {openIncluded, opened} from './included';
import {fileName, services, notice, tab, text} from './state';

/** True if a place is in the edited text, not in one that it includes. */
export const isHere = (place: Place) => place.file === fileName.value;

/** The offset of a place of the scene in the present text; null if it has been deleted. */
export function offsetOf(place: {line: number; column: number}): number | null {
    return services.editor?.offsetOf(place.line, place.column) ?? null;
}

function select(from: number) {
    opened.value = null;
    const end = text.value.indexOf('\n', from);
    if (matchMedia('(max-width: 1011px)').matches) tab.value = 'text';
    // After the editor's panel has become visible.
    requestAnimationFrame(() => services.editor?.reveal(from, end < 0 ? text.value.length : end));
}

function isElsewhere(file: string | undefined, line: number): boolean {
    if (file === fileName.value) return false;
    openIncluded(file, line);
    return true;
}

/** Shows the place of an item of the scene, also in a text that it includes. */
export function reveal(place: Partial<Place> | null | undefined) {
    const {line, column, file} = place ?? {};
    if (line === undefined || column === undefined) return;
    if (isElsewhere(file, line)) return;
    const from = offsetOf({line, column});
    if (from === null) {
        notice.value = 'That part of the text has been deleted.';
    } else {
        select(from);
    }
}

/** Shows the place of a message about the present text. */
export function revealMistake({file, line, column}: Place) {
    if (isElsewhere(file, line)) return;
    select(spanOf(text.value, line, column)[0]);
}
