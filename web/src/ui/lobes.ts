// SPDX-License-Identifier: Apache-2.0
// How much light a surface sends into each direction.
import type {ExplainedHit, LightTerms} from 'glint-wasm';

/**
 * What the surface sends of the light into each direction of the plane of N and L, by the direction's angle from N in degrees (positive:
 * towards L). Diffuse light is alike in all directions. Null if the light adds nothing.
 */
export function lobes(hit: ExplainedHit, terms: LightTerms, isPhong: boolean): {diffuse: number; highlight: (angle: number) => number} | null {
    const {material} = hit, cosine = terms.n_l ?? 0, diffuse = Math.max(...terms.diffuse);
    if (terms.reason !== 'adds' || !(cosine > 0)) return null;
    const {color} = terms.light, factor = terms.diffuse_factor ?? cosine;
    // How much of the light's color arrives at the point: attenuation, spot and all else on the way.
    const arriving = Math.max(0, ...terms.diffuse.map((value, c) => value / (material.diffuse[c]! * color[c]! * factor)).filter(Number.isFinite)) || 1;
    const peak = terms.highlight === 'adds' ? Math.max(...material.specular.map((value, c) => value * color[c]!)) * arriving : 0;
    const incidence = (Math.acos(Math.min(1, cosine)) * 180) / Math.PI;
    // R is at -incidence, H halfway between L and the direction.
    const apart = (angle: number) => (isPhong ? angle + incidence : (angle + incidence) / 2);
    return {diffuse, highlight: (angle) => peak * Math.max(0, Math.cos((apart(angle) * Math.PI) / 180)) ** material.shininess};
}
