// SPDX-License-Identifier: Apache-2.0
// Mouse, touch, wheel and keys turn, shift and zoom the view in space. One finger scrolls the page; two turn and zoom the view.
import {useEffect, useRef} from 'preact/hooks';

import {turn} from '../store/space';
import {startTurn} from './frame';

const inside = (value: number, low: number, high: number) => Math.max(low, Math.min(high, value));

export function turnBy(yaw: number, tilt: number) {
    turn.value = {...turn.value, yaw: turn.value.yaw + yaw, tilt: inside(turn.value.tilt + tilt, 0, 2)};
}
export function zoomBy(factor: number) {
    turn.value = {...turn.value, zoom: inside(turn.value.zoom * factor, 0.1, 50)};
}
function panBy(x: number, y: number) {
    const [right, up] = turn.value.pan;
    turn.value = {...turn.value, pan: [inside(right + x, -3, 3), inside(up + y, -3, 3)]};
}
export function resetTurn() {
    turn.value = startTurn;
}

/** `clicked`: at fractions of the view's size. */
export function useGestures(body: {current: HTMLDivElement | null}, clicked: (x: number, y: number) => void) {
    const down = useRef(new Map<number, {x: number; y: number}>());
    const path = useRef(0);
    useEffect(() => {
        const element = body.current!;
        const wheel = (event: WheelEvent) => {
            event.preventDefault();
            zoomBy(1.1 ** -inside(event.deltaY / (event.deltaMode === 0 ? 100 : 3), -5, 5));
        };
        // Two fingers are no scrolling, which `touch-action: pan-y` allows.
        const touched = (event: TouchEvent) => {
            if (event.touches.length > 1) event.preventDefault();
        };
        element.addEventListener('wheel', wheel, {passive: false});
        element.addEventListener('touchmove', touched, {passive: false});
        return () => {
            element.removeEventListener('wheel', wheel);
            element.removeEventListener('touchmove', touched);
        };
    }, []);
    const up = (event: PointerEvent) => {
        down.current.delete(event.pointerId);
    };
    return {
        onPointerDown(event: PointerEvent) {
            (event.currentTarget as Element).setPointerCapture(event.pointerId);
            down.current.set(event.pointerId, {x: event.clientX, y: event.clientY});
            path.current = down.current.size > 1 ? Infinity : 0;
        },
        onPointerMove(event: PointerEvent) {
            const from = down.current.get(event.pointerId);
            if (!from) return;
            const x = event.clientX - from.x, y = event.clientY - from.y;
            path.current += Math.hypot(x, y);
            if (path.current < 4) return;
            const box = body.current!.getBoundingClientRect();
            const other = [...down.current].find(([id]) => id !== event.pointerId)?.[1];
            if (other) {
                const span = (p: {x: number; y: number}) => Math.max(8, Math.hypot(p.x - other.x, p.y - other.y));
                zoomBy(span({x: event.clientX, y: event.clientY}) / span(from));
                turnBy(-x / 240, -y / 240);  // both fingers move
            } else if (event.pointerType === 'touch') {
                return;
            } else if (event.shiftKey || event.buttons & 6) {
                panBy(x / box.width, -y / box.height);
            } else {
                turnBy(-x / 120, -y / 120);
            }
            down.current.set(event.pointerId, {x: event.clientX, y: event.clientY});
        },
        onPointerUp(event: PointerEvent) {
            up(event);
            if (path.current >= 4 || event.button !== 0) return;
            const box = body.current!.getBoundingClientRect();
            clicked((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
        },
        onPointerCancel: up,
        onContextMenu: (event: Event) => event.preventDefault(),
        onKeyDown(event: KeyboardEvent) {
            const ways: Record<string, [number, number]> = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
            const way = ways[event.key];
            if (way && event.shiftKey) {
                panBy(-0.05 * way[0], -0.05 * way[1]);
            } else if (way) {
                turnBy(-0.1 * way[0], -0.1 * way[1]);
            } else if (event.key === '+' || event.key === '=') {
                zoomBy(1.2);
            } else if (event.key === '-') {
                zoomBy(1 / 1.2);
            } else if (event.key === '0') {
                resetTurn();
            } else {
                return;
            }
            event.preventDefault();
            event.stopPropagation();
        },
    };
}
