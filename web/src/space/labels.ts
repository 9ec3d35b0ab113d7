// SPDX-License-Identifier: Apache-2.0
// Places of labels in the view in space: inside it, and over no other label, handle or axis.

export interface Box {
    x: number;
    y: number;
    width: number;
    height: number;
}

/** The point that a label is about, and its lines. */
export interface Labelled {
    x: number;
    y: number;
    lines: string[];
}

/** Pixels of a letter and of a line in the view's type; a little more than they take. */
const letter = 6.9;
export const lineHeight = 15;
const gap = 10;

const meet = (a: Box, b: Box) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

/** The labels' boxes. One that has no free place is null. `taken`: what they must not cover. */
export function placeLabels(labels: readonly Labelled[], view: {width: number; height: number}, taken: readonly Box[]): (Box | null)[] {
    const placed: Box[] = [...taken];
    return labels.map(({x, y, lines}) => {
        const width = letter * Math.max(...lines.map((line) => line.length)), height = lineHeight * lines.length;
        const beside = (dx: number, dy: number): Box => ({
            x: Math.max(3, Math.min(view.width - width - 3, dx)), y: Math.max(3, Math.min(view.height - height - 3, dy)), width, height,
        });
        if (width > view.width - 6 || x < 0 || y < 0 || x > view.width || y > view.height) return null;
        const own: Box = {x: x - 7, y: y - 7, width: 14, height: 14};
        for (let step = 0; step < 8; ++step) {
            for (const down of step === 0 ? [0] : [step, -step]) {
                const middle = y - height / 2 + down * lineHeight;
                for (const box of [beside(x + gap, middle), beside(x - gap - width, middle), beside(x - width / 2, middle)]) {
                    if (meet(box, own) || placed.some((other) => meet(box, other))) continue;
                    placed.push(box);
                    return box;
                }
            }
        }
        return null;
    });
}
