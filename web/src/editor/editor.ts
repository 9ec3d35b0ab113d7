// SPDX-License-Identifier: Apache-2.0
// The editor of the scene's text. It is in a shadow root, where CodeMirror's styles need no <style> element: the page's
// Content-Security-Policy forbids one.
import {defaultKeymap, history, historyKeymap, invertedEffects, isolateHistory, redo, redoDepth, undo, undoDepth} from '@codemirror/commands';
import {bracketMatching, indentUnit} from '@codemirror/language';
import {type Diagnostic as Mark, lintGutter, setDiagnostics} from '@codemirror/lint';
import {openSearchPanel, search, searchKeymap} from '@codemirror/search';
import {Annotation, Compartment, EditorState, type Extension, StateEffect, Transaction} from '@codemirror/state';
import {EditorView, drawSelection, highlightActiveLine, highlightActiveLineGutter, keymap, lineNumbers} from '@codemirror/view';

import type {SceneInfo, SceneText} from 'glint-wasm';

import {parts} from '../gallery';
import type {Edit} from '../text/edit';
import {longestLine, withShortLines} from '../text/long_lines';
import {completion} from './completion';
import {type KeptHistory, keptHistory, stateWith} from './kept_history';
import {languageOf} from './language';
import {numbers} from './numbers';
import {PlaceTracker} from './place_tracker';

/** The parts of a scene that are not in its text; undo restores them with the text. */
export interface DocumentState {
    /** Another scene has another number; a changed or converted one keeps it. */
    id: number;
    name: string;
    scene: string | undefined;
    overrides: Record<string, string>;
    /** The texts that it may include. */
    includes: SceneText[];
}
const documentStateChanged = StateEffect.define<DocumentState>();
/** The change goes on with the one before. */
const continued = Annotation.define<boolean>();
/** Changes of the same place in quicker succession are undone together; in milliseconds. */
const quick = 500;

export interface EditorEvents {
    /** `documentState` changes, too. */
    changed(text: string, documentState: DocumentState | null, canUndo: boolean, canRedo: boolean): void;
    /** The present document state. */
    documentState(): DocumentState;
    /** The facts of the last scene without errors, for completion; null: none. */
    facts(): SceneInfo | null;
    /** A change was refused because a line would be too long. */
    refused(): void;
}

const theme = EditorView.theme({
    '&': {height: '100%', color: 'var(--text)', backgroundColor: 'var(--field)', fontSize: '13px'},
    '.cm-scroller': {overscrollBehavior: 'contain', fontFamily: 'var(--mono)', lineHeight: '1.55'},
    '.cm-content': {caretColor: 'var(--text)', padding: '8px 0'},
    '.cm-line': {paddingLeft: '30px', textIndent: '-24px'},
    '.cm-cursor': {borderLeftColor: 'var(--text)', borderLeftWidth: '2px'},
    '.cm-gutters': {backgroundColor: 'var(--field)', color: 'var(--faint)', border: 'none'},
    '.cm-activeLine, .cm-activeLineGutter': {backgroundColor: 'var(--line-now)'},
    '&.cm-focused': {outline: 'none'},
    '&.cm-focused .cm-selectionBackground, .cm-selectionBackground': {background: 'var(--selection) !important'},
    '.cm-matchingBracket': {backgroundColor: 'var(--selection) !important', outline: 'none'},
    '.cm-tooltip': {backgroundColor: 'var(--panel)', color: 'var(--text)', border: '1px solid var(--rule)', borderRadius: '6px'},
    '.cm-tooltip-autocomplete > ul > li[aria-selected]': {backgroundColor: 'var(--accent-soft)', color: 'var(--text)'},
    '.cm-completionDetail': {color: 'var(--faint)', fontSize: '12px'},
    '.cm-completionInfo': {fontFamily: 'var(--sans)', fontSize: '13px', maxWidth: '280px'},
    '.cm-panels': {backgroundColor: 'var(--panel)', color: 'var(--text)', fontFamily: 'var(--sans)', fontSize: '13px'},
    '.cm-panels-top': {borderBottom: '1px solid var(--rule)'},
    '.cm-panel.cm-search': {display: 'flex', flexWrap: 'wrap', alignItems: 'center', gap: '6px 8px', padding: '8px 34px 8px 10px'},
    '.cm-panel.cm-search br': {display: 'none'},
    '.cm-panel.cm-search :is(input, button, label)': {margin: '0', fontSize: '13px'},
    '.cm-panel.cm-search label': {display: 'flex', alignItems: 'center', gap: '5px', minHeight: '24px'},
    '.cm-panel.cm-search [name=close]': {top: '6px', right: '6px', minWidth: '24px', minHeight: '24px', fontSize: '18px', color: 'var(--soft)'},
    '.cm-textfield': {border: '1px solid var(--edge)', borderRadius: '6px', backgroundColor: 'var(--field)', padding: '3px 7px', color: 'var(--text)'},
    '.cm-button': {border: '1px solid var(--edge)', borderRadius: '6px', backgroundImage: 'none !important', backgroundColor: 'var(--panel)', color: 'var(--text)', padding: '3px 9px'},
    '.cm-searchMatch': {backgroundColor: 'var(--accent-soft)', outline: '1px solid var(--accent)'},
    '.cm-searchMatch-selected': {backgroundColor: 'var(--selection)'},
    '.cm-diagnostic': {fontFamily: 'var(--sans)', fontSize: '13px', padding: '6px 10px'},
    // Marks of errors without CodeMirror's images.
    '.cm-lintRange': {backgroundImage: 'none !important', textDecorationSkipInk: 'none'},
    '.cm-lintRange-error': {textDecoration: 'underline wavy var(--error)', backgroundColor: 'var(--error-soft)'},
    '.cm-lintRange-warning': {textDecoration: 'underline wavy var(--warning)'},
    '.cm-lint-marker': {content: 'normal !important', width: '9px', height: '9px', borderRadius: '50%', margin: '5px 3px'},
    '.cm-lint-marker-error': {backgroundColor: 'var(--error)'},
    '.cm-lint-marker-warning': {backgroundColor: 'var(--light)'},
    '.tok-comment': {color: 'var(--faint)', fontStyle: 'italic'},
    '.tok-string': {color: 'var(--string)'},
    '.tok-number': {color: 'var(--number)'},
    '.tok-keyword': {color: 'var(--keyword)', fontWeight: '600'},
    '.tok-key': {color: 'var(--key)'},
});

