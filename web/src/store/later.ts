// SPDX-License-Identifier: Apache-2.0
// What the first picture does not need is fetched after it, all of it: the page makes no connections later.
import {effect} from '@preact/signals';

import {state} from './state';

/** Fetches something after the first picture, or after the mistakes of its scene. What needs it fetches it itself if this fails. */
export function fetchLater(fetchIt: () => Promise<unknown>) {
    const stop = effect(() => {
        if (state.value !== 'done' && state.value !== 'error') return;
        requestIdleCallback(() => void fetchIt().catch(() => {}));
        queueMicrotask(() => stop());
    });
}
