// SPDX-License-Identifier: Apache-2.0
// Lessons and challenges: the list, the open lesson with its steps.
import {useEffect} from 'preact/hooks';

import {solutionOf} from '../learn/solution';
import {
    beginAgain, challenge, challenges, done, goToStep, leave, lesson, lessons, loadLessons, openChallenge, openLesson, step, stepId, verdict,
} from '../store/learning';
import {pin} from '../store/pixels';
import {services, size, tab} from '../store/state';
import {OpenChallenge, TeachersChallenge} from './Challenge';
import type {Lesson, Step} from '../learn/types';

const Tick = ({isDone}: {isDone: boolean}) => <span class="tick" role="img" aria-label={isDone ? 'done' : 'not done yet'}>{isDone ? '✓' : ''}</span>;

/** The HTML of a lesson; a link to #inspect opens that panel. */
function Html({html}: {html: string}) {
    return (
        <div class="lesson-text" dangerouslySetInnerHTML={{__html: html}} onClick={(event) => {
            const target = (event.target as Element).closest('a')?.getAttribute('href');
            if (target !== '#inspect' && target !== '#compare' && target !== '#controls') return;
            event.preventDefault();
            tab.value = target.slice(1) as 'inspect' | 'compare' | 'controls';
        }} />
    );
}

/** What the solution changes, and a button that does it. */
function Solution({of, number}: {of: Lesson; number: number}) {
    const solution = solutionOf(of, number), {pixel} = solution;
    const apply = () => {
        if (solution.lines.length > 0 || !pixel) services.editor?.replaceBy(solution.text, false);
        if (pixel) void pin([Math.floor(pixel[0] * size.value.width), Math.floor(pixel[1] * size.value.height)], false);
    };
    return (
        <details class="solution"><summary>Solution</summary>
            {solution.lines.length > 0 && (
                <>
                    <p class="note">The text’s changed {solution.lines.length === 1 ? 'line' : 'lines'}:</p>
                    <pre>{solution.lines.join('\n')}</pre>
                </>
            )}
            {pixel && <p class="note">{solution.lines.length > 0 ? 'Then click' : 'Click'} the picture at {Math.round(100 * pixel[0])}% of its width and {Math.round(100 * pixel[1])}% of its height.</p>}
            <button class="button" onClick={apply}>Apply</button>
        </details>
    );
}

function StepOf({of, one, number}: {of: Lesson; one: Step; number: number}) {
    const isOpen = step.value === number, wasDone = done.value.has(stepId(of, number));
    const isDone = isOpen ? verdict.value?.isDone === true : wasDone;
    return (
        <li class="step" data-step={number} data-done={isDone} aria-current={isOpen ? 'step' : undefined}>
            <h3><Tick isDone={wasDone} />
                <button class="link" aria-expanded={isOpen} onClick={() => goToStep(number)}>{number + 1}. {one.title}</button>
            </h3>
            {isOpen && (
                <>
                    <Html html={one.html} />
                    <p class={`step-state${isDone ? ' done' : ''}`} role="status">{isDone ? 'Done.' : `Not done${wasDone ? ' in this picture' : ' yet'}${verdict.value ? `: ${verdict.value.missing}` : '.'}`}</p>
                    <div class="presets">
                        {number + 1 < of.steps.length
                            ? <button class="button" aria-pressed={isDone} onClick={() => {
                                goToStep(number + 1);
                                requestAnimationFrame(() => document.querySelector<HTMLElement>('.step[aria-current] .link')?.focus());
                            }}>Next step</button>
                            : <button class="button" aria-pressed={isDone} onClick={() => nextLesson(of)}>Next lesson</button>}
                        <button class="button" onClick={beginAgain}>Begin again</button>
                    </div>
                    <Solution of={of} number={number} />
                </>
            )}
        </li>
    );
}

function nextLesson(of: Lesson) {
    const next = lessons.value[lessons.value.indexOf(of) + 1];
    if (next) {
        void openLesson(next.id);
    } else {
        leave();
    }
}

function List() {
    const isChallengeDone = (id: string) => done.value.has(id);
    return (
        <>
            <section>
                <h2>Lessons</h2>
                <ol class="learn-list">
                    {lessons.value.map((one) => {
                        const count = one.steps.filter((_, i) => done.value.has(stepId(one, i))).length;
                        return (
                            <li key={one.id}>
                                <Tick isDone={count === one.steps.length} />
                                <button class="link" data-lesson={one.id} onClick={() => void openLesson(one.id)}>{one.title}</button>
                                <span class="faint">{count} of {one.steps.length}</span>
                            </li>
                        );
                    })}
                </ol>
            </section>
            {[['Challenges: make this picture', 'c', 'Challenge'], ['What is wrong here?', 'case_', 'Case'], ['Find the bug with its log', 'log_', 'Log']].map(([heading, kind, word]) => (
                <section key={heading}>
                    <h2>{heading}</h2>
                    <ol class="learn-list">
                        {challenges.value.filter((one) => one.id.replace(/\d+$/, '') === kind).map((one, i) => (
                            <li key={one.id}>
                                <Tick isDone={isChallengeDone(one.id)} />
                                <button class="link" data-challenge={one.id} onClick={() => void openChallenge(one.id)}>{word} {i + 1}</button>
                            </li>
                        ))}
                    </ol>
                </section>
            ))}
            <TeachersChallenge />
        </>
    );
}

export function Learn() {
    useEffect(() => void loadLessons(), []);
    const open = lesson.value;
    if (!open && !challenge.value) return <List />;
    return (
        <>
            <div><button class="link" onClick={leave}>All lessons and challenges</button></div>
            {open ? (
                <section class="lesson" data-open={open.id}>
                    <h2>{open.title}</h2>
                    <Html html={open.html} />
                    <ol class="steps">{open.steps.map((one, i) => <StepOf key={i} of={open} one={one} number={i} />)}</ol>
                </section>
            ) : <OpenChallenge />}
        </>
    );
}
