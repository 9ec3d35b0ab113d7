// SPDX-License-Identifier: Apache-2.0
// The middle of the page: the picture and its overlays.
import {useSignal} from '@preact/signals';
import {useEffect, useLayoutEffect, useRef} from 'preact/hooks';

import type {Move} from '../camera';
import {layout} from '../store/layout';
import {reveal} from '../store/places';
import {isLarge} from '../store/space';
import {
    besides, comparisonFailure, diagnostics, difference, failure, hovered, info, isPictureOfScene, isSecondDone, notice, ownPicture, pinned, pixel, progress, size, split, state,
} from '../store/state';
import {cameraNow, moveCamera, resetCamera} from '../store/viewpoint';
import {Difference} from './Compare';
import {LogPixels} from './LogPixels';
import {keyPressed, lookDistance, usePointers, useWheel, zoom} from './gestures';
import {RayLines} from './RayLines';
import {Space} from './Space';
import {Splitter} from './Splitter';
import {sentence} from './sentence';
import {hex, itemName} from './words';
import {canvases} from './pictures';

/** The picture's size on the page. */
function fit(box: {width: number; height: number}, picture: {width: number; height: number}) {
    const scale = layout.value.zoom === 'whole' ? 1 : Math.min(box.width / picture.width, box.height / picture.height);
    return {width: picture.width * scale, height: picture.height * scale, enlarged: scale >= 2};
}

