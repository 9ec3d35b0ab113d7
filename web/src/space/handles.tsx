// SPDX-License-Identifier: Apache-2.0
// What can be moved in the view in space: buttons over it, for pointers and keys.
import {useSignal} from '@preact/signals';
import type {Vec3} from 'glint-wasm';
import {useEffect, useRef} from 'preact/hooks';

import {add, scaled, unit} from '../camera';
import {type Drag, type Movable, beginDrag} from '../store/space';
import {info} from '../store/state';
import {length} from '../text/edit';
import {type Frame, seenAt} from './frame';

export interface Handle {
    id: string;
    name: string;
    what: Movable;
    point: Vec3;
    /** A light is shown in its color. */
    color?: string;
}

/** `moved`: at the end of a move. */
export function HandleButton({handle, frame, moved}: {handle: Handle; frame: Frame; moved: (by: Vec3) => void}) {
    /** Where the move began, until the scene has caught up with it. */
    const start = useRef<Vec3 | null>(null);
    const drag = useRef<{move: Drag; from: {x: number; y: number}; width: number; height: number} | null>(null);
    const by = useSignal<Vec3>([0, 0, 0]);
    useEffect(() => {
        if (drag.current) return;
        start.current = null;
        by.value = [0, 0, 0];
    }, [info.value, handle.point]);
    const go = (to: Vec3) => {
        by.value = to;
        drag.current!.move.to(to);
    };
    const end = () => {
        if (!drag.current) return;
        drag.current.move.end();
        drag.current = null;
        moved(by.value);
    };
    useEffect(() => end, []);
    const begin = (event: MouseEvent | KeyboardEvent) => {
        if (drag.current) return true;
        const move = beginDrag(handle.what);
        if (!move) return false;
        const box = (event.currentTarget as Element).parentElement!.getBoundingClientRect();
        const from = event instanceof MouseEvent ? {x: event.clientX, y: event.clientY} : {x: 0, y: 0};
        start.current = handle.point;
        by.value = [0, 0, 0];
        drag.current = {move, from, width: box.width, height: box.height};
        return true;
    };
    const {x, y} = seenAt(frame, add(start.current ?? handle.point, by.value));
    if (!(x > -0.02 && x < 1.02 && y > -0.02 && y < 1.02)) return null;
    return (
        <button
            class={`handle ${handle.what.kind}`} aria-label={`Move ${handle.name}`} title={`${handle.name}: drag it; arrow keys, Page Up and Page Down move it`}
            style={{left: `${100 * x}%`, top: `${100 * y}%`, '--c': handle.color ?? ''}}
            onPointerDown={(event) => {
                event.stopPropagation();
                if (event.button === 0 && begin(event)) event.currentTarget.setPointerCapture(event.pointerId);
            }}
            onPointerMove={(event) => {
                const now = drag.current;
                if (!now || !(event.buttons & 1)) return;
                const {right, up} = frame;
                go(add(scaled(right, (event.clientX - now.from.x) / now.width), up, -(event.clientY - now.from.y) / now.height));
            }}
            onPointerUp={end} onPointerCancel={end} onKeyUp={end} onBlur={end}
            onKeyDown={(event) => {
                const {right, up, forward} = frame;
                const size = (event.shiftKey ? 0.1 : 0.02) * Math.min(length(right), length(up));
                const ways: Record<string, Vec3> = {
                    ArrowLeft: scaled(unit(right), -size), ArrowRight: scaled(unit(right), size), ArrowUp: scaled(unit(up), size),
                    ArrowDown: scaled(unit(up), -size), PageUp: scaled(forward, size), PageDown: scaled(forward, -size),
                };
                const way = ways[event.key];
                if (!way) return;
                event.preventDefault();
                event.stopPropagation();
                if (begin(event)) go(add(by.value, way));
            }}
        />
    );
}
