// SPDX-License-Identifier: Apache-2.0
import {computed, effect} from '@preact/signals';
import {useLayoutEffect, useRef} from 'preact/hooks';

import {Editor} from '../editor/editor';
import {opened} from '../store/included';
import {chooseFile, folderScenes} from '../store/opening';
import {revealMistake} from '../store/places';
import {chooseScene, convertToGlint, skipUnsupported, textChanged} from '../store/scene';
import {currentDocumentState, diagnostics, failure, fileName, format, info, missing, notice, services, sceneName, skipsUnsupported, text} from '../store/state';
import {longestLine} from '../text/long_lines';
import {spanOf} from '../text/places';
import {Choice, FileButton} from './fields';
import {IncludedText} from './IncludedText';
import {Outside} from './Outside';

const scenes = computed(() => format.value?.scenes?.(text.value) ?? []);

export function TextPane() {
    const host = useRef<HTMLDivElement>(null);
    // Before the first scene is opened.
    useLayoutEffect(() => {
        const editor = new Editor(host.current!, {
            changed: textChanged, documentState: currentDocumentState, facts: () => info.value,
            refused: () => queueMicrotask(() => {
                notice.value = `Not inserted: a line would have more than ${longestLine} characters.`;
            }),
        });
        services.editor = editor;
        return effect(() => {
            const here = diagnostics.value.filter((one) => one.line > 0 && one.file === fileName.value);
            const now = text.peek();
            editor.mark(here.map((one) => {
                const [from, to] = spanOf(now, one.line, one.column, one.length);
                return {from, to: Math.min(Math.max(to, from), now.length), severity: one.severity, message: one.message};
            }));
        });
    }, []);
    return (
        <section class="text-pane" aria-label="Scene text" id="panel-text">
            <div class="pane-head">
                <h2 title={fileName.value}>{fileName.value.split('/').at(-1)}</h2>
                {folderScenes.value.length > 1 && <Choice label="File" hidden value={fileName.value} values={folderScenes.value} set={chooseFile} />}
                {scenes.value.length > 1 && (
                    <Choice label="Scene of this file" hidden value={sceneName.value ?? scenes.value[0]!} values={scenes.value} set={chooseScene} />
                )}
                {format.value?.name !== '.glint' && (
                    <button class="link" onClick={() => void convertToGlint()}>convert to .glint</button>
                )}
                <button class="quiet" aria-label="Find in the text" title="Find (Ctrl+F)" onClick={() => services.editor?.find()}>
                    <svg class="icon" viewBox="0 0 14 14" aria-hidden="true"><circle cx="6" cy="6" r="4" /><path d="M9 9l4 4" /></svg>
                </button>
            </div>
            {opened.value && <IncludedText />}
            <div class="editor" ref={host} hidden={opened.value !== null} />
            <Outside />
            <Messages />
        </section>
    );
}

function Messages() {
    const list = diagnostics.value;
    if (list.length === 0 && !failure.value && !skipsUnsupported.value) return <div class="messages" aria-live="polite" />;
    return (
        <div class="messages" aria-live="polite">
            {missing.value.length > 0 && (
                <p class="message">
                    {missing.value.join(', ')} {missing.value.length === 1 ? 'is' : 'are'} not here. Drop {missing.value.length === 1 ? 'it' : 'them'} onto the page, alone or in a folder or .zip, or <FileButton label="choose files…" /> <FileButton label="choose a folder…" folder />
                </p>
            )}
            {(skipsUnsupported.value || list.some((one) => one.can_skip)) && (
                <label class="message skip">
                    <input type="checkbox" checked={skipsUnsupported.value} onChange={(event) => skipUnsupported(event.currentTarget.checked)} />
                    {' '}leave out what glint does not render (skip-unsupported)
                </label>
            )}
            {failure.value && <p class="message error">{failure.value}</p>}
            {list.slice(0, 20).map((one, i) => (
                <button key={i} class={`message ${one.severity}`} onClick={() => revealMistake(one)}>
                    <span class="where">{one.line > 0 ? `${one.file === fileName.value ? '' : `${one.file} `}${one.line}:${one.column}` : one.severity}</span>
                    {one.message}
                </button>
            ))}
        </div>
    );
}
