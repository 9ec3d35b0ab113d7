// SPDX-License-Identifier: Apache-2.0
// The scene in space: what the camera sees, the pinned pixel's rays, and lights and shapes that can be moved. The engine renders
// the scene; lines and handles are drawn over it.
import {useSignal} from '@preact/signals';
import type {CameraInfo, SceneInfo, Vec3} from 'glint-wasm';
import {useEffect, useLayoutEffect, useMemo, useRef} from 'preact/hooks';

import {add, unit} from '../camera';
import {isMoving, manyShapes, ownCut, shapeCount, turn} from '../store/space';
import {documentId, info, pinned, pinnedIn, selected, services, state} from '../store/state';
import {length} from '../text/edit';
import {sceneDistance} from '../ui/gestures';
import {canvases} from '../ui/pictures';
import {segments, stepClass} from '../ui/RayLines';
import {css, itemName, lightName} from '../ui/words';
import {type Frame, type Region, type Turn, frameOf, regionOf, seenAt, startTurn} from './frame';
import {type Handle, HandleButton} from './handles';
import {type Box, lineHeight, placeLabels} from './labels';
import {frustum, partsOf} from './lines';
import {type Depths, SpacePicture, viewSettings} from './picture';
import {useGestures} from './turning';
import './space.css';

const between = (a: Vec3, b: Vec3) => length(add(a, b, -1));

/** The distance from the camera of what it looks at. */
function reachOf(camera: CameraInfo): number {
    const hit = pinned.value?.rays[0]?.hit;
    if (hit) return between(hit.point, camera.position);
    return camera.look_at ? between(camera.look_at, camera.position) : sceneDistance();
}

/** The points that the view must contain. */
function pointsOf(camera: CameraInfo): Vec3[] {
    const reach = reachOf(camera), explanation = pinned.value;
    const target = add(camera.position, unit(camera.view.forward), reach);
    const hits = explanation?.rays.slice(0, 2000).flatMap((ray) => (ray.hit ? [ray.hit.point] : [])) ?? [];
    // Of far reflections, only the beginning is shown.
    const near = hits.length > 0 ? hits.filter((point) => between(point, hits[0]!) < 1.2 * reach) : [target];
    const lights = (info.value?.lights ?? []).flatMap(({position}) => (position && between(position, near[0]!) < 2 * reach ? [position] : []));
    const bounds = info.value?.bounds;
    const box: Vec3[] = bounds && between(bounds.min, bounds.max) < 3 * reach ? [bounds.min, bounds.max] : [];
    return [camera.position, ...near, ...lights, ...box];
}

/** The handles of the lights, of the present ray's object, and of the one that was clicked. */
function handlesOf(chosen: Handle | null): Handle[] {
    const lights = (info.value?.lights ?? []).flatMap((light, index): Handle[] => {
        const {position, place, kind, name} = light;
        return position ? [{id: `light ${index}`, name: itemName({name, kind: `${kind} light`, line: place?.line}), what: {kind: 'light', index}, point: position,
                            color: css(light.color)}] : [];
    });
    const hit = pinned.value?.rays[selected.value.ray]?.hit;
    const own: Handle | null = hit ? {id: `ray ${selected.value.ray}`, name: itemName(hit.shape), what: {kind: 'shape', shape: hit.shape}, point: hit.point} : null;
    return [...lights.slice(0, 100), ...(own ? [own] : []), ...(chosen ? [chosen] : [])];
}

/** From how high a closed room is looked into: its walls then hide little of it. */
const intoRoom = 0.22;

/** In a closed room, looks in from above, and cuts more of the scene away while most of the points are hidden; until the user does. */
function useUncovered(about: string, region: Region, depths: Depths | null, frame: Frame) {
    useEffect(() => {
        const {cut} = turn.value;
        if (ownCut.about !== about && cut === ownCut.cut) {
            Object.assign(ownCut, {about, cut: 0});
            if (cut !== 0) turn.value = {...turn.value, cut: 0, tilt: turn.value.tilt === intoRoom ? startTurn.tilt : turn.value.tilt};
        }
        if (!depths || depths.frame !== frame || cut !== ownCut.cut || cut >= 1) return;
        const hidden = region.points.filter((point) => partsOf(frame, depths, point, point, 0.02 * region.radius)[0]!.hidden).length;
        if (hidden <= region.points.length / 2) return;
        Object.assign(ownCut, {about, cut: Math.min(1, cut + 0.35)});
        turn.value = {...turn.value, cut: ownCut.cut, tilt: turn.value.tilt === startTurn.tilt ? intoRoom : turn.value.tilt};
    }, [about, depths]);
}

