// SPDX-License-Identifier: Apache-2.0
// Mouse, touch and keys on the picture: point at a pixel, pin it, move the camera.
import type {CameraInfo} from 'glint-wasm';
import {useEffect, useRef} from 'preact/hooks';

import {type Move, dot, moved, sub} from '../camera';
import {allows, embedded} from '../store/embedded';
import {markedPixel} from '../store/own_log';
import {hover, pin} from '../store/pixels';
import {hovered, info, pinned, pixel, services, size} from '../store/state';
import {cameraNow, moveCamera} from '../store/viewpoint';
import {length} from '../text/edit';

type Frame = {current: HTMLDivElement | null};
type Point = {x: number; y: number};

/** A distance for a camera without a target. */
export function sceneDistance(): number {
    const bounds = info.value?.bounds;
    return bounds ? Math.min(10, length(sub(bounds.max, bounds.min))) : 5;
}

/** The distance of the camera's target. */
export function lookDistance(): number {
    const hit = hovered.value?.rays[0]?.hit ?? pinned.value?.rays[0]?.hit;
    const camera = info.value?.camera;
    return hit && camera ? length(sub(hit.point, camera.position)) : sceneDistance();
}

/** Moves the camera nearer or farther, but never through the object that is seen. */
export function zoom(factor: number) {
    const camera = cameraNow();
    if (!camera) return;
    const next = moved(camera, {kind: 'zoom', factor}, lookDistance());
    const seen = (hovered.value ?? pinned.value)?.rays[0]?.hit?.point;
    const way = sub(next.position, camera.position);
    // The part of the way to the object that the step takes.
    const share = seen && factor < 1 ? dot(way, way) / Math.max(1e-12, dot(way, sub(seen, camera.position))) : 0;
    const allowed = share > 0.5 ? 1 - ((1 - factor) * 0.5) / share : factor;
    moveCamera(camera, lookDistance(), {kind: 'zoom', factor: allowed});
}

/** The gesture in progress: its start, and the camera then. */
interface Gesture {
    kind: 'orbit' | 'pan' | 'pinch';
    from: Point;
    /** The distance between two fingers. */
    span: number;
    camera: CameraInfo;
    distance: number;
    moved: boolean;
}

export function usePointers(frame: Frame) {
    const gesture = useRef<Gesture | null>(null);
    const down = useRef(new Map<number, Point>());
    const at = (event: PointerEvent): [number, number] | null => {
        const box = frame.current!.getBoundingClientRect();
        const x = Math.floor(((event.clientX - box.left) / box.width) * size.value.width);
        const y = Math.floor(((event.clientY - box.top) / box.height) * size.value.height);
        return x >= 0 && y >= 0 && x < size.value.width && y < size.value.height ? [x, y] : null;
    };
    /** The middle of all fingers, and the distance of the first two. */
    const hands = () => {
        const points = [...down.current.values()];
        const middle = points.reduce((sum, p) => ({x: sum.x + p.x / points.length, y: sum.y + p.y / points.length}), {x: 0, y: 0});
        const [a, b] = points;
        return {middle, span: a && b ? Math.max(1, Math.hypot(a.x - b.x, a.y - b.y)) : 0};
    };
    const begin = (kind: Gesture['kind']) => {
        const {middle, span} = hands();
        gesture.current = {kind, from: middle, span, camera: cameraNow()!, distance: lookDistance(), moved: false};
    };
    const end = (event: PointerEvent) => {
        down.current.delete(event.pointerId);
        gesture.current = null;  // the remaining finger must not move anything
    };
    return {
        onPointerDown(event: PointerEvent) {
            if (!info.value || event.button > 2 || !(allows('camera') || allows('inspect')) || (event.target as Element).closest('.border')) return;
            frame.current!.setPointerCapture(event.pointerId);
            down.current.set(event.pointerId, {x: event.clientX, y: event.clientY});
            begin(down.current.size > 1 ? 'pinch' : event.shiftKey || event.button !== 0 ? 'pan' : 'orbit');
        },
        onPointerMove(event: PointerEvent) {
            if (!down.current.has(event.pointerId)) {
                void hover(at(event));
                return;
            }
            down.current.set(event.pointerId, {x: event.clientX, y: event.clientY});
            const now = gesture.current;
            if (!now) return;
            const {middle, span} = hands();
            const x = middle.x - now.from.x, y = middle.y - now.from.y;
            if (!now.moved && Math.hypot(x, y, span - now.span) < 4) return;
            if (!allows('camera')) return;
            const continues = now.moved;
            now.moved = true;
            const box = frame.current!.getBoundingClientRect();
            const by = {x: x / box.width, y: y / box.height};
            const moves: Move[] = now.kind === 'pinch' ? [{kind: 'zoom', factor: now.span / span}, {kind: 'pan', ...by}] : [{kind: now.kind, ...by}];
            services.editor?.edit(continues, () => moveCamera(now.camera, now.distance, ...moves));
        },
        onPointerUp(event: PointerEvent) {
            const now = gesture.current;
            end(event);
            if (now && now.kind !== 'pinch' && !now.moved && event.button === 0 && allows('inspect')) void pin(markedPixel(at(event)));
        },
        onPointerCancel: end,
        onPointerLeave() {
            if (down.current.size === 0) void hover(null);
        },
        onContextMenu: (event: Event) => event.preventDefault(),
    };
}

export function useWheel(frame: Frame) {
    useEffect(() => {
        const element = frame.current!;
        const turned = (event: WheelEvent) => {
            // In a frame, the wheel alone scrolls the page around.
            if (!cameraNow() || (embedded && !(event.ctrlKey && allows('camera')))) return;
            event.preventDefault();
            const lines = event.deltaY / (event.deltaMode === 0 ? 100 : 3);
            zoom(1.1 ** Math.max(-5, Math.min(5, lines)));
        };
        element.addEventListener('wheel', turned, {passive: false});
        return () => element.removeEventListener('wheel', turned);
    }, []);
}

/** Arrow keys point at a pixel, Enter pins it. */
export function keyPressed(event: KeyboardEvent) {
    const steps: Record<string, [number, number]> = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
    const step = steps[event.key];
    const {width, height} = size.value;
    const now = pixel.value ?? [Math.floor(width / 2), Math.floor(height / 2)];
    if (step) {
        event.preventDefault();
        const by = event.shiftKey ? 20 : 1;
        const inside = (value: number, most: number) => Math.max(0, Math.min(most - 1, value));
        void hover([inside(now[0] + by * step[0], width), inside(now[1] + by * step[1], height)]);
    } else if (event.key === 'Enter' && allows('inspect')) {
        event.preventDefault();
        void pin([now[0], now[1]]);
    }
}
