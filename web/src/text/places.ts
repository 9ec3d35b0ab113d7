// SPDX-License-Identifier: Apache-2.0
// The engine counts lines from 1 and columns in bytes of UTF-8; the editor counts UTF-16 units from the start of the text.

/** Start and end of line `line` of a text, without its line end. */
function lineSpan(text: string, line: number): [number, number] {
    let from = 0;
    for (let n = 1; n < line; ++n) {
        const end = text.indexOf('\n', from);
        if (end < 0) return [text.length, text.length];
        from = end + 1;
    }
    const end = text.indexOf('\n', from);
    return [from, end < 0 ? text.length : end];
}

/** The number of UTF-16 units for a number of bytes of UTF-8. */
export function unitsOf(text: string, bytes: number): number {
    let left = bytes, units = 0;
    for (const character of text) {
        if (left <= 0) break;
        const code = character.codePointAt(0)!;
        left -= code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
        units += character.length;
    }
    return units;
}

/** The offsets of a place, and of a number of bytes after it. */
export function spanOf(text: string, line: number, column: number, bytes = 0): [number, number] {
    const [from, to] = lineSpan(text, line);
    const start = from + unitsOf(text.slice(from, to), column - 1);
    return [start, start + unitsOf(text.slice(start, to), bytes)];
}
