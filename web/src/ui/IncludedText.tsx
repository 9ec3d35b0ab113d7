// SPDX-License-Identifier: Apache-2.0
// A text that the scene includes, in the place of the scene's own: it can be changed, and the picture follows.
import {effect} from '@preact/signals';
import {useEffect, useRef} from 'preact/hooks';

import {opened} from '../store/included';
import {currentDocumentState, fileName, includes, services} from '../store/state';

/** Changes in quicker succession are undone together; in milliseconds. */
const quick = 500;

export function IncludedText() {
    const area = useRef<HTMLTextAreaElement>(null), changedAt = useRef(-Infinity);
    const {name, line} = opened.value!;
    const text = includes.value.find((one) => one.name === name)?.text ?? '';
    useEffect(() => {
        const {current} = area, lines = text.split('\n');
        const from = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
        current!.focus();
        current!.setSelectionRange(from, from + (lines[line - 1]?.length ?? 0));
        const height = current!.scrollHeight / Math.max(1, lines.length);
        current!.scrollTop = (line - 1) * height - current!.clientHeight / 2;
    }, [name, line]);
    useEffect(() => effect(() => {
        // Another scene has been opened.
        if (!includes.value.some((one) => one.name === name)) opened.value = null;
    }), [name]);
    const change = (now: string) => {
        const again = performance.now() - changedAt.current < quick;
        changedAt.current = performance.now();
        const changed = includes.value.map((one) => (one.name === name ? {name, text: now} : one));
        services.editor?.setDocumentState({...currentDocumentState(), includes: changed}, undefined, again);
    };
    return (
        <div class="included">
            <p>
                <span>Included by {fileName.value.split('/').at(-1)}: <b>{name}</b></span>
                <button class="button" onClick={() => {
                    opened.value = null;
                }}>Back to the scene’s text</button>
            </p>
            <textarea ref={area} aria-label={`Text of ${name}`} spellcheck={false} wrap="off" value={text} onInput={(event) => change(event.currentTarget.value)} />
        </div>
    );
}
