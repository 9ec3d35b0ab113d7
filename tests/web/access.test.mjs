// SPDX-License-Identifier: Apache-2.0
// The page without a mouse, on a small screen, and with the dark theme.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {bothSettled, choose, clickPicture, native, picture, saved, scenes, settled, shoot, until, withPage} from './browser.mjs';

/** Presses Tab until an element has the focus. */
async function tabTo(page, selector) {
    for (let i = 0; i < 120; ++i) {
        await page.keyboard.press('Tab');
        const found = await page.evaluate((wanted) => {
            let focused = document.activeElement;
            while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
            return focused?.matches(wanted) ?? false;
        }, selector);
        if (found) return;
    }
    assert.fail(`Tab does not lead to ${selector}`);
}

test('with the keyboard alone: a scene, a setting, a pixel, a picture', () => withPage(async (page) => {
    await tabTo(page, 'button[aria-haspopup=dialog]');
    await page.keyboard.press('Enter');
    await tabTo(page, '[data-scene$="castle.json"]');
    await page.keyboard.press('Enter');
    await page.waitForFunction(() => document.querySelector('.file-name').textContent === 'castle.json');
    await settled(page);
    await tabTo(page, '.frame');
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Shift+ArrowLeft');
    await page.waitForFunction(() => /line \d+/.test(document.querySelector('.pixel-line').textContent));
    await page.keyboard.press('Enter');
    await page.locator('.inspector').waitFor();
    assert.equal(await page.locator('.inspector').getAttribute('data-pixel'), '300,321');
    assert.equal((await saved(page, () => page.keyboard.press('s'))).name, 'castle_BlinnPhong.png');
    await page.keyboard.press('Escape');
    await page.locator('.empty').waitFor();
    await tabTo(page, '[role=tab][aria-selected=true]');
    await page.keyboard.press('ArrowLeft');
    await tabTo(page, 'select');
    await page.keyboard.press('ArrowUp');
    await settled(page);
    assert.deepEqual(await picture(page), native(`${scenes}/epfl/castle.json`, '--shading', 'phong'));
}));

test('everything that can be used has a name, and ids are unique', () => withPage(async (page) => {
    await clickPicture(page, 0.5, 0.62);
    await page.locator('.inspector').waitFor();
    for (const tab of ['Controls', 'Inspect', 'Compare']) {
        await page.getByRole('tab', {name: tab}).click();
        const nameless = await page.evaluate(() => [...document.querySelectorAll('button, input, select, [tabindex="0"], canvas, dialog')]
            .filter((e) => e.checkVisibility() && !e.ariaLabel && !e.getAttribute('aria-label') && !e.labels?.length && !e.textContent.trim() && !e.closest('[aria-label][role=application]'))
            .map((e) => e.outerHTML.slice(0, 120)));
        assert.deepEqual(nameless, []);
    }
    const ids = await page.evaluate(() => [...document.querySelectorAll('[id]')].map((e) => e.id));
    assert.equal(new Set(ids).size, ids.length);
}));

