// SPDX-License-Identifier: Apache-2.0
// Texts for explanations.
import type {ExplainedHit, ExplainedRay, Explanation, LightTerms, NamedItem, Vec3} from 'glint-wasm';

import {fileName} from '../store/state';

export const hex = (bytes: Vec3) => `rgb(${bytes.join(' ')})`;

/** "sphere “lamp”", "sphere, line 8" or, in a text that the scene includes, "sphere, line 8 of parts/column.glint". */
export function itemName(item: NamedItem & {kind?: string}): string {
    const kind = (item.kind ?? '').replace('_', ' ');
    const name = item.name ? `${kind} “${item.name}”`.trim() : kind;
    const {line, file} = item;
    if (line === undefined) return name;
    return `${name}, line ${line}${file === undefined || file === fileName.value ? '' : ` of ${file}`}`;
}

/** “lamp”, or "point light, line 12". */
export function lightName(light: LightTerms['light']): string {
    return light.name ? `“${light.name}”` : itemName({...light, kind: `${light.kind} light`});
}

/** What the first of a pixel's samples that hits something has hit. */
export const firstHit = ({rays}: Explanation): ExplainedHit | undefined => rays.find(({parent, hit}) => parent === null && hit)?.hit;

/** The indices of the terms, those of one area light's samples together. */
export function byLight(lights: readonly LightTerms[]): number[][] {
    const groups: number[][] = [];
    for (const [i, terms] of lights.entries()) {
        const last = groups.at(-1);
        if (last && terms.sample !== undefined && lights[last[0]!]!.light.index === terms.light.index) last.push(i);
        else groups.push([i]);
    }
    return groups;
}

/** A number with four digits. */
export function short(value: number | null | undefined): string {
    if (value === null || value === undefined) return '–';
    if (Math.abs(value) < 1e-12) return '0';  // rounding, and powers that have vanished
    // With a hyphen-minus, so that a copied number is one in a scene's text.
    const text = Math.abs(value) >= 1e5 || Math.abs(value) < 1e-4 ? value.toExponential(1) : String(Number(value.toPrecision(4)));
    return text;
}

/** A vector, or one number for a grey. */
export function shortColor(color: Vec3): string {
    return color[0] === color[1] && color[1] === color[2] ? short(color[0]) : `(${color.map(short).join(', ')})`;
}
export const shortVector = (v: Vec3) => `(${v.map(short).join(', ')})`;

export const isBlack = (color: Vec3) => color.every((c) => c === 0);

/** A linear color as CSS. */
export const css = (color: Vec3) => hex(color.map((c) => Math.round(255 * Math.max(0, Math.min(1, c)))) as Vec3);

export const reasons: Record<LightTerms['reason'], string> = {
    adds: 'adds light',
    blocked: 'is blocked',
    behind: 'is behind the surface (N·L ≤ 0)',
    no_color: 'adds nothing: its color times the surface’s is black',
    faded: 'is too far: its attenuation is 0',
    in_surface: 'is at the hit point itself',
    faint: 'is too faint here: the convention light_threshold leaves it out',
    outside_cone: 'is aimed elsewhere: the point is outside its cone',
    back_of_light: 'gives light on one side only, and the point is on the other',
};

export const highlights: Record<LightTerms['highlight'], string> = {
    adds: '',
    none: 'the surface has no highlight',
    unshaded: 'this shading has no highlights',
    behind: 'no highlight: N·L ≤ 0',
    turned_away: 'no highlight: the reflected light points away from the eye (S ≤ 0)',
};

export const rayNames: Record<ExplainedRay['kind'], string> = {camera: 'Camera ray', mirror: 'Mirror ray', transmitted: 'Ray through glass'};

/** The layers of a pixel, in the order in which they are added. */
export const layerNames = ['background', 'ambient', 'diffuse', 'specular', 'reflection', 'transmission', 'emission', 'sky', 'fog'] as const;
