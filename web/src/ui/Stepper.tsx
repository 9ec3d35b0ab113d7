// SPDX-License-Identifier: Apache-2.0
// Steps through the pinned pixel's rays: the tree, the view in space and the picture show the present one, and the sum grows.
import {useEffect} from 'preact/hooks';

import {addedBy, goTo, stepBy, steps} from '../store/stepping';
import {pinned} from '../store/state';
import {css, itemName, rayNames, short, shortColor} from './words';

/** Opens the present ray in the tree, and brings it into sight. */
function useTree(ray: number | null | undefined) {
    useEffect(() => {
        const node = ray === null || ray === undefined ? null : document.querySelector(`.tree [data-ray="${ray}"]`);
        for (let outer: Element | null = node; outer; outer = outer.parentElement?.closest('.ray-node') ?? null) outer.setAttribute('open', '');
        node?.querySelector('summary')?.scrollIntoView({block: 'nearest'});
    }, [ray]);
}

export function Stepper() {
    const now = steps.value, explanation = pinned.value;
    useTree(now?.ray);
    if (!now || !explanation) return null;
    const {order, at, sum} = now;
    const ray = now.ray === null ? null : explanation.rays[now.ray]!;
    const most = Math.max(1e-6, ...explanation.value, ...sum);
    return (
        <section class="stepper" aria-label="Ray by ray">
            <div class="stepper-buttons">
                <button class="quiet" aria-label="First ray" disabled={at === 0} onClick={() => goTo(0)}>«</button>
                <button class="button" aria-keyshortcuts="p" title="The ray before (p)" onClick={() => stepBy(-1)}>Previous</button>
                <button class="button" aria-keyshortcuts="n" title="The next ray (n)" onClick={() => stepBy(1)}>Next ray</button>
                <button class="button" aria-pressed={at === null} onClick={() => goTo(null)}>All</button>
                <span class="swatch large" style={{background: css(sum)}} aria-hidden="true" />
            </div>
            <p aria-live="polite">
                {ray === null ? (order.length === 1 ? 'This pixel has one ray.' : `All ${order.length} rays: n and p, or the buttons, go through them one by one.`)
                    : `Ray ${at! + 1} of ${order.length}: ${rayNames[ray.kind].toLowerCase()} ${ray.hit ? `hits ${itemName(ray.hit.shape)}` : 'leaves the scene'}, adds ${shortColor(addedBy(ray))}.`}
            </p>
            <div class="growing" data-sum-so-far={sum.join(' ')}>
                {(['red', 'green', 'blue'] as const).map((channel, c) => (
                    <div class="bar-row" key={channel}>
                        <span>{channel}</span>
                        <div class="bar"><span class={`part ${channel}`} style={{width: `${(100 * Math.max(0, sum[c]!)) / most}%`}} /></div>
                        <span class="mono">{short(sum[c])}</span>
                    </div>
                ))}
            </div>
        </section>
    );
}
