// SPDX-License-Identifier: Apache-2.0
// .json and .js: the scenes of RT2, as JSON or as JavaScript data.
import type {Vec3} from 'glint-wasm';

import {type Edit, type SceneFormat, number, ofPosition, withLargest} from './edit';
import {movePoints} from './moving';

interface Value {
    from: number;
    to: number;
    members?: Map<string, Value>;
    items?: Value[];
}

/** Reads the value at an offset, tolerating errors; null if there is none. */
function parse(text: string, offset: number): Value | null {
    let at = offset;
    const skip = () => {
        for (;;) {
            const blank = /(?:\s|,|;|\/\/.*|\/\*[\s\S]*?\*\/)*/y;
            blank.lastIndex = at;
            const found = blank.exec(text)![0];
            if (found === '') return;
            at += found.length;
        }
    };
    const word = (): string | null => {
        const pattern = /"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|[^\s,:;{}[\]()"']+/y;
        pattern.lastIndex = at;
        const found = pattern.exec(text)?.[0] ?? null;
        if (found) at += found.length;
        return found;
    };
    const value = (depth: number): Value | null => {
        const from = at;
        const opening = text[at];
        if (depth > 100) return null;
        if (opening === '{' || opening === '[') {
            const result: Value = opening === '{' ? {from, to: from, members: new Map()} : {from, to: from, items: []};
            ++at;
            for (skip(); at < text.length && text[at] !== '}' && text[at] !== ']'; skip()) {
                if (result.items) {
                    const item = value(depth + 1);
                    if (!item) return null;
                    result.items.push(item);
                } else {
                    const key = word();
                    skip();
                    if (!key || text[at] !== ':') return null;
                    ++at;
                    skip();
                    const member = value(depth + 1);
                    if (!member) return null;
                    result.members!.set(key.replace(/^["']|["']$/g, ''), member);
                }
            }
            result.to = ++at;
            return result;
        }
        return word() === null ? null : {from, to: at};
    };
    return value(0);
}

/** The objects of a text, single or in a list. */
function* objects(text: string): Generator<Map<string, Value>> {
    const next = /\/\/.*|\/\*[\s\S]*?\*\/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|[{[]/g;
    for (let match = next.exec(text); match; match = next.exec(text)) {
        if (match[0] !== '{' && match[0] !== '[') continue;
        const found = parse(text, match.index);
        if (!found) return;
        for (const one of found.items ?? [found]) {
            if (one.members) yield one.members;
        }
        next.lastIndex = found.to;
    }
}

function numbers(text: string, value: Value | undefined): Vec3 | null {
    const list = value?.items?.map((item) => Number(text.slice(item.from, item.to)));
    return list?.length === 3 && list.every(Number.isFinite) ? (list as Vec3) : null;
}

function replaced(value: Value, v: Vec3): Edit {
    return {from: value.from, to: value.to, insert: `[${v.map(number).join(', ')}]`};
}

export const json: SceneFormat = {
    name: '.json',
    setting: () => null,
    scenes(text) {
        if (/^\s*{/.test(text)) return [];  // JSON has only one
        const names = [...objects(text)].map((one) => one.get('name')).filter((name) => name !== undefined);
        return names.map(({from, to}) => text.slice(from, to).replace(/^["']|["']$/g, ''));
    },
    light(text, offset) {
        const members = parse(text, offset)?.members;
        const color = members?.get('color'), position = members?.get('position');
        const channels = numbers(text, color);
        if (!color || !position || !channels) return null;
        return {
            intensity: Math.max(...channels),
            setIntensity: (value) => [replaced(color, withLargest(channels, value))],
            setField: ofPosition((value) => [replaced(position, value)]),
        };
    },
    moveShape(text, offset, by) {
        const center = parse(text, offset)?.members?.get('center');
        return center ? movePoints(text, center.from, center.to, by) : null;
    },
    camera(text, offset, camera) {
        // The place is that of the key.
        const colon = offset === null ? -1 : text.indexOf(':', offset);
        const members = colon < 0 ? undefined : parse(text, colon + 1 + /^\s*/.exec(text.slice(colon + 1))![0].length)?.members;
        const position = members?.get('position'), target = members?.get('target');
        if (!position || !target || !camera.look_at) return null;
        return [replaced(position, camera.position), replaced(target, camera.look_at)];
    },
};
