// SPDX-License-Identifier: Apache-2.0
// Explains a pixel: the sum of its color, its ray tree, and each term of each light.
import type {Explanation, ExplainedHit, ExplainedRay, LightTerms, Vec3} from 'glint-wasm';
import type {ComponentChildren} from 'preact';

import {reveal} from '../store/places';
import {comparison, pinned, pinnedIn, selected} from '../store/state';
import {addedBy, goToRay, steps} from '../store/stepping';
import {Diagram} from './Diagram';
import {ObjectControls} from './ObjectControls';
import {Plots} from './Plots';
import {sentence} from './sentence';
import {SpaceInPanel} from './Space';
import {Stepper} from './Stepper';
import {hitTerms, lightTerms} from './terms';
import {byLight, css, hex, highlights, isBlack, itemName, layerNames, lightName, rayNames, reasons, short, shortColor, shortVector} from './words';

/** How the sum becomes the bytes. */
function byteWords({transfer, gamma}: Explanation): string {
    const value = gamma === 1 ? '' : `c^${short(gamma)}`;
    if (transfer === 'srgb') return `sRGB${value && `(${value})`} × 255`;
    return `${value} × 255`.trim();
}

function Sum({explanation}: {explanation: Explanation}) {
    const layers = layerNames.filter((name) => !isBlack(explanation.layers[name]));
    const most = Math.max(1, ...explanation.value, ...[0, 1, 2].map((c) => layers.reduce((sum, name) => sum + Math.max(0, explanation.layers[name][c]!), 0)));
    return (
        <section class="sum" aria-label="Sum of the color">
            {(['red', 'green', 'blue'] as const).map((channel, c) => (
                <div class="bar-row" key={channel}>
                    <span>{channel}</span>
                    <div class="bar">
                        {layers.map((name) => (
                            <span key={name} class={`part ${name}`} style={{width: `${(100 * Math.max(0, explanation.layers[name][c]!)) / most}%`}}
                                  title={`${name} ${short(explanation.layers[name][c])}`} />
                        ))}
                    </div>
                    <span class="mono">{short(explanation.value[c])}</span>
                </div>
            ))}
            <table class="layers">
                <thead><tr><th scope="col">part</th><th scope="col">red</th><th scope="col">green</th><th scope="col">blue</th></tr></thead>
                <tbody>
                    {layers.map((name) => (
                        <tr key={name}>
                            <th scope="row"><span class={`key ${name}`} aria-hidden="true" />{name}</th>
                            {explanation.layers[name].map((value, c) => <td key={c}>{short(value)}</td>)}
                        </tr>
                    ))}
                </tbody>
                <tfoot>
                    <tr data-sum><th scope="row">sum</th>{explanation.value.map((value, c) => <td key={c}>{short(value)}</td>)}</tr>
                    <tr><th scope="row">{byteWords(explanation)}{explanation.value.some((value) => value > 1) && ', at most 255'}</th>{explanation.bytes.map((value, c) => <td key={c}>{value}</td>)}</tr>
                </tfoot>
            </table>
        </section>
    );
}

/** A line of the outline; with a place it is a button that shows the place. */
function Term({name, value, place, formula}: {
    name: ComponentChildren; value: string; place?: {line?: number} | null | undefined; formula?: ComponentChildren;
}) {
    return (
        <div class="term">
            {place?.line !== undefined ? <button class="link" onClick={() => reveal(place)}>{name}</button> : <span>{name}</span>}
            {formula && <span class="formula">{formula}</span>}
            <span class="mono value">{value}</span>
        </div>
    );
}

