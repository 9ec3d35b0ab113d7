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

/** What the checks ask of a log, as the page finds it when the pixel is clicked. */
function factsOf(log, scene, pixel) {
    if (!log) return {wrong: null, chosen: null};
    const {rows, wrong_pixels: wrong} = scene.diagnose(log.text, {name: log.name});
    const {width, height} = scene.info;
    const clicked = pixel && [Math.floor(pixel[0] * width), Math.floor(pixel[1] * height)].join();
    const ofPixel = rows.filter((row) => row.pixel.join() === clicked);
    const first = ofPixel.find(({verdict}) => verdict === 'wrong');
    return {wrong, chosen: ofPixel.length > 0 ? first?.quantity ?? 'none' : null};
}

/** What is missing; '' if the step is done. */
async function missing(step, {text, pixel}, log = null) {
    const scene = glint.open({texts: [{name: 'lesson.glint', text}]});
    try {
        assert.ok(scene.report.ready, scene.report.diagnostics.map((one) => one.text).join(''));
        const {info} = scene;
        const explain = async (x, y) => scene.explain(Math.floor(x * info.width), Math.floor(y * info.height));
        const situation = {info, pinned: pixel ? await explain(...pixel) : null, explain, log: factsOf(log, scene, pixel)};
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
    const missingIn = (step, state) => missing(step, state, lesson.log);
    test(`${lesson.id}: right ways and near misses`, async () => {
        assert.equal(ways[lesson.id].length, lesson.steps.length);
        for (const [number, step] of lesson.steps.entries()) {
            const where = `step ${number + 1}`;
            const before = number === 0 ? lesson.scene.text : solutionOf(lesson, number - 1).text;
            assert.notEqual(await missingIn(step, {text: before, pixel: null}), '', `${where} is done before it begins`);
            assert.equal(await missingIn(step, solutionOf(lesson, number)), '', `${where}: the solution`);
            const {right, near} = ways[lesson.id][number];
            assert.ok(right.length >= 3 && near.length >= 2, where);
            for (const way of right) assert.equal(await missingIn(step, act(before, way)), '', `${where}: ${way}`);
            for (const way of near) {
                const said = await missingIn(step, act(before, way));
                assert.match(said, /^[^{}`]+\.$/, `${where}: ${way}`);
            }
        }
    });
}
