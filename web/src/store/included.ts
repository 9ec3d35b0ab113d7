// SPDX-License-Identifier: Apache-2.0
// A text that the scene includes and that is shown in the place of the scene's own.
import {signal} from '@preact/signals';

import {includes, notice, tab} from './state';

export const opened = signal<{name: string; line: number} | null>(null);

/** Opens an included text at a line. glint's own texts, as colors.inc, are only named. */
export function openIncluded(name: string | undefined, line: number) {
    if (!includes.value.some((one) => one.name === name)) {
        notice.value = `That is line ${line} of ${name}, a text of glint’s own.`;
        return;
    }
    if (includes.value.find((one) => one.name === name)?.base64) {
        notice.value = `${name} is no text.`;
        return;
    }
    if (matchMedia('(max-width: 1011px)').matches) tab.value = 'text';
    opened.value = {name: name!, line};
}
