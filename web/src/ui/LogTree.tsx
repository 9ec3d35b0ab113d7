// SPDX-License-Identifier: Apache-2.0
// The values of a pixel of the user's log beside what they should be: a table for each ray, in groups for its lights.
import type {DiagnosedRow} from 'glint-wasm';
import {useId} from 'preact/hooks';

import {type LoggedPixel, choosePixel, chosenPixel, loggedPixels} from '../store/own_log';
import {loggedLight, rayName, valuesOf} from './log_words';

const marks = {right: '', wrong: '✗', unknown: '?'} as const;
const words = {right: '', wrong: 'wrong', unknown: 'not judged'} as const;

const keyOf = ({ray, light, quantity}: DiagnosedRow) => [ray?.number ?? '', light?.index ?? '', quantity].join();

/** Shows a row of a pixel that has just been chosen. */
function goToRow(row: DiagnosedRow) {
    requestAnimationFrame(() => {
        const element = document.querySelector<HTMLElement>(`.log-table [data-row="${keyOf(row)}"]`);
        element?.focus({preventScroll: true});
        element?.scrollIntoView({block: 'center'});
    });
}

export function showRow(row: DiagnosedRow) {
    choosePixel(row.pixel);
    goToRow(row);
}

function Row({row, isFirst}: {row: DiagnosedRow; isFirst: boolean}) {
    const {yours, expected} = valuesOf(row);
    return (
        <tr class={`${row.verdict}${isFirst ? ' first' : ''}`} data-row={keyOf(row)} tabIndex={-1}>
            <th scope="row" title={row.line > 0 ? `line ${row.line} of the log` : undefined}>
                <span class="name"><span class="mark" aria-hidden="true">{marks[row.verdict]}</span>{row.quantity}</span>
                <span class="for-readers"> {isFirst ? 'wrong, the first difference' : words[row.verdict]}</span>
                {isFirst && <span class="badge" aria-hidden="true">first</span>}
            </th>
            <td>{yours}</td>
            <td>{expected}</td>
        </tr>
    );
}

/** Consecutive rows for which a key is the same. */
function grouped(rows: readonly DiagnosedRow[], keyOf: (row: DiagnosedRow) => number | undefined): DiagnosedRow[][] {
    const groups: DiagnosedRow[][] = [];
    for (const row of rows) {
        const group = groups.at(-1);
        if (group && keyOf(group[0]!) === keyOf(row)) group.push(row);
        else groups.push([row]);
    }
    return groups;
}

function RayTable({rows, first}: {rows: DiagnosedRow[]; first: DiagnosedRow | undefined}) {
    const {ray} = rows[0]!;
    return (
        <table class="log-table" style={{marginLeft: `${8 * Math.min(4, ray?.generation ?? 0)}px`}}>
            <caption>{ray ? <><span class={`ray-key ${ray.kind === 'glass' ? 'transmitted' : ray.kind}`} aria-hidden="true" />{rayName(ray)}</> : 'The pixel'}</caption>
            <thead><tr><th scope="col">quantity</th><th scope="col">yours</th><th scope="col">should be</th></tr></thead>
            {grouped(rows, ({light}) => light?.index).map((group, i) => (
                <tbody key={i}>
                    {(i > 0 || group[0]!.light) && <tr class="of"><th colSpan={3} scope="rowgroup">{group[0]!.light ? loggedLight(group[0]!.light) : 'the surface'}</th></tr>}
                    {group.map((row, k) => <Row key={k} row={row} isFirst={row === first} />)}
                </tbody>
            ))}
        </table>
    );
}

/** A menu of the pixels, and buttons that go through those with a difference. */
function Choice({pixel}: {pixel: LoggedPixel}) {
    const id = useId();
    const all = [...loggedPixels.value.values()], wrong = all.filter(({first}) => first >= 0);
    const go = (by: 1 | -1) => {
        const at = all.indexOf(pixel), list = by > 0 ? wrong : [...wrong].reverse();
        const next = list.find((one) => (all.indexOf(one) - at) * by > 0) ?? list[0];
        if (next) choosePixel(next.at);
    };
    return (
        <div class="choice log-choice">
            <label for={id}>Pixel</label>
            <select id={id} value={pixel.at.join()} onChange={(event) => choosePixel(loggedPixels.value.get(event.currentTarget.value)!.at)}>
                {all.map(({at, rows, first}) => <option key={at.join()} value={at.join()}>{at.join(', ')}{first >= 0 ? `: ${rows[first]!.quantity} is wrong` : ': no difference'}</option>)}
            </select>
            <button class="quiet" disabled={wrong.length === 0} aria-label="The wrong pixel before" title="The wrong pixel before" onClick={() => go(-1)}>‹</button>
            <button class="quiet" disabled={wrong.length === 0} aria-label="The next wrong pixel" title="The next wrong pixel" onClick={() => go(1)}>›</button>
        </div>
    );
}

export function LogTree() {
    const pixel = chosenPixel.value;
    if (!pixel) return null;
    const first = pixel.rows[pixel.first];
    return (
        <section class="log-tree" aria-label="Values of a pixel" data-pixel={pixel.at.join()}>
            <h3>All values of a pixel</h3>
            <Choice pixel={pixel} />
            {first && (
                <p class="note">
                    The first difference: <button class="link" onClick={() => goToRow(first)}>{[...(first.ray ? [rayName(first.ray).toLowerCase()] : []), ...(first.light ? [loggedLight(first.light)] : []), first.quantity].join(', ')}</button>
                </p>
            )}
            {grouped(pixel.rows, ({ray}) => ray?.number ?? -1).map((rows, i) => <RayTable key={i} rows={rows} first={first} />)}
        </section>
    );
}
