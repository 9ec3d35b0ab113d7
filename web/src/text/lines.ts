// SPDX-License-Identifier: Apache-2.0
// .nff: each line is a word and its numbers. .pov: vectors in angle brackets, in blocks.
import type {Vec3} from 'glint-wasm';

import {type Edit, type SceneFormat, length, number, ofPosition, withLargest} from './edit';
import {movePoints} from './moving';

/** The first match of a pattern from an offset on, and the offset of its first group. */
function find(text: string, pattern: RegExp, offset: number, end = text.length): {from: number; to: number; found: string} | null {
    const match = new RegExp(pattern.source, 'dm').exec(text.slice(offset, end));
    const span = match?.indices?.[1];
    return span ? {from: offset + span[0], to: offset + span[1], found: match![1]!} : null;
}

const plain = (v: Vec3) => v.map(number).join(' ');

/** .dat is shown and rendered; it has no text that the page changes. */
export const dat: SceneFormat = {name: '.dat', setting: () => null, light: () => null, camera: () => null};

export const nff: SceneFormat = {
    name: '.nff',
    setting(text, key, value) {
        const resolution = key === 'size' ? find(text, /^resolution[ \t]+(\S+[ \t]+\S+)/, 0) : null;
        return resolution && [{from: resolution.from, to: resolution.to, insert: value.replace('x', ' ')}];
    },
    light(text, offset) {
        const end = text.indexOf('\n', offset) < 0 ? text.length : text.indexOf('\n', offset);
        const [word, ...rest] = text.slice(offset, end).split('#')[0]!.trim().split(/\s+/);
        const values = rest.map(Number);
        if (word !== 'l' || !values.every(Number.isFinite)) return null;
        if (values.length !== 3 && values.length !== 6) return null;
        const place = values.slice(0, 3) as Vec3;
        // The total brightness of lights without a color is the square root of their number.
        const count = text.match(/^l[ \t]/gm)?.length ?? 1;
        const color = (values.length === 6 ? values.slice(3) : Array(3).fill(1 / Math.sqrt(count))) as Vec3;
        const line = (p: Vec3, c: Vec3): Edit[] => [{from: offset, to: end, insert: `l ${plain(p)} ${plain(c)}`}];
        return {
            intensity: Math.max(...color),
            setIntensity: (value) => line(place, withLargest(color, value)),
            setField: ofPosition((value) => line(value, color)),
        };
    },
    moveShape(text, offset, by) {
        const ball = /^s[ \t]+\S+[ \t]+\S+[ \t]+\S+/.exec(text.slice(offset, offset + 400));
        return ball && movePoints(text, offset, offset + ball[0].length, by);
    },
    camera(text, offset, camera) {
        const from = find(text, /^from[ \t]+(\S+[ \t]+\S+[ \t]+\S+)/, offset ?? 0);
        const at = find(text, /^at[ \t]+(\S+[ \t]+\S+[ \t]+\S+)/, offset ?? 0);
        if (!from || !at || !camera.look_at) return null;
        return [{from: from.from, to: from.to, insert: plain(camera.position)}, {from: at.from, to: at.to, insert: plain(camera.look_at)}];
    },
};

const angled = (v: Vec3) => `<${v.map(number).join(', ')}>`;
const vector = /(<[^<>]*>)/;

function parseAngled(text: string): Vec3 | null {
    const list = text.slice(1, -1).split(',').map(Number);
    return list.length === 3 && list.every(Number.isFinite) ? (list as Vec3) : null;
}

/** The end of the block whose word is at an offset. */
function endOfBlock(text: string, offset: number): number {
    const end = text.indexOf('}', offset);
    return end < 0 ? text.length : end;
}

export const pov: SceneFormat = {
    name: '.pov',
    setting: () => null,
    light(text, offset) {
        if (!text.startsWith('light_source', offset)) return null;
        const end = endOfBlock(text, offset);
        const place = find(text, vector, offset, end);
        const color = find(text, /rgb\s*(<[^<>]*>)/, offset, end);
        const channels = color && parseAngled(color.found);
        if (!place || !color || !channels) return null;
        return {
            intensity: Math.max(...channels),
            setIntensity: (value) => [{from: color.from, to: color.to, insert: angled(withLargest(channels, value))}],
            setField: ofPosition((value) => [{from: place.from, to: place.to, insert: angled(value)}]),
        };
    },
    moveShape(text, offset, by) {
        // The corners or centres come first; a transform would move them elsewhere.
        const shape = /^(?:sphere|box|cone|cylinder|triangle)\s*\{/.exec(text.slice(offset, offset + 400));
        const next = shape && /[}]\s*(?:$|\n\s*\n|\n\w)/.exec(text.slice(offset));
        const whole = next && text.slice(offset, offset + next.index);
        if (!shape || !whole || /\b(?:translate|rotate|scale|matrix)\b/.test(whole)) return null;
        const ends = /^[\s,]*(?:<[^<>]*>[\s,]*(?:[\d.+-]+[\s,]*)?)+/.exec(whole.slice(shape[0].length));
        if (!ends) return null;
        const at = offset + shape[0].length;
        return [...ends[0].matchAll(/<[^<>]*>/g)].flatMap((one) => movePoints(text, at + one.index, at + one.index + one[0].length, by));
    },
    camera(text, offset, camera) {
        if (offset === null) return null;
        const end = endOfBlock(text, offset);
        const {right, up, forward} = camera.view;
        const look_at = camera.position.map((p, i) => p + (forward[i]! / length(forward)) * 10) as Vec3;
        const edits: Edit[] = [];
        for (const [word, value] of Object.entries({location: camera.position, up, right, look_at})) {
            const said = find(text, new RegExp(`\\b${word}\\s*(<[^<>]*>)`), offset, end);
            if (!said) return null;
            edits.push({from: said.from, to: said.to, insert: angled(value)});
        }
        return edits.sort((a, b) => a.from - b.from);
    },
};
