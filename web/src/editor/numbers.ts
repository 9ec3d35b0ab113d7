// SPDX-License-Identifier: Apache-2.0
// Numbers in the text change when they are dragged to the left or right, or by Alt and the arrow keys.
import {isolateHistory} from '@codemirror/commands';
import {syntaxTree} from '@codemirror/language';
import {type EditorState, Prec, Transaction} from '@codemirror/state';
import {EditorView, keymap} from '@codemirror/view';

interface Span {
    from: number;
    to: number;
}

/** The number at an offset, which may be its end; null if there is none, or in a comment or a string. */
function numberAt(state: EditorState, at: number): Span | null {
    for (const side of [1, -1] as const) {
        const {name, from, to} = syntaxTree(state).resolveInner(at, side);
        if (name === 'number' && Number.isFinite(Number(state.sliceDoc(from, to)))) return {from, to};
    }
    return null;
}

/** A number, changed by so many of its steps: 1 for a whole number, 0.01 or the last digit for others, 2% with an exponent. */
export function stepped(said: string, steps: number): string {
    const value = Number(said);
    if (/e/i.test(said)) return String(Number((value * 1.02 ** steps).toPrecision(3)));
    const digits = said.includes('.') ? Math.max(2, said.split('.')[1]!.length) : 0;
    const next = Number((value + Math.round(steps) * 10 ** -digits).toFixed(digits));
    return String(next === 0 ? 0 : next);  // not -0
}

/** Pixels of a step: whole numbers that are small would change too fast. */
const pixelsOf = (said: string) => (/[.e]/i.test(said) || Math.abs(Number(said)) >= 100 ? 1 : 6);

/** Replaces the number by another one. `again`: is undone together with the change before. */
function change(view: EditorView, span: Span, insert: string, again: boolean): Span {
    view.dispatch({
        changes: {...span, insert},
        // Changes of a composition are joined whatever the time between them.
        annotations: again ? Transaction.userEvent.of('input.type.compose') : isolateHistory.of('before'),
    });
    return {from: span.from, to: span.from + insert.length};
}

function drag(view: EditorView, start: PointerEvent, span: Span) {
    const said = view.state.sliceDoc(span.from, span.to);
    let last = said, now = span;
    const moved = (event: PointerEvent) => {
        if (event.pointerId !== start.pointerId) return;
        const distance = event.clientX - start.clientX;
        if (last === said && now === span && Math.abs(distance) < 4) return;
        const next = stepped(said, distance / pixelsOf(said));
        if (next === last) return;
        if (view.state.sliceDoc(now.from, now.to) !== last) return ended();  // the text is another one
        now = change(view, now, next, now !== span);
        last = next;
    };
    const ended = () => {
        removeEventListener('pointermove', moved);
        removeEventListener('pointerup', up);
        removeEventListener('pointercancel', ended);
    };
    const up = (event: PointerEvent) => {
        ended();
        if (now !== span || event.pointerType !== 'mouse') return;
        // It was a click.
        const at = view.posAtCoords({x: event.clientX, y: event.clientY});
        if (at !== null) view.dispatch({selection: {anchor: at}});
        view.focus();
    };
    addEventListener('pointermove', moved);
    addEventListener('pointerup', up);
    addEventListener('pointercancel', ended);
}

/** The number under a pointer without modifiers; with them, text is selected. */
function numberUnder(view: EditorView, event: MouseEvent): Span | null {
    if (event.button !== 0 || event.shiftKey || event.ctrlKey || event.metaKey || event.altKey || event.detail > 1) return null;
    if (!(event.target instanceof Element) || !event.target.classList.contains('tok-number')) return null;
    const at = view.posAtCoords({x: event.clientX, y: event.clientY});
    return at === null ? null : numberAt(view.state, at);
}

function step(view: EditorView, by: number): boolean {
    const {main} = view.state.selection;
    const span = main.empty ? numberAt(view.state, main.head) : null;
    if (!span) return false;
    const said = view.state.sliceDoc(span.from, span.to);
    change(view, span, stepped(said, /[.e]/i.test(said) ? 10 * by : by), false);
    return true;
}

export const numbers = [
    EditorView.domEventHandlers({
        pointerdown(event, view) {
            const span = numberUnder(view, event);
            if (span) drag(view, event, span);
            return false;
        },
        // Else the text would be selected.
        mousedown: (event, view) => numberUnder(view, event) !== null,
        // A number is a word: what is typed next replaces all of it.
        dblclick(event, view) {
            const at = view.posAtCoords({x: event.clientX, y: event.clientY});
            const span = at === null ? null : numberAt(view.state, at);
            if (span) view.dispatch({selection: {anchor: span.from, head: span.to}});
            return span !== null;
        },
    }),
    // touch-action has no effect on the number itself, which is inline. Lines are wrapped: they need no horizontal panning.
    EditorView.theme({'.tok-number': {cursor: 'ew-resize'}, '.cm-content': {touchAction: 'pan-y pinch-zoom'}}),
    Prec.high(keymap.of([{key: 'Alt-ArrowUp', run: (view) => step(view, 1)}, {key: 'Alt-ArrowDown', run: (view) => step(view, -1)}])),
];
