// SPDX-License-Identifier: Apache-2.0
// .glint and .cgfs: blocks of `key = value`.
import type {FieldInfo, Vec3} from 'glint-wasm';

import {type Edit, type FogText, type LightText, type SceneFormat, length, number} from './edit';

export interface Entry {
    key: string;
    /** The value's text. */
    from: number;
    to: number;
}
export interface Block {
    word: string;
    from: number;
    /** Offsets after the opening brace and before the closing one. */
    open: number;
    close: number;
    entries: Entry[];
    blocks: Block[];
}

interface Token {
    kind: 'word' | 'string' | '{' | '}' | '(' | ')' | '=';
    from: number;
    to: number;
}

/** The tokens from an offset on; `oneBlock`: only up to the end of the first block. */
function tokenize(text: string, from = 0, oneBlock = false): Token[] {
    const tokens: Token[] = [];
    let depth = 0;
    const pattern = /#.*|\/\/.*|"(?:\\.|[^"\\\n])*"?|[{}()=]|[^\s,;{}()="#]+/g;
    pattern.lastIndex = from;
    for (const match of text.matchAll(pattern)) {
        const [found] = match;
        if (found.startsWith('#') || found.startsWith('//')) continue;
        const comment = found.indexOf('//');  // inside a word
        if (comment > 0) continue;
        const first = found[0]!;
        const kind = first === '"' ? 'string' : '{}()='.includes(first) ? (first as Token['kind']) : 'word';
        tokens.push({kind, from: match.index, to: match.index + found.length});
        depth += kind === '{' ? 1 : kind === '}' ? -1 : 0;
        if (oneBlock && kind === '}' && depth <= 0) break;
    }
    return tokens;
}

/** Reads the well-formed parts and skips the rest, because the engine reports errors. */
function parse(text: string, tokens = tokenize(text)): Block {
    let i = 0;
    const value = (): [number, number] | null => {
        const first = tokens[i];
        if (!first || first.kind === '{' || first.kind === '}' || first.kind === '=' || first.kind === ')') return null;
        let to = first.to;
        if (first.kind !== '(') ++i;
        if (tokens[i]?.kind === '(' && (first.kind === '(' || tokens[i]!.from === first.to)) {
            let depth = 0;
            do {
                const token = tokens[i]!;
                depth += token.kind === '(' ? 1 : token.kind === ')' ? -1 : 0;
                to = token.to;
                ++i;
            } while (depth > 0 && i < tokens.length);
        } else if (first.kind === 'word' && tokens[i]?.kind === 'word' && text.slice(tokens[i]!.from, tokens[i]!.to) === 'x') {
            to = tokens[i + 1]?.to ?? to;  // 640 x 480
            i += 2;
        }
        return [first.from, to];
    };
    const content = (block: Block, depth: number) => {
        while (i < tokens.length) {
            const token = tokens[i]!;
            if (token.kind === '}') {
                if (depth > 0) return;
                ++i;
                continue;
            }
            const next = tokens[i + 1], after = tokens[i + 2];
            if (token.kind === 'word' && next?.kind === '=') {
                i += 2;
                const span = value();
                if (span) block.entries.push({key: text.slice(token.from, token.to), from: span[0], to: span[1]});
            } else if (token.kind === 'word' && (next?.kind === '{' || (next && after?.kind === '{')) && depth < 300) {
                const brace = next.kind === '{' ? next : after!;
                i += next.kind === '{' ? 2 : 3;
                const inner: Block = {
                    word: text.slice(token.from, token.to), from: token.from, open: brace.to, close: text.length, entries: [],
                    blocks: [],
                };
                content(inner, depth + 1);
                inner.close = tokens[i]?.from ?? text.length;
                ++i;
                block.blocks.push(inner);
            } else {
                ++i;
            }
        }
    };
    const root: Block = {word: '', from: 0, open: 0, close: text.length, entries: [], blocks: []};
    content(root, 0);
    return root;
}

/** Sets a key of a block: replaces its value, or appends an entry in the style of the others. */
function set(text: string, block: Block, key: string, value: string): Edit[] {
    const said = block.entries.findLast((entry) => entry.key === key);
    if (said) return [{from: said.from, to: said.to, insert: value}];
    const last = block.entries.at(-1);
    if (!last) return [{from: block.open, to: block.open, insert: ` ${key} = ${value} `}];
    const line = text.slice(text.lastIndexOf('\n', last.from) + 1, last.from);
    const indent = /^[ \t]*/.exec(line)![0];
    const isLong = text.slice(block.open, last.from).includes('\n');
    return [{from: last.to, to: last.to, insert: isLong ? `\n${indent}${key} = ${value}` : `  ${key} = ${value}`}];
}

export const vector = (v: Vec3) => `(${v.map(number).join(', ')})`;

/** The blocks around an offset, the outermost first. */
export function blocksAround(text: string, offset: number): Block[] {
    const around: Block[] = [];
    for (let blocks = parse(text).blocks; ;) {
        const next = blocks.find((block) => block.open <= offset && offset < block.close);
        if (!next) return around;
        around.push(next);
        blocks = next.blocks;
    }
}

/** The block that begins at an offset. */
export function anyBlockAt(text: string, offset: number): Block | null {
    return parse(text, tokenize(text, offset, true)).blocks.find((block) => block.from === offset) ?? null;
}

