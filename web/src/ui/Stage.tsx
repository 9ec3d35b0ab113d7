// The middle: the picture, what is drawn over it, and what one does with the mouse and the keys there.
import {useSignal} from '@preact/signals';
import type {CameraInfo} from 'glint-wasm';
import {useEffect, useLayoutEffect, useRef} from 'preact/hooks';

import {length} from '../text/edit';
import {sub} from '../camera';
import {
    comparison, difference, hover, hovered, info, moveCamera, pin, pinned, pixel, progress, reveal, split, state,
} from '../store';
import {Difference} from './Compare';
import {RayLines} from './RayLines';
import {hex, itemName} from './words';
import {canvases, size} from './pictures';

/** How far what the camera looks at is. */
function lookDistance(): number {
    const hit = hovered.value?.rays[0]?.hit ?? pinned.value?.rays[0]?.hit;
    const camera = info.value?.camera;
    if (hit && camera) return length(sub(hit.point, camera.position));
    const bounds = info.value?.bounds;
    return bounds ? Math.min(10, length(sub(bounds.max, bounds.min))) : 5;
}

/** The picture's size on the page: as large as fits, and small pictures enlarged by a whole number. */
function fit(box: {width: number; height: number}, picture: {width: number; height: number}) {
    const scale = Math.min(box.width / picture.width, box.height / picture.height);
    const used = scale >= 2 ? Math.floor(scale) : scale >= 1 ? 1 : scale;
    return {width: picture.width * used, height: picture.height * used, enlarged: used >= 2};
}

function Canvas({canvas, label}: {canvas: HTMLCanvasElement; label: string}) {
    const host = useRef<HTMLDivElement>(null);
    useLayoutEffect(() => {
        canvas.setAttribute('role', 'img');
        canvas.setAttribute('aria-label', label);
        host.current!.replaceChildren(canvas);
    }, [canvas, label]);
    return <div class="layer" ref={host} />;
}

interface Drag {
    x: number;
    y: number;
    pan: boolean;
    moved: boolean;
    camera: CameraInfo;
    distance: number;
}

function useMouse(frame: {current: HTMLDivElement | null}) {
    const drag = useRef<Drag | null>(null);
    const at = (event: PointerEvent): [number, number] | null => {
        const box = frame.current!.getBoundingClientRect();
        const x = Math.floor(((event.clientX - box.left) / box.width) * size.value.width);
        const y = Math.floor(((event.clientY - box.top) / box.height) * size.value.height);
        return x >= 0 && y >= 0 && x < size.value.width && y < size.value.height ? [x, y] : null;
    };
    return {
        onPointerDown(event: PointerEvent) {
            if (!info.value || event.button > 2 || (event.target as Element).closest('.border')) return;
            frame.current!.setPointerCapture(event.pointerId);
            drag.current = {
                x: event.clientX, y: event.clientY, pan: event.shiftKey || event.button !== 0, moved: false,
                camera: info.value.camera, distance: lookDistance(),
            };
        },
        onPointerMove(event: PointerEvent) {
            const now = drag.current;
            if (!now) {
                void hover(at(event));
                return;
            }
            const box = frame.current!.getBoundingClientRect();
            const x = event.clientX - now.x, y = event.clientY - now.y;
            if (!now.moved && Math.hypot(x, y) < 4) return;
            now.moved = true;
            moveCamera(now.camera, {kind: now.pan ? 'pan' : 'orbit', x: x / box.width, y: y / box.height}, now.distance);
        },
        onPointerUp(event: PointerEvent) {
            const now = drag.current;
            drag.current = null;
            if (now && !now.moved && event.button === 0) void pin(at(event));
        },
        onPointerCancel() {
            drag.current = null;
        },
        onPointerLeave() {
            if (!drag.current) void hover(null);
        },
        onContextMenu: (event: Event) => event.preventDefault(),
    };
}

function useWheel(frame: {current: HTMLDivElement | null}) {
    useEffect(() => {
        const element = frame.current!;
        const turned = (event: WheelEvent) => {
            if (!info.value) return;
            event.preventDefault();
            const lines = event.deltaY / (event.deltaMode === 0 ? 100 : 3);
            moveCamera(info.value.camera, {kind: 'zoom', factor: 1.1 ** Math.max(-5, Math.min(5, lines))}, lookDistance());
        };
        element.addEventListener('wheel', turned, {passive: false});
        return () => element.removeEventListener('wheel', turned);
    }, []);
}

/** Arrow keys point at a pixel, Enter pins it. */
function keyPressed(event: KeyboardEvent) {
    const steps: Record<string, [number, number]> = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
    const step = steps[event.key];
    const {width, height} = size.value;
    const now = pixel.value ?? [Math.floor(width / 2), Math.floor(height / 2)];
    if (step) {
        event.preventDefault();
        const by = event.shiftKey ? 20 : 1;
        const inside = (value: number, most: number) => Math.max(0, Math.min(most - 1, value));
        void hover([inside(now[0] + by * step[0], width), inside(now[1] + by * step[1], height)]);
    } else if (event.key === 'Enter') {
        event.preventDefault();
        void pin([now[0], now[1]]);
    }
}

