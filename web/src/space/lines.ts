// SPDX-License-Identifier: Apache-2.0
// The lines of the view in space, in its fractions: visible parts, and parts behind a surface.
import type {CameraInfo, Vec3} from 'glint-wasm';

import {add, scaled} from '../camera';
import {length} from '../text/edit';
import {type Frame, seenAt} from './frame';
import type {Depths} from './picture';

export interface Part {
    x1: number;
    y1: number;
    x2: number;
    y2: number;
    hidden: boolean;
    /** Where on the line it begins and ends: 0 to 1. */
    from: number;
    to: number;
}

/** A line from a to b, divided where it goes behind a surface. `slack`: what may be in front of it. */
export function partsOf(frame: Frame, depths: Depths | null, a: Vec3, b: Vec3, slack: number): Part[] {
    const from = seenAt(frame, a), to = seenAt(frame, b);
    const at = (s: number) => ({x: from.x + s * (to.x - from.x), y: from.y + s * (to.y - from.y), depth: from.depth + s * (to.depth - from.depth)});
    const isHidden = (s: number) => {
        const {x, y, depth} = at(s);
        if (depth < 0) return false;  // in what is cut away
        const i = Math.floor(x * depths!.width), j = Math.floor(y * depths!.height);
        return i >= 0 && j >= 0 && i < depths!.width && j < depths!.height && depth > depths!.values[j * depths!.width + i]! + slack;
    };
    const part = (s: number, t: number, hidden: boolean): Part => {
        const p = at(s), q = at(t);
        return {x1: p.x, y1: p.y, x2: q.x, y2: q.y, hidden, from: s, to: t};
    };
    if (!depths || depths.frame !== frame) return [part(0, 1, false)];
    const count = Math.max(1, Math.min(300, Math.ceil(Math.hypot((to.x - from.x) * depths.width, (to.y - from.y) * depths.height) / 3)));
    const parts: Part[] = [];
    let start = 0, hidden = isHidden(0.5 / count);
    for (let i = 1; i < count; ++i) {
        if (isHidden((i + 0.5) / count) === hidden) continue;
        parts.push(part(start, i / count, hidden));
        start = i / count;
        hidden = !hidden;
    }
    parts.push(part(start, 1, hidden));
    return parts;
}

/** The corners of the camera's picture at a distance: top left, top right, bottom right, bottom left; and its edges' start. */
export function frustum({projection, position, view: {right, up, forward}}: CameraInfo, distance: number): {from: Vec3[]; corners: Vec3[]} {
    const s = distance / length(forward);
    const spread = projection === 'perspective' ? s : 1;
    const corner = (from: Vec3, by: number, [u, v]: number[]) => add(add(from, right, by * u!), up, by * v!);
    const units = [[-0.5, 0.5], [0.5, 0.5], [0.5, -0.5], [-0.5, -0.5]];
    return {
        from: units.map((unit) => (projection === 'perspective' ? position : corner(position, 1, unit))),
        corners: units.map((unit) => corner(add(position, scaled(forward, s)), spread, unit)),
    };
}
