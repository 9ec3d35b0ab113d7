// SPDX-License-Identifier: Apache-2.0
import {useSignal} from '@preact/signals';
import {useEffect, useRef} from 'preact/hooks';

import {setComparison} from '../store/scene';
import {comparison, comparisonFailure, difference, info, settingOf, split} from '../store/state';
import {wordsOf} from './Controls';
import {Choice, Switch, TextField} from './fields';
import {Own} from './Own';
import {OwnLog} from './OwnLog';
import {canvases, firstDone, pixelsOf, secondDone} from './pictures';

const presets = [
    {label: 'Phong | Blinn-Phong', key: 'shading', a: 'phong', b: 'blinn-phong'},
    {label: '0 | 3 reflections', key: 'reflections', a: '0', b: '3'},
    {label: 'Shadows | none', key: 'shadows', a: 'true', b: 'false'},
    {label: 'Gated | ungated highlight', key: 'specular_gate', a: 'true', b: 'false'},
    {label: '1 | 3×3 samples', key: 'aa', a: '1', b: '3'},
];

/** Two values of a key: the scene's and another one. */
function twoValues(key: string): {a: string; b: string} {
    const setting = settingOf(key);
    const now = setting?.value ?? '';
    const words = setting && wordsOf(setting);
    const other = words ? words.find((word) => word !== now)! : String(Number(now) === 0 ? 1 : 0);
    return {a: now, b: other};
}

function Value({name, label, value, set}: {name: string; label: string; value: string; set: (v: string) => void}) {
    const words = settingOf(name) && wordsOf(settingOf(name)!);
    if (words) return <Choice label={label} value={value} values={words} set={set} />;
    return <TextField label={label} value={value} set={set} />;
}

/** The amplified difference of the two pictures, and its size. */
export function Difference() {
    const canvas = useRef<HTMLCanvasElement>(null);
    const figures = useSignal('');
    const done = [firstDone.value, secondDone.value].join();
    useEffect(() => {
        const {first, second} = canvases;
        if (!canvas.current || first.width !== second.width || first.height !== second.height) return;
        const {data, width, height} = pixelsOf(first);
        const a = new ImageData(data.slice(), width, height), b = pixelsOf(second);
        let most = 0, differing = 0;
        for (let i = 0; i < a.data.length; i += 4) {
            let here = 0;
            for (let c = i; c < i + 3; ++c) {
                const d = Math.abs(a.data[c]! - b.data[c]!);
                here = Math.max(here, d);
                a.data[c] = Math.min(255, d * 4);
            }
            a.data[i + 3] = 255;
            most = Math.max(most, here);
            differing += here > 0 ? 1 : 0;
        }
        canvas.current.width = a.width;
        canvas.current.height = a.height;
        canvas.current.getContext('2d')!.putImageData(a, 0, 0);
        figures.value = `${((400 * differing) / a.data.length).toFixed(1)}% of the pixels differ, by at most ${most} of 255.`;
    }, [done]);
    return (
        <>
            <canvas ref={canvas} class="layer" role="img" aria-label="Difference, amplified four times" />
            <p class="figures">{figures.value} Shown four times as large.</p>
        </>
    );
}

/** Whether the pictures or their difference is shown, and the border between them. */
function ViewOfBoth() {
    return (
        <>
            <Switch label="Show the difference" on={difference.value} set={(on) => {
                difference.value = on;
            }} />
            {!difference.value && (
                <div class="slider">
                    <label for="split">Border</label>
                    <input id="split" type="range" min={0} max={1} step={0.005} value={split.value}
                           onInput={(event) => {
                               split.value = event.currentTarget.valueAsNumber;
                           }} />
                </div>
            )}
        </>
    );
}

export function Compare() {
    const compare = comparison.value;
    if (!info.value) return <p class="note">No scene yet.</p>;
    return (
        <>
            <Own view={<ViewOfBoth />} />
            <OwnLog />
            <section>
                <h2>Two renderings of one scene</h2>
                <div class="presets">
                    {presets.map(({label, ...preset}) => (
                        <button key={label} class="button" aria-pressed={compare?.key === preset.key && compare.a === preset.a && compare.b === preset.b}
                                onClick={() => setComparison(preset)}>{label}</button>
                    ))}
                </div>
            </section>
            <section>
                <Choice label="Setting" value={compare?.key ?? ''} values={['', ...info.value.settings.filter((s) => s.name !== 'size').map((s) => s.name)]}
                        set={(key) => setComparison(key === '' ? null : {key, ...twoValues(key)})} />
                {compare && (
                    <>
                        <Value name={compare.key} label="Left" value={compare.a} set={(a) => setComparison({...compare, a})} />
                        <Value name={compare.key} label="Right" value={compare.b} set={(b) => setComparison({...compare, b})} />
                        {comparisonFailure.value && <p class="message error" role="alert">Right: {comparisonFailure.value}</p>}
                        <ViewOfBoth />
                        <button class="button" onClick={() => setComparison(null)}>End the comparison</button>
                    </>
                )}
                {!compare && <p class="note">Choose a pair above, or any setting. The picture is rendered twice, with a movable border.</p>}
            </section>
        </>
    );
}
