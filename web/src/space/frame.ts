// SPDX-License-Identifier: Apache-2.0
// The view in space: an orthographic camera outside the scene, which turns about the points of interest.
import type {CameraInfo, Vec3, View} from 'glint-wasm';

import {add, cross, dot, inFrame, isLeftHanded, nearestAxis, scaled, sub, turned, unit} from '../camera';
import {length} from '../text/edit';

/** How the view is turned; pan and zoom relative to the ball around its points. */
export interface Turn {
    /** About the vertical axis, and from above towards the horizon; radians. */
    yaw: number;
    tilt: number;
    zoom: number;
    pan: [number, number];
    /** 0: everything in front of the points is cut away; 1: everything in front of their middle; -1: little. */
    cut: number;
}
export const startTurn: Turn = {yaw: 0.5, tilt: 0.95, zoom: 1, pan: [0, 0], cut: 0};

/** What the view shows: a ball, and the axes of the scene's camera there. */
export interface Region {
    points: Vec3[];
    center: Vec3;
    radius: number;
    upright: Vec3;
    /** Horizontal, from the scene towards its camera. */
    behind: Vec3;
    leftHanded: boolean;
}

/** The ball around some points, which the camera's direction turns upright and forward. */
export function regionOf(points: Vec3[], camera: CameraInfo): Region {
    const low = points.reduce((a, p) => a.map((c, i) => Math.min(c, p[i]!)) as Vec3);
    const high = points.reduce((a, p) => a.map((c, i) => Math.max(c, p[i]!)) as Vec3);
    const center = scaled(add(low, high), 0.5);
    const upright = nearestAxis(camera.up ?? camera.view.up);
    const along = add(camera.view.forward, upright, -dot(camera.view.forward, upright));
    const ahead = length(along) > 1e-6 * length(camera.view.forward)
        ? unit(along) : unit(cross(upright, Math.abs(upright[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]));
    return {
        points, center, upright, behind: scaled(ahead, -1), leftHanded: isLeftHanded(camera),
        radius: Math.max(1e-6, ...points.map((p) => length(sub(p, center)))),
    };
}

/** The frame of a view; right and up have its width and height in world units. */
export interface Frame extends View {
    position: Vec3;
}

/** aspect: width over height. With yaw 0 the camera's direction points up, and its right is at the right. */
export function frameOf({points, center, radius, upright, behind, leftHanded}: Region, turn: Turn, aspect: number): Frame {
    const back = turned(behind, upright, leftHanded ? -turn.yaw : turn.yaw);
    const level = cross(upright, back);
    const towards = turned(upright, level, turn.tilt);  // from the centre to the viewer
    const reach = Math.max(...points.map((p) => dot(sub(p, center), towards)));
    const before = reach + 0.35 * radius;
    const distance = turn.cut > 0 ? before * (1 - turn.cut) : before - 3 * turn.cut * radius;
    const width = (2.5 * radius * Math.max(1, aspect)) / turn.zoom;
    const right = scaled(level, leftHanded ? -width : width), up = scaled(unit(cross(towards, level)), width / aspect);
    return {
        position: add(add(add(center, towards, distance), right, -turn.pan[0]), up, -turn.pan[1]),
        right, up, forward: scaled(towards, -1),
    };
}

/** A point in the view: x and y from 0 to 1 in its width and height, from the top left; depth in world units. */
export function seenAt(frame: Frame, point: Vec3): {x: number; y: number; depth: number} {
    const {u, v, depth} = inFrame({projection: 'orthographic', position: frame.position, place: null, has_frame: true, view: frame}, point);
    return {x: 0.5 + u, y: 0.5 - v, depth};
}
