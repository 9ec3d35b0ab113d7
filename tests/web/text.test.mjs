// SPDX-License-Identifier: Apache-2.0
// The text: errors are shown at their place; undo; conversion.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';

import {book, choose, drop, native, nativeText, paste, picture, sceneText, scenes, settled, shoot, withPage} from './browser.mjs';

test('a mistake is shown at its line and column, and the last good picture stays', () => withPage(async (page) => {
    const before = await picture(page);
    const bad = book.replace('(2, 0, 4) ', '(2, oops, 4) ');
    await paste(page, bad);
    await settled(page, 'error');
    const line = bad.split('\n').findIndex((text) => text.includes('oops')) + 1;
    const column = bad.split('\n')[line - 1].indexOf('oops') + 1;
    const message = page.locator('.message.error');
    assert.match(await message.innerText(), new RegExp(`^${line}:${column}\\s*expected a number, found 'oops'`));
    assert.match(await page.locator('[data-state=error]').innerText(), new RegExp(`^not rendered: ${line}:${column} expected a number, found 'oops'`));
    const marked = page.locator('.cm-lintRange-error');
    assert.equal(await marked.innerText(), 'oops');
    assert.deepEqual(await picture(page), before);

    await page.locator('.cm-line').first().click();
    await message.click();
    await page.waitForFunction((rest) => document.querySelector('.editor').shadowRoot.getSelection().toString() === rest,
        bad.split('\n')[line - 1].slice(column - 1));

    await paste(page, book);
    await settled(page);
    assert.deepEqual(await picture(page), before);
    assert.equal(await page.locator('.message').count(), 0);

    // Typing over several lines leaves no report of forbidden styles.
    await page.locator('.cm-line').nth(8).click();
    for (let i = 0; i < 6; ++i) await page.keyboard.press('Shift+ArrowDown');
    await page.keyboard.type('#');
    await page.waitForFunction((count) => document.querySelector('.editor').shadowRoot.querySelectorAll('.cm-line').length < count, book.split('\n').length - 1);
}));

test('columns count characters where the text is not ASCII', () => withPage(async (page) => {
    await paste(page, '# ü 🌞\nsphere { center = (0, 0, 3) radius = 1 color = (1, 2, 3) } # é\nlight { type = ambient intensity = "ßß" oops }');
    await settled(page, 'error');
    assert.match(await page.locator('.cm-lintRange-error').first().innerText(), /"ßß"/);
}));

test('every message of a scene that is only warned of', () => withPage(async (page) => {
    await paste(page, book.replace('radius = 1 ', 'radius = 1 spin = 7 '));
    await settled(page);
    assert.match(await page.locator('.message.warning').innerText(), /spin/);
    assert.ok(await page.locator('.cm-lintRange-warning').count() > 0);
}));

test('objects that glint does not render can be left out', () => withPage(async (page) => {
    await drop(page, {name: 'a.pov', text: 'light_source { <3, 4, -5>, 1 }\ncamera { location -5*z look_at 0 }\nblob { }\nsphere { 0, 1 pigment { rgb 1 } }\n'});
    await settled(page, 'error');
    assert.match(await page.locator('.message.error').innerText(), /does not render `blob`/);
    await page.getByRole('checkbox', {name: 'leave out what glint does not render'}).check();
    await settled(page);
    assert.match(await page.locator('.message.warning').innerText(), /left out 1 object that glint does not render: `blob`/);
    await page.getByRole('checkbox', {name: 'leave out what glint does not render'}).uncheck();
    await settled(page, 'error');
    // A mistake cannot be left out.
    await paste(page, 'sphere { 0 }');
    await page.waitForFunction(() => document.querySelector('.message.error')?.textContent.includes('expected'));
    assert.equal(await page.getByRole('checkbox', {name: 'leave out what glint does not render'}).count(), 0);
}));