export function SpaceView() {
    const body = useRef<HTMLDivElement>(null), canvas = useRef<HTMLCanvasElement>(null), film = useRef<HTMLCanvasElement>(null);
    const picture = useRef<SpacePicture | null>(null);
    const shown = useRef<{frame: Frame; facts: SceneInfo; turn: Turn; at: number} | null>(null);
    const depths = useSignal<Depths | null>(null);
    const box = useSignal({width: 320, height: 240});
    const chosen = useSignal<Handle | null>(null);
    const facts = info.value!, {camera} = facts;
    const {side} = pinnedIn.value;
    const explanation = pinned.value;
    // Not with every edit, or the view would move while something is dragged in it.
    const about = JSON.stringify([explanation?.pixel, side, documentId.value, camera.position, camera.view]);
    const region = useMemo(() => regionOf(pointsOf(camera), camera), [about]);
    const {width, height} = box.value;
    const frame = useMemo(() => frameOf(region, turn.value, width / height), [region, turn.value, width / height]);
    const isMany = shapeCount() >= manyShapes;

    useLayoutEffect(() => {
        const measure = () => {
            const {clientWidth, clientHeight} = body.current!;
            box.value = {width: Math.max(80, clientWidth), height: Math.max(80, clientHeight)};
        };
        const observer = new ResizeObserver(measure);
        observer.observe(body.current!);
        measure();
        picture.current = new SpacePicture(services.pool!, canvas.current!, (now) => {
            depths.value = now;
        });
        return () => {
            observer.disconnect();
            picture.current?.end();
        };
    }, []);
    useUncovered(about, region, depths.value, frame);
    useEffect(() => {
        chosen.value = null;
    }, [documentId.value, explanation?.pixel.join()]);
    useEffect(() => {
        const view = services[side];
        if (!view?.current || view.current.content.document !== documentId.value) return;
        const detail = isMany ? 0.7 : Math.min(2, Math.sqrt(1.5e6 / (width * height)));
        const show = (isCoarse: boolean) =>
            picture.current?.show({view, frame, isCoarse, width: Math.round(detail * width), height: Math.round(detail * height)});
        // When a picture is complete, the view already has its scene, perhaps coarse. While the camera or a slider is dragged, the
        // picture goes first.
        const before = shown.current, now = performance.now();
        const isChanged = before?.frame !== frame || before.facts !== facts;
        const isOwn = before?.turn !== turn.value || isMoving.value;
        const isCoarseShown = isChanged && (isOwn || now - before.at > 250);
        if (isCoarseShown) show(true);
        shown.current = {frame, facts, turn: turn.value, at: isCoarseShown ? now : (before?.at ?? now)};
        const timer = setTimeout(() => show(false), 160);
        return () => clearTimeout(timer);
    }, [frame, facts, width, height, side, state.value === 'done']);

    const distance = 0.4 * reachOf(camera);
    const {from, corners} = frustum(camera, distance);
    // The picture, in its frustum.
    useEffect(() => {
        const {width: w, height: h} = film.current!;
        const context = film.current!.getContext('2d')!;
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.clearRect(0, 0, w, h);
        const [a, b, , d] = corners.map((corner) => seenAt(frame, corner)).map(({x, y}) => [x * w, y * h] as const);
        context.setTransform(b![0] - a![0], b![1] - a![1], d![0] - a![0], d![1] - a![1], a![0], a![1]);
        context.globalAlpha = 0.85;
        if (![a, b, d].flat().some((c) => !Number.isFinite(c) || Math.abs(c!) > 1e5)) context.drawImage(canvases[side], 0, 0, 1, 1);
    }, [frame, facts, width, height, side, state.value]);

    const pick = async (x: number, y: number) => {
        const view = services[side], seen = depths.value;
        if (!view?.current || !services.pool || !seen) return;
        const prepare = {settings: {...viewSettings, size: `${seen.width}x${seen.height}`}, camera: seen.frame};
        const at = (fraction: number, size: number) => Math.max(0, Math.min(size - 1, Math.floor(fraction * size)));
        const task = {what: 'explain' as const, x: at(x, seen.width), y: at(y, seen.height)};
        const found = await services.pool.run({view: side, key: view.current.key, request: view.current.content.request, prepare, task}, true).catch(() => null);
        const hit = found?.rays[0]?.hit;
        chosen.value = hit ? {id: `shape ${hit.shape.index}`, name: itemName(hit.shape), what: {kind: 'shape', shape: hit.shape}, point: hit.point} : null;
    };
    const gestures = useGestures(body, (x, y) => void pick(x, y));

    const slack = 0.012 * region.radius;
    const x = (fraction: number) => (fraction * width).toFixed(1), y = (fraction: number) => (fraction * height).toFixed(1);
    const line = (className: string, a: Vec3, b: Vec3, key: string) => partsOf(frame, depths.value, a, b, slack).map((part, i) => (
        <line key={`${key} ${i}`} class={`${className}${part.hidden ? ' hidden' : ''}`} x1={x(part.x1)} y1={y(part.y1)} x2={x(part.x2)} y2={y(part.y2)}
              pathLength={className.endsWith(' now') && !part.hidden ? 1 : undefined} style={{'--from': part.from, '--part': part.to - part.from}} />
    ));
    const rays = explanation ? segments(explanation).slice(0, 400) : [];
    const now = explanation?.rays[selected.value.ray]?.hit;
    const blockers = now?.lights.slice(0, 64).flatMap(({blocker, light}) => {
        if (!blocker) return [];
        const at = seenAt(frame, blocker.point);
        return [{x: at.x * width, y: at.y * height, lines: [itemName(blocker.shape), `blocks ${lightName(light)}`]}];
    }) ?? [];
    const handles = handlesOf(chosen.value);
    const handleBoxes = handles.map(({point}) => seenAt(frame, point)).map((at): Box => ({x: at.x * width - 13, y: at.y * height - 13, width: 26, height: 26}));
    const labels = placeLabels(blockers, {width, height}, [...handleBoxes, {x: 0, y: height - 72, width: 72, height: 72}]);
    const axes = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]] as Vec3[]).map((axis) => {
        const tip = seenAt(frame, add(add(frame.position, frame.forward), axis, (0.07 * length(frame.right)) / Math.max(1, width / 400)));
        return {x: 34 + (tip.x - 0.5) * width, y: height - 34 + (tip.y - 0.5) * height};
    });
    return (
        <>
            <div class="space-body" ref={body}>
                <div class="space-frame" tabIndex={0} role="application"
                     aria-label="The scene in space, with the rays. Arrow keys turn it, with Shift they shift it; plus and minus zoom, 0 resets." {...gestures}>
                    <canvas ref={canvas} />
                    <canvas ref={film} class="film" width={width} height={height} />
                    <svg class="rays" viewBox={`0 0 ${width} ${height}`} aria-hidden="true">
                        {from.map((start, i) => line('frustum', start, corners[i]!, `edge ${i}`))}
                        {corners.map((corner, i) => line('frustum', corner, corners[(i + 1) % 4]!, `side ${i}`))}
                        {rays.map((one, i) => line(`casing${stepClass(one)}`, one.from, one.to, `casing ${i}`))}
                        {rays.map((one, i) => line(`ray ${one.kind}${stepClass(one)}`, one.from, one.to, `ray ${i}`))}
                        {blockers.map((one, i) => (
                            <g key={i} class="blocker">
                                <circle cx={one.x.toFixed(1)} cy={one.y.toFixed(1)} r="6" />
                                {labels[i] && <text>{one.lines.map((words, k) => (
                                    <tspan key={k} x={labels[i]!.x.toFixed(1)} y={(labels[i]!.y + lineHeight * (k + 0.8)).toFixed(1)}>{words}</tspan>
                                ))}</text>}
                            </g>
                        ))}
                        {axes.map((tip, i) => (
                            <g key={i} class={`axis ${'xyz'[i]}`}>
                                <line x1="34" y1={height - 34} x2={tip.x.toFixed(1)} y2={tip.y.toFixed(1)} />
                                <text x={tip.x.toFixed(1)} y={(tip.y + 4).toFixed(1)} text-anchor="middle">{'xyz'[i]}</text>
                            </g>
                        ))}
                    </svg>
                </div>
                {handles.map((handle) => (
                    <HandleButton key={handle.id} handle={handle} frame={frame} moved={(by) => {
                        if (chosen.value?.id === handle.id) chosen.value = {...handle, point: add(handle.point, by)};
                    }} />
                ))}
            </div>
            {isMany && <p class="note">{shapeCount().toLocaleString('en')} shapes: shown in less detail, and what is dragged moves when it is released.</p>}
            <p class="note hint">Drag to turn (with two fingers on a touch screen), with Shift to shift. Click a shape, then drag its handle; lights have theirs.</p>
        </>
    );
}
