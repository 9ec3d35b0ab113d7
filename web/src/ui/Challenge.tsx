// SPDX-License-Identifier: Apache-2.0
// The open challenge: its target, the difference from it, hints; and the form for a challenge of one's own.
import {useSignal} from '@preact/signals';
import {useEffect, useRef} from 'preact/hooks';

import {View} from '../engine/view';
import {
    askForHints, challenge, difference, done, forbiddenLines, hints, isMet, isSearching, targetRequest,
} from '../store/learning';
import {link, openScene} from '../store/scene';
import {notice, overrides, services, text} from '../store/state';
import {TextField} from './fields';
import {painter} from './pictures';

function Target() {
    const canvas = useRef<HTMLCanvasElement>(null);
    const wanted = challenge.value!;
    useEffect(() => {
        const view = new View(services.pool!, 'target', {
            ...painter(canvas.current!), opened: () => {}, progress: () => {}, failed: () => {},
            done: () => {
                if (canvas.current) canvas.current.dataset['complete'] = 'true';
            },
        });
        view.show({request: targetRequest(wanted), prepare: {}});
        return () => view.stop();
    }, [wanted]);
    return <canvas ref={canvas} class="target" role="img" aria-label="The target" />;
}

/** "12.3% of the pixels differ; 4.1 of 255 on average." */
function Figures() {
    const found = difference.value;
    if (found === null) return <p class="difference" role="status">Comparing…</p>;
    if (typeof found === 'string') return <p class="difference" role="status">Cannot be compared: {found}</p>;
    const percent = (100 * (found.pixels - found.within)) / found.pixels;
    return (
        <p class="difference" role="status">
            {isMet(found) ? 'Your picture is the target.'
                : `${percent.toFixed(1)}% of the pixels differ, by ${found.mean.toFixed(2)} of 255 on average over all, by ${Math.round(found.largest.value)} at most.`}
        </p>
    );
}

export function OpenChallenge() {
    const now = challenge.value!;
    const isDone = done.value.has(now.id);
    const forbidden = forbiddenLines(now, text.value);
    return (
        <section class="challenge" data-open={now.id} data-done={isDone}>
            <h2>{now.task}</h2>
            {now.may && now.may.length > 0 && <p class="note">Only lines with one of these words may be changed: {now.may.join(', ')}.</p>}
            <Target />
            <Figures />
            {forbidden.length > 0 && <p class="message error" role="alert">Line {forbidden.slice(0, 5).join(', ')} may not be changed.</p>}
            {isDone && <p class="step-state"><span class="tick" aria-hidden="true">✓</span> Done.</p>}
            <div class="presets">
                <button class="button" disabled={isSearching.value} onClick={() => void askForHints()}>{isSearching.value ? 'Searching…' : 'Give me a hint'}</button>
                <button class="button" onClick={() => openScene({name: now.name, text: now.start})}>Begin again</button>
            </div>
            {hints.value && <ul class="hints" aria-live="polite">{hints.value.map((hint) => <li key={hint}>{hint}</li>)}</ul>}
        </section>
    );
}

/** A teacher makes a challenge: the target first, then the scene to start with. */
export function TeachersChallenge() {
    const target = useSignal<{text: string; overrides: Record<string, string>} | null>(null);
    const task = useSignal('Make this picture.'), may = useSignal('');
    const copy = async () => {
        const words = may.value.split(/[\s,]+/).filter(Boolean);
        const address = await link({
            task: task.value, target: target.value!.text, overrides: target.value!.overrides, may: words.length > 0 ? words : undefined,
        });
        try {
            await navigator.clipboard.writeText(address);
            notice.value = 'The link to the challenge is copied. It contains both scenes.';
        } catch {
            globalThis.history.replaceState(null, '', address);
            notice.value = 'The link to the challenge is in the address bar. It contains both scenes.';
        }
    };
    return (
        <details class="teacher">
            <summary><h2>Your own challenge</h2></summary>
            <p class="note">First make the picture that is to be reached, then the scene to start with. Both are in the link.</p>
            <div class="presets">
                <button class="button" aria-pressed={target.value !== null} onClick={() => {
                    target.value = {text: text.value, overrides: overrides.value};
                }}>{target.value ? 'The target is kept' : 'This is the target'}</button>
            </div>
            <TextField label="Task" value={task.value} set={(value) => {
                task.value = value;
            }} />
            <TextField label="May change" value={may.value} set={(value) => {
                may.value = value;
            }} />
            <p class="note">Words of the lines that may be changed, such as <code>intensity, position</code>; empty: all.</p>
            <div><button class="button" disabled={!target.value} onClick={() => void copy()}>Copy the challenge’s link</button></div>
        </details>
    );
}
