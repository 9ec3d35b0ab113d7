// SPDX-License-Identifier: Apache-2.0
// The controls of a field of a light or of the fog, from the engine's table.
import type {FieldInfo, Vec3} from 'glint-wasm';
import {useSignal} from '@preact/signals';

import type {FieldValue} from '../store/lights';
import {NumberField, Slider, Switch} from './fields';

export const capital = (text: string) => text[0]!.toUpperCase() + text.slice(1);

/** The names of a value's three numbers. */
const parts: Partial<Record<FieldInfo['type'], string[]>> = {
    point: ['x', 'y', 'z'], direction: ['x', 'y', 'z'], color: ['red', 'green', 'blue'], attenuation: ['c0', 'c1', 'c2'],
};

/** The controls of a field. */
export function Field({field, value, set}: {field: FieldInfo; value: FieldValue; set: (value: FieldValue) => void}) {
    if (typeof value === 'boolean') return <Switch label={capital(field.label)} hint={field.description} on={value} set={set} />;
    return <NumbersField field={field} value={value} set={set} />;
}

/** Places have sliders, other numbers are typed. */
function NumbersField({field, value, set}: {field: FieldInfo; value: number | Vec3; set: (value: number | Vec3) => void}) {
    const label = capital(field.label);
    const numbers = typeof value === 'number' ? [value] : value;
    const hasSliders = field.type === 'point' || field.type === 'direction';
    const reach = useSignal(0);
    const needed = Math.max(5, ...numbers.map((c) => Math.abs(c) * 1.25));
    if (hasSliders && needed > reach.value) reach.value = Number(needed.toPrecision(1)) >= needed ? Number(needed.toPrecision(1)) : Math.ceil(needed);
    const isWhole = field.type === 'whole';
    const setPart = (i: number, typed: number) => {
        const v = isWhole ? Math.round(typed) : typed;
        set(typeof value === 'number' ? v : (value.map((c, k) => (k === i ? v : c)) as Vec3));
    };
    if (hasSliders) {
        return (
            <>
                {numbers.map((c, i) => (
                    <Slider key={i} label={`${label} ${parts[field.type]![i]}`} value={c} min={-reach.value} max={reach.value} step={reach.value / 200}
                            set={(v) => setPart(i, v)} />
                ))}
            </>
        );
    }
    return (
        <fieldset class="row" title={field.description}>
            <legend>{label}</legend>
            {numbers.map((c, i) => (
                <NumberField key={i} label={numbers.length === 1 ? label : `${label} ${parts[field.type]![i]}`} hidden value={c} {...(isWhole ? {step: 1} : {})}
                             {...(field.min === undefined ? {} : {min: field.min})} {...(field.max == null ? {} : {max: field.max})}
                             set={(v) => setPart(i, v)} />
            ))}
        </fieldset>
    );
}
