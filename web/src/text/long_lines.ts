// SPDX-License-Identifier: Apache-2.0
// Lines that are too long for the editor. JSON, and JavaScript data, mean the same with other line ends.

/** The longest line that the editor can show; longer ones block the page. */
export const longestLine = 20_000;

/** The number of a line that is too long, or 0. */
export function tooLongLine(text: string): number {
    for (let from = 0, line = 1; from <= text.length; ++line) {
        const end = text.indexOf('\n', from) < 0 ? text.length : text.indexOf('\n', from);
        if (end - from > longestLine) return line;
        from = end + 1;
    }
    return 0;
}

/** The length from which a line ends at the next comma. */
const usual = 80;

/** The text with ends of lines after some of its commas and braces. Strings and comments stay as they are. */
function laidOut(text: string): string {
    const tokens = /"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|\/\/[^\n]*|\/\*[\s\S]*?\*\/|[{}[\],]|[^\S\n]+|\n|[^{}[\],"'\s/]+|[\s\S]/g;
    const lines: string[] = [];
    let line = '', depth = 0;
    const indent = () => '  '.repeat(Math.min(depth, 20));
    const end = () => {
        lines.push(line.trimEnd());
        line = indent();
    };
    for (const [token] of text.matchAll(tokens)) {
        if (token === '\n') {
            end();
            continue;
        }
        if (line.trim() === '' && token.trim() === '') continue;
        if (token === '{' && /[,[]\s*$/.test(line)) end();
        if (token === '}' || token === ']') --depth;
        line += token;
        if (token === '{' || token === '[') ++depth;
        if (token === ',' && (line.length > usual || depth <= 1)) end();
    }
    lines.push(line);
    return lines.join('\n');
}

/** A text whose lines the editor can show: of .json and .js with more ends of lines, if it needs them. */
export function withShortLines(name: string, text: string): string {
    return /\.(json|js)$/i.test(name) && tooLongLine(text) > 0 ? laidOut(text) : text;
}
