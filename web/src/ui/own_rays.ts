// SPDX-License-Identifier: Apache-2.0
// The rays of the user's own ray tracer that go elsewhere than they should, as lines beside those of the explained pixel.
import type {DiagnosedRow, Vec3} from 'glint-wasm';

import {add} from '../camera';
import {chosenPixel, mirrored} from '../store/own_log';
import {pinned} from '../store/state';
import type {Segment} from './RayLines';

const isVector = (value: DiagnosedRow['yours'] | undefined): value is Vec3 => Array.isArray(value) && value.every((c) => c !== null);

/** The quantities that say where a ray is. */
const placing = ['origin', 'direction', 'shape', 't', 'P'];

/** Of the pixel that is explained; `reach`: the length of a ray that hits nothing. */
export function ownRays(reach: number): Segment[] {
    const pixel = chosenPixel.value;
    if (!pixel || mirrored(pixel.at).join() !== pinned.value?.pixel.join()) return [];
    const rays = new Map<number, Map<string, DiagnosedRow>>();
    for (const row of pixel.rows) {
        if (!row.ray || row.light || !placing.includes(row.quantity)) continue;
        const one = rays.get(row.ray.number) ?? new Map<string, DiagnosedRow>();
        rays.set(row.ray.number, one.set(row.quantity, row));
    }
    return [...rays.values()].flatMap((rows): Segment[] => {
        const origin = rows.get('origin')?.yours, direction = rows.get('direction')?.yours, point = rows.get('P')?.yours;
        if (!isVector(origin) || ![...rows.values()].some(({verdict}) => verdict === 'wrong')) return [];
        const to = isVector(point) ? point : isVector(direction) ? add(origin, direction, reach / (Math.hypot(...direction) || 1)) : null;
        return to ? [{ray: -1, from: origin, to, kind: 'yours'}] : [];
    });
}