function Light({terms, hit, ray, index}: {terms: LightTerms; hit: ExplainedHit; ray: number; index: number}) {
    const {isPhong} = pinnedIn.value;
    const isSelected = selected.value.ray === ray && selected.value.light === index;
    const {light} = terms;
    return (
        <details class="light-terms" open={isSelected} onToggle={(event) => {
            if ((event.currentTarget as HTMLDetailsElement).open) selected.value = {ray, light: index};
        }}>
            <summary>
                <span class={`dot ${terms.reason}`} aria-hidden="true" />
                {lightName(light)}{terms.sample !== undefined && `, sample ${terms.sample},`} {reasons[terms.reason]}
                {terms.blocker && <> by {itemName(terms.blocker.shape)}</>}
            </summary>
            <Term name="the light" place={light} formula={light.kind} value={shortColor(light.color)} />
            <Term name="L" place={light} formula={light.has_position ? 'P to the light' : 'towards the light'} value={shortVector(terms.to_light)} />
            {light.has_position && <Term name="distance" place={light} value={short(terms.distance)} />}
            {lightTerms.map(({name, label, usual}) => terms[name] !== usual && <Term key={name} name={label} place={light} value={short(terms[name] as number)} />)}
            {terms.spot !== 1 && <Term name="spot" place={light} value={short(terms.spot)} />}
            {terms.filters?.slice(0, 12).map(({shape, distance, factor}, i) => <Term key={i} name="passes" place={shape} formula={`${itemName(shape)}, ${short(distance)} away: times`} value={shortColor(factor)} />)}
            {terms.filter && !terms.filters && <Term name="filter" place={light} formula="transparent surfaces color the light: times" value={shortColor(terms.filter)} />}
            {terms.samples && <Term name="visible" place={light} formula={`${terms.samples.filter((s) => !s.blocked).length} of ${terms.samples.length} samples`} value={short(terms.visible)} />}
            <Term name="N·L" place={light} value={short(terms.n_l)} />
            <Term name={isPhong ? 'R·V' : 'N·H'} place={light} value={short(terms.s)} />
            {terms.highlight === 'adds'
                ? <Term name={isPhong ? <>(R·V)<sup>n</sup></> : <>(N·H)<sup>n</sup></>} place={hit.material} formula={`n = ${short(hit.material.shininess)}`} value={short(terms.power)} />
                : <p class="why">{highlights[terms.highlight]}</p>}
            {terms.blocker && <Term name="blocker" place={terms.blocker.shape} formula={`${short(terms.blocker.distance)} away`} value={shortVector(terms.blocker.point)} />}
            {hit.material.brilliance !== 1 && <Term name={<>(N·L)<sup>b</sup></>} place={hit.material} formula={`brilliance b = ${short(hit.material.brilliance)}`} value={short(terms.diffuse_factor)} />}
            {terms.phong_power !== undefined && <Term name={<>(R·V)<sup>n</sup></>} place={hit.material} formula={`second highlight, n = ${short(hit.material.phong_shininess)}`} value={short(terms.phong_power)} />}
            {terms.highlight_tint && <Term name="tint" place={hit.material} formula="of the metal's highlights" value={shortColor(terms.highlight_tint)} />}
            <Term name="diffuse" place={hit.material} formula={hit.material.brilliance === 1 ? 'k_d N·L I' : <>k_d (N·L)<sup>b</sup> I</>} value={shortColor(terms.diffuse)} />
            <Term name="specular" place={hit.material} formula={<>k_s {isPhong ? '(R·V)' : '(N·H)'}<sup>n</sup> I</>} value={shortColor(terms.specular)} />
        </details>
    );
}

const branchWords: Record<string, string> = {
    limit: 'not traced: the limit of reflections is reached',
    faint: 'not traced: its weight is too small',
    cut: 'not traced: this sample has too many rays',
};

/** An area light may have thousands of samples. */
const mostSamples = 64;

/** The samples of an area light, each of which is a light. */
function Samples({members, hit, ray}: {members: number[]; hit: ExplainedHit; ray: number}) {
    const all = members.map((i) => hit.lights[i]!), {light} = all[0]!;
    const adding = all.filter(({reason}) => reason === 'adds').length;
    const total = (part: 'diffuse' | 'specular') => [0, 1, 2].map((c) => all.reduce((sum, terms) => sum + terms[part][c]!, 0)) as Vec3;
    return (
        <details class="light-terms">
            <summary><span class={`dot ${adding > 0 ? 'adds' : all[0]!.reason}`} aria-hidden="true" />{lightName(light)}: {adding} of {all.length} samples add light</summary>
            <Term name="diffuse" place={light} formula="of all samples" value={shortColor(total('diffuse'))} />
            <Term name="specular" place={light} formula="of all samples" value={shortColor(total('specular'))} />
            {members.slice(0, mostSamples).map((i) => <Light key={i} terms={hit.lights[i]!} hit={hit} ray={ray} index={i} />)}
            {members.length > mostSamples && <p class="why">And {members.length - mostSamples} more samples.</p>}
        </details>
    );
}