export class Editor {
    readonly #view: EditorView;
    readonly #language = new Compartment();
    readonly #completion = new Compartment();
    readonly #places = new PlaceTracker();
    #changedAt = -Infinity;
    #continues = false;

    constructor(host: HTMLElement, private readonly events: EditorEvents) {
        const root = host.shadowRoot ?? host.attachShadow({mode: 'open'});
        const parent = document.createElement('div');
        parent.style.height = '100%';
        root.append(parent);
        this.#view = new EditorView({parent, root, state: this.#state('', '')});
    }

    #state(text: string, name: string, kept?: KeptHistory) {
        const extensions = this.#extensions(name);
        try {
            if (kept) return stateWith(text, kept, extensions, documentStateChanged, parts);
        } catch {
            // It is of another version of the editor.
        }
        return EditorState.create({doc: text, extensions});
    }

    #extensions(name: string): Extension {
        return [
            lineNumbers(), this.#history(), drawSelection(), bracketMatching(), EditorView.lineWrapping, highlightActiveLine(), highlightActiveLineGutter(),
            lintGutter(), indentUnit.of('    '), search({top: true}), numbers, keymap.of([...searchKeymap, ...defaultKeymap, ...historyKeymap]), theme,
            this.#completion.of(this.#completionOf(name)),
            this.#language.of(languageOf(name)),
            EditorView.contentAttributes.of({'aria-label': 'Scene text', tabindex: '0', spellcheck: 'false', autocapitalize: 'off'}),
            // Chromium types over several lines by way of elements with styles, which the Content-Security-Policy reports.
            EditorView.domEventHandlers({
                beforeinput({inputType, data}, view) {
                    if (inputType !== 'insertText' || data === null || view.state.selection.main.empty || view.composing) return false;
                    view.dispatch(view.state.replaceSelection(data), {userEvent: 'input.type', scrollIntoView: true});
                    return true;
                },
            }),
            EditorView.clipboardInputFilter.of((pasted) => withShortLines(this.events.documentState().name, pasted)),
            EditorState.changeFilter.of(({changes, newDoc}) => {
                let isTooLong = false;
                changes.iterChangedRanges((_from, _to, from, to) => {
                    for (const lines = newDoc.iterLines(newDoc.lineAt(from).number, newDoc.lineAt(to).number + 1); !lines.next().done;)
                        isTooLong ||= lines.value.length > longestLine;
                });
                if (isTooLong) this.events.refused();
                return !isTooLong;
            }),
            invertedEffects.of((transaction) =>
                transaction.effects.some((one) => one.is(documentStateChanged)) ? [documentStateChanged.of(this.events.documentState())] : []),
            EditorView.updateListener.of((update) => {
                if (update.docChanged) {
                    this.#places.changed(update.changes.desc, update.state.doc);
                    this.#changedAt = performance.now();
                }
                const documentState = update.transactions.flatMap((one) => one.effects).findLast((one) => one.is(documentStateChanged))?.value;
                if (update.docChanged || documentState) this.#tell(documentState ?? null);
            }),
        ];
    }

    #history() {
        return history({
            newGroupDelay: 1e9,  // not infinite: the history isolates a change by a time of 0
            joinToEvent: (transaction, isAdjacent) => isAdjacent &&
                (transaction.annotation(continued) === true || performance.now() - this.#changedAt < quick),
        });
    }

    /** Only .glint has tables of its keys. */
    #completionOf(name: string) {
        return name.endsWith('.glint') ? completion(() => this.events.facts()) : [];
    }

    #tell(documentState: DocumentState | null) {
        const {state} = this.#view;
        this.events.changed(state.doc.toString(), documentState, undoDepth(state) > 0, redoDepth(state) > 0);
    }

    /** Sets the first scene; it cannot be undone. `kept`: what undo had before a reload. */
    begin(text: string, name: string, kept?: KeptHistory) {
        this.#view.setState(this.#state(text, name, kept));
        this.#places.restart(this.#view.state.doc);
        this.#tell(null);
    }

    /** What undo and redo take back, to be kept. */
    get kept(): KeptHistory {
        return keptHistory(this.#view.state, documentStateChanged, parts);
    }

    /** The version of the text, for wasRead(). */
    get version() {
        return this.#places.version;
    }

    /** A scene was read from a version of the text; offsetOf() then uses its places. */
    wasRead(version: number) {
        this.#places.read(version);
    }

    /** The offset of the scene's line and column in the present text; null if that part was deleted. */
    offsetOf(line: number, column: number): number | null {
        return this.#places.now(line, column);
    }

    /** Applies an edit of a control. Edits in quick succession are undone together; the history does this without a userEvent. */
    apply(edits: Edit[]) {
        this.#view.dispatch({changes: edits, annotations: continued.of(this.#continues)});
    }

    /** `continues`: edits that are made by `act` are undone together with the ones before, whatever the time between them. */
    edit(continues: boolean, act: () => void) {
        this.#continues = continues;
        act();
        this.#continues = false;
    }

    /** Within edit(true). */
    get continues() {
        return this.#continues;
    }

    /** Makes the text this one, by one edit of what differs. `continues`: undone together with the edit before, whenever that was. */
    replaceBy(text: string, continues: boolean) {
        const before = this.#view.state.doc.toString();
        const least = Math.min(before.length, text.length);
        let from = 0, end = 0;
        while (from < least && before[from] === text[from]) ++from;
        while (end < least - from && before[before.length - 1 - end] === text[text.length - 1 - end]) ++end;
        if (from === before.length && from === text.length) return;
        this.#view.dispatch({
            changes: {from, to: before.length - end, insert: text.slice(from, text.length - end)},
            // The history joins compositions however long they take.
            annotations: [continues ? Transaction.userEvent.of('input.type.compose') : isolateHistory.of('before')],
        });
    }

    /** The next edit is undone separately. */
    endEdit() {
        this.#view.dispatch({annotations: isolateHistory.of('full')});
    }

    /** Changes the document state, and all of the text if it is given. `again`: is undone together with the last change. */
    setDocumentState(documentState: DocumentState, text?: string, again = false) {
        const all = {from: 0, to: this.#view.state.doc.length}, {name} = this.events.documentState();
        this.#view.dispatch({
            ...(text === undefined ? {} : {changes: {...all, insert: text}}),
            effects: [documentStateChanged.of(documentState), ...(documentState.name === name ? [] : [EditorView.scrollIntoView(0)])],
            ...(documentState.name === name ? {} : {selection: {anchor: 0}}),
            // A change of the whole text is undone separately.
            annotations: [Transaction.addToHistory.of(!again), ...(text === undefined ? [] : [isolateHistory.of('full')])],
        });
    }

    /** The scene has another name, whose extension is its language. */
    setName(name: string) {
        this.#view.dispatch({effects: [this.#language.reconfigure(languageOf(name)), this.#completion.reconfigure(this.#completionOf(name))]});
    }

    undo() {
        undo(this.#view);
    }
    redo() {
        redo(this.#view);
    }

    /** Opens the search panel. */
    find() {
        openSearchPanel(this.#view);
    }

    mark(marks: Mark[]) {
        this.#view.dispatch(setDiagnostics(this.#view.state, marks));
    }

    /** Selects a place and scrolls to it. */
    reveal(from: number, to: number) {
        const most = this.#view.state.doc.length;
        const anchor = Math.min(from, most), head = Math.min(to, most);
        this.#view.dispatch({selection: {anchor, head}, effects: EditorView.scrollIntoView(anchor, {y: 'center'})});
        this.#view.focus();
    }
}
