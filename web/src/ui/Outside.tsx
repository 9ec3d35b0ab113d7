// SPDX-License-Identifier: Apache-2.0
// The settings that the text's format cannot express; below the text, where they move no control that is in use.
import {convertToGlint} from '../store/scene';
import {dropOverride} from '../store/settings';
import {format, overrides} from '../store/state';

export function Outside() {
    const names = Object.keys(overrides.value);
    if (names.length === 0) return null;
    return (
        <div class="outside" role="note">
            <p>Set outside the text, because {format.value ? `${format.value.name} cannot express it` : 'the format cannot express it'}:</p>
            <ul>
                {names.map((name) => (
                    <li key={name}>
                        <code>{name} = {overrides.value[name]}</code>
                        <button class="quiet" aria-label={`Drop ${name}`} onClick={() => dropOverride(name)}>✕</button>
                    </li>
                ))}
            </ul>
            <button class="button" onClick={() => void convertToGlint()}>Convert to .glint, with these in it</button>
        </div>
    );
}
