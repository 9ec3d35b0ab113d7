// SPDX-License-Identifier: Apache-2.0
// The page on a projector: task, picture and explanation side by side, in large type. Its address has ?projector.
import {signal} from '@preact/signals';

const word = 'projector';

export const isProjected = signal(new URLSearchParams(location.search).has(word));

export function project(on: boolean) {
    isProjected.value = on;
    const url = new URL(location.href);
    if (on) url.searchParams.set(word, '');
    else url.searchParams.delete(word);
    history.replaceState(history.state, '', url.href.replace(`${word}=`, word));
}
