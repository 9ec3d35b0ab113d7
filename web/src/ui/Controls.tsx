// SPDX-License-Identifier: Apache-2.0
// The right side: everything of the scene that a page can set, in the order in which a student meets it: how surfaces are shaded,
// the lights, what goes wrong, the picture, the conventions. Each control edits the text where its format can say it.
import type {FieldInfo, LightInfo, Setting} from 'glint-wasm';

import {type Samples, samplesOf, samplesText} from '../engine/levels';
import {fieldValue, lightText, setField, setIntensity, switchLight} from '../store/lights';
import {isHere, reveal} from '../store/places';
import {setSetting} from '../store/settings';
import {info, overrides, settingOf} from '../store/state';
import {Field, capital} from './Field';
import {FogControls} from './Fog';
import {SkyControls} from './Sky';
import {Choice, NumberField, Slider, Switch} from './fields';

/** The words of "a | b | c", or nothing. */
export function wordsOf(setting: Setting): string[] | null {
    return setting.values.includes(' | ') ? setting.values.split(' | ') : null;
}

function Size() {
    // What has been set counts before the engine has answered: else a new height would bring the old width back.
    const [width, height] = (overrides.value['size'] ?? settingOf('size')?.value ?? '1x1').split('x').map(Number) as [number, number];
    const set = (w: number, h: number) => setSetting('size', `${Math.round(w)}x${Math.round(h)}`);
    return (
        <fieldset class="row">
            <legend>Size</legend>
            <NumberField label="Width" hidden value={width} min={1} max={65536} step={1} set={(w) => set(w, height)} />
            <span aria-hidden="true">×</span>
            <NumberField label="Height" hidden value={height} min={1} max={65536} step={1} set={(h) => set(width, h)} />
            <button class="quiet" aria-label="½: half as large" title="Half as large" onClick={() => set(width / 2, height / 2)} disabled={Math.min(width, height) < 64}>½</button>
            <button class="quiet" aria-label="×2: twice as large" title="Twice as large" onClick={() => set(width * 2, height * 2)} disabled={Math.max(width, height) > 4096}>×2</button>
        </fieldset>
    );
}

const textOf = (name: string) => settingOf(name)?.value ?? '';

export function Shading() {
    return (
        <section>
            <h2>Shading</h2>
            <Choice label="Shading" value={textOf('shading')} values={wordsOf(settingOf('shading')!)!} set={(v) => setSetting('shading', v)} />
            <Switch label="Shadows" on={textOf('shadows') === 'true'} set={(on) => setSetting('shadows', String(on))} />
            <Slider label="Reflections" value={Number(textOf('reflections'))} min={0} max={Math.max(10, Number(textOf('reflections')))} step={1}
                    set={(v) => setSetting('reflections', String(Math.round(v)))} />
        </section>
    );
}

/** The number of samples, whether only the pixels at edges have them, and whether they are jittered. */
function SampleControls({aa}: {aa: string}) {
    const now = samplesOf(aa), {n, threshold, jitter} = now;
    const set = (change: Partial<Samples>) => setSetting('aa', samplesText({...now, ...change}));
    return (
        <>
            <Slider label="Samples n×n" value={n} min={1} max={Math.max(4, n)} step={1}
                    text={`${n} by ${n}: ${n ** 2} per pixel`} set={(v) => set({n: Math.round(v)})} />
            {n > 1 && <Switch label="Only at edges" on={threshold !== null} set={(on) => set({threshold: on ? '0.05' : null})} />}
            {n > 1 && <Switch label="Jittered" hint="Each sample at a place of its own in its square" on={jitter} set={(on) => set({jitter: on})} />}
        </>
    );
}

export function PictureControls() {
    return (
        <section>
            <h2>Picture</h2>
            <SampleControls aa={textOf('aa')} />
            <Size />
            <Switch label="Transparent background" on={textOf('alpha') === 'true'} set={(on) => setSetting('alpha', String(on))} />
        </section>
    );
}

/** The intensity stands for the colors. */
const isColor = (field: FieldInfo) => field.name === 'color' || field.name === 'specular_color';

function Light({light, index}: {light: LightInfo; index: number}) {
    const said = lightText(index);
    const name = light.name || capital(light.kind);
    const swatch = light.color.map((c) => Math.round(255 * Math.max(0, Math.min(1, c)))).join(' ');
    const brightest = Math.max(...light.color);
    return (
        <fieldset class="light-card" data-light={index}>
            <legend class="for-readers">{`Light ${index + 1}: ${name}`}</legend>
            <div class="light-head">
                <Switch label={<><span class="swatch" style={{background: `rgb(${swatch})`}} aria-hidden="true" /> {name}</>}
                        on={said ? said.intensity !== 0 : brightest !== 0} disabled={!said} set={(on) => switchLight(index, on)} />
                <span class="kind">{light.name && light.name !== light.kind ? light.kind : ''}</span>
                {light.place && <button class="link" onClick={() => reveal(light.place)}>line {light.place.line}</button>}
            </div>
            {said ? (
                <>
                    <Slider label="Intensity" value={said.intensity} min={0} max={Math.max(2, Math.ceil(said.intensity))} step={0.01}
                            set={(v) => setIntensity(index, v)} />
                    {info.value!.light_fields.map((field) => {
                        const value = isColor(field) ? undefined : fieldValue(light, field);
                        if (value === undefined || !said.setField(field, value)) return null;
                        return <Field key={field.name} field={field} value={value} set={(v) => setField(index, field, v)} />;
                    })}
                </>
            ) : (
                <p class="note">{!light.place ? 'This light is a part of the format. Convert to .glint to change it here.'
                    : isHere(light.place) ? 'This light cannot be changed here in its present form in the text.'
                    : `This light is in ${light.place.file}. Convert to .glint to change it here.`}</p>
            )}
        </fieldset>
    );
}

