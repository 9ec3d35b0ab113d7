// SPDX-License-Identifier: Apache-2.0
// The lesson or challenge that is open, and what of it is done.
import {effect, signal} from '@preact/signals';
import type {Comparison, OpenRequest} from 'glint-wasm';

import {examine} from '../learn/checks';
import type {Challenge, Lesson} from '../learn/types';
import {forgetHints} from './hints';
import {openScene, presentRequest} from './scene';
import {
    documentId, givenChallenge, info, isFirstVisit, overrides, pinned, services, shownId, size, state, tab, text,
} from './state';

/** Loaded when they are first needed. */
export const lessons = signal<Lesson[]>([]);
export const challenges = signal<Challenge[]>([]);
/** The open lesson, and the number of its step; or the open challenge. */
export const lesson = signal<Lesson | null>(null);
export const step = signal(0);
export const challenge = signal<(Challenge & {overrides?: Record<string, string> | undefined}) | null>(null);
/** The difference of the picture from the challenge's target, or why there is none. */
export const difference = signal<Comparison | string | null>(null);
/** Whether the open step or challenge is done in the present picture, and what is missing; null: not known yet. */
export const verdict = signal<{isDone: boolean; missing: string} | null>(null);

const key = 'glint.done';

function kept(): string[] {
    try {
        const list: unknown = JSON.parse(localStorage.getItem(key) ?? '[]');
        return Array.isArray(list) ? list.filter((one) => typeof one === 'string') : [];
    } catch {
        return [];
    }
}

/** The steps and challenges that have been done once: "01_ambient/0", "c01". */
export const done = signal<ReadonlySet<string>>(new Set(kept()));

function setDone(id: string) {
    if (done.value.has(id)) return;
    done.value = new Set([...done.value, id]);
    try {
        localStorage.setItem(key, JSON.stringify([...done.value]));
    } catch {
        // It is then done for this visit.
    }
}

export const stepId = (of: Lesson, number: number) => `${of.id}/${number}`;

export async function loadLessons() {
    if (lessons.value.length > 0) return;
    const [first, second] = await Promise.all([import('../lessons/lessons'), import('../lessons/challenges')]);
    lessons.value = first.lessons;
    challenges.value = second.challenges;
}

export async function openLesson(id: string) {
    await loadLessons();
    const found = lessons.value.find((one) => one.id === id) ?? lessons.value[0]!;
    leave();
    openScene(found.scene);
    lesson.value = found;
    step.value = 0;
    verdict.value = null;
    tab.value = 'learn';
}

/** Opens the lesson of an address, `#lesson=01_ambient`; false if it is the address of none. */
export async function openLessonOf(hash: string): Promise<boolean> {
    const id = /^#lesson=(\w+)$/.exec(hash)?.[1];
    if (id === undefined) return false;
    history.replaceState(null, '', location.pathname + location.search);  // a reload then keeps what has been done
    await openLesson(id);
    return true;
}

export function goToStep(number: number) {
    const scene = lesson.value?.steps[number]?.scene;
    if (scene) openScene(scene);
    pinned.value = null;  // of the step before
    verdict.value = null;
    step.value = number;
}

function begin(wanted: Challenge & {overrides?: Record<string, string> | undefined}) {
    lesson.value = null;
    challenge.value = wanted;
    difference.value = null;
    verdict.value = null;
    forgetHints();
    tab.value = 'learn';
}

export async function openChallenge(id: string) {
    await loadLessons();
    const found = challenges.value.find((one) => one.id === id) ?? challenges.value[0]!;
    leave();
    openScene({name: found.name, text: found.start});
    begin(found);
}

export function leave() {
    lesson.value = null;
    challenge.value = null;
}

/** The request that opens a challenge's target. */
export const targetRequest = (of: NonNullable<typeof challenge.value>): OpenRequest =>
    ({texts: [{name: of.name, text: of.target}], settings: of.overrides ?? {}});

