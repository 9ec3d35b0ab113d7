// SPDX-License-Identifier: Apache-2.0
// The scene from above, rendered by the engine, with the pixel's rays. It can be rotated.
import {useSignal} from '@preact/signals';
import type {Explanation, Vec3} from 'glint-wasm';
import {useEffect, useRef} from 'preact/hooks';

import {add, overview, overviewCamera} from '../camera';
import {View} from '../engine/view';
import {info, services, text} from '../store/state';
import {Lines, segments} from './RayLines';

const width = 320, height = 240;

/** The points that the view must contain: start and end of the pixel's rays, and their lights. */
function pointsOf(explanation: Explanation): Vec3[] {
    const rays = segments(explanation).filter((one) => one.kind !== 'dark' && one.kind !== 'light');
    const hits = explanation.rays.flatMap((ray) => (ray.hit ? [ray.hit.point] : []));
    const ends = hits.length > 0 ? hits : rays.map((one) => one.to);
    const reach = Math.max(...ends.map((p) => Math.hypot(...add(p, explanation.rays[0]!.origin, -1))));
    const lights = (info.value?.lights ?? []).flatMap((light) =>
        light.position && Math.hypot(...add(light.position, ends[0]!, -1)) < 2 * reach ? [light.position] : []);
    return [explanation.rays[0]!.origin, ...ends, ...lights];
}

export function TopView({explanation}: {explanation: Explanation}) {
    const canvas = useRef<HTMLCanvasElement>(null);
    const view = useRef<View | null>(null);
    const yaw = useSignal(0), tilt = useSignal(0.35);
    const camera = info.value!.camera;
    const seen = overview(pointsOf(explanation), camera, yaw.value, tilt.value, width / height);
    const key = JSON.stringify(seen);
    useEffect(() => {
        const context = canvas.current!.getContext('2d', {alpha: false})!;
        view.current = new View(services.pool!, 'top', {
            opened: () => {},
            sized: () => {},
            painted: (tile, to, stretched) => {
                if (!stretched) {
                    context.putImageData(tile, to.x, to.y);
                    return;
                }
                const coarse = new OffscreenCanvas(tile.width, tile.height);
                coarse.getContext('2d')!.putImageData(tile, 0, 0);
                context.drawImage(coarse, to.x, to.y, to.width, to.height);
            },
            progress: () => {},
            done: () => {},
            failed: () => {},
        });
        return () => view.current?.stop();
    }, []);
    useEffect(() => {
        const current = services.first?.current;
        if (!current) return;
        view.current?.show({
            request: current.content.request,
            prepare: {
                settings: {size: `${width}x${height}`, shading: 'diffuse', shadows: 'false', reflections: '0', aa: '2', pixel_sample: 'center', camera_t_min: '0', ray_direction: 'unit'},
                camera: seen,
            },
        });
    }, [key, text.value, explanation]);
    const turn = (dx: number, dy: number) => {
        yaw.value += dx;
        tilt.value = Math.max(0, Math.min(1.5, tilt.value + dy));
    };
    return (
        <section class="top-view" aria-label="From above">
            <h3>From above</h3>
            <div
                class="top-frame" tabIndex={0} role="application" aria-label="The scene from above, with the rays. Arrow keys turn it."
                onPointerDown={(event) => (event.currentTarget as Element).setPointerCapture(event.pointerId)}
                onPointerMove={(event) => event.buttons & 1 && turn(-event.movementX / 120, -event.movementY / 120)}
                onKeyDown={(event) => {
                    const steps: Record<string, [number, number]> = {
                        ArrowLeft: [0.1, 0], ArrowRight: [-0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1],
                    };
                    const step = steps[event.key];
                    if (!step) return;
                    event.preventDefault();
                    turn(...step);
                }}
            >
                <canvas ref={canvas} width={width} height={height} />
                <Lines explanation={explanation} camera={overviewCamera(seen)} width={width} height={height} withCamera />
            </div>
            <p class="legend">
                <span class="ray-key camera" /> camera <span class="ray-key mirror" /> mirror <span class="ray-key transmitted" /> glass
                <span class="ray-key light" /> light <span class="ray-key blocked" /> blocked
            </p>
        </section>
    );
}
