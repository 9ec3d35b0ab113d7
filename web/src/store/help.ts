// SPDX-License-Identifier: Apache-2.0
// The place of the help that something else on the page refers to.
import {signal} from '@preact/signals';

/** heading: as the documents' addresses have it, "the-exponent"; empty: the beginning. */
export const wantedHelp = signal<{topic: string; heading: string} | null>(null);

export function openHelp(topic: string, heading = '') {
    wantedHelp.value = {topic, heading};
}

/** A heading's words as in addresses. */
export const slugOf = (words: string) => words.toLowerCase().replace(/[^\p{L}\p{N} -]/gu, '').trim().replaceAll(' ', '-');
