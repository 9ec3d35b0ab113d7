// SPDX-License-Identifier: Apache-2.0
// Lessons and challenges: each can be done, none is done by itself, and from the first visit a reader is led to them.
import assert from 'node:assert/strict';
import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {address, clickPicture, paste, picture, project, nativeText, sceneText, settled, shoot, withPage} from './browser.mjs';

const lessons = readdirSync(join(project, 'docs/lessons')).filter((name) => /^\d/.test(name)).sort().map((name) => name.replace('.md', ''));

/** Does one action of a solution. */
async function act(page, action) {
    const [, what, rest] = /^(\w+) (.*)$/.exec(action);
    if (what === 'pin') {
        const [x, y] = rest.split(',').map(Number);
        await clickPicture(page, x, y);
        await page.getByRole('tab', {name: 'Inspect', selected: true}).waitFor();  // opens with the explanation, some time after the click
        return;
    }
    const text = await sceneText(page);
    const [from, to] = rest.split(' => ');
    if (what === 'replace') assert.ok(text.includes(from), `${from} is not in the text`);
    const now = what === 'append' ? `${text}${rest}\n` : what === 'prepend' ? `${rest}\n${text}` : text.replace(from, () => to);
    assert.notEqual(now, text);
    await paste(page, now);
}

test('every step of every lesson is done by its solution, and not before', () => withPage(async (page) => {
    await page.locator('.welcome').getByRole('button', {name: 'A lesson'}).click();
    await page.locator('.lesson').waitFor();
    for (const id of lessons) {
        if (id !== lessons[0]) {
            await page.getByRole('button', {name: 'All lessons and challenges'}).click();
            await page.locator(`[data-lesson="${id}"]`).click();
        }
        await page.locator(`.lesson[data-open="${id}"]`).waitFor();
        await page.waitForFunction((name) => document.querySelector('.file-name').textContent === name, `${id.slice(3)}.glint`);
        await settled(page);
        const markdown = readFileSync(join(project, `docs/lessons/${id}.md`), 'utf8');
        const solutions = [...markdown.matchAll(/```solution\n([^]*?)\n```/g)].map(([, text]) => text);
        for (const [i, solution] of solutions.entries()) {
            const step = page.locator(`.step[data-step="${i}"]`);
            assert.equal(await step.getAttribute('data-done'), 'false', `${id}, step ${i + 1} is done before it begins`);
            for (const action of solution.split('\n')) await act(page, action);
            await page.getByRole('tab', {name: 'Learn'}).click();
            await page.waitForSelector(`.step[data-step="${i}"][data-done=true]`)
                .catch(() => assert.fail(`${id}, step ${i + 1}: ${solution}`));
            if (id === '04_blinn' && i === 0) await shoot(page, 'lesson.png');
            if (i + 1 < solutions.length) await page.getByRole('button', {name: 'Next step'}).click();
        }
        if (id === '01_ambient') assert.ok(await page.locator('.lesson math').count() > 0, 'formulas');
        assert.deepEqual(await picture(page), nativeText('lesson.glint', await sceneText(page)));
    }
    await page.getByRole('button', {name: 'All lessons and challenges'}).click();
    const ticks = page.locator('.learn-list').first().locator('.tick');
    assert.equal(await ticks.count(), lessons.length);
    for (let i = 0; i < lessons.length; ++i) assert.equal(await ticks.nth(i).getAttribute('aria-label'), 'done');
}));

const challenges = readdirSync(join(project, 'web/challenges')).sort();

