// SPDX-License-Identifier: Apache-2.0
// The view in space's own buttons for the rays of the pinned pixel: one by one, or by themselves.
import {useEffect} from 'preact/hooks';

import {pinned} from '../store/state';
import {isPlaying, play, stepBy, steps} from '../store/stepping';
import {itemName, rayNames} from './words';

/** A ray is shown for so long, in milliseconds. */
const pace = 1900;

export function StepButtons() {
    const now = steps.value, isOn = isPlaying.value;
    useEffect(() => {
        if (!isOn) return undefined;
        const timer = setInterval(() => {
            if (!steps.value || (steps.value.at ?? 0) + 1 >= steps.value.order.length) isPlaying.value = false;
            else stepBy(1);
        }, pace);
        return () => clearInterval(timer);
    }, [isOn]);
    if (!now || !pinned.value) return null;
    const ray = now.ray === null ? null : pinned.value.rays[now.ray]!;
    return (
        <div class="step-buttons" role="group" aria-label="Rays in space">
            <button class="quiet" aria-label="Step back" title="The ray before (p)" onClick={() => stepBy(-1)}>‹</button>
            <button class="button" aria-pressed={isOn} onClick={() => play(!isOn)}>{isOn ? 'Stop' : 'Play'}</button>
            <button class="quiet" aria-label="Step forward" title="The next ray (n)" onClick={() => stepBy(1)}>›</button>
            <span>{ray === null ? `${now.order.length} ${now.order.length === 1 ? 'ray' : 'rays'}` : `${now.at! + 1} of ${now.order.length}: ${rayNames[ray.kind].toLowerCase()} ${ray.hit ? `hits ${itemName(ray.hit.shape)}` : 'leaves the scene'}`}</span>
        </div>
    );
}