/** The formula of a hit's contribution to the pixel. */
function sumWords(hit: ExplainedHit, fog: ExplainedRay['fog']): string {
    const {local_share: share, highlight_share: highlights = share} = hit;
    const areApart = highlights !== share && hit.lights.length > 0;  // as highlights on clear glass
    const terms = [
        'ambient', ...(hit.lights.length > 0 ? ['all diffuse', ...(areApart ? [] : ['all specular'])] : []), ...(isBlack(hit.emission) ? [] : ['emission']),
        ...(hit.occlusion ? ['sky'] : []),
    ];
    const sum = `${share === 1 ? '' : 'own share × '}${terms.length > 1 ? `(${terms.join(' + ')})` : 'ambient'}`;
    return `weight × ${areApart ? `(${sum} + ${highlights === 1 ? '' : `${short(highlights)} × `}all specular)` : sum}${fog && !isBlack(fog.added) ? ' + fog' : ''}`;
}

/** Where a texture is read, and what its color does. */
function textureText(texture: NonNullable<ExplainedHit['texture']>): string {
    const place = `${texture.name ? `${texture.name} ` : ''}at u ${short(texture.u)}, v ${short(texture.v)}`;
    const does = {multiply: 'multiplies color, k_a and k_d', multiply_all: 'multiplies color, k_a, k_d and k_e', replace: 'replaces the color'};
    const {column, next_column: next, next_column_weight: w} = texture;
    const colors = texture.row !== texture.next_row || column < 0 ? '' : column === next ? `, its color ${column + 1}` : `, between its colors ${column + 1} and ${next + 1}, w = ${short(w)}`;
    return `${place}${colors}; ${does[texture.mix]}`;
}

/** The holes of textures and the backs of one-sided surfaces that a ray passes. */
function Holes({ray}: {ray: ExplainedRay}) {
    const {holes = [], hole_count: count = 0} = ray;
    return (
        <>
            {holes.map(({shape, t, texture}, i) => (
                <Term key={i} name="passes" place={shape} value={itemName(shape)}
                    formula={`t = ${short(t)}, ${texture ? `a hole of its texture: alpha ${short(texture.alpha)}` : 'its back: the material is one-sided'}`} />
            ))}
            {count > holes.length && <p class="why">And {count - holes.length} more such places.</p>}
        </>
    );
}

/** The crossings of a ray's line with the shapes of the solid that it hits. */
function Crossings({hit}: {hit: ExplainedHit}) {
    return (
        <>
            {(hit.crossings ?? []).map(({operand, t, enters, surface, hit: isHit}, i) => (
                <Term key={i} name={enters ? 'into' : 'out of'} place={hit.shape} value={`shape ${operand + 1}`}
                    formula={`t = ${short(t)}${surface ? ', a surface of the solid' : ''}${isHit ? ': the hit' : ''}`} />
            ))}
        </>
    );
}