function blockAt(text: string, offset: number, word: string): Block | null {
    const block = anyBlockAt(text, offset);
    return block?.word === word ? block : null;
}

/** `canAdd`: a field that the text does not say can be said in a new key. */
function light(text: string, offset: number, canAdd: boolean): LightText | null {
    const block = blockAt(text, offset, 'light');
    if (!block) return null;
    const intensity = block.entries.findLast((entry) => entry.key === 'intensity');
    const setField = (field: FieldInfo, value: number | boolean | Vec3) => {
        const key = block.entries.findLast((entry) => field.keys.includes(entry.key))?.key ?? (canAdd ? field.keys[0]! : null);
        return key === null ? null : set(text, block, key, valueText(value));
    };
    return {
        intensity: intensity ? Number(text.slice(intensity.from, intensity.to)) : 1,
        setIntensity: (value) => set(text, block, 'intensity', number(value)),
        setField,
    };
}

const valueText = (value: number | boolean | Vec3) => (typeof value === 'number' ? number(value) : typeof value === 'boolean' ? String(value) : vector(value));

/** A block that a scene has at most once; `key` says its kind. */
function onlyBlock(text: string, offset: number, word: string, key: string): FogText | null {
    const block = blockAt(text, offset, word);
    if (!block) return null;
    return {
        setKind: (kind) => set(text, block, key, kind),
        setField: (field, value) => set(text, block, field.keys[0]!, valueText(value)),
        remove() {
            const line = /^[ \t]*(?:\r?\n)?/.exec(text.slice(block.close + 1))![0];
            return [{from: block.from, to: block.close + 1 + line.length, insert: ''}];
        },
    };
}

/** The position for new lines at the top of a text: after its first comments and settings. */
function top(text: string, settings: string[]): number {
    const root = parse(text);
    const last = root.entries.findLast((entry) => settings.includes(entry.key));
    if (last) {
        const end = text.indexOf('\n', last.to);
        return end < 0 ? text.length : end + 1;
    }
    const comments = /^(?:[ \t]*(?:#|\/\/).*\n)*/.exec(text.replace(/^\uFEFF/, ' '))![0];
    return comments.length;
}

/** Adds a line at the top. */
function addLine(text: string, line: string): Edit[] {
    const at = top(text, ['glint', 'profile', 'background']);
    return [{from: at, to: at, insert: `${at > 0 && text[at - 1] !== '\n' ? '\n' : ''}${line}\n`}];
}

export const glint: SceneFormat = {
    name: '.glint',
    setting(text, key, value, isConvention) {
        const word = isConvention ? 'conventions' : 'render';
        const shown = value.includes(':') ? JSON.stringify(value) : value.replace(/^(\d+)x(\d+)$/, '$1 x $2');
        const blocks = parse(text).blocks.filter((block) => block.word === word);
        const said = blocks.findLast((block) => block.entries.some((entry) => entry.key === key)) ?? blocks.at(-1);
        if (said) return set(text, said, key, shown);
        const at = top(text, ['glint', 'profile']);
        return [{from: at, to: at, insert: `${at > 0 && text[at - 1] !== '\n' ? '\n' : ''}${word} { ${key} = ${shown} }\n`}];
    },
    light: (text, offset) => light(text, offset, true),
    fog: (text, offset) => onlyBlock(text, offset, 'fog', 'type'),
    addFog: (text, density) => addLine(text, `fog { type = exp  color = (0.7, 0.75, 0.8)  density = ${number(density)} }`),
    block: onlyBlock,
    addBlock: addLine,
    camera(text, offset, camera) {
        const block = offset === null ? null : blockAt(text, offset, 'camera');
        if (!block) return null;
        const edits = set(text, block, 'position', vector(camera.position));
        if (camera.has_frame) {
            for (const key of ['right', 'up', 'forward'] as const) edits.push(...set(text, block, key, vector(camera.view[key])));
        } else {
            edits.push(...set(text, block, 'look_at', vector(camera.look_at!)));
            if (camera.projection === 'orthographic') edits.push(...set(text, block, 'width', number(camera.width!)));
        }
        return merged(edits);
    },
};

/** Joins edits at the same position, because an editor applies them in any order. */
function merged(edits: Edit[]): Edit[] {
    const result: Edit[] = [];
    for (const edit of edits) {
        const same = result.find((other) => other.from === edit.from && other.to === edit.to && other.from === other.to);
        if (same) {
            same.insert += edit.insert;
        } else {
            result.push({...edit});
        }
    }
    return result.sort((a, b) => a.from - b.from);
}

export const cgfs: SceneFormat = {
    name: '.cgfs',
    setting: () => null,
    light: (text, offset) => light(text, offset, false),
    camera(text, offset, camera) {
        const {right, up, forward} = camera.view;
        const axes = [right, up, forward].map((axis) => axis.map((c) => c / length(axis)));
        const rows = [0, 1, 2].map((row) => vector(axes.map((axis) => axis[row]!) as Vec3));
        const position = vector(camera.position), rotation = `(${rows.join(', ')})`;
        const block = offset === null ? parse(text).blocks.findLast((one) => one.word === 'camera') : blockAt(text, offset, 'camera');
        if (block) return merged([...set(text, block, 'position', position), ...set(text, block, 'rotation', rotation)]);
        const at = top(text, []);
        return [{from: at, to: at, insert: `camera {\n    position = ${position}\n    rotation = ${rotation}\n}\n`}];
    },
};
