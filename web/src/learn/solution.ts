// SPDX-License-Identifier: Apache-2.0
// The solutions of steps: what they change in the text, and where they click.
import type {Lesson} from './types';

export interface Solution {
    /** The scene's text after the step. */
    text: string;
    /** Its lines that differ from those of the step before. */
    lines: string[];
    /** The pixel to click, as fractions of the picture's size. */
    pixel: [number, number] | null;
}

/** The text after one action; null if the action does not fit the text. */
function after(text: string, action: string): string | null {
    const [, what, rest] = /^(\w+) (.*)$/.exec(action)!;
    if (what === 'append') return `${text}${rest}\n`;
    if (what === 'prepend') return `${rest}\n${text}`;
    const [from, to] = rest!.split(' => ') as [string, string];
    return text.includes(from) ? text.replace(from, () => to) : null;
}

/** The solution of a step, after those of the steps before. */
export function solutionOf(lesson: Lesson, number: number): Solution {
    let {text} = lesson.scene, before = text;
    let pixel: Solution['pixel'] = null;
    for (const step of lesson.steps.slice(0, number + 1)) {
        if (step.scene) ({text} = step.scene);
        before = text;
        pixel = null;
        for (const action of step.solution.split('\n')) {
            if (action.startsWith('pin ')) {
                const [x, y] = action.slice(4).split(',').map(Number) as [number, number];
                pixel = [x, y];
                continue;
            }
            text = after(text, action) ?? text;
        }
    }
    const old = new Set(before.split('\n'));
    return {text, lines: text.split('\n').filter((line) => !old.has(line)), pixel};
}
