// SPDX-License-Identifier: Apache-2.0
// Sessions of random use: no error in the console, and the picture is always that of the scene: the same page, reloaded, renders
// the same. Environment: GLINT_SESSIONS, their number; GLINT_SEED, that of the first.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {patience, picture, sceneText, settled, withPage} from './browser.mjs';

const sessions = Number(process.env.GLINT_SESSIONS ?? 2), firstSeed = Number(process.env.GLINT_SEED ?? 1);
const actionsPerRound = 14, rounds = 2;

/** Numbers from 0 to 1 (mulberry32). */
function randomOf(seed) {
    let state = seed * 0x9E3779B9;
    return () => {
        state = (state + 0x6D2B79F5) | 0;
        let t = Math.imul(state ^ (state >>> 15), 1 | state);
        t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
        return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
    };
}

/** What a user could do next, each with its weight. */
function actionsOf(page, random) {
    const pick = (list) => list[Math.floor(random() * list.length)];
    const within = async (selector) => {
        const box = await page.locator(selector).first().boundingBox({timeout: 1000});
        return box && [box.x + box.width * (0.05 + 0.9 * random()), box.y + box.height * (0.05 + 0.9 * random())];
    };
    const drag = async (selector, key) => {
        const at = await within(selector);
        if (!at) return 'nothing';
        if (key) await page.keyboard.down(key);
        await page.mouse.move(...at);
        await page.mouse.down();
        for (let i = 0; i < 4; ++i) await page.mouse.move(at[0] + 60 * (random() - 0.5), at[1] + 60 * (random() - 0.5));
        await page.mouse.up();
        if (key) await page.keyboard.up(key);
        return selector;
    };
    /** One of the visible controls that match, as a locator and its name. */
    const control = async (selector) => {
        const all = page.locator(`:is(${selector}):visible:not(:disabled)`);
        const count = await all.count();
        if (count === 0) return null;
        const one = all.nth(Math.floor(random() * count));
        const name = await one.evaluate((element) => element.getAttribute('aria-label') ?? element.labels?.[0]?.textContent ?? element.textContent, null, {timeout: 1000});
        // Not those that save files, copy, or leave the page.
        return /save|full screen|share|copy|choose|open|command|link|embed/i.test(name) ? null : {one, name: name.slice(0, 40)};
    };
    return [
        [3, async () => {
            await page.getByRole('button', {name: 'Scenes', exact: true}).click({timeout: 2000});
            const scene = page.locator('[data-scene]').nth(Math.floor(random() * 18));
            const name = await scene.getAttribute('data-scene', {timeout: 1000});
            await scene.click({timeout: 2000});
            return name;
        }],
        [4, async () => {
            const at = await within('.frame');
            if (at) await page.mouse.click(...at);
            return 'a pixel';
        }],
        [4, () => drag('.frame', pick([undefined, undefined, 'Shift']))],
        [2, async () => {
            const at = await within('.frame');
            if (!at) return 'nothing';
            await page.mouse.move(...at);
            await page.mouse.wheel(0, pick([-200, 200, 500]));
            return 'the wheel';
        }],
        [6, async () => {
            const found = await control('input[type=number], input[type=range], select, input[type=checkbox]');
            if (!found) return 'nothing';
            const type = await found.one.evaluate((element) => element.type);
            if (type === 'checkbox') {
                await found.one.click({timeout: 1000, force: true});
            } else if (type.startsWith('select')) {
                await found.one.selectOption({index: Math.floor(random() * await found.one.locator('option').count())}, {timeout: 1000});
            } else {
                const now = Number(await found.one.inputValue());
                const next = pick([0, 1, 2, 3, 0.5, now * 1.1, now * 0.7 + 0.1, now + 1]);
                await found.one.evaluate((input, value) => {
                    input.focus();
                    input.value = String(value);
                    input.dispatchEvent(new Event('input', {bubbles: true}));
                }, Number(next.toPrecision(4)));
            }
            return found.name;
        }],
        [5, async () => {
            const found = await control('.side button, .stage button, .side summary, [role=tab]');
            await found?.one.click({timeout: 1000});
            return found?.name ?? 'nothing';
        }],
        [3, async () => {
            const key = pick(['Control+z', 'Control+z', 'Control+Shift+z', 'n', 'p', 'Escape', 'Enter', 'ArrowLeft', 'Shift+ArrowDown']);
            await page.locator('.frame').focus({timeout: 1000});
            await page.keyboard.press(key);
            return key;
        }],
        [3, async () => {
            const line = page.locator('.cm-line');
            await line.nth(Math.floor(random() * await line.count())).click({timeout: 1000});
            const words = pick(['Control+Shift+K', '1', '0', ' ', 'Backspace', '}', '# ', 'Enter']);
            if (words.length > 2) {
                await page.keyboard.press(words);
            } else {
                await page.keyboard.type(words);
            }
            return `types ${words}`;
        }],
        [2, () => drag('.space-frame')],
        [2, async () => {
            const handles = page.locator('.handle');
            const count = await handles.count();
            if (count === 0) return 'nothing';
            await handles.nth(Math.floor(random() * count)).press(pick(['ArrowLeft', 'ArrowUp', 'PageUp', 'Shift+ArrowRight']), {timeout: 1000});
            return 'a handle';
        }],
        [1, async () => {
            const [width, height] = pick([[1440, 900], [1100, 700], [500, 800]]);
            await page.setViewportSize({width, height});
            return `${width} wide`;
        }],
    ];
}

/** Waits until nothing happens any more; the picture's state. */
async function quiet(page) {
    for (let last = ''; ;) {
        await settled(page, 'done', 'error');
        await page.waitForTimeout(150);
        const now = await page.locator('[data-state]').evaluate((element) => element.dataset.state + element.textContent);
        if (now === last) return now.startsWith('done') ? 'done' : 'error';
        last = now.startsWith('rendering') ? '' : now;
    }
}

for (let seed = firstSeed; seed < firstSeed + sessions; ++seed) {
    test(`random use, seed ${seed}`, {timeout: 1_200_000}, async () => {
        const log = [];
        const random = randomOf(seed);
        try {
            await withPage(async (page) => {
                page.setDefaultTimeout(2000);
                page.setDefaultNavigationTimeout(patience);
                const actions = actionsOf(page, random);
                const all = actions.reduce((sum, [weight]) => sum + weight, 0);
                for (let round = 0; round < rounds; ++round) {
                    for (let i = 0; i < actionsPerRound; ++i) {
                        let at = random() * all;
                        const [, act] = actions.find(([weight]) => (at -= weight) < 0);
                        // What is not there (any more) is not used.
                        log.push(await act().catch((error) => {
                            if (!/Timeout|not attached|detached|not visible|intercepts|No node found|out of range/i.test(error.message)) throw error;
                            return 'not there';
                        }));
                        if (random() < 0.3) await page.waitForTimeout(400 * random());
                    }
                    // Menus cover the page.
                    while (await page.locator('dialog[open]').count() > 0) await page.keyboard.press('Escape');
                    await page.setViewportSize({width: 1440, height: 900});
                    const state = await quiet(page), text = await sceneText(page), before = await picture(page);
                    await page.reload();
                    await page.locator('.cm-content').waitFor({timeout: patience});
                    assert.equal(await quiet(page), state);
                    assert.equal(await sceneText(page), text, 'the text after a reload');
                    if (state === 'done') assert.deepEqual(await picture(page), before, 'the picture is stale');
                }
            });
        } catch (error) {
            error.message += `\nseed ${seed}: ${log.join('; ')}`;
            throw error;
        }
    });
}
