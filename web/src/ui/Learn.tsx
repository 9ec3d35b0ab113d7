// SPDX-License-Identifier: Apache-2.0
// Lessons and challenges: the list, the open lesson with its steps.
import {useEffect} from 'preact/hooks';

import {
    challenge, challenges, done, goToStep, leave, lesson, lessons, loadLessons, openChallenge, openLesson, step, stepId,
} from '../store/learning';
import {openScene} from '../store/scene';
import {tab} from '../store/state';
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

function StepOf({of, one, number}: {of: Lesson; one: Step; number: number}) {
    const isOpen = step.value === number, isDone = done.value.has(stepId(of, number));
    return (
        <li class="step" data-step={number} data-done={isDone} aria-current={isOpen ? 'step' : undefined}>
            <h3><Tick isDone={isDone} />
                <button class="link" aria-expanded={isOpen} onClick={() => goToStep(number)}>{number + 1}. {one.title}</button>
            </h3>
            {isOpen && (
                <>
                    <Html html={one.html} />
                    <p class="step-state" role="status">{isDone ? 'Done.' : 'Not done yet: glint checks it as you work.'}</p>
                    <div class="presets">
                        {number + 1 < of.steps.length
                            ? <button class="button" aria-pressed={isDone} onClick={() => goToStep(number + 1)}>Next step</button>
                            : <button class="button" aria-pressed={isDone} onClick={() => nextLesson(of)}>Next lesson</button>}
                        <button class="button" onClick={() => openScene(one.scene ?? of.scene)}>Begin again</button>
                    </div>
                    <details><summary>Solution</summary><pre class="solution">{one.solution}</pre></details>
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
            {[['Challenges: make this picture', false], ['What is wrong here?', true]].map(([heading, isFault]) => (
                <section key={String(heading)}>
                    <h2>{heading}</h2>
                    <ol class="learn-list">
                        {challenges.value.filter((one) => one.id.startsWith('case') === isFault).map((one, i) => (
                            <li key={one.id}>
                                <Tick isDone={isChallengeDone(one.id)} />
                                <button class="link" data-challenge={one.id} onClick={() => void openChallenge(one.id)}>{isFault ? 'Case' : 'Challenge'} {i + 1}</button>
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
