// SPDX-License-Identifier: Apache-2.0
// The lesson or challenge that is open, and what of it is done.
import {effect, signal} from '@preact/signals';
import type {Comparison, OpenRequest} from 'glint-wasm';

import {gallery} from '../gallery';
import {type Situation, examine} from '../learn/checks';
import {solutionOf} from '../learn/solution';
import type {Challenge, Lesson} from '../learn/types';
import {type Entry, type Place, arrive, galleryName, keepForBack, placeOf, setAddress} from './address';
import {forgetHints} from './hints';
import {fetchLater} from './later';
import {chosenPixel, diagnosis, openLogOf} from './own_log';
import {openBookScene, openLink, openScene, presentRequest, resumeChallenge} from './scene';
import {
    documentId, fileName, givenChallenge, includes, info, isFirstVisit, notice, overrides, pinned, services, shownId, size, state, tab, text,
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

/** Opens a lesson at a step, whose scene is as the steps before have left it. */
export async function openLesson(id: string, number = 0) {
    await loadLessons();
    const found = lessons.value.find((one) => one.id === id) ?? lessons.value[0]!;
    const at = Math.min(number, found.steps.length - 1);
    keepForBack();
    end();
    const scene = found.steps[at]!.scene ?? found.scene;
    openScene(at > 0 && !found.steps[at]!.scene ? {...scene, text: solutionOf(found, at - 1).text} : scene, true);
    if (found.log) openLogOf(found.log);
    showLesson(found, at);
}

function showLesson(found: Lesson, number: number) {
    lesson.value = found;
    step.value = number;
    verdict.value = null;
    tab.value = 'learn';
    setAddress({what: 'lesson', id: found.id, step: number});
}

/** Back, forward, or another fragment of the address. */
export const addressChanged = (entry: Entry | null) => arrive(async () => {
    const {hash} = location, place = placeOf(hash);
    if (entry?.scene) {
        openScene(entry.scene);
        end();
        if (place) await resume(place);
        else if (hash !== '') await resumeChallenge(hash);
    } else if (place) {
        await goToPlace(place);
    } else if (hash !== '') {
        await openLink(hash);
    } else {
        end();
        openBookScene();
    }
});

/** Goes to what an address stands for. */
export async function goToPlace(place: Place) {
    if (place.what === 'challenge') {
        await openChallenge(place.id);
    } else if (place.what === 'scene') {
        const scene = gallery.find((one) => galleryName(one) === place.name);
        end();
        if (scene) {
            openScene(scene);
        } else {
            if (fileName.value === '') openBookScene();
            notice.value = `There is no scene ${place.name}.`;
        }
    } else if (lesson.value?.id === place.id && lesson.value.steps[place.step]) {
        goToStep(place.step);
    } else {
        await openLesson(place.id, place.step);
    }
}

/** After a reload: the lesson or challenge is open again, beside the scene as it was. */
export async function resume(place: Place) {
    if (place.what === 'scene') return;
    await loadLessons();
    const {id} = place;
    if (place.what === 'challenge') {
        const found = challenges.value.find((one) => one.id === id);
        if (found) begin(found);
        return;
    }
    const found = lessons.value.find((one) => one.id === id);
    if (found?.steps[place.step]) showLesson(found, place.step);
}

export function goToStep(number: number) {
    const now = lesson.value, scene = now?.steps[number]?.scene;
    if (!now) return;
    keepForBack();
    if (scene) openScene(scene);
    if (scene && now.log) openLogOf(now.log);
    pinned.value = null;  // of the step before
    verdict.value = null;
    step.value = number;
    setAddress({what: 'lesson', id: now.id, step: number});
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
    keepForBack();
    end();
    openScene({name: found.name, text: found.start}, true);
    if (found.log) openLogOf(found.log);
    begin(found);
    setAddress({what: 'challenge', id: found.id});
}

/** The scene of the open step or challenge as it was at first. */
export function beginAgain() {
    const from = lesson.value, of = challenge.value;
    if (from) openScene(from.steps[step.value]!.scene ?? from.scene);
    else if (of) openScene({name: of.name, text: of.start});
    const log = (from ?? of)?.log;
    if (log) openLogOf(log);
}

/** Ends the lesson or challenge; the scene stays. */
function end() {
    lesson.value = null;
    challenge.value = null;
}

/** Back to the list of lessons and challenges. */
export function leave() {
    keepForBack();
    end();
    setAddress(null);
}

/** The request that opens a challenge's target. */
export const targetRequest = (of: NonNullable<typeof challenge.value>): OpenRequest =>
    ({texts: [{name: of.name, text: of.target}], includes: includes.value, settings: of.overrides ?? {}});

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
        info: facts, pinned: pinned.value, log: factsOfLog(),
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

/** What the checks ask of the log that is open. */
function factsOfLog(): Situation['log'] {
    const found = diagnosis.value, pixel = chosenPixel.value;
    return {
        wrong: found && typeof found !== 'string' ? found.wrong_pixels : null,
        chosen: pixel && (pixel.first >= 0 ? pixel.rows[pixel.first]!.quantity : 'none'),
    };
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
    fetchLater(() => Promise.all([loadLessons(), import('../lessons/help')]));
    effect(() => {
        const isReady = state.value === 'done' && shownId.value === documentId.value;
        void [pinned.value, info.value, step.value, overrides.value, diagnosis.value, chosenPixel.value];
        if (state.value === 'error') verdict.value = {isDone: false, missing: 'The scene has an error, which the panel Text shows.'};
        if (!isReady) return;
        if (lesson.value) void checkStep();
        if (challenge.value) void checkChallenge();
    });
    effect(() => {
        void [text.value, overrides.value];  // hints are about one picture
        forgetHints();
    });
    effect(() => {
        // Another scene has been opened.
        const name = fileName.value, scenes = lesson.value ? [lesson.value.scene, ...lesson.value.steps.map((one) => one.scene)] : challenge.value ? [challenge.value] : null;
        if (scenes && !scenes.some((one) => one?.name === name)) end();
    });
    effect(() => {
        const given = givenChallenge.value;
        if (!given) return;
        begin({id: `link:${given.task}`, ...given});
        isFirstVisit.value = false;
    });
}