test('undo and redo, of typing and of settings beside the text', () => withPage(async (page) => {
    const phong = await picture(page);
    await page.getByRole('combobox', {name: 'Shading'}).selectOption('blinn-phong');
    await settled(page);
    assert.match(await page.locator('.outside').innerText(), /shading = blinn-phong/);
    const blinn = native(join(scenes, 'cgfs/three_mirrors.cgfs'), '--shading', 'blinn-phong');
    assert.deepEqual(await picture(page), blinn);
    await page.getByRole('button', {name: 'Undo'}).click();
    await settled(page);
    assert.deepEqual(await picture(page), phong);
    assert.equal(await page.locator('.outside').count(), 0);
    await page.getByRole('button', {name: 'Redo'}).click();
    await settled(page);
    assert.deepEqual(await picture(page), blinn);
}));

test('a scene is converted to .glint, with what its own format cannot say, and back by undo', () => withPage(async (page) => {
    await page.getByRole('combobox', {name: 'Shading'}).selectOption('blinn-phong');
    await settled(page);
    const before = await picture(page);
    await page.getByRole('button', {name: /^Convert to .glint/}).click();
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'three_mirrors.glint');
    await settled(page);
    const text = await sceneText(page);
    assert.match(text, /blinn-phong/);
    assert.deepEqual(await picture(page), before);
    assert.deepEqual(nativeText('three_mirrors.glint', text), before);
    assert.equal(await page.locator('.outside').count(), 0);
    assert.match(await page.locator('.notice').innerText(), /^The scene is now three_mirrors\.glint;/);
    await page.getByRole('button', {name: 'Undo'}).click();
    await settled(page);
    assert.equal(await page.locator('.notice').count(), 0);
    assert.equal(await sceneText(page), book);
    assert.equal(await page.locator('.file-name').innerText(), 'three_mirrors.cgfs');
    assert.match(await page.locator('.outside').innerText(), /shading = blinn-phong/);
    assert.deepEqual(await picture(page), before);
}));

test('one of several scenes in a file is chosen', () => withPage(async (page) => {
    const file = join(scenes, 'epfl/two_scenes.js');
    await drop(page, {name: 'two_scenes.js', text: readFileSync(file)});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'two_scenes.js');
    await settled(page);
    const menu = page.getByRole('combobox', {name: 'Scene of this file'});
    assert.equal(await menu.inputValue(), 'snowman');
    await menu.selectOption('pipes');
    await settled(page);
    assert.deepEqual(await picture(page), native(file, '--scene', 'pipes'));
    await page.getByRole('button', {name: 'Undo'}).click();
    await settled(page);
    assert.equal(await menu.inputValue(), 'snowman');
    assert.deepEqual(await picture(page), native(file));
}));

test('undo brings back the scene that was open before', () => withPage(async (page) => {
    const phrase = '# my own work\n';
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+Home');
    await page.keyboard.type(phrase);
    await page.getByRole('combobox', {name: 'Shading'}).selectOption('normals');
    await settled(page);
    const before = await picture(page);
    await choose(page, 'glint/still_life.glint');
    assert.equal(await page.locator('.outside').count(), 0);
    await page.locator('[data-light="1"]').getByRole('spinbutton', {name: 'Intensity'}).fill('0.5');
    await settled(page);
    const undo = page.getByRole('button', {name: 'Undo'});
    await undo.click();
    await settled(page);
    assert.deepEqual(await picture(page), native(join(scenes, 'glint/still_life.glint')));
    await undo.click();
    await settled(page);
    assert.equal(await page.locator('.file-name').innerText(), 'three_mirrors.cgfs');
    assert.equal(await sceneText(page), phrase + book);
    assert.deepEqual(await picture(page), before);
    await page.getByRole('button', {name: 'Redo'}).click();
    await settled(page);
    assert.deepEqual(await picture(page), native(join(scenes, 'glint/still_life.glint')));
}));

