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
    assert.equal(await ticks.count(), 12);
    for (let i = 0; i < 12; ++i) assert.equal(await ticks.nth(i).getAttribute('aria-label'), 'done');
}));

const challenges = readdirSync(join(project, 'web/challenges')).sort();

test('every challenge is met by its target, and not before', () => withPage(async (page) => {
    assert.equal(challenges.filter((name) => !name.startsWith('case')).length, 10);
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
            await page.locator('.hints li').first().waitFor({timeout: 180_000});  // the search may take two minutes
            assert.match(await page.locator('.hints').innerText(), /exponent|shininess/i);
            await shoot(page, 'challenge.png');
        }
        await paste(page, target);
        await page.waitForSelector('.challenge[data-done=true]');
        assert.match(await page.locator('.difference').innerText(), /is the target/);
    }
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
