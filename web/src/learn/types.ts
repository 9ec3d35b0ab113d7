// SPDX-License-Identifier: Apache-2.0
// Lessons and challenges, as tools/make-lessons.mjs makes them.

export interface NamedText {name: string; text: string}

export interface Step {
    title: string;
    html: string;
    /** Opened when the step begins; null: the scene stays. */
    scene: NamedText | null;
    /** All of them make the step done; see checks.ts. */
    checks: string[];
    solution: string;
}

export interface Lesson {
    id: string;
    title: string;
    html: string;
    scene: NamedText;
    /** The log of a program that should draw the scene; it is open while the lesson is. */
    log?: NamedText;
    steps: Step[];
}

export interface Challenge {
    id: string;
    task: string;
    /** The name of both scenes; its extension is their format. */
    name: string;
    target: string;
    start: string;
    /** The log of a program that draws the target. */
    log?: NamedText | undefined;
    /** If given: the challenge is also met if all of them hold (checks.ts) and the picture is nearly the target. */
    checks?: string[];
    /** If given: only lines with one of these words may be changed. */
    may?: string[] | undefined;
}

/** A topic of the help. */
export interface Topic {
    id: string;
    title: string;
    html: string;
}