test('what is converted is the text itself: not a comparison’s side, and not the scene before a mistake', () => withPage(async (page) => {
    await page.getByRole('tab', {name: 'Compare'}).click();
    await page.getByRole('button', {name: '0 | 3 reflections'}).click();
    await settled(page);
    await page.getByRole('button', {name: 'convert to .glint'}).click();
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'three_mirrors.glint');
    await page.getByRole('button', {name: 'End the comparison'}).click();
    await settled(page);
    assert.deepEqual(await picture(page), native(join(scenes, 'cgfs/three_mirrors.cgfs')));
    await page.getByRole('button', {name: 'Undo'}).click();
    await paste(page, 'sphere { radius = oops }');
    await settled(page, 'error');
    await page.getByRole('button', {name: 'convert to .glint'}).click();
    await page.waitForFunction(() => /without errors/.test(document.querySelector('.notice')?.textContent));
    assert.equal(await sceneText(page), 'sphere { radius = oops }');
}));

const numberNear = (page, line, n) => page.locator('.cm-line').filter({hasText: line}).locator('.tok-number').nth(n);

test('a number in the text is dragged, and by keys; a whole drag is one change; text is still selected and clicked', () => withPage(async (page) => {
    const text = 'camera { position = (0, 0, -4)  look_at = (0, 0, 0) }\nlight { type = ambient  intensity = 0.5 }  # 7 lamps\nsphere { center = (1, 0, 0)  radius = 1.25  color = (1, 0.5, 0) }\nrender { size = 90 x 70 }\n';
    await drop(page, {name: 'drag.glint', text});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'drag.glint');
    await settled(page);
    const dragBy = async (number, pixels, pause = 0) => {
        const box = await number.boundingBox();
        await page.mouse.move(box.x + 4, box.y + box.height / 2);
        await page.mouse.down();
        await page.mouse.move(box.x + 4 + pixels / 2, box.y + box.height / 2, {steps: 3});
        await page.waitForTimeout(pause);
        await page.mouse.move(box.x + 4 + pixels, box.y + box.height / 2, {steps: 3});
        await page.mouse.up();
        await settled(page);
    };
    await dragBy(numberNear(page, 'ambient', 0), 30, 700);
    const brighter = text.replace('0.5 }', '0.8 }');
    assert.equal(await sceneText(page), brighter);
    assert.deepEqual(await picture(page), nativeText('drag.glint', brighter));
    await dragBy(numberNear(page, 'sphere', 0), -30);  // whole: a step is six pixels
    assert.match(await sceneText(page), /center = \(-4, 0, 0\)/);
    await page.getByRole('button', {name: 'Undo'}).click();
    assert.equal(await sceneText(page), brighter);
    await page.getByRole('button', {name: 'Undo'}).click();
    assert.equal(await sceneText(page), text, 'also with a pause in it');
    // A click places the cursor; Alt and the arrow keys change the number there, and elsewhere move the line.
    await numberNear(page, 'sphere', 3).click();
    await page.keyboard.press('Alt+ArrowUp');
    assert.match(await sceneText(page), /radius = 1\.35 /);
    await numberNear(page, 'sphere', 3).click();  // the button has taken the focus
    await page.keyboard.press('Alt+ArrowDown');
    assert.equal(await sceneText(page), text);
    await numberNear(page, 'sphere', 3).click();
    await page.keyboard.press('Home');
    await page.keyboard.press('Alt+ArrowUp');
    assert.match(await sceneText(page), /look_at = \(0, 0, 0\) }\nsphere/);
    await page.getByRole('button', {name: 'Undo'}).click();
    // A double click selects the whole number: what is typed replaces it.
    await numberNear(page, 'sphere', 3).dblclick();
    await page.keyboard.type('0.72');
    assert.match(await sceneText(page), /radius = 0\.72 /);
    await paste(page, text);
    await settled(page);
    // In a field the arrow keys move a number by its step, within its range.
    const intensity = page.getByRole('spinbutton', {name: 'Intensity'}).first();
    await intensity.press('ArrowUp');
    await settled(page);
    assert.doesNotMatch(await sceneText(page), /intensity = 0\.5 }/);
    await paste(page, text);
    await settled(page);
    // Digits of a comment are text; with Shift a drag selects.
    const comment = await page.locator('.tok-comment').boundingBox();
    await page.mouse.move(comment.x + 20, comment.y + 8);
    await page.mouse.down();
    await page.mouse.move(comment.x + 60, comment.y + 8, {steps: 4});
    await page.mouse.up();
    assert.equal(await sceneText(page), text);
}));

