// SPDX-License-Identifier: Apache-2.0
// The page's input fields. While a field is edited, it shows the user's input; else the scene's value.
import {useSignal} from '@preact/signals';
import type {ComponentChildren} from 'preact';
import {useId} from 'preact/hooks';

import {chosenFiles} from '../given_files';
import {openFiles} from '../store/opening';
import {services} from '../store/state';

/** `name`: the setting's key, shown beside the label. */
export function Switch({label, on, set, disabled, hint, name}: {
    label: ComponentChildren; on: boolean; set: (on: boolean) => void; disabled?: boolean; hint?: string; name?: string;
}) {
    return (
        <label class="switch" title={hint}>
            <input type="checkbox" role="switch" checked={on} disabled={disabled}
                   onChange={(event) => set(event.currentTarget.checked)} />
            <span class="track" aria-hidden="true" />
            <span>{label}</span>
            {name && <code class="key-name" aria-hidden="true">{name}</code>}
        </label>
    );
}

export function Slider({label, value, min, max, step, set, disabled, text}: {
    label: string; value: number; min: number; max: number; step: number; set: (value: number) => void; disabled?: boolean;
    text?: string;
}) {
    const draft = useSignal<number | null>(null);
    const id = useId();
    const shown = draft.value ?? value;
    return (
        <div class="slider">
            <label for={id}>{label}</label>
            <input id={id} type="range" min={min} max={max} step={step} value={shown} disabled={disabled} aria-valuetext={text}
                   onInput={(event) => {
                       const now = event.currentTarget.valueAsNumber, isDragged = draft.value !== null;
                       draft.value = now;
                       services.editor?.edit(isDragged, () => set(now));
                   }}
                   onChange={() => {
                       draft.value = null;
                   }}
                   onBlur={() => {
                       draft.value = null;
                   }} />
            <NumberField label={label} hidden value={value} min={min} step={step} set={set} disabled={disabled} />
        </div>
    );
}

/** `value` moved by a step, within its range, without the digits that rounding adds. */
function moved(value: number, by: number, min = -Infinity, max = Infinity): number {
    return Math.min(max, Math.max(min, Number((value + by).toPrecision(12))));
}

/** A number field. `hidden`: its label is for screen readers only. The arrow keys move it by a step. */
export function NumberField({label, value, set, min, max, step = 1, disabled, hidden}: {
    label: string; value: number; set: (value: number) => void; min?: number; max?: number; step?: number; disabled?: boolean | undefined;
    hidden?: boolean;
}) {
    const draft = useSignal<string | null>(null);
    const id = useId();
    return (
        <div class="number">
            <label for={id} class={hidden ? 'for-readers' : ''}>{label}</label>
            {/* With a step of its own, the browser would call all numbers invalid that are no whole steps from the least one. */}
            <input id={id} type="number" value={draft.value ?? String(Number(value.toPrecision(6)))} min={min} max={max} step="any" disabled={disabled}
                   onInput={(event) => {
                       draft.value = event.currentTarget.value;
                       const typed = event.currentTarget.valueAsNumber;
                       if (Number.isFinite(typed) && event.currentTarget.validity.rangeUnderflow === false &&
                           event.currentTarget.validity.rangeOverflow === false) set(typed);
                   }}
                   onKeyDown={(event) => {
                       if ((event.key !== 'ArrowUp' && event.key !== 'ArrowDown') || event.altKey || event.ctrlKey || event.metaKey) return;
                       event.preventDefault();
                       draft.value = null;
                       set(moved(value, (event.key === 'ArrowUp' ? 1 : -1) * step * (event.shiftKey ? 10 : 1), min, max));
                   }}
                   onBlur={() => {
                       draft.value = null;
                   }} />
        </div>
    );
}

/** A text field; its value is applied when it is valid. */
export function TextField({label, value, set}: {label: string; value: string; set: (value: string) => void}) {
    const draft = useSignal<string | null>(null);
    const id = useId();
    return (
        <div class="choice">
            <label for={id}>{label}</label>
            <input id={id} type="text" value={draft.value ?? value}
                   onInput={(event) => {
                       draft.value = event.currentTarget.value;
                   }}
                   onChange={(event) => {
                       draft.value = null;
                       set(event.currentTarget.value);
                   }} />
        </div>
    );
}

/** Opens files of the user, or a folder. */
export function FileButton({label, opened, folder}: {label: string; opened?: () => void; folder?: boolean}) {
    return (
        <label class="button file">{label}
            <input type="file" multiple {...(folder ? {webkitdirectory: true} : {})} onChange={(event) => {
                void openFiles(chosenFiles(event.currentTarget.files ?? []));
                event.currentTarget.value = '';
                opened?.();
            }} />
        </label>
    );
}

export function Choice({label, value, values, set, hidden}: {
    label: string; value: string; values: readonly string[]; set: (value: string) => void; hidden?: boolean;
}) {
    const id = useId();
    return (
        <div class="choice">
            <label for={id} class={hidden ? 'for-readers' : ''}>{label}</label>
            <select id={id} value={value} onChange={(event) => set(event.currentTarget.value)}>
                {values.map((one) => <option key={one} value={one}>{one}</option>)}
            </select>
        </div>
    );
}
