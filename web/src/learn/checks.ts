// SPDX-License-Identifier: Apache-2.0
// Decides whether a lesson's step is done, and says what is missing: by the scene as glint reads it, by its pixels as glint
// explains them, and by the pinned pixel. docs/lessons/README.md describes the checks.
import type {Explanation, SceneInfo} from 'glint-wasm';

export interface Situation {
    info: SceneInfo;
    pinned: Explanation | null;
    /** Of the log that is open: pixels with a difference, and the first wrong quantity of the chosen pixel, or "none"; null: it is not known. */
    log: {wrong: number | null; chosen: string | null};
    /** Explains the pixel at these fractions of the picture's size. */
    explain(x: number, y: number): Promise<Explanation | null>;
}

/** missing: what is missing, for the reader; empty if the check holds. */
export interface Verdict {holds: boolean; missing: string}

type Value = number | string | null;
/** A quantity, and what it is called in a sentence. */
interface Found {value: Value; name: string}

const number = String.raw`-?[\d.]+`;
const signs: Record<string, string> = {'=': '', '<': 'less than ', '>': 'more than ', '<=': 'at most ', '>=': 'at least '};

function holds(value: Value, sign: string, limit: Value): boolean {
    if (value === null || limit === null) return false;
    if (typeof value === 'string' || typeof limit === 'string') return sign === '=' && String(value) === String(limit);
    if (sign === '=') return Math.abs(value - limit) <= 1e-6 * Math.abs(limit);
    return sign === '<' ? value < limit : sign === '>' ? value > limit : sign === '<=' ? value <= limit : value >= limit;
}

const largest = (color: readonly number[]) => Math.max(...color);
const channels = ['red', 'green', 'blue'];
const layers = ['background', 'ambient', 'diffuse', 'specular', 'reflection', 'transmission', 'emission', 'sky', 'fog'] as const;

/** The names of quantities of a pixel that are not their own. */
const pixelNames: Record<string, string> = {
    ambient: 'the ambient light', diffuse: 'the diffuse light', specular: 'the highlight', reflection: 'the mirror’s part', transmission: 'the glass’s part',
    n_l: 'N·L', rays: 'the number of rays', generations: 'the number of mirrors and glass surfaces on the way', lights: 'the number of lights that add something',
    blocked: 'the number of blocked lights', 'material.shininess': 'the exponent', 'material.ior': 'the index of refraction',
    'texture.u': 'u', 'texture.next_column_weight': 'w',
};

/** A quantity of a pixel: a channel's byte, a layer, a number of the material, the number of rays. */
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
    if (what === 'n_l') return hit && hit.lights.length > 0 ? Math.max(...hit.lights.map((light) => light.n_l ?? -1)) : null;
    const [owner, field, part] = what.split('.') as [string, string?, string?];
    const owned = hit?.[owner as 'material' | 'texture'] as Record<string, unknown> | undefined;
    const value = field !== undefined ? owned?.[field] : undefined;
    if (Array.isArray(value)) return part === undefined ? largest(value as number[]) : ((value as number[])[Number(part)] ?? null);
    return typeof value === 'number' ? value : null;
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

function lightName(info: SceneInfo, index: number): string {
    const light = info.lights[index - 1];
    if (!light) return `light ${index}`;
    return light.name ? `“${light.name}”` : `the ${light.kind} light`;
}

/** The quantity that the words before the sign name. Null: they name none. */
async function find(words: string[], {info, pinned, log, explain}: Situation): Promise<Found[] | null> {
    const [what, ...rest] = words;
    const last = rest.at(-1);
    if (what === 'setting' && last !== undefined) {
        const value = info.settings.find((one) => one.name === last)?.value ?? null;
        const isNumber = value !== null && value.trim() !== '' && Number.isFinite(Number(value));
        return [{value: isNumber ? Number(value) : value, name: last}];
    }
    if (what === 'log' && last === 'wrong') return [{value: log.wrong, name: 'the number of pixels of the log that differ'}];
    if (what === 'log' && last === 'chosen') return [{value: log.chosen, name: 'the first wrong quantity of the chosen pixel'}];
    if (what === 'lights' && last === undefined) return [{value: info.lights.length, name: 'the number of lights'}];
    if (what === 'light' && rest.length === 2) {
        const index = Number(rest[0]);
        return [{value: ofLight(info, index, last!), name: `${last!.split('.')[0]} of ${lightName(info, index)}`}];
    }
    if (what === 'pinned' && last !== undefined) return [{value: ofPixel(pinned, last), name: `${pixelNames[last] ?? last} at the clicked pixel`}];
    if (what === 'pixel' && last !== undefined) {
        const found: Found[] = [];
        for (const place of rest.slice(0, -1)) {
            const [x, y] = place.split(',').map(Number) as [number, number];
            found.push({value: ofPixel(await explain(x, y), last), name: pixelNames[last] ?? last});
        }
        return found.length > 0 ? found : null;
    }
    return null;
}

const shown = (value: Value) => (typeof value === 'number' ? String(Number(value.toPrecision(3))) : String(value));

/** The limit: a value, or a multiple of another quantity of a pixel: 0.5 specular@0.5,0.5. */
async function limitOf(words: string[], left: string[], situation: Situation): Promise<Found | null> {
    const [first, other, ...more] = words;
    if (first === undefined || more.length > 0) return null;
    const isNumber = new RegExp(`^${number}$`).test(first);
    if (other === undefined) return {value: isNumber ? Number(first) : first, name: ''};
    if (!isNumber) return null;
    const [what, place] = other.split('@') as [string, string?];
    const at = place !== undefined ? ['pixel', place, what] : [...left.slice(0, -1), what];
    const found = (await find(at, situation))?.[0];
    if (!found) return null;
    return {value: typeof found.value === 'number' ? Number(first) * found.value : null, name: `${first} times ${pixelNames[what] ?? what}`};
}

/**
 * Examines a check, `QUANTITY SIGN LIMIT`, and after a `|` the sentence that says what is missing; {value} in it is the quantity.
 * Of several pixels, one has to hold. Throws if it is none.
 */
export async function examine(check: string, situation: Situation): Promise<Verdict> {
    const [condition = '', message] = check.split(/\s\|\s/);
    const match = /^(.+?)\s*(<=|>=|<|>|=)\s*(.+)$/.exec(condition.trim());
    const words = match ? match[1]!.split(/\s+/) : [];
    const found = match ? await find(words, situation) : null;
    const limit = match ? await limitOf(match[3]!.trim().split(/\s+/), words, situation) : null;
    if (!match || !found || !limit) throw new Error(`not a check: ${check}`);
    const sign = match[2]!;
    if (found.some(({value}) => holds(value, sign, limit.value))) return {holds: true, missing: ''};
    if (words[0] === 'pinned' && !situation.pinned) return {holds: false, missing: 'Click a pixel of the picture.'};
    const {value, name} = found[0]!;
    // Of nothing, a sentence with a value would be false.
    if (value === null && (message === undefined || message.includes('{value}'))) return {holds: false, missing: `There is no ${name.replace(/^the /, '')} here: no surface is seen, or it has none.`};
    if (message !== undefined) return {holds: false, missing: message.replace('{value}', shown(value))};
    const wanted = `${signs[sign]}${shown(limit.value)}${limit.name && `, ${limit.name}`}`;
    return {holds: false, missing: `${name[0]!.toUpperCase()}${name.slice(1)} is ${shown(value)}; it has to be ${wanted}.`};
}