/** Texts with less than AA's contrast of 4.5 to their background, and fields whose edge has less than 3. */
function faintTexts(page) {
    return page.evaluate(() => {
        const canvas = document.createElement('canvas');
        canvas.width = canvas.height = 1;
        const context = canvas.getContext('2d', {willReadFrequently: true});
        const over = (color, behind) => {
            context.fillStyle = `rgb(${behind.join(' ')})`;
            context.fillRect(0, 0, 1, 1);
            context.fillStyle = color;
            context.fillRect(0, 0, 1, 1);
            return [...context.getImageData(0, 0, 1, 1).data].slice(0, 3);
        };
        const parent = (e) => e.parentElement ?? e.getRootNode().host ?? null;
        const background = (e) => {
            const chain = [];
            for (let at = e; at; at = parent(at)) chain.unshift(getComputedStyle(at).backgroundColor);
            return chain.reduce((behind, color) => over(color, behind), [255, 255, 255]);
        };
        const luminance = (rgb) => rgb.map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4))
            .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
        const between = (one, other) => {
            const [a, b] = [luminance(one), luminance(other)].sort((x, y) => y - x);
            return (a + 0.05) / (b + 0.05);
        };
        const faint = [];
        for (const e of document.querySelectorAll('select, input:is([type=number], [type=text])')) {
            if (!e.checkVisibility() || e.disabled) continue;
            const behind = background(e.parentElement);
            const contrast = between(over(getComputedStyle(e).borderTopColor, behind), behind);
            if (contrast < 3) faint.push(`${contrast.toFixed(2)} the edge of ${e.outerHTML.slice(0, 60)}`);
        }
        const visit = (root) => {
            for (const e of root.querySelectorAll('*')) {
                if (e.shadowRoot) visit(e.shadowRoot);
                const own = [...e.childNodes].some((n) => n.nodeType === Node.TEXT_NODE && n.textContent.trim());
                if (!own || !e.checkVisibility({opacityProperty: true}) || e.closest('.for-readers, :disabled, .frame, style')) continue;
                const behind = background(e), style = getComputedStyle(e);
                const contrast = between(over(e instanceof SVGElement ? style.fill : style.color, behind), behind);
                if (contrast < 4.5) faint.push(`${contrast.toFixed(2)} ${e.className} ${e.textContent.trim().slice(0, 30)}`);
            }
        };
        visit(document);
        return faint;
    });
}

for (const scheme of ['light', 'dark']) {
    test(`contrast is AA, ${scheme}`, () => withPage(async (page) => {
        await clickPicture(page, 0.5, 0.62);
        await page.locator('.inspector').waitFor();
        for (const tab of ['Inspect', 'Compare', 'Controls']) {
            await page.getByRole('tab', {name: tab}).click();
            assert.deepEqual(await faintTexts(page), []);
        }
        const [ground, words] = await page.evaluate(() => [getComputedStyle(document.body).backgroundColor, getComputedStyle(document.body).color]);
        const sum = (color) => color.match(/\d+/g).slice(0, 3).reduce((a, b) => a + Number(b), 0);
        assert.equal(sum(ground) > sum(words), scheme === 'light');
    }, {scheme}));
}

test('on a phone the header is one line, and a tapped pixel says its sentence beside the picture', () => withPage(async (page) => {
    const {height} = await page.locator('.header').boundingBox();
    assert.ok(height < 60, `${height} pixels`);
    await page.locator('.more summary').click();
    await page.getByRole('button', {name: 'Save PNG'}).waitFor();
    await page.locator('.more summary').click();
    await page.locator('.frame').tap();
    const line = page.locator('.sentence-line');
    await line.waitFor();
    assert.match(await line.innerText(), /light|background/);
    const box = await line.boundingBox();
    assert.ok(box.y + box.height < 740, 'in sight without scrolling');
}, {width: 360, height: 740, hasTouch: true, isMobile: true}));

test('at 360 pixels nothing is cut off, and every panel can be reached', () => withPage(async (page) => {
    const isIn = ({width, wide}) => width === 360 && wide.length === 0;
    const overflow = () => until(() => page.evaluate(() => {
        // Views of the scene clip what they show.
        const wide = [...document.querySelectorAll('body *')].filter((e) => e.checkVisibility() && e.getBoundingClientRect().right > 361 &&
            !e.closest('.frame, .space-body, .for-readers, .pixel-line')).map((e) => `${e.tagName} ${e.getAttribute('class')}`);
        return {width: document.documentElement.scrollWidth, wide};
    }), isIn);
    for (const tab of ['Controls', 'Compare', 'Text']) {
        await page.getByRole('tab', {name: tab}).click();
        assert.deepEqual(await overflow(), {width: 360, wide: []}, tab);
    }
    assert.ok(await page.locator('.cm-content').isVisible());
    await clickPicture(page, 0.5, 0.62);
    await page.locator('.inspector').waitFor();
    assert.deepEqual(await overflow(), {width: 360, wide: []}, 'Inspect');
    await shoot(page, 'playground_small.png');
    await page.getByRole('button', {name: 'the light'}).first().click();
    await page.waitForFunction(() => document.querySelector('.editor').checkVisibility());
    await choose(page, 'glint/still_life.glint');
}, {width: 360, height: 740}));