function Ray({explanation, number, depth}: {explanation: Explanation; number: number; depth: number}) {
    const ray = explanation.rays[number]!;
    const {hit} = ray;
    const added = addedBy(ray);
    const isNow = steps.value?.ray === number;
    const absorbed = hit?.weight.some((c, i) => c !== ray.weight[i]);
    return (
        <details class="ray-node" open={depth < 3} data-ray={number}>
            <summary aria-current={isNow ? 'step' : undefined} onClick={() => {
                if (hit && selected.value.ray !== number) selected.value = {ray: number, light: 0};
                goToRay(number);
            }}>
                <span class={`ray-key ${ray.kind}`} aria-hidden="true" />
                <b>{rayNames[ray.kind]}</b> {hit ? <>hits {itemName(hit.shape)}</> : ray.beyond_limit ? 'is beyond the limit of reflections' : 'leaves the scene'}
                <span class="swatch" style={{background: css(added)}} aria-hidden="true" />
            </summary>
            {ray.inside_object && <Term name="fog" formula="the ray is inside an object" value="none" />}
            {ray.fog && ray.fog.visibility !== 1 && <Term name="fog" formula={`${short(ray.fog.visibility)} of the light is seen; the fog adds`} value={shortColor(ray.fog.added)} />}
            <Holes ray={ray} />
            {hit ? (
                <>
                    <Term name="object" place={hit.shape} formula={`t = ${short(ray.t)}`} value={itemName(hit.shape)} />
                    <Term name="P" place={hit.shape} value={shortVector(hit.point)} />
                    <Term name="N" place={hit.shape} formula={`${hit.side} side${hit.normal_turned ? ', turned' : ''}`} value={shortVector(hit.normal)} />
                    <Crossings hit={hit} />
                    {hit.texture && <Term name="texture" place={hit.material} formula={textureText(hit.texture)} value={shortColor(hit.texture.color)} />}
                    <Term name="weight" place={ray.parent === null ? null : explanation.rays[ray.parent]!.hit?.material} formula={absorbed ? 'of this ray in the pixel, after glass and fog' : 'of this ray in the pixel'} value={shortColor(hit.weight)} />
                    {hit.opacity !== undefined && <Term name="opacity" place={hit.material} formula="the rest is what is behind" value={short(hit.opacity)} />}
                    {hit.outline !== undefined && <Term name="outline" place={hit.material} formula="times the diffuse light" value={short(hit.outline)} />}
                    {hit.local_share !== 1 && <Term name="own share" place={hit.material} formula={hit.opacity === undefined ? '1 − mirror − glass' : 'of its own light'} value={short(hit.local_share)} />}
                    {hitTerms.map(({name, label, usual}) => hit[name] !== usual && <Term key={name} name={label} place={hit.material} value={short(hit[name] as number)} />)}
                    {hit.fade && <Term name="fades" place={hit.material} formula="what leaves the object here: times" value={shortColor(hit.fade)} />}
                    <Term name="ambient" place={hit.material} formula="k_a I_a" value={shortColor(hit.ambient)} />
                    {byLight(hit.lights).map((members) => (members.length === 1
                        ? <Light key={members[0]} terms={hit.lights[members[0]!]!} hit={hit} ray={number} index={members[0]!} />
                        : <Samples key={members[0]} members={members} hit={hit} ray={number} />))}
                    {!isBlack(hit.emission) && <Term name="emission" place={hit.material} formula="k_e" value={shortColor(hit.emission)} />}
                    {hit.occlusion && <Term name="sky" place={hit.material} formula={`k_d color f: ${hit.occlusion.blocked} of ${hit.occlusion.samples} samples are blocked, f = ${short(hit.occlusion.factor)}`} value={shortColor(hit.occlusion.light)} />}
                    <Term name="adds to the pixel" value={shortColor(added)} />
                    <p class="why">= {sumWords(hit, ray.fog)}</p>
                    {(['reflected', 'transmitted'] as const).map((side) => {
                        const branch = hit[side];
                        if (branch.state === 'none') return null;
                        if (branch.ray !== undefined) return <Ray key={side} explanation={explanation} number={branch.ray} depth={depth + 1} />;
                        return <p class="why" key={side}>{side === 'reflected' ? 'Mirror ray' : 'Ray through glass'} {branchWords[branch.state]}.</p>;
                    })}
                </>
            ) : <Term name="background" formula="times its weight" value={shortColor(ray.background!)} />}
        </details>
    );
}

export function Inspector() {
    const explanation = pinned.value;
    if (!explanation) {
        return (
            <div class="empty">
                <p><b>Click a pixel</b> of the picture to take it apart.</p>
                <p class="note">You see its rays, every term of the lighting equation, and how they add up to its color. With the keyboard: focus the picture, point with the arrow keys, press Enter.</p>
                <SpaceInPanel />
            </div>
        );
    }
    const compare = comparison.value, {side} = pinnedIn.value;
    const roots = explanation.rays.map((ray, i) => ({ray, i})).filter(({ray}) => ray.parent === null);
    return (
        <div class="inspector" data-pixel={explanation.pixel.join(',')}>
            <div class="pixel-head">
                <span class="swatch large" style={{background: hex(explanation.bytes)}} aria-hidden="true" />
                <h2>Pixel ({explanation.pixel.join(', ')})</h2>
                <span class="mono">{explanation.bytes.join(' ')}</span>
                <button class="quiet" aria-label="Unpin the pixel" onClick={() => {
                    pinned.value = null;
                }}>✕</button>
            </div>
            {compare && <p class="note">In the {side === 'first' ? 'left' : 'right'} picture: {compare.key} = {side === 'first' ? compare.a : compare.b}.</p>}
            <p class="sentence">{sentence(explanation)}</p>
            <Sum explanation={explanation} />
            <Diagram explanation={explanation} />
            <Plots explanation={explanation} />
            <SpaceInPanel />
            <Stepper />
            <section class="tree" aria-label="Rays">
                <h3>Rays</h3>
                {roots.slice(0, 64).map(({ray, i}) => (
                    <div key={i}>
                        {explanation.samples > 1 && <p class="note">Sample {ray.sample[0] + 1}, {ray.sample[1] + 1} of {explanation.samples} × {explanation.samples}</p>}
                        <Ray explanation={explanation} number={i} depth={0} />
                    </div>
                ))}
                {roots.length > 64 && <p class="note">And {roots.length - 64} more samples.</p>}
            </section>
            <ObjectControls explanation={explanation} />
        </div>
    );
}
