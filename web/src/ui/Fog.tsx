// SPDX-License-Identifier: Apache-2.0
// The fog, in formats that have it.
import type {FieldInfo} from 'glint-wasm';

import {fogText, switchFog} from '../store/fog';
import type {FieldValue} from '../store/lights';
import {reveal} from '../store/places';
import {format, info, services} from '../store/state';
import {Field} from './Field';
import {Choice, Switch} from './fields';

export function FogControls() {
    const {fog, fog_fields} = info.value!;
    if (!fog && !format.value?.addFog) return null;
    const said = fogText();
    const value = (field: FieldInfo) => (fog as unknown as Record<string, FieldValue | undefined> | null)?.[field.name];
    return (
        <section class="fog">
            <h2>Fog</h2>
            <Switch label="In fog" on={fog !== null} disabled={fog !== null && !said} set={switchFog} />
            {fog?.place && <button class="link" onClick={() => reveal(fog.place)}>line {fog.place.line}</button>}
            {fog && said && (
                <>
                    <Choice label="Kind of fog" value={fog.kind} values={['linear', 'exp', 'exp2']} set={(kind) => services.editor?.apply(said.setKind(kind))} />
                    {fog_fields.map((field) => {
                        const now = value(field);
                        return now !== undefined && (
                            <Field key={field.name} field={{...field, label: `fog ${field.label}`}} value={now} set={(to) => services.editor?.apply(said.setField(field, to))} />
                        );
                    })}
                </>
            )}
        </section>
    );
}