/** The middle of an element's box, from the top. */
const middle = async (locator) => {
    const {y, height} = await locator.boundingBox();
    return y + height / 2;
};

test('the menu of scenes is closed beside its title, on a phone too', async (t) => {
    for (const width of [360, 390, 1280]) await t.test(String(width), () => withPage(async (page) => {
        await page.getByRole('button', {name: 'Scenes', exact: true}).click();
        const menu = page.getByRole('dialog', {name: 'Scenes'}), close = menu.getByRole('button', {name: 'Close'});
        assert.ok(Math.abs(await middle(menu.getByRole('heading', {name: 'Scenes', exact: true})) - await middle(close)) < 4);
        const box = await close.boundingBox(), whole = await menu.boundingBox();
        assert.ok(whole.x + whole.width - box.x - box.width < 40, 'at the right end');
    }, {width, height: 800}));
});

test('the buttons of a first visit are one line', async (t) => {
    for (const width of [1024, 1280]) await t.test(String(width), () => withPage(async (page) => {
        const buttons = page.locator('.welcome .button');
        assert.equal(await buttons.count(), 3);
        assert.equal(await middle(buttons.first()), await middle(buttons.last()));
    }, {width, height: 800}));
});

test('a point that the line of a pixel has no room for ends with an ellipsis', () => withPage(async (page) => {
    await choose(page, 'castle.json');
    await clickPicture(page, 0.5, 0.55);
    const point = page.locator('.pixel-line .point');
    await point.waitFor();
    const {cut, shown, style, room} = await point.evaluate((e) => ({
        cut: e.scrollWidth > e.clientWidth, shown: e.getBoundingClientRect().right, style: getComputedStyle(e).textOverflow,
        room: e.closest('.pixel-line').getBoundingClientRect().right,
    }));
    assert.ok(cut && shown <= room + 1 && style === 'ellipsis', `${cut} ${shown} ${room} ${style}`);
    assert.equal(await point.getAttribute('title'), await point.textContent());
}, {width: 1280, height: 800}));

test('on a phone the picture stays in sight while its controls are used', () => withPage(async (page) => {
    const slider = page.locator('[data-light="2"]').getByRole('slider', {name: 'Direction z'});
    await slider.evaluate((input) => input.scrollIntoView({block: 'end'}));
    assert.ok(await page.evaluate(() => scrollY) > 100);
    const box = await page.locator('.frame').boundingBox(), under = await slider.boundingBox();
    assert.ok(box.y >= 0 && box.height > 200 && box.y + box.height < under.y, JSON.stringify([box, under]));
    await slider.click();
    await settled(page);
}, {width: 360, height: 740}));

test('the page, to look at', () => withPage(async (page) => {
    await choose(page, 'epfl/castle.json');
    await clickPicture(page, 0.585, 0.79);
    await page.locator('.inspector').waitFor();
    await page.waitForTimeout(800);
    await shoot(page, 'playground.png');
    await page.locator('.inspector .space').scrollIntoViewIfNeeded();
    await page.waitForTimeout(800);
    await shoot(page, 'playground_rays.png');
}));

test('the page in the dark, to look at', () => withPage(async (page) => {
    await choose(page, 'cgfs/three_mirrors.cgfs');
    await page.getByRole('tab', {name: 'Compare'}).click();
    await page.getByRole('button', {name: '0 | 3 reflections'}).click();
    await bothSettled(page);
    await shoot(page, 'playground_dark.png');
}, {scheme: 'dark'}));
