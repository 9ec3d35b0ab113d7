// SPDX-License-Identifier: Apache-2.0
// The open challenge: its target, the difference from it, hints; and the form for a challenge of one's own.
import {signal, useSignal} from '@preact/signals';
import {useEffect, useRef} from 'preact/hooks';

import {View} from '../engine/view';
import {hints, isSearching, nextHint} from '../store/hints';
import {
    beginAgain, challenge, challenges, difference, done, forbiddenLines, isMet, leave, openChallenge, targetRequest, verdict,
} from '../store/learning';
import {pin} from '../store/pixels';
import {link} from '../store/scene';
import {notice, overrides, services, state, text} from '../store/state';
import {differencesOf} from './differences';
import {TextField} from './fields';
import {canvases, painter, pixelsOf} from './pictures';

/** The target of the open challenge is drawn. */
const isTargetDrawn = signal(false);

function Target({canvas}: {canvas: {current: HTMLCanvasElement | null}}) {
    const wanted = challenge.value!;
    useEffect(() => {
        isTargetDrawn.value = false;
        delete canvas.current!.dataset['complete'];
        const view = new View(services.pool!, 'target', {
            ...painter(canvas.current!), opened: () => {}, progress: () => {}, failed: () => {},
            done: () => {
                isTargetDrawn.value = true;
                if (canvas.current) canvas.current.dataset['complete'] = 'true';
            },
        });
        view.show({request: targetRequest(wanted), prepare: {}});
        return () => view.stop();
    }, [wanted]);
    return <canvas ref={canvas} class="target" role="img" aria-label="The target" />;
}

const cell = 12;  // pixels; a difference of this size is no edge

/** A pixel where the pictures differ, not only at an edge: that of the cell that differs most. */
function differingPixel(a: ImageData, b: ImageData): [number, number] {
    const width = Math.min(a.width, b.width), height = Math.min(a.height, b.height);
    const apart = (x: number, y: number) => {
        let sum = 0;
        for (let c = 0; c < 3; ++c) sum += Math.abs(a.data[4 * (y * a.width + x) + c]! - b.data[4 * (y * b.width + x) + c]!);
        return sum;
    };
    let most = -1, at: [number, number] = [0, 0];
    for (let top = 0; top < height; top += cell) {
        for (let left = 0; left < width; left += cell) {
            const right = Math.min(left + cell, width), bottom = Math.min(top + cell, height);
            let sum = 0, largest = -1, place: [number, number] = [left, top];
            for (let y = top; y < bottom; ++y) {
                for (let x = left; x < right; ++x) {
                    const here = apart(x, y);
                    sum += here;
                    if (here > largest) {
                        largest = here;
                        place = [x, y];
                    }
                }
            }
            sum /= (right - left) * (bottom - top);
            if (sum <= most) continue;
            most = sum;
            at = place;
        }
    }
    return at;
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

/** The hints that are shown, one more at each click. */
function Hints({canvas}: {canvas: {current: HTMLCanvasElement | null}}) {
    const now = challenge.value!, given = hints.value;
    const isLast = given !== null && given.shown === given.all.length;
    const ask = () => {
        const pixel = given?.pixel ?? differingPixel(pixelsOf(canvases.first), pixelsOf(canvas.current!));
        if (!given) void pin(pixel, false);
        void nextHint(targetRequest(now), pixel, differencesOf);
    };
    return (
        <>
            <div class="presets">
                <button class="button" disabled={isSearching.value || isLast || !isTargetDrawn.value || state.value !== 'done' || verdict.value?.isDone === true} onClick={ask}>
                    {isSearching.value ? 'Searching…' : given ? 'Another hint' : 'Give me a hint'}
                </button>
                <button class="button" onClick={beginAgain}>Begin again</button>
            </div>
            {given && (
                <>
                    <p class="note">At pixel ({given.pixel.join(', ')}), which is marked in the picture, the two differ:</p>
                    <ul class="hints" aria-live="polite">{given.all.slice(0, given.shown).map((hint) => <li key={hint}>{hint}</li>)}</ul>
                </>
            )}
        </>
    );
}

function nextChallenge() {
    const at = challenges.value.findIndex((one) => one.id === challenge.value?.id);
    const next = at < 0 ? undefined : challenges.value[at + 1];
    if (next) void openChallenge(next.id);
    else leave();
}

export function OpenChallenge() {
    const now = challenge.value!, canvas = useRef<HTMLCanvasElement>(null);
    const isDone = verdict.value?.isDone === true;
    const forbidden = forbiddenLines(now, text.value);
    return (
        <section class="challenge" data-open={now.id} data-done={isDone}>
            <h2>{now.task}</h2>
            {now.may && now.may.length > 0 && <p class="note">Only lines with one of these words may be changed: {now.may.join(', ')}.</p>}
            <Target canvas={canvas} />
            <Figures />
            {forbidden.length > 0 && <p class="message error" role="alert">Line {forbidden.slice(0, 5).join(', ')} may not be changed.</p>}
            {isDone ? (
                <div class="presets">
                    <p class="step-state done"><span class="tick" aria-hidden="true">✓</span> Done.{!isMet(difference.value) && ' The fault is mended, in another way than in the target.'}</p>
                    <button class="button" onClick={nextChallenge}>{challenges.value.at(-1)?.id === now.id || now.id.startsWith('link:') ? 'All challenges' : 'Next challenge'}</button>
                </div>
            ) : done.value.has(now.id) && <p class="step-state">You have done this before; this picture is not the target.</p>}
            <Hints canvas={canvas} />
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
