// SPDX-License-Identifier: Apache-2.0
// The line of a first visit: what this page is, and where to begin.
import {openChallenge, openLesson} from '../store/learning';
import {pin} from '../store/pixels';
import {isFirstVisit, size} from '../store/state';

/** A pixel of the ball in the middle of the book's scene, which mirrors the others. */
const place = [0.5, 0.72] as const;

function takeApart() {
    void pin([Math.floor(place[0] * size.value.width), Math.floor(place[1] * size.value.height)]);
    isFirstVisit.value = false;
}

export function Welcome() {
    if (!isFirstVisit.value) return null;
    return (
        <section class="welcome" aria-label="What this page is">
            <p>glint draws a described scene by ray tracing, in this page, and shows why each pixel has its color. This scene is that of chapter 4 of “Computer Graphics from Scratch”.</p>
            <div class="presets">
                <button class="button" onClick={takeApart}>Take a pixel apart</button>
                <button class="button" onClick={() => void openLesson('')}>A lesson</button>
                <button class="button" onClick={() => void openChallenge('')}>A challenge</button>
            </div>
            <button class="quiet" aria-label="Dismiss" onClick={() => {
                isFirstVisit.value = false;
            }}>✕</button>
        </section>
    );
}
