// SPDX-License-Identifier: Apache-2.0
// The checks of the lessons' steps, by the engine without a browser: each step is done by its solution and by other right ways, and not
// before nor by near misses, for which the page says what is missing.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {ways} from './lesson_ways.mjs';
import {load, pageModule} from './page_module.mjs';

const glint = await load();

const {examine} = await pageModule('learn/checks.ts'), {solutionOf} = await pageModule('learn/solution.ts');
const {lessons} = await pageModule('lessons/lessons.ts');

/** The text after the actions, and the pixel that they click. */
function act(text, actions) {
    let pixel = null;
    for (const action of actions.split('; ')) {
        const [, what, rest] = /^(\w+) ([^]*)$/.exec(action);
        if (what === 'pin') pixel = rest.split(',').map(Number);
        else if (what === 'append') text += `${rest}\n`;
        else if (what === 'prepend') text = `${rest}\n${text}`;
        else {
            const [from, to] = rest.split(' => ');
            assert.ok(text.includes(from), `${from} is not in the text`);
            text = text.replace(from, () => to);
        }
    }
    return {text, pixel};
}

/** What is missing; '' if the step is done. */
async function missing(step, {text, pixel}) {
    const scene = glint.open({texts: [{name: 'lesson.glint', text}]});
    try {
        assert.ok(scene.report.ready, scene.report.diagnostics.map((one) => one.text).join(''));
        const {info} = scene;
        const explain = async (x, y) => scene.explain(Math.floor(x * info.width), Math.floor(y * info.height));
        const situation = {info, pinned: pixel ? await explain(...pixel) : null, explain};
        for (const check of step.checks) {
            const verdict = await examine(check, situation);
            if (!verdict.holds) return verdict.missing;
        }
        return '';
    } finally {
        scene.close();
    }
}

test('of nothing no value is said', async () => {
    const {steps, scene} = lessons.find(({id}) => id === '02_diffuse');
    assert.match(await missing(steps[2], {text: scene.text, pixel: [0.05, 0.05]}), /^There is no N·L at the clicked pixel here/);
});

for (const lesson of lessons) {
    test(`${lesson.id}: right ways and near misses`, async () => {
        assert.equal(ways[lesson.id].length, lesson.steps.length);
        for (const [number, step] of lesson.steps.entries()) {
            const where = `step ${number + 1}`;
            const before = number === 0 ? lesson.scene.text : solutionOf(lesson, number - 1).text;
            assert.notEqual(await missing(step, {text: before, pixel: null}), '', `${where} is done before it begins`);
            assert.equal(await missing(step, solutionOf(lesson, number)), '', `${where}: the solution`);
            const {right, near} = ways[lesson.id][number];
            assert.ok(right.length >= 3 && near.length >= 2, where);
            for (const way of right) assert.equal(await missing(step, act(before, way)), '', `${where}: ${way}`);
            for (const way of near) {
                const said = await missing(step, act(before, way));
                assert.match(said, /^[^{}`]+\.$/, `${where}: ${way}`);
            }
        }
    });
}