function CameraButtons() {
    const act = (move: Parameters<typeof moveCamera>[1]) => info.value && moveCamera(info.value.camera, move, lookDistance());
    const turn = (x: number, y: number) => () => act({kind: 'orbit', x, y});
    return (
        <div class="camera-buttons" role="group" aria-label="Camera">
            <button class="quiet" aria-label="Turn left" title="Turn left (or drag)" onClick={turn(0.06, 0)}>←</button>
            <button class="quiet" aria-label="Turn right" title="Turn right (or drag)" onClick={turn(-0.06, 0)}>→</button>
            <button class="quiet" aria-label="Turn up" title="Turn up (or drag)" onClick={turn(0, 0.06)}>↑</button>
            <button class="quiet" aria-label="Turn down" title="Turn down (or drag)" onClick={turn(0, -0.06)}>↓</button>
            <button class="quiet" aria-label="Nearer" title="Nearer (or turn the wheel)" onClick={() => act({kind: 'zoom', factor: 1 / 1.15})}>+</button>
            <button class="quiet" aria-label="Farther" title="Farther (or turn the wheel)" onClick={() => act({kind: 'zoom', factor: 1.15})}>−</button>
        </div>
    );
}

function PixelLine() {
    const told = hovered.value ?? pinned.value;
    if (!told) return <p class="pixel-line">Point at the picture; click a pixel to take it apart; drag to turn the camera, with Shift to shift it.</p>;
    const hit = told.rays[0]?.hit;
    return (
        <p class="pixel-line">
            <span class="mono">({told.pixel.join(', ')})</span>
            <span class="swatch" style={{background: hex(told.bytes)}} aria-hidden="true" />
            <span class="mono">{told.bytes.join(' ')}</span>
            {hit ? <>
                <button class="link" onClick={() => reveal(hit.shape)}>{itemName(hit.shape)}</button>
                <span class="mono faint">({hit.point.map((c) => Number(c.toPrecision(4))).join(', ')})</span>
            </> : <span>background</span>}
        </p>
    );
}

function Status() {
    const {fraction, rays, milliseconds} = progress.value;
    const rate = milliseconds > 0 ? rays / milliseconds / 1000 : 0;
    const words = {starting: 'starting', drawing: 'drawing', done: 'done', error: 'not drawn: see the messages'}[state.value];
    return (
        <div class="status">
            <PixelLine />
            <div class="figures-line">
                <progress value={state.value === 'done' ? 1 : fraction} max={1} aria-label="Progress of the picture" />
                <span class="mono" data-state={state.value} role="status">
                    {state.value === 'done'
                        ? `${size.value.width}×${size.value.height} · ${Math.round(milliseconds)} ms · ${rate.toFixed(1)} M rays/s` : words}
                </span>
                <CameraButtons />
            </div>
        </div>
    );
}

export function Stage() {
    const room = useRef<HTMLDivElement>(null);
    const frame = useRef<HTMLDivElement>(null);
    const box = useSignal({width: 600, height: 600});
    useLayoutEffect(() => {
        const measure = () => {
            const {clientWidth, clientHeight} = room.current!;
            box.value = {width: Math.max(64, clientWidth), height: Math.max(64, clientHeight)};
        };
        measure();
        const observer = new ResizeObserver(measure);
        observer.observe(room.current!);
        return () => observer.disconnect();
    }, []);
    useWheel(frame);
    const mouse = useMouse(frame);
    const shown = fit(box.value, size.value);
    const compare = comparison.value;
    const [x, y] = pixel.value ?? [-1, -1];
    const percent = (n: number, of: number) => `${(100 * n) / of}%`;
    return (
        <section class="stage" aria-label="Picture">
            <div class="room" ref={room}>
                <div
                    ref={frame} class={`frame${shown.enlarged ? ' enlarged' : ''}`} tabIndex={0} role="application"
                    aria-label="Picture. Arrow keys point at a pixel, Enter takes it apart, S saves."
                    style={{width: `${shown.width}px`, height: `${shown.height}px`}} onKeyDown={keyPressed} {...mouse}
                >
                    <Canvas canvas={canvases.first} label={compare ? `${compare.key} = ${compare.a}` : 'The rendered scene'} />
                    {compare && !difference.value && (
                        <>
                            <div class="right-half" style={{clipPath: `inset(0 0 0 ${100 * split.value}%)`}}>
                                <Canvas canvas={canvases.second} label={`${compare.key} = ${compare.b}`} />
                            </div>
                            <Border frame={frame} />
                            <span class="tag left">{compare.key} = {compare.a}</span>
                            <span class="tag right">{compare.key} = {compare.b}</span>
                        </>
                    )}
                    {compare && difference.value && <Difference />}
                    <RayLines />
                    {pixel.value && pinned.value?.pixel.join() !== pixel.value.join() && (
                        <div class="cursor" style={{left: percent(x, size.value.width), top: percent(y, size.value.height),
                            width: percent(1, size.value.width), height: percent(1, size.value.height)}} />
                    )}
                </div>
            </div>
            <Status />
        </section>
    );
}

function Border({frame}: {frame: {current: HTMLDivElement | null}}) {
    const move = (event: PointerEvent) => {
        if (!(event.buttons & 1)) return;
        event.stopPropagation();
        const box = frame.current!.getBoundingClientRect();
        split.value = Math.max(0, Math.min(1, (event.clientX - box.left) / box.width));
    };
    return (
        <div
            class="border" role="slider" tabIndex={0} aria-label="Border between the pictures" aria-valuemin={0} aria-valuemax={100}
            aria-valuenow={Math.round(100 * split.value)} style={{left: `${100 * split.value}%`}}
            onPointerDown={(event) => (event.currentTarget as Element).setPointerCapture(event.pointerId)} onPointerMove={move}
            onKeyDown={(event) => {
                const step = event.key === 'ArrowLeft' ? -0.02 : event.key === 'ArrowRight' ? 0.02 : 0;
                if (step === 0) return;
                event.preventDefault();
                event.stopPropagation();
                split.value = Math.max(0, Math.min(1, split.value + step));
            }}
        />
    );
}