test('keys, blocks and values are completed from the reader’s tables, and the text is searched', () => withPage(async (page) => {
    await drop(page, {name: 'words.glint', text: 'camera { position = (0, 0, 5)  look_at = (0, 0, 0) }\nmaterial brass { color = (1, 1, 0) }\nsphere { center = (0, 0, 0)  radius = 1 }\n'});
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'words.glint');
    await settled(page);
    const list = page.locator('.cm-tooltip-autocomplete');
    /** Types words, checks the first completion and takes it. */
    const complete = async (words, expected) => {
        await page.keyboard.type(words, {delay: 10});
        await list.locator('[aria-selected]').filter({hasText: expected}).waitFor();
        await page.waitForTimeout(100);  // a list that has just appeared takes no key
        await page.keyboard.press('Enter');
        await list.waitFor({state: 'detached'});
    };
    await page.locator('.cm-content').click();
    await page.keyboard.press('Control+End');
    await complete('lig', 'light');
    await complete('ty', 'type');
    await complete('amb', 'ambient');
    await complete(' intens', 'intensity');
    await page.keyboard.type('0.7 }\n');
    await complete('sphe', 'sphere');
    await complete('cent', 'center');
    await page.keyboard.type('(1, 0, 0) ');
    await complete('mater', 'material');
    await complete('br', 'brass');
    await page.keyboard.type(' radius = 1 }\n');
    await complete('text', 'texture');
    await page.keyboard.type('wood { ');
    await complete('map', 'mapping');
    await complete('pla', 'planar');
    await page.keyboard.type(' texels = ("804020") }\n');
    await complete('conv', 'conventions');
    await page.keyboard.type('specular_g', {delay: 10});
    await list.getByText('specular_gate').waitFor();
    await page.locator('.cm-completionInfo').filter({hasText: 'N.L > 0'}).waitFor();
    await page.keyboard.press('Escape');
    await page.keyboard.type('ate = true }');
    await settled(page);
    const added = '\nlight { type = ambient intensity = 0.7 }\nsphere { center = (1, 0, 0) material = brass radius = 1 }\ntexture wood { mapping = planar texels = ("804020") }\nconventions { specular_gate = true }';
    assert.ok((await sceneText(page)).replaceAll(/ +/g, ' ').includes(added), await sceneText(page));
    await page.getByRole('button', {name: 'Find in the text'}).click();
    await page.locator('.cm-search [name=search]').fill('brass');
    await page.keyboard.press('Enter');
    assert.equal(await page.locator('.cm-searchMatch').count(), 2);
    await shoot(page, 'playground_search.png');
    await page.locator('.cm-search [name=close]').click();
    assert.equal(await page.locator('.cm-search').count(), 0);
}));

test('no control moves while it is used', () => withPage(async (page) => {
    // The first setting outside the text makes a box appear that says so.
    const slider = page.getByRole('slider', {name: 'Reflections'});
    const before = await slider.boundingBox();
    await page.mouse.move(before.x + before.width * 0.3, before.y + before.height / 2);
    await page.mouse.down();
    await page.mouse.move(before.x + before.width * 0.8, before.y + before.height / 2, {steps: 5});
    await page.waitForSelector('.outside');
    assert.deepEqual(await slider.boundingBox(), before);
    await page.mouse.up();
    await settled(page);
    assert.deepEqual(await slider.boundingBox(), before);
    assert.equal(await slider.inputValue(), '8');
}));
