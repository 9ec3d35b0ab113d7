// SPDX-License-Identifier: Apache-2.0
// The vectors at a hit, in 3D: N is vertical, the others are relative to it, viewed slightly from above.
import type {Explanation, Vec3} from 'glint-wasm';

import {add, cross, dot, scaled, unit} from '../camera';
import {pinnedIn, selected} from '../store/state';
import {lobes} from './lobes';
import {itemName, lightName} from './words';

const degrees = (a: Vec3, b: Vec3) => (Math.acos(Math.max(-1, Math.min(1, dot(a, b)))) * 180) / Math.PI;

const angles = Array.from({length: 181}, (_, i) => i - 90);

export function Diagram({explanation}: {explanation: Explanation}) {
    const {ray, light} = selected.value;
    const hit = explanation.rays[ray]?.hit;
    const terms = hit?.lights[light];
    if (!hit || !terms) return null;
    const n = unit(hit.normal), l = unit(terms.to_light), v = unit(hit.to_eye);
    const r = add(scaled(n, 2 * dot(n, l)), l, -1), h = unit(add(l, v));
    // The view's axes: L's component in the surface points left.
    const along = add(l, n, -dot(l, n));
    const fallback = cross(n, Math.abs(n[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0]);
    const left = unit(Math.hypot(...along) > 1e-6 ? along : fallback);
    const depth = cross(left, n);
    const lift = 0.32;  // sine of the angle from which the surface is seen
    const at = (p: Vec3): [number, number] => {
        const x = -dot(p, left), y = dot(p, depth), z = dot(p, n);
        return [150 + 96 * x, 128 - 96 * (z * Math.sqrt(1 - lift * lift) + y * lift)];
    };
    const {isPhong} = pinnedIn.value;
    const vectors: [string, Vec3, boolean][] = [['N', n, true], ['L', l, true], ['V', v, true], ['R', r, isPhong], ['H', h, !isPhong]];
    const sizes = [
        ['N', 'L', degrees(n, l)], ['N', 'V', degrees(n, v)], ['R', 'V', degrees(r, v)], ['N', 'H', degrees(n, h)],
    ] as const;
    const [cx, cy] = at([0, 0, 0]);
    const sent = lobes(hit, terms, isPhong);
    const largest = sent ? Math.max(...angles.map((angle) => sent.diffuse + sent.highlight(angle)), 1e-9) : 1;
    const outline = (amount: (angle: number) => number) => `${angles.map((angle, i) => {
        const turn = (angle * Math.PI) / 180;
        const [x, y] = at(scaled(add(scaled(n, Math.cos(turn)), left, Math.sin(turn)), amount(angle) / largest));
        return `${i === 0 ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`;
    }).join('')}Z`;
    return (
        <section class="diagram" aria-label="Vectors at the hit">
            <h3>At {itemName(hit.shape)}, with {lightName(terms.light)}</h3>
            <div class="diagram-body">
                <svg viewBox="0 0 300 190" role="img"
                     aria-label={`The vectors at the hit: ${sizes.map(([a, b, d]) => `${a} and ${b} are ${d.toFixed(1)} degrees apart`).join(', ')}`}>
                    <ellipse cx={cx} cy={cy} rx={96} ry={96 * lift} class="ground" />
                    {sent && <path class="lobe highlight" d={outline((angle) => sent.diffuse + sent.highlight(angle))} />}
                    {sent && <path class="lobe diffuse" d={outline(() => sent.diffuse)} />}
                    {vectors.map(([name, vector, used]) => {
                        const [x, y] = at(vector);
                        const [fx, fy] = at(add(vector, n, -dot(vector, n)));
                        const [tx, ty] = at(scaled(vector, 1.14));
                        return (
                            <g key={name} class={`vector ${name}${used ? '' : ' unused'}`}>
                                {name !== 'N' && <path class="foot" d={`M${cx} ${cy}L${fx} ${fy}L${x} ${y}`} />}
                                <line x1={cx} y1={cy} x2={x} y2={y} />
                                <circle cx={x} cy={y} r={3} />
                                <text x={tx} y={ty + 4} text-anchor="middle">{name}</text>
                            </g>
                        );
                    })}
                </svg>
                <dl class="angles">
                    {sizes.map(([a, b, d]) => (
                        <div key={a + b} class={(a === 'R' && !isPhong) || (b === 'H' && isPhong) ? 'unused' : ''}>
                            <dt>∠({a}, {b})</dt><dd class="mono">{d.toFixed(1)}°</dd>
                        </div>
                    ))}
                </dl>
            </div>
            {sent && <p class="note">The lobes: how much of this light the surface sends into each direction in the plane of N and L. Inside, the diffuse light, alike in all directions; around it, the highlight.</p>}
        </section>
    );
}
