// SPDX-License-Identifier: Apache-2.0
// The factors of the selected light as curves over their angle, with the present angle marked.
import type {Explanation} from 'glint-wasm';

import {pinnedIn, selected} from '../store/state';
import {short} from './words';

const width = 150, height = 84, left = 8, bottom = 16;
const degrees = (cosine: number) => (Math.acos(Math.max(-1, Math.min(1, cosine))) * 180) / Math.PI;

/** cos^n from 0 to 90 degrees; `cosine`: the present one. */
function Plot({label, n, cosine}: {label: string; n: number; cosine: number | null}) {
    const x = (angle: number) => left + (angle / 90) * (width - 2 * left);
    const y = (value: number) => 6 + (1 - value) * (height - bottom - 6);
    const at = (angle: number) => Math.max(0, Math.cos((angle * Math.PI) / 180)) ** n;
    const path = Array.from({length: 91}, (_, angle) => `${angle === 0 ? 'M' : 'L'}${x(angle).toFixed(1)} ${y(at(angle)).toFixed(1)}`).join('');
    const angle = cosine === null ? null : degrees(cosine);
    const now = angle === null ? null : at(Math.min(90, angle));
    const words = angle === null ? 'undefined' : `${angle.toFixed(1)}°: ${angle > 90 ? '0' : short(now)}`;
    return (
        <figure class="plot">
            <svg viewBox={`0 0 ${width} ${height}`} role="img" aria-label={`${label} over the angle; now at ${words}`}>
                <path class="axis" d={`M${left} ${y(0)}H${width - left}M${left} ${y(0)}V${y(1)}`} />
                <path class="curve" d={path} />
                {angle !== null && angle <= 90 && now !== null && <circle class="now" cx={x(angle)} cy={y(now)} r={4} />}
                <text x={left} y={height - 3}>0°</text>
                <text x={width - left} y={height - 3} text-anchor="end">90°</text>
            </svg>
            <figcaption><b>{label}</b> <span class="mono">{words}</span></figcaption>
        </figure>
    );
}

export function Plots({explanation}: {explanation: Explanation}) {
    const hit = explanation.rays[selected.value.ray]?.hit;
    const terms = hit?.lights[selected.value.light];
    if (!hit || !terms) return null;
    const {isPhong} = pinnedIn.value;
    return (
        <section class="plots" aria-label="Factors over the angle">
            <Plot label="N·L" n={1} cosine={terms.n_l} />
            <Plot label={`(${isPhong ? 'R·V' : 'N·H'})^${short(hit.material.shininess)}`} n={hit.material.shininess} cosine={terms.s} />
        </section>
    );
}
