// SPDX-License-Identifier: Apache-2.0
// The border of two columns, which can be moved by pointer and keys.
import {layout, narrowest, widest} from '../store/layout';

export function Splitter({side}: {side: 'left' | 'right'}) {
    const set = (percent: number) => {
        layout.value = {...layout.value, [side]: Math.max(narrowest, Math.min(widest, percent))};
    };
    return (
        <div
            class={`splitter ${side}`} role="separator" tabIndex={0} aria-orientation="vertical" aria-label={side === 'left' ? 'Width of the text' : 'Width of the panels'}
            aria-valuemin={narrowest} aria-valuemax={widest} aria-valuenow={Math.round(layout.value[side])}
            onPointerDown={(event) => (event.currentTarget as Element).setPointerCapture(event.pointerId)}
            onPointerMove={(event) => {
                if (!(event.buttons & 1)) return;
                const box = (event.currentTarget as Element).closest('.columns')!.getBoundingClientRect();
                set((100 * (side === 'left' ? event.clientX - box.left : box.right - event.clientX)) / box.width);
            }}
            onDblClick={() => set(27)}
            onKeyDown={(event) => {
                const step = event.key === 'ArrowLeft' ? -1 : event.key === 'ArrowRight' ? 1 : 0;
                if (step === 0) return;
                event.preventDefault();
                set(layout.value[side] + (side === 'left' ? step : -step));
            }}
        />
    );
}