test('every challenge is met by its target, and not before', () => withPage(async (page) => {
    assert.equal(challenges.filter((name) => name.startsWith('c0') || name.startsWith('c1')).length, 10);
    await page.locator('.welcome').getByRole('button', {name: 'A challenge'}).click();
    for (const name of challenges) {
        const id = name.replace('.glint', '');
        if (name !== challenges[0]) {
            await page.getByRole('button', {name: 'All lessons and challenges'}).click();
            await page.locator(`[data-challenge="${id}"]`).click();
        }
        const open = page.locator(`.challenge[data-open="${id}"]`);
        await open.waitFor();
        await page.waitForFunction((wanted) => document.querySelector('.file-name').textContent === wanted, name);
        await page.waitForFunction(() => /% of the pixels differ/.test(document.querySelector('.difference').textContent));
        assert.equal(await open.getAttribute('data-done'), 'false', id);
        const [target] = readFileSync(join(project, 'web/challenges', name), 'utf8').split('\n').slice(1).join('\n').split('---\n');
        // Nothing that is shown gives the answer away.
        assert.doesNotMatch(await sceneText(page), /#|\/\//);
        if (id === 'c04') {
            await page.waitForSelector('.target[data-complete]');
            await page.getByRole('button', {name: 'Give me a hint'}).click();
            await page.locator('.hints li').first().waitFor();
            assert.match(await page.locator('.hints').innerText(), /^Your picture here: .*highlight/);
            const more = page.getByRole('button', {name: 'Another hint'});
            while (await more.isEnabled()) await more.click();
            assert.match(await page.locator('.hints').innerText(), /its shininess\./);
            await shoot(page, 'challenge.png');
        }
        if (id.startsWith('log')) await page.waitForFunction(() => document.querySelectorAll('.logged.wrong').length > 2);
        await paste(page, target);
        await page.waitForSelector('.challenge[data-done=true]');
        assert.match(await page.locator('.difference').innerText(), /is the target/);
        assert.equal(await page.locator('.hints').count(), 0, 'hints of an older picture');
        // It is not done in another picture, and then again.
        await paste(page, target.replace('intensity = 0.8', 'intensity = 0.1'));
        await page.waitForSelector('.challenge[data-done=false]');
        await page.getByText('You have done this before').waitFor();
    }
}));

test('a fault that is mended in another way than in the target is mended', () => withPage(async (page) => {
    await page.getByRole('tab', {name: 'Learn'}).click();
    await page.locator('[data-challenge="case_03"]').click();
    await page.waitForFunction(() => /% of the pixels differ/.test(document.querySelector('.difference').textContent));
    await page.waitForSelector('.target[data-complete]');
    await page.getByRole('button', {name: 'Give me a hint'}).click();
    await page.locator('.hints li').first().waitFor();
    assert.match(await page.locator('.hints').innerText(), /is blocked by the sphere “bulb”/);
    const text = await sceneText(page);
    for (const [from, to, isDone] of [
        ['color = (1, 1, 0.8)  ambient = 1', 'color = (1, 1, 0.8)  ambient = 1  casts_shadow = false', true], [/sphere "bulb".*\n/, '', true],
        ['intensity = 0.2', 'intensity = 0.5', false], ['radius = 0.25', 'radius = 0.2', false],
    ]) {
        await paste(page, text.replace(from, to));
        await settled(page);
        await page.waitForSelector(`.challenge[data-done=${isDone}]`);
    }
    await paste(page, text.replace(/sphere "bulb".*\n/, ''));
    await page.getByRole('button', {name: 'Next challenge'}).click();
    await page.locator('.challenge[data-open="case_04"]').waitFor();
}));

test('a step says what is missing, is applied by a button, and is not done in another picture', () => withPage(async (page) => {
    await page.locator('.welcome').getByRole('button', {name: 'A lesson'}).click();
    const step = page.locator('.step[data-step="0"]');
    await step.getByText('The ambient light’s intensity is 0.2: it has to be at least 0.6.').waitFor();
    const text = await sceneText(page);
    await paste(page, text.replace('intensity = 0.2', 'intensity = 0.4'));
    await step.getByText('intensity is 0.4').waitFor();
    await step.getByText('Solution').click();
    assert.match(await step.locator('.solution pre').innerText(), /^light { type = ambient {2}intensity = 0\.8 }$/);
    await step.getByRole('button', {name: 'Apply'}).click();
    await page.waitForSelector('.step[data-step="0"][data-done=true]');
    await paste(page, text);
    await step.getByText('Not done in this picture: The ambient light’s').waitFor();
    await paste(page, text.replace('intensity = 0.2', 'intensity = )'));
    await step.getByText('The scene has an error').waitFor();
}));

test('undo stays in its lesson, and Back returns to the scene before', () => withPage(async (page) => {
    const before = await sceneText(page);
    await page.locator('.welcome').getByRole('button', {name: 'A lesson'}).click();
    await page.locator('.lesson').waitFor();
    assert.ok(await page.getByRole('button', {name: 'Undo'}).isDisabled());
    const text = await sceneText(page);
    await paste(page, text.replace('intensity = 0.2', 'intensity = 0.4'));
    await page.getByRole('button', {name: 'Undo'}).click();
    assert.equal(await sceneText(page), text);
    await page.goBack();
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'three_mirrors.cgfs');
    assert.equal(await sceneText(page), before);
}));

test('a teacher’s challenge is a link', () => withPage(async (page, context) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    await page.getByRole('tab', {name: 'Learn'}).click();
    await page.getByText('Your own challenge').click();
    await page.getByRole('button', {name: 'This is the target'}).click();
    const target = await sceneText(page);
    await paste(page, target.replace('intensity = 0.6', 'intensity = 0.1'));
    await settled(page);
    await page.getByRole('textbox', {name: 'Task'}).fill('Find the light of this picture.');
    await page.getByRole('textbox', {name: 'May change'}).fill('intensity');
    await page.getByRole('textbox', {name: 'May change'}).blur();
    await page.getByRole('button', {name: /^Copy the challenge/}).click();
    await page.waitForFunction(() => /copied/.test(document.querySelector('.notice')?.textContent));
    const link = await page.evaluate(() => navigator.clipboard.readText());
    const other = await context.newPage();
    await other.goto(link);
    await settled(other);
    await other.getByRole('heading', {name: 'Find the light of this picture.'}).waitFor();
    // Another line may not be changed.
    await paste(other, target.replace('radius = 1 ', 'radius = 1.0 '));
    await other.waitForFunction(() => /may not be changed/.test(document.querySelector('[role=alert]')?.textContent));
    await other.waitForFunction(() => /is the target/.test(document.querySelector('.difference').textContent));
    assert.equal(await other.locator('.challenge').getAttribute('data-done'), 'false');
    await paste(other, target);
    await other.waitForSelector('.challenge[data-done=true]');
    await other.close();
    assert.ok(link.startsWith(address));
}));
