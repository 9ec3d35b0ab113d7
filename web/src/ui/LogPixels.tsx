// SPDX-License-Identifier: Apache-2.0
// Marks the pixels of the user's log in the picture, while its panel is open; those of a lesson's log beside the lesson, too.
import {areLogPixelsMarked, loggedPixels, markRadius, mirrored} from '../store/own_log';
import {size} from '../store/state';

export function LogPixels() {
    if (!areLogPixelsMarked()) return null;
    const {width, height} = size.value;
    return (
        <svg class="rays" viewBox={`0 0 ${width} ${height}`} preserveAspectRatio="none" aria-hidden="true">
            {[...loggedPixels.value.values()].map(({at, first}) => {
                const [x, y] = mirrored(at), circle = {cx: x + 0.5, cy: y + 0.5, r: markRadius(), 'vector-effect': 'non-scaling-stroke' as const};
                return <g key={at.join()}><circle class="logged-back" {...circle} /><circle class={`logged${first >= 0 ? ' wrong' : ''}`} {...circle} /></g>;
            })}
        </svg>
    );
}
