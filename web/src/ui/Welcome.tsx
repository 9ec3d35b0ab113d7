// SPDX-License-Identifier: Apache-2.0
// The line of a first visit: what this page is, and where to begin.
import {openChallenge, openLesson} from '../store/learning';
import {openBookScene} from '../store/scene';
import {isFirstVisit} from '../store/state';

export function Welcome() {
    if (!isFirstVisit.value) return null;
    return (
        <section class="welcome" aria-label="What this page is">
            <p>glint draws a described scene by ray tracing, in this page, and shows why each pixel has its color.</p>
            <div class="presets">
                <button class="button" onClick={openBookScene}>The book’s scene</button>
                <button class="button" onClick={() => void openLesson('')}>A lesson</button>
                <button class="button" onClick={() => void openChallenge('')}>A challenge</button>
            </div>
            <button class="quiet" aria-label="Dismiss" onClick={() => {
                isFirstVisit.value = false;
            }}>✕</button>
        </section>
    );
}
