// SPDX-License-Identifier: Apache-2.0
// The pinned pixel's rays as lines over a picture of the scene.
import type {CameraInfo, Explanation, Vec3} from 'glint-wasm';

import {add, projectLine} from '../camera';
import {info, pinned, size} from '../store/state';

export interface Segment {
    from: Vec3;
    to: Vec3;
    kind: 'camera' | 'mirror' | 'transmitted' | 'light' | 'blocked' | 'dark';
}

/** The length of the line for a ray that leaves the scene. */
const reachOf = (explanation: Explanation) =>
    2 * Math.max(1, ...explanation.rays.filter((ray) => ray.hit && ray.t).map((ray) => ray.t! * Math.hypot(...ray.direction)));

/** All lines of an explanation; for several samples, those of the middle one. */
export function segments(explanation: Explanation): Segment[] {
    const middle = Math.floor(explanation.samples / 2);
    const reach = reachOf(explanation);
    const list: Segment[] = [];
    for (const ray of explanation.rays.slice(0, 2000)) {
        if (ray.sample[0] !== middle || ray.sample[1] !== middle) continue;
        const step = reach / Math.hypot(...ray.direction);
        list.push({from: ray.origin, to: ray.hit?.point ?? add(ray.origin, ray.direction, step), kind: ray.kind});
        for (const light of ray.hit?.lights ?? []) {
            const point = ray.hit!.point;
            const far = light.shadow_ray && light.shadow_ray.t_max === null ? reach / Math.max(1e-9, light.distance) : 1;
            const end = add(point, light.to_light, far);
            if (light.reason === 'adds') list.push({from: point, to: end, kind: 'light'});
            if (light.blocker) {
                list.push({from: point, to: light.blocker.point, kind: 'blocked'}, {from: light.blocker.point, to: end, kind: 'dark'});
            }
        }
    }
    return list;
}

export function Lines({explanation, camera, width, height, withCamera}: {
    explanation: Explanation; camera: CameraInfo; width: number; height: number; withCamera: boolean;
}) {
    return (
        <svg class="rays" viewBox={`0 0 ${width} ${height}`} preserveAspectRatio="none" aria-hidden="true">
            {segments(explanation).map(({from, to, kind}, i) => {
                if (kind === 'camera' && !withCamera) return null;
                const line = projectLine(camera, width, height, from, to);
                if (!line || line.some((c) => Math.abs(c) > 1e6)) return null;
                return <line key={i} class={`ray ${kind}`} x1={line[0]} y1={line[1]} x2={line[2]} y2={line[3]} vector-effect="non-scaling-stroke" />;
            })}
        </svg>
    );
}

export function RayLines() {
    const explanation = pinned.value, facts = info.value;
    if (!explanation || !facts) return null;
    const {width, height} = size.value;
    return (
        <>
            <Lines explanation={explanation} camera={facts.camera} width={width} height={height} withCamera={false} />
            <svg class="rays" viewBox={`0 0 ${width} ${height}`} preserveAspectRatio="none" aria-hidden="true">
                <circle class="pin-back" cx={explanation.pixel[0] + 0.5} cy={explanation.pixel[1] + 0.5} r={width / 110} vector-effect="non-scaling-stroke" />
                <circle class="pin" cx={explanation.pixel[0] + 0.5} cy={explanation.pixel[1] + 0.5} r={width / 110} vector-effect="non-scaling-stroke" />
            </svg>
        </>
    );
}
