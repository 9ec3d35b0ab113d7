// SPDX-License-Identifier: Apache-2.0
// The numbers of the object under the pinned pixel and of its material, as controls that edit the text.
import type {Explanation, Place} from 'glint-wasm';

import {isHere, offsetOf} from '../store/places';
import {format, services, text} from '../store/state';
import {numericEntries} from '../text/items';
import {NumberField} from './fields';
import {itemName} from './words';

const plain: Record<string, string> = {
    ambient: 'ambient, k_a', diffuse: 'diffuse, k_d', specular: 'specular, k_s', shininess: 'shininess, n', mirror: 'mirror, a',
    reflective: 'mirror, a', ior: 'refraction, ior', color: 'color', diffuse_color: 'k_d', ambient_color: 'k_a', specular_color: 'k_s',
    filter: 'filter (tinted)', transmit: 'transmit (clear)',
    emission: 'emission, k_e', emission_color: 'k_e',
};

/** In .cgfs, as in its book, `specular` is the exponent of the highlight. */
const plainIn: Record<string, Record<string, string>> = {'.cgfs': {specular: 'exponent, n'}};

function Block({offset, title}: {offset: number; title: string}) {
    const found = numericEntries(text.value, offset);
    if (!found || found.entries.length === 0) return null;
    return (
        <>
            <h4>{title}</h4>
            {found.entries.map(({key, numbers, set}) => (
                <fieldset key={key} class="row" title={key}>
                    <legend>{plainIn[format.value?.name ?? '']?.[key] ?? plain[key] ?? key}</legend>
                    {numbers.map((value, i) => (
                        <NumberField key={i} label={numbers.length === 1 ? `${title}: ${key}` : `${title}: ${key} ${i + 1}`} hidden value={value} step={Math.abs(value) >= 10 ? 1 : 0.05}
                                     set={(to) => services.editor?.apply(set(i, to))} />
                    ))}
                </fieldset>
            ))}
        </>
    );
}

export function ObjectControls({explanation}: {explanation: Explanation}) {
    const hit = explanation.rays[0]?.hit;
    if (!hit || !['.glint', '.cgfs'].includes(format.value?.name ?? '')) return null;
    const offset = ({file, line, column}: Partial<Place>) =>
        line !== undefined && file !== undefined && column !== undefined && isHere({file, line, column}) ? offsetOf({line, column}) : null;
    const shape = offset(hit.shape), material = offset(hit.material);
    if (shape === null && material === null) return null;
    return (
        <section class="object-controls" aria-label="This object">
            <h3>This object: {itemName(hit.shape)}</h3>
            {shape !== null && <Block offset={shape} title={hit.shape.kind.replace('_', ' ')} />}
            {material !== null && material !== shape && <Block offset={material} title={hit.material.name ? `material ${hit.material.name}` : 'material'} />}
        </section>
    );
}
