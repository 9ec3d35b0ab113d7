// SPDX-License-Identifier: Apache-2.0
// The user's own picture of the present scene, in the panel Compare: how it differs from glint's, and why.
import type {Comparison} from 'glint-wasm';
import type {ComponentChildren} from 'preact';

import {answer, closePicture, fits, isSearching, sceneSize} from '../store/own';
import {setSetting} from '../store/settings';
import {ownPicture} from '../store/state';
import {FileButton} from './fields';

function Figures({found}: {found: Comparison}) {
    const {pixels, equal, within, mean, largest} = found;
    if (equal === pixels) return <p>All pixels are equal.</p>;
    // Rounded down: 100% are all.
    const percent = (count: number) => `${Math.floor((10_000 * count) / pixels) / 100}%`;
    return (
        <p>
            {percent(equal)} of the pixels are equal, {percent(within)} within 2 of 255. They differ by {mean.toFixed(2)} of 255 on average,
            by {Math.round(largest.value)} at most, at ({largest.x}, {largest.y}).
        </p>
    );
}

/** What glint says of the difference, as `glint compare --scene` does. */
function Causes({found}: {found: Comparison}) {
    // A sure cause needs no others beside it.
    const all = found.causes ?? [], causes = all[0]?.perhaps === false ? all.slice(0, 1) : all.slice(0, 3), then = found.then ?? [];
    return (
        <>
            {causes.length > 0 && (
                <ul class="hints">
                    {causes.map((cause) => <li key={cause.explanation}>{cause.perhaps ? 'Perhaps: ' : ''}{cause.explanation} ({Math.round(100 * cause.explained)}% of the difference)</li>)}
                    {then.map((cause) => <li key={cause.explanation}>And: {cause.perhaps ? 'perhaps ' : ''}{cause.explanation}</li>)}
                </ul>
            )}
            {found.remark && <p>{found.remark}</p>}
            {found.where && <p>{found.where}</p>}
        </>
    );
}

export function Own({view}: {view: ComponentChildren}) {
    const own = ownPicture.value, found = answer.value;
    if (!own) {
        return (
            <section>
                <h2>Your own picture</h2>
                <p class="note">Has your ray tracer drawn this scene? Drop its picture onto the page (PNG, JPEG, PPM, OpenEXR): it is compared with glint’s pixel by pixel, and glint looks for the likeliest mistake.</p>
                <div><FileButton label="Open a picture" /></div>
            </section>
        );
    }
    const {width, height} = own.image;
    return (
        <section class="own" aria-label="Your own picture" data-answered={found !== null && !isSearching.value}>
            <h2>{own.name}</h2>
            {fits() ? (
                <>
                    <div aria-live="polite">
                        {found === null ? <p>Comparing…</p> : typeof found === 'string' ? <p class="message error" role="alert">{found}</p> : <><Figures found={found} /><Causes found={found} /></>}
                        {isSearching.value && <p>Looking for the cause, which takes some hundred pictures…</p>}
                    </div>
                    {view}
                </>
            ) : (
                <>
                    <p class="message error" role="alert">Your picture has {width} × {height} pixels, and the scene’s has {sceneSize().width} × {sceneSize().height}: pictures of one size are compared.</p>
                    <div><button class="button" onClick={() => setSetting('size', `${width}x${height}`)}>Render at {width} × {height}</button></div>
                </>
            )}
            <div><button class="button" onClick={closePicture}>Close your picture</button></div>
        </section>
    );
}
