// SPDX-License-Identifier: Apache-2.0
// The camera in the page: projects world points into the picture, and applies mouse movements.
import type {CameraInfo, Vec3} from 'glint-wasm';

import {length} from './text/edit';

export const add = (a: Vec3, b: Vec3, s = 1): Vec3 => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
export const sub = (a: Vec3, b: Vec3): Vec3 => add(a, b, -1);
export const scaled = (a: Vec3, s: number): Vec3 => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a: Vec3, b: Vec3) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [
    a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const unit = (a: Vec3): Vec3 => scaled(a, 1 / (length(a) || 1));

/** `v` rotated about a unit axis, by the right-hand rule. */
export function turned(v: Vec3, axis: Vec3, angle: number): Vec3 {
    const c = Math.cos(angle), s = Math.sin(angle);
    return add(add(scaled(v, c), cross(axis, v), s), axis, dot(axis, v) * (1 - c));
}

export const isLeftHanded = ({view: {right, up, forward}}: CameraInfo) => dot(cross(right, up), forward) > 0;

/** A point in camera coordinates: v = depth (forward + u right + v up) for perspective, else forward depth + u right + v up. */
export function inFrame(camera: CameraInfo, point: Vec3): {u: number; v: number; depth: number} {
    const {right, up, forward} = camera.view;
    const d = sub(point, camera.position);
    const volume = dot(cross(right, up), forward);
    const u = dot(cross(d, up), forward) / volume, v = dot(cross(right, d), forward) / volume,
          depth = dot(cross(right, up), d) / volume;
    return {u, v, depth};
}

/** The projection of a line from a to b, clipped at the camera; null if all of it is behind the camera. */
export function projectLine(camera: CameraInfo, width: number, height: number, a: Vec3, b: Vec3):
    [number, number, number, number] | null {
    const near = camera.projection === 'perspective' ? 1e-3 : -Infinity;
    let from = inFrame(camera, a), to = inFrame(camera, b);
    if (from.depth < near && to.depth < near) return null;
    const cut = (x: typeof from, y: typeof from) => {
        const s = (near - x.depth) / (y.depth - x.depth);
        return {u: x.u + s * (y.u - x.u), v: x.v + s * (y.v - x.v), depth: near};
    };
    if (from.depth < near) from = cut(from, to);
    if (to.depth < near) to = cut(to, from);
    const pixel = ({u, v, depth}: typeof from) => {
        const s = camera.projection === 'perspective' ? 1 / depth : 1;
        return [(0.5 + u * s) * width, (0.5 - v * s) * height] as const;
    };
    return [...pixel(from), ...pixel(to)];
}

export type Move = {kind: 'orbit' | 'pan'; x: number; y: number} | {kind: 'zoom'; factor: number};

/** The point that the camera orbits, at a constant distance. */
function pivotOf(camera: CameraInfo, distance: number): Vec3 {
    return camera.look_at ?? add(camera.position, unit(camera.view.forward), distance);
}

/**
 * The camera after a move. x and y are fractions of the picture's width and height: the mouse movement, right and down;
 * `distance` is the distance of the target, for a camera without one.
 */
export function moved(camera: CameraInfo, move: Move, distance: number): CameraInfo {
    const pivot = pivotOf(camera, distance);
    const {right, up, forward} = camera.view;
    const next: CameraInfo = structuredClone(camera);
    if (move.kind === 'zoom') {
        if (camera.projection === 'orthographic' && camera.width !== undefined) {
            next.width = camera.width * move.factor;
            next.view = {right: scaled(right, move.factor), up: scaled(up, move.factor), forward};
        } else {
            next.position = add(pivot, sub(camera.position, pivot), move.factor);
        }
        return next;
    }
    if (move.kind === 'pan') {
        const reach = camera.projection === 'perspective' ? length(sub(pivot, camera.position)) / length(forward) : 1;
        const shift = add(scaled(right, -move.x * reach), up, move.y * reach);
        next.position = add(camera.position, shift);
        if (camera.look_at) next.look_at = add(camera.look_at, shift);
        return next;
    }
    // A turntable: rotates about the scene's vertical axis, then about the camera's horizontal one, not beyond the poles.
    const upright = camera.up ? unit(camera.up) : nearestAxis(up);
    const leftHanded = isLeftHanded(camera);
    const yaw = (leftHanded ? 1 : -1) * move.x * Math.PI;
    const level = unit(right);
    const elevation = Math.asin(Math.max(-1, Math.min(1, dot(unit(forward), upright))));
    const limit = 1.5;
    const wanted = Math.max(-limit, Math.min(limit, elevation - move.y * Math.PI * 0.6));
    const pitch = (leftHanded ? -1 : 1) * (wanted - elevation);
    const turn = (v: Vec3) => turned(turned(v, level, pitch), upright, yaw);
    next.position = add(pivot, turn(sub(camera.position, pivot)));
    next.view = {right: turn(right), up: turn(up), forward: turn(forward)};
    return next;
}

export function nearestAxis(v: Vec3): Vec3 {
    const largest = Math.max(...v.map(Math.abs));
    const axis = v.map((c) => (Math.abs(c) === largest ? Math.sign(c) : 0)) as Vec3;
    return unit(axis);
}
