// SPDX-License-Identifier: Apache-2.0
// The layout that the user has chosen: widths of the columns, and the picture's size in its space.
import {effect, signal} from '@preact/signals';

const key = 'glint.layout';

interface Layout {
    /** Widths of the first and the last column, in percent of all. */
    left: number;
    right: number;
    /** As large as its space; or a pixel of the picture is one of the page. */
    zoom: 'fit' | 'whole';
}

function kept(): Partial<Layout> {
    try {
        return (JSON.parse(localStorage.getItem(key) ?? '{}') ?? {}) as Partial<Layout>;
    } catch {
        return {};
    }
}

const within = (value: unknown, low: number, high: number, usual: number) =>
    typeof value === 'number' && value >= low && value <= high ? value : usual;

/** The limits of a column's width, in percent. */
export const narrowest = 15, widest = 45;

const before = kept();
export const layout = signal<Layout>({
    left: within(before.left, narrowest, widest, 27), right: within(before.right, narrowest, widest, 27),
    zoom: before.zoom === 'whole' ? 'whole' : 'fit',
});

effect(() => {
    try {
        localStorage.setItem(key, JSON.stringify(layout.value));
    } catch {
        // The layout is then that of this visit.
    }
});
