// SPDX-License-Identifier: Apache-2.0
// The pinned pixel's rays as lines over a picture of the scene.
import type {CameraInfo, Explanation, Vec3} from 'glint-wasm';

import {add, projectLine} from '../camera';
import {info, pinned, size} from '../store/state';
import {steps} from '../store/stepping';
import {ownRays} from './own_rays';

export interface Segment {
    /** The index of its ray, or of that whose hit it leaves to a light; -1: a ray of the user's own ray tracer. */
    ray: number;
    from: Vec3;
    to: Vec3;
    kind: 'camera' | 'mirror' | 'transmitted' | 'light' | 'blocked' | 'dark' | 'yours';
}

/** The length of the line for a ray that leaves the scene. */
const reachOf = (explanation: Explanation) =>
    2 * Math.max(1, ...explanation.rays.filter((ray) => ray.hit && ray.t).map((ray) => ray.t! * Math.hypot(...ray.direction)));

/** Lines from one hit: of an area light's samples, which may be thousands, some. */
const mostLights = 32;

/** All lines of an explanation; of several samples, those of the present step's, else of the middle one. */
export function segments(explanation: Explanation): Segment[] {
    const middle = Math.floor(explanation.samples / 2);
    const present = steps.value?.ray ?? null;
    const sample = present === null ? [middle, middle] : explanation.rays[present]!.sample;
    const reach = reachOf(explanation);
    const list: Segment[] = [];
    for (const [i, ray] of explanation.rays.slice(0, 2000).entries()) {
        if (ray.sample[0] !== sample[0] || ray.sample[1] !== sample[1]) continue;
        const step = reach / Math.hypot(...ray.direction);
        list.push({ray: i, from: ray.origin, to: ray.hit?.point ?? add(ray.origin, ray.direction, step), kind: ray.kind});
        const lights = ray.hit?.lights ?? [], every = Math.ceil(lights.length / mostLights);
        for (const light of lights) {
            if (light.sample !== undefined && light.sample % every !== 0) continue;
            const point = ray.hit!.point;
            const far = light.shadow_ray && light.shadow_ray.t_max === null ? reach / Math.max(1e-9, light.distance) : 1;
            const end = add(point, light.to_light, far);
            if (light.reason === 'adds') list.push({ray: i, from: point, to: end, kind: 'light'});
            if (light.blocker) {
                list.push({ray: i, from: point, to: light.blocker.point, kind: 'blocked'}, {ray: i, from: light.blocker.point, to: end, kind: 'dark'});
            } else if (light.reason !== 'adds' && light.reason !== 'in_surface') {
                list.push({ray: i, from: point, to: end, kind: 'dark'});
            }
        }
    }
    return [...ownRays(reach), ...list];
}

/** How a segment's ray takes part in stepping: the present one, one that is not reached yet. */
export const stepClass = ({ray}: Segment) => (ray < 0 || !steps.value || steps.value.at === null ? '' : steps.value.ray === ray ? ' now' : steps.value.shown.has(ray) ? '' : ' later');

function Lines({explanation, camera, width, height}: {explanation: Explanation; camera: CameraInfo; width: number; height: number}) {
    return (
        <svg class="rays" viewBox={`0 0 ${width} ${height}`} preserveAspectRatio="none" aria-hidden="true">
            {segments(explanation).map((segment, i) => {
                const {from, to, kind} = segment;
                if (kind === 'camera') return null;
                const line = projectLine(camera, width, height, from, to);
                if (!line || line.some((c) => Math.abs(c) > 1e6)) return null;
                return <line key={i} class={`ray ${kind}${stepClass(segment)}`} x1={line[0]} y1={line[1]} x2={line[2]} y2={line[3]} vector-effect="non-scaling-stroke" />;
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
            <Lines explanation={explanation} camera={facts.camera} width={width} height={height} />
            <svg class="rays" viewBox={`0 0 ${width} ${height}`} preserveAspectRatio="none" aria-hidden="true">
                <circle class="pin-back" cx={explanation.pixel[0] + 0.5} cy={explanation.pixel[1] + 0.5} r={width / 110} vector-effect="non-scaling-stroke" />
                <circle class="pin" cx={explanation.pixel[0] + 0.5} cy={explanation.pixel[1] + 0.5} r={width / 110} vector-effect="non-scaling-stroke" />
            </svg>
        </>
    );
}
