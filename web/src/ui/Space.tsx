// SPDX-License-Identifier: Apache-2.0
// The place of the view in space, in the inspector or in that of the picture. Its code is loaded after the first picture.
import {type Signal, signal} from '@preact/signals';
import type {ComponentType} from 'preact';
import {useEffect} from 'preact/hooks';

import {fetchLater} from '../store/later';
import {isLarge, isOpen, turn} from '../store/space';
import {info, isPictureOfScene} from '../store/state';
import {startTurn} from '../space/frame';
import {StepButtons} from './StepButtons';
import {ownRays} from './own_rays';

const loaded: Signal<ComponentType | null> = signal(null);

async function load() {
    loaded.value ??= (await import('../space/SpaceView')).SpaceView;
}

fetchLater(load);

function Content() {
    useEffect(() => {
        load().catch(() => {
            isOpen.value = false;
        });
    }, []);
    const View = loaded.value;
    return View && info.value && isPictureOfScene.value ? <View /> : <div class="space-body" />;
}

const legend = [['camera', 'camera'], ['mirror', 'mirror'], ['transmitted', 'glass'], ['light', 'light'], ['blocked', 'blocked'], ['dark', 'no light']] as const;

export function Space() {
    const {cut, zoom} = turn.value;
    const set = (to: Partial<typeof turn.value>) => {
        turn.value = {...turn.value, ...to};
    };
    return (
        <section class="space" aria-label="View in space">
            <div class="space-head">
                {isLarge.value ? <h2>In space</h2> : <h3>In space</h3>}
                <button class="button space-size" onClick={() => {
                    isLarge.value = !isLarge.value;
                    requestAnimationFrame(() => document.querySelector<HTMLElement>('.space-size')?.focus());
                }}>{isLarge.value ? 'Back to the picture' : 'Large'}</button>
                <button class="quiet" aria-label="Zoom in" title="Zoom in (+)" onClick={() => set({zoom: Math.min(50, 1.2 * zoom)})}>+</button>
                <button class="quiet" aria-label="Zoom out" title="Zoom out (-)" onClick={() => set({zoom: Math.max(0.1, zoom / 1.2)})}>−</button>
                <button class="quiet" aria-label="Reset the view" title="As at first (0)" onClick={() => set(startTurn)}>⟲</button>
                <button class="quiet" aria-label="Close the view" title="Close" onClick={() => {
                    isOpen.value = isLarge.value = false;
                }}>✕</button>
            </div>
            <Content />
            <StepButtons />
            <label class="cut">Cut away <input type="range" min={-1} max={1} step={0.05} value={cut} onInput={(event) => set({cut: event.currentTarget.valueAsNumber})} /></label>
            <p class="legend">
                {legend.map(([kind, words]) => <span key={kind}><span class={`ray-key ${kind}`} /> {words}</span>)}
                {ownRays(1).length > 0 && <span><span class="ray-key yours" /> yours</span>}
            </p>
        </section>
    );
}

/** In the inspector: the view, or a button that opens it. */
export function SpaceInPanel() {
    if (isLarge.value) return null;
    if (isOpen.value) return <Space />;
    return <div><button class="button" onClick={() => {
        isOpen.value = true;
        requestAnimationFrame(() => document.querySelector<HTMLElement>('.space-size')?.focus());
    }}>Show the scene in space</button></div>;
}
