// SPDX-License-Identifier: Apache-2.0
// Decides whether a lesson's step is done: by the scene as glint reads it, by its pixels as glint explains them, and by the
// pinned pixel. docs/lessons/README.md describes the checks.
import type {Explanation, ExplainedHit, SceneInfo} from 'glint-wasm';

export interface Situation {
    info: SceneInfo;
    text: string;
    pinned: Explanation | null;
    /** Explains the pixel at these fractions of the picture's size. */
    explain(x: number, y: number): Promise<Explanation | null>;
}

const number = String.raw`(-?[\d.]+)`;
const comparison = String.raw`(<=|>=|<|>|=)\s*${number}`;

function holds(value: number | null | undefined, sign: string, limit: number): boolean {
    if (value === null || value === undefined) return false;
    if (sign === '=') return Math.abs(value - limit) < 1e-6;
    return sign === '<' ? value < limit : sign === '>' ? value > limit : sign === '<=' ? value <= limit : value >= limit;
}

const largest = (color: readonly number[]) => Math.max(...color);
const channels = ['red', 'green', 'blue'];
const layers = ['background', 'ambient', 'diffuse', 'specular', 'reflection', 'transmission', 'emission', 'sky', 'fog'] as const;

/** A quantity of a pixel: a channel's byte, a layer, the material's exponent, the number of rays. */
function ofPixel(explanation: Explanation | null, what: string): number | null {
    if (!explanation) return null;
    const hit = explanation.rays[0]?.hit;
    if (channels.includes(what)) return explanation.bytes[channels.indexOf(what)]!;
    const layer = layers.find((one) => one === what);
    if (layer) return largest(explanation.layers[layer]);
    if (what === 'rays') return explanation.rays.length;
    if (what === 'generations') return Math.max(...explanation.rays.map((ray) => ray.generation));
    if (what === 'lights') return hit?.lights.filter((light) => light.reason === 'adds').length ?? 0;
    if (what === 'blocked') return hit?.lights.filter((light) => light.reason === 'blocked').length ?? 0;
    if (what === 'n_l') return Math.max(...(hit?.lights.map((light) => light.n_l ?? -1) ?? [-1]));
    const material = hit?.material as (ExplainedHit['material'] & Record<string, unknown>) | undefined;
    const value = what.startsWith('material.') ? material?.[what.slice(9)] : undefined;
    return typeof value === 'number' ? value : Array.isArray(value) ? largest(value as number[]) : null;
}

/** A light's field: its color's largest channel, or a part of another field: position.x. */
function ofLight(info: SceneInfo, index: number, what: string): number | null {
    const light = info.lights[index - 1] as unknown as Record<string, unknown> | undefined;
    if (!light) return null;
    if (what === 'intensity') return largest(light['color'] as number[]);
    const [field, part] = what.split('.') as [string, string | undefined];
    const value = light[field];
    return Array.isArray(value) && part ? ((value as number[])[['x', 'y', 'z'].indexOf(part)] ?? (value as number[])[Number(part)] ?? null) : null;
}

type Check = (situation: Situation, parts: string[]) => boolean | Promise<boolean>;
const kinds: [RegExp, Check][] = [
    [/^setting (\w+) = (\S+)$/, ({info}, [key, value]) => info.settings.find((one) => one.name === key)?.value === value],
    [new RegExp(`^setting (\\w+) ${comparison}$`), ({info}, [key, sign, limit]) =>
        holds(Number(info.settings.find((one) => one.name === key)?.value), sign!, Number(limit))],
    [new RegExp(`^lights ${comparison}$`), ({info}, [sign, limit]) => holds(info.lights.length, sign!, Number(limit))],
    [new RegExp(`^light (\\d+) (\\S+) ${comparison}$`), ({info}, [index, what, sign, limit]) =>
        holds(ofLight(info, Number(index), what!), sign!, Number(limit))],
    [new RegExp(`^pixel ${number},${number} (\\S+) ${comparison}$`), async ({explain}, [x, y, what, sign, limit]) =>
        holds(ofPixel(await explain(Number(x), Number(y)), what!), sign!, Number(limit))],
    [new RegExp(`^pinned (\\S+) ${comparison}$`), ({pinned}, [what, sign, limit]) => holds(ofPixel(pinned, what!), sign!, Number(limit))],
];

/** True if a check holds. Throws if it is none. */
export async function holdsCheck(check: string, situation: Situation): Promise<boolean> {
    for (const [pattern, decide] of kinds) {
        const match = pattern.exec(check.trim());
        if (match) return decide(situation, match.slice(1));
    }
    throw new Error(`not a check: ${check}`);
}
