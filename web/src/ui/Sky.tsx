// SPDX-License-Identifier: Apache-2.0
// The light from all directions and the background gradient, in formats that have them.
import type {FieldInfo, SkyInfo} from 'glint-wasm';

import type {FieldValue} from '../store/lights';
import {isHere, offsetOf, reveal} from '../store/places';
import {format, info, services, text} from '../store/state';
import type {FogText} from '../text/edit';
import {Field} from './Field';
import {Choice, Switch} from './fields';

interface Block {
    title: string;
    switchLabel: string;
    word: string;
    key: string;
    kinds: [string, string];
    /** The line that turns it on. */
    line: string;
    item: SkyInfo | null;
    fields: FieldInfo[];
}

/** The block as given in the text; null if there is none, or if it cannot be changed there. */
function blockText({item, word, key}: Block): FogText | null {
    const offset = item?.place && isHere(item.place) ? offsetOf(item.place) : null;
    return offset === null ? null : (format.value?.block?.(text.value, offset, word, key) ?? null);
}

function BlockControls({block}: {block: Block}) {
    const {item, fields} = block;
    if (!item && !format.value?.addBlock) return null;
    const said = blockText(block);
    const values = item as unknown as Record<string, FieldValue | null | undefined> | null;
    const turn = (on: boolean) => {
        const edits = on ? format.value?.addBlock?.(text.value, block.line) : said?.remove();
        if (edits) services.editor?.apply(edits);
    };
    return (
        <section class={block.word}>
            <h2>{block.title}</h2>
            <Switch label={block.switchLabel} on={item !== null} disabled={item !== null && !said} set={turn} />
            {item?.place && <button class="link" onClick={() => reveal(item.place)}>line {item.place.line}</button>}
            {item && said && (
                <>
                    <Choice label={`Kind of ${block.title.toLowerCase()}`} value={item.kind} values={block.kinds} set={(kind) => services.editor?.apply(said.setKind(kind))} />
                    {fields.map((field) => {
                        const now = values?.[field.name];
                        return now !== undefined && now !== null && (
                            <Field key={field.name} field={{...field, label: `${block.title.toLowerCase()} ${field.label}`}} value={now} set={(to) => services.editor?.apply(said.setField(field, to))} />
                        );
                    })}
                </>
            )}
        </section>
    );
}

export function SkyControls() {
    const {occlusion, occlusion_fields, gradient, gradient_fields} = info.value!;
    return (
        <>
            <BlockControls block={{title: 'Occlusion', switchLabel: 'Light from all directions', word: 'occlusion', key: 'method',
                                   kinds: ['hashed', 'fixed'], line: 'occlusion { samples = 16  color = (0.6, 0.6, 0.6) }', item: occlusion, fields: occlusion_fields}} />
            <BlockControls block={{title: 'Gradient', switchLabel: 'Background gradient', word: 'background_gradient', key: 'type',
                                   kinds: ['sphere', 'plane'], line: 'background_gradient { bottom_color = (0.9, 0.92, 1)  top_color = (0.3, 0.5, 0.85) }',
                                   item: gradient, fields: gradient_fields}} />
        </>
    );
}