function ZoomButtons() {
    const {zoom: now} = layout.value;
    const set = (to: typeof now) => {
        layout.value = {...layout.value, zoom: to};
    };
    return (
        <div class="camera-buttons" role="group" aria-label="Size on the page">
            <button class="quiet" aria-pressed={now === 'fit'} title="As large as its space" onClick={() => set('fit')}>Fit</button>
            <button class="quiet" aria-pressed={now === 'whole'} title="Each pixel of the picture is one of the page" onClick={() => set('whole')}>100%</button>
            <button class="quiet" aria-label="Full screen" title="Full screen" onClick={(event) => {
                const stage = (event.currentTarget as Element).closest('.stage')!;
                void (document.fullscreenElement ? document.exitFullscreen() : stage.requestFullscreen());
            }}>
                <svg class="icon" viewBox="0 0 14 14" aria-hidden="true"><path d="M1 5V1h4M9 1h4v4M13 9v4H9M5 13H1V9" /></svg>
            </button>
        </div>
    );
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

const turns = [
    ['left', '←', 0.06, 0],
    ['right', '→', -0.06, 0],
    ['up', '↑', 0, 0.06],
    ['down', '↓', 0, -0.06],
] as const;

function CameraButtons() {
    const act = (move: Move) => {
        const camera = cameraNow();
        if (camera) moveCamera(camera, lookDistance(), move);
    };
    return (
        <div class="camera-buttons" role="group" aria-label="Camera">
            {turns.map(([way, sign, x, y]) => (
                <button key={way} class="quiet" aria-label={`Turn ${way}`} title={`Turn ${way} (or drag); with Shift: go ${way}`}
                        onClick={(event) => act(event.shiftKey ? {kind: 'pan', x, y} : {kind: 'orbit', x, y})}>{sign}</button>
            ))}
            <button class="quiet" aria-label="Reset the camera" title="The camera as the scene was opened" onClick={resetCamera}>⟲</button>
            <button class="quiet" aria-label="Nearer" title="Nearer (or turn the wheel)" onClick={() => zoom(1 / 1.15)}>+</button>
            <button class="quiet" aria-label="Farther" title="Farther (or turn the wheel)" onClick={() => zoom(1.15)}>−</button>
        </div>
    );
}

/** The pixel in the user's own picture. */
function OwnPixel({at: [x, y]}: {at: readonly [number, number]}) {
    const image = ownPicture.value?.image;
    if (!image || x >= image.width || y >= image.height) return null;
    const [r, g, b] = image.data.subarray(4 * (y * image.width + x));
    return (
        <>
            <span>yours</span>
            <span class="swatch" style={{background: hex([r!, g!, b!])}} aria-hidden="true" />
            <span class="mono">{r} {g} {b}</span>
        </>
    );
}

function PixelLine() {
    const explanation = hovered.value ?? pinned.value;
    if (!explanation) return <p class="pixel-line how" aria-live="polite">Point at the picture; click a pixel to take it apart; drag to turn the camera, with Shift to shift it.</p>;
    const hit = explanation.rays[0]?.hit;
    const point = hit ? `(${hit.point.map((c) => Number(c.toPrecision(4))).join(', ')})` : '';
    return (
        <p class="pixel-line" aria-live="polite">
            <span class="mono">({explanation.pixel.join(', ')})</span>
            <span class="swatch" style={{background: hex(explanation.bytes)}} aria-hidden="true" />
            <span class="mono">{explanation.bytes.join(' ')}</span>
            <OwnPixel at={explanation.pixel} />
            {hit ? <>
                <button class="link" onClick={() => reveal(hit.shape)}>{itemName(hit.shape)}</button>
                <span class="mono faint point" title={point}>{point}</span>
            </> : <span>background</span>}
        </p>
    );
}

function Status() {
    const {fraction, rays, milliseconds} = progress.value;
    const rate = `${(milliseconds > 0 ? rays / milliseconds / 1000 : 0).toFixed(1)} M rays/s`;
    const {width, height} = size.value;
    const first = diagnostics.value.find((one) => one.severity === 'error');
    const mistake = first && `${first.line > 0 ? `${first.line}:${first.column} ` : ''}${first.message}`;
    // Pictures of more pixels than the page can hold are rendered smaller.
    const asked = info.value && isPictureOfScene.value && info.value.width * info.value.height > width * height ? info.value : null;
    const reduced = asked ? ` (reduced from ${asked.width}×${asked.height})` : '';
    const words = {
        starting: 'starting',
        reading: `reading · ${Math.round(100 * fraction)}%`,
        rendering: fraction > 0 && fraction < 1 ? `rendering${reduced} · ${Math.round(100 * fraction)}% · ${rate}` : 'rendering',
        done: `${width}×${height}${reduced} · ${Math.round(milliseconds)} ms · ${rate}`,
        error: `not rendered: ${failure.value || mistake}`,
    }[state.value];
    return (
        <div class="status">
            <div class="figures-line">
                <PixelLine />
                <ZoomButtons />
            </div>
            {pinned.value && <p class="sentence-line">{sentence(pinned.value)}</p>}
            <div class="figures-line">
                <progress value={state.value === 'done' ? 1 : state.value === 'error' ? 0 : fraction} max={1} aria-label="Progress of the picture" />
                <span class="mono words" data-state={state.value} title={words}>{words}</span>
                <span class="for-readers" role="status" aria-label="Explanation">{pinned.value && `Pixel ${pinned.value.pixel.join(', ')}: ${sentence(pinned.value)}`}</span>
                <span class="for-readers" role="status">{{starting: '', reading: '', rendering: '', done: 'Rendered', error: 'Not rendered'}[state.value]}</span>
                <CameraButtons />
            </div>
        </div>
    );
}

/** What a notice says is read within this time, in milliseconds; it then makes room. */
const noticeTime = 20_000;

function useNoticeTime() {
    const {value} = notice;
    useEffect(() => {
        if (!value) return undefined;
        const timer = setTimeout(() => {
            notice.value = '';
        }, noticeTime);
        return () => clearTimeout(timer);
    }, [value]);
}

export function Stage() {
    useNoticeTime();
    const area = useRef<HTMLDivElement>(null);
    const frame = useRef<HTMLDivElement>(null);
    const box = useSignal({width: 600, height: 600});
    useLayoutEffect(() => {
        const measure = () => {
            const {clientWidth, clientHeight} = area.current!;
            box.value = {width: Math.max(64, clientWidth), height: Math.max(64, clientHeight)};
        };
        measure();
        const observer = new ResizeObserver(measure);
        observer.observe(area.current!);
        return () => observer.disconnect();
    }, []);
    useWheel(frame);
    const pointers = usePointers(frame);
    const shown = fit(box.value, size.value);
    const beside = besides.value;
    const [x, y] = pixel.value ?? [-1, -1];
    const percent = (n: number, of: number) => `${(100 * n) / of}%`;
    return (
        <section class={`stage${isLarge.value ? ' in-space' : ''}`} aria-label="Picture">
            <Splitter side="left" />
            <Splitter side="right" />
            <div class={`stage-area${layout.value.zoom === 'whole' ? ' whole' : ''}`} ref={area}>
                <div
                    ref={frame} class={`frame${shown.enlarged ? ' enlarged' : ''}${isPictureOfScene.value ? '' : state.value === 'error' ? ' without' : ' before'}`} tabIndex={0} role="application" data-focus
                    aria-label="Picture. Arrow keys point at a pixel, Enter explains it, S saves."
                    style={{width: `${shown.width}px`, height: `${shown.height}px`}} onKeyDown={keyPressed} {...pointers}
                >
                    <Canvas canvas={canvases.first} label={beside?.left ?? 'The rendered scene'} />
                    {beside && !difference.value && (
                        <>
                            <div class="right-half" data-complete={isSecondDone.value} style={{clipPath: `inset(0 0 0 ${100 * split.value}%)`}}>
                                <Canvas canvas={canvases.second} label={beside.right} />
                            </div>
                            <Border frame={frame} />
                            <span class="tag left">{beside.left}</span>
                            <span class="tag right">{beside.right}{comparisonFailure.value && ': not rendered'}</span>
                        </>
                    )}
                    {beside && difference.value && <Difference />}
                    {!isPictureOfScene.value && state.value === 'error' && <p class="no-picture">There is no picture: the text has errors.</p>}
                    <LogPixels />
                    <RayLines />
                    {pixel.value && pinned.value?.pixel.join() !== pixel.value.join() && (
                        <div class="cursor" style={{left: percent(x, size.value.width), top: percent(y, size.value.height),
                            width: percent(1, size.value.width), height: percent(1, size.value.height)}} />
                    )}
                </div>
            </div>
            {isLarge.value && <Space />}
            <Status />
            {notice.value && (
                <div class="notice" role="status">
                    <span>{notice.value}</span>
                    <button class="quiet" aria-label="Dismiss" onClick={() => {
                        notice.value = '';
                    }}>✕</button>
                </div>
            )}
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
