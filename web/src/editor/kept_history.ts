// SPDX-License-Identifier: Apache-2.0
// What undo and redo take back, as JSON, so that it survives a reload. CodeMirror's own JSON of its history lacks the effects,
// which here are the document states.
import {historyField} from '@codemirror/commands';
import {EditorState, type Extension, type StateEffect, type StateEffectType} from '@codemirror/state';
import type {SceneText} from 'glint-wasm';

import type {DocumentState} from './editor';

/** An event; `effects` is what its type does not declare. */
interface Event {
    effects: readonly StateEffect<unknown>[];
    toJSON(): Record<string, unknown>;
}
interface History {
    done: Event[];
    undone: Event[];
}
/** `state`: that of the document before the event; without includes: those of the gallery. */
type KeptEvent = Record<string, unknown> & {state?: Omit<DocumentState, 'includes'> & {includes?: SceneText[] | undefined}};
export interface KeptHistory {
    done: KeptEvent[];
    undone: KeptEvent[];
}

/** Characters of JSON that are kept; the oldest events are given up. */
const largest = 600_000;

function newest(events: KeptEvent[], most: number): KeptEvent[] {
    let size = 0, from = events.length;
    while (from > 0 && (size += JSON.stringify(events[from - 1]).length) <= most) --from;
    return events.slice(from);
}

/** `usual`: the includes that need not be kept. */
export function keptHistory(state: EditorState, changed: StateEffectType<DocumentState>, usual: readonly SceneText[]): KeptHistory {
    const {done, undone} = state.field(historyField) as History;
    const kept = (event: Event): KeptEvent => {
        const before = event.effects.find((one) => one.is(changed))?.value as DocumentState | undefined;
        return {...event.toJSON(), ...(before ? {state: {...before, includes: before.includes === usual ? undefined : before.includes}} : {})};
    };
    return {done: newest(done.map(kept), largest), undone: newest(undone.map(kept), largest)};
}

/** The state of an editor with a text and a kept history. */
export function stateWith(text: string, kept: KeptHistory, extensions: Extension, changed: StateEffectType<DocumentState>, usual: SceneText[]): EditorState {
    const json = {doc: text, selection: {ranges: [{anchor: 0, head: 0}], main: 0}, history: kept};
    const state = EditorState.fromJSON(json, {extensions}, {history: historyField}), read = state.field(historyField) as History;
    for (const list of ['done', 'undone'] as const) {
        read[list].forEach((event, i) => {
            const before = kept[list][i]!.state;
            if (before) event.effects = [changed.of({...before, includes: before.includes ?? usual})];
        });
    }
    return state;
}

/** The greatest number of a document in it. */
export const lastIdOf = ({done, undone}: KeptHistory) => Math.max(0, ...[...done, ...undone].map(({state}) => state?.id ?? 0));