/** Typical values for teaching: the effect of omitting something. */
const faults = [
    ['epsilon', '0', 'No epsilon', 'Shadow and mirror rays hit their own surface: acne'],
    ['clamp_cosines', 'false', 'N·L not clamped', 'Light from behind makes surfaces darker'],
    ['normalize', 'false', 'No normalisation', 'L, V, R and H keep their lengths'],
    ['specular_gate', 'false', 'Specular without gate', 'Highlights on sides that face away from the light'],
    ['shadow_stops_at_light', 'false', 'Shadows from beyond the light', 'Shapes beyond the light cast shadows, too'],
] as const;

export function Faults() {
    return (
        <section>
            <h2>Classic faults</h2>
            {faults.map(([key, fault, label, hint]) => {
                const setting = settingOf(key)!;
                if (setting.profile_value === fault) return null;  // the scene's own convention is no fault
                return (
                    <Switch key={key} label={label} name={key} hint={hint} on={setting.value === fault}
                            set={(on) => setSetting(key, on ? fault : setting.profile_value)} />
                );
            })}
        </section>
    );
}

function Origin({setting}: {setting: Setting}) {
    if (setting.origin === 'file' && setting.place)
        return <button class="link" onClick={() => reveal(setting.place)}>line {setting.place.line}</button>;
    return <span class="origin">{setting.origin === 'command' ? 'outside the text' : setting.origin === 'profile' ? `as ${info.value!.profile}` : ''}</span>;
}

function Convention({setting}: {setting: Setting}) {
    const words = wordsOf(setting);
    const set = (value: string) => setSetting(setting.name, value);
    return (
        <div class="convention">
            {words ? <Choice label={setting.name} value={setting.value} values={words} set={set} />
                : <NumberField label={setting.name} value={Number(setting.value)} min={0} set={(v) => set(String(v))} />}
            <Origin setting={setting} />
            <p class="note">{setting.description}</p>
        </div>
    );
}

export function Lights() {
    const {lights} = info.value!;
    return (
        <section>
            <h2>Lights</h2>
            {lights.slice(0, 24).map((light, i) => <Light key={i} light={light} index={i} />)}
            {lights.length === 0 && <p class="note">There are none: everything is black.</p>}
            {lights.length > 24 && <p class="note">And {lights.length - 24} more, in the text.</p>}
        </section>
    );
}

export function Epsilon() {
    const epsilon = settingOf('epsilon')!;
    const exponent = Number(epsilon.value) > 0 ? Math.log10(Number(epsilon.value)) : -13;
    return (
        <section>
            <h2>Epsilon</h2>
            <div class="slider">
                <label for="epsilon">10^{exponent <= -13 ? '−∞' : Number(exponent.toFixed(1))}</label>
                <input id="epsilon" type="range" min={-13} max={0} step={0.25} value={exponent} aria-label="Epsilon, as a power of ten"
                       onInput={(event) => {
                           const power = event.currentTarget.valueAsNumber;
                           setSetting('epsilon', power <= -13 ? '0' : String(Number((10 ** power).toPrecision(2))));
                       }} />
                <NumberField label="Epsilon" hidden value={Number(epsilon.value)} min={0} set={(v) => setSetting('epsilon', String(v))} />
            </div>
        </section>
    );
}

export function Conventions() {
    const {settings, profile} = info.value!;
    return (
        <section>
            <details>
                <summary><h2>Conventions</h2><span class="origin">{profile}</span></summary>
                {settings.filter((setting) => setting.is_convention).map((setting) => <Convention key={setting.name} setting={setting} />)}
            </details>
        </section>
    );
}

export function Controls() {
    const facts = info.value;
    if (!facts) return <p class="note">No scene yet.</p>;
    const shapes = Object.entries(facts.shapes).map(([kind, n]) => `${n} ${kind.replace('_', ' ')}${n === 1 ? '' : kind === 'box' ? 'es' : 's'}`);
    return (
        <>
            <Shading />
            <Lights />
            <Faults />
            <Epsilon />
            <FogControls />
            <SkyControls />
            <PictureControls />
            <Conventions />
            <p class="note">{shapes.join(', ')}; {facts.material_count} material{facts.material_count === 1 ? '' : 's'}.</p>
        </>
    );
}