/** The numbers of the lines that may not be changed and are. */
export function forbiddenLines(of: Challenge, now: string): number[] {
    const {may} = of;
    if (!may || may.length === 0) return [];
    const lines = now.split('\n'), before = of.start.split('\n');
    const isFree = (line: string | undefined) => may.some((word) => line?.includes(word));
    return Array.from({length: Math.max(lines.length, before.length)}, (_, i) => i)
        .filter((i) => lines[i] !== before[i] && !(isFree(before[i]) || (before[i] === undefined && isFree(lines[i])))).map((i) => i + 1);
}

/** A challenge is met if the pictures are equal but for rounding. */
export const isMet = (found: Comparison | string | null) => typeof found === 'object' && found !== null && found.mean <= 0.1 && found.within >= 0.999 * found.pixels;

/** The picture is nearly the target: with a challenge's own conditions that is enough. */
const isNear = (found: Comparison | string) => typeof found === 'object' && found.mean <= 4;

let last = 0;

async function compare(): Promise<Comparison | string> {
    const current = challenge.value!;
    try {
        return await services.pool!.run({
            view: 'challenge', key: ++last, request: presentRequest(), prepare: {},
            task: {what: 'compare', reference: targetRequest(current), causes: false},
        }, true);
    } catch (error) {
        return error instanceof Error ? error.message : String(error);
    }
}

/** The first check that does not hold decides. Null if the scene has been replaced meanwhile. */
async function examineAll(checks: readonly string[]): Promise<{isDone: boolean; missing: string} | null> {
    const current = services.first?.current, facts = info.value;
    if (!facts || !current || !services.pool) return null;
    const {content, key: opened, prepare} = current;
    const situation = {
        info: facts, pinned: pinned.value,
        explain: (x: number, y: number) => services.pool!.run({
            view: 'first', key: opened, request: content.request, prepare,
            task: {what: 'explain', x: Math.floor(x * size.value.width), y: Math.floor(y * size.value.height)},
        }, true),
    };
    try {
        for (const check of checks) {
            const {holds, missing} = await examine(check, situation);
            if (!holds) return {isDone: false, missing};
        }
    } catch {
        return null;
    }
    return {isDone: true, missing: ''};
}

let checks = 0;

async function checkStep() {
    const now = lesson.value, number = step.value, check = ++checks;
    if (!now) return;
    const found = await examineAll(now.steps[number]!.checks);
    if (!found || lesson.value !== now || step.value !== number || check !== checks) return;
    verdict.value = found;
    if (found.isDone) setDone(stepId(now, number));
}

async function checkChallenge() {
    const now = challenge.value, number = ++checks;
    const found = await compare();
    if (challenge.value !== now || !now || number !== checks) return;  // of an older picture
    const others = now.checks && !isMet(found) && isNear(found) ? await examineAll(now.checks) : null;
    if (challenge.value !== now || number !== checks) return;
    const isDone = (isMet(found) || others?.isDone === true) && forbiddenLines(now, text.value).length === 0;
    difference.value = found;
    verdict.value = {isDone, missing: ''};
    if (!isDone) return;
    forgetHints();
    setDone(now.id);
}

/** Checks the open step or challenge whenever a picture is complete or a pixel is pinned. */
export function followLessons() {
    requestIdleCallback(() => void loadLessons());  // the page makes no connections later
    effect(() => {
        const isReady = state.value === 'done' && shownId.value === documentId.value;
        void [pinned.value, info.value, step.value, overrides.value];
        if (state.value === 'error') verdict.value = {isDone: false, missing: 'The scene has an error, which the panel Text shows.'};
        if (!isReady) return;
        if (lesson.value) void checkStep();
        if (challenge.value) void checkChallenge();
    });
    effect(() => {
        void text.value;  // hints are about one picture
        forgetHints();
    });
    effect(() => {
        const given = givenChallenge.value;
        if (!given) return;
        begin({id: `link:${given.task}`, ...given});
        isFirstVisit.value = false;
    });
}
