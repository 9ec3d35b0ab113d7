// SPDX-License-Identifier: Apache-2.0
// Moves a shape of a text by a vector of the world.
import type {Vec3} from 'glint-wasm';

import {anyBlockAt, blocksAround, vector} from './blocks';
import {type Edit, aNumber, number} from './edit';

/** Keys of points; those of directions stay. */
const points = ['center', 'point', 'from', 'to', 'min', 'max', 'vertices'];
const transforms = ['translate', 'rotate', 'scale', 'matrix'];

/** Adds a vector to the points of a part of a text: all its numbers, three by three. */
export function movePoints(text: string, from: number, to: number, by: Vec3): Edit[] {
    return [...text.slice(from, to).matchAll(aNumber)].flatMap((found, i) => {
        const at = from + found.index;
        return by[i % 3] === 0 ? [] : [{from: at, to: at + found[0].length, insert: number(Number(found[0]) + by[i % 3]!)}];
    });
}

/** The shape of the block at an offset of a .glint or .cgfs text; null in a group that transforms it. */
export function moveBlock(text: string, offset: number, by: Vec3): Edit[] | null {
    const block = anyBlockAt(text, offset);
    const isTransformed = blocksAround(text, offset).some((group) => group.entries.some(({key}) => transforms.includes(key)));
    if (!block || isTransformed) return null;
    const last = block.entries.findLast(({key}) => transforms.includes(key));
    if (last?.key === 'translate') return movePoints(text, last.from, last.to, by);
    if (last) return [{from: last.to, to: last.to, insert: `  translate = ${vector(by)}`}];
    const said = block.entries.filter(({key}) => points.includes(key));
    return said.length === 0 ? null : said.flatMap(({from, to}) => movePoints(text, from, to, by));
}

/** The text after edits that do not overlap. */
export function edited(text: string, edits: Edit[]): string {
    return [...edits].sort((a, b) => b.from - a.from)
        .reduce((now, {from, to, insert}) => now.slice(0, from) + insert + now.slice(to), text);
}
