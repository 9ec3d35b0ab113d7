// SPDX-License-Identifier: Apache-2.0
// Texts for the log of another ray tracer: those of `glint diagnose`.
import type {DiagnosedRow, DiagnosedValue, Diagnosis, DiagnosisFinding} from 'glint-wasm';

import {info} from '../store/state';
import {itemName} from './words';

export const counted = (count: number, what: string) => `${count.toLocaleString('en')} ${what}${count === 1 ? '' : 's'}`;

function numberText(value: number | null, digits: number): string {
    if (value === null) return 'no number';
    if (value === 0) return '0';
    return Math.abs(value) >= 1e7 || Math.abs(value) < 1e-4 ? value.toExponential(digits - 1).replace(/\.?0+e/, 'e') : String(Number(value.toPrecision(digits)));
}

const children = ['none', 'a mirror ray', 'a glass ray', 'a mirror and a glass ray'];

function valueText(quantity: string, value: DiagnosedValue, digits: number): string {
    if (value === null) return '–';
    if (typeof value !== 'number') return `(${value.map((one) => numberText(one, digits)).join(', ')})`;
    if (quantity === 'shape') return value < 1 ? 'a miss' : `shape ${value}`;
    if (quantity === 'children') return children[value] ?? String(value);
    return numberText(value, digits);
}

/** Vectors of which only the direction is compared. */
const directions = ['direction', 'N', 'V', 'L', 'R', 'H'];

function inLengthOf(value: DiagnosedValue, model: DiagnosedValue): DiagnosedValue {
    if (!Array.isArray(value) || !Array.isArray(model)) return value;
    const factor = Math.hypot(...model.map(Number)) / Math.hypot(...value.map(Number));
    return Number.isFinite(factor) ? value.map((c) => Number(c) * factor) as [number, number, number] : value;
}

/** Both values of a row, with as many digits as show their difference. */
export function valuesOf({quantity, verdict, yours, expected: exact}: DiagnosedRow): {yours: string; expected: string} {
    const expected = verdict === 'right' && directions.includes(quantity) ? inLengthOf(exact, yours) : exact;
    for (let digits = 4;; ++digits) {
        const texts = {yours: valueText(quantity, yours, digits), expected: valueText(quantity, expected, digits)};
        if (digits === 12 || verdict !== 'wrong' || texts.yours !== texts.expected) return texts;
    }
}

/** “lamp”, or "point light, line 12". */
export function loggedLight({index, name}: NonNullable<DiagnosedRow['light']>): string {
    const light = info.value?.lights[index];
    if (name || !light) return name ? `“${name}”` : `light ${index + 1}`;
    return itemName({...light.place, kind: `${light.kind} light`});
}

export const rayName = ({kind, generation}: NonNullable<DiagnosedRow['ray']>) =>
    `${kind.charAt(0).toUpperCase()}${kind.slice(1)} ray${generation > 1 ? ` (generation ${generation})` : ''}`;

/** "pixel (3, 4), mirror ray, point light, line 12; line 7 of the log" */
export function placeText({pixel, ray, light, line}: DiagnosedRow): string {
    const places = [`pixel (${pixel.join(', ')})`, ...(ray && ray.generation > 0 ? [rayName(ray).toLowerCase()] : []), ...(light ? [loggedLight(light)] : [])];
    return `${places.join(', ')}${line > 0 ? `; line ${line} of the log` : ''}`;
}

export function findingTitle({word, quantity, pixels, first_pixels: first, only}: DiagnosisFinding, all: number): string {
    const begin = /^(the|whether) /.test(word) ? word.charAt(0).toUpperCase() + word.slice(1) : word;
    return `${begin}${quantity === 'children' ? ' (its number)' : ''} ${quantity === 'bytes' ? 'are' : 'is'} wrong in ${pixels.toLocaleString('en')} of ${counted(all, 'pixel')}${
        first > 0 ? `, in ${first.toLocaleString('en')} as the first difference` : ''}${only === '' ? '' : `; only ${only}`}.`;
}

/** What was compared, and whether anything differs. */
export function summary({judged, unknown, outside, pixels, rays, findings}: Diagnosis): string[] {
    const sentences = [`${counted(judged, 'value')} of ${counted(rays, 'ray')} in ${counted(pixels, 'pixel')} were compared${unknown > 0 ? `; ${unknown.toLocaleString('en')} could not be judged` : ''}.`];
    if (outside > 0) sentences.push(outside === 1 ? 'One pixel of the log is not in the picture.' : `${outside.toLocaleString('en')} pixels of the log are not in the picture.`);
    const differing = new Set(findings.map(({word}) => word)).size;
    if (differing > 0) sentences.push(differing === 1 ? 'One quantity differs.' : `${differing} quantities differ.`);
    else if (judged === 0) sentences.push('Nothing could be compared: the log has too little, or it is not of this scene.');
    else if (unknown > judged / 4) sentences.push('None of the values that could be compared differs: each follows from the scene, up to rounding.');
    else sentences.push('Nothing differs: each value follows from the scene, up to rounding.');
    return sentences;
}

/** "LIGHT-5, docs/lighting.md#the-exponent": words, and a place in the help. */
export function referenceOf(where: string): {words: string; topic: string | null; heading: string} {
    const found = /docs\/(\w+)\.md(?:#([\w-]+))?/.exec(where);
    return {words: where.replace(/,?\s*docs\/\S+/, ''), topic: found?.[1] ?? null, heading: found?.[2] ?? ''};
}
