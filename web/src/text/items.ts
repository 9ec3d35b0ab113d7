// SPDX-License-Identifier: Apache-2.0
// The numbers of a block of .glint and .cgfs, such as a shape's or a material's, each as it can be changed in the text.
import {anyBlockAt} from './blocks';
import {type Edit, aNumber, number} from './edit';

export interface NumericEntry {
    key: string;
    numbers: number[];
    /** The edit that gives one of the numbers another value. */
    set(index: number, value: number): Edit[];
}

/** The entries of the block at an offset whose values are numbers; null if there is no block. */
export function numericEntries(text: string, offset: number): {word: string; entries: NumericEntry[]} | null {
    const block = anyBlockAt(text, offset);
    if (!block) return null;
    const entries = block.entries.flatMap(({key, from, to}) => {
        const said = text.slice(from, to);
        const spans = [...said.matchAll(aNumber)];
        // A word is no number; "rgb255(1, 2, 3)" has three.
        if (spans.length === 0 || spans.length > 4 || /^["#]|^[A-Za-z_]\w*$/.test(said)) return [];
        return [{
            key, numbers: spans.map(([found]) => Number(found)),
            set(index: number, value: number): Edit[] {
                const at = from + spans[index]!.index;
                return [{from: at, to: at + spans[index]![0].length, insert: number(value)}];
            },
        }];
    });
    return {word: block.word, entries};
}
