// SPDX-License-Identifier: Apache-2.0
// The page in an iframe: its picture, the controls that the address names, and a button to the whole page.
import {useEffect, useRef} from 'preact/hooks';

import {allows} from '../store/embedded';
import {talkToParent} from '../store/embedding';
import {link} from '../store/scene';
import {info, size} from '../store/state';
import {Compare} from './Compare';
import {Conventions, Epsilon, Faults, Lights, PictureControls, Shading} from './Controls';
import {Inspector} from './Inspector';
import {Stage} from './Stage';
import {TextPane} from './TextPane';

const parts = {
    shading: Shading, lights: Lights, faults: Faults, epsilon: Epsilon, picture: PictureControls, conventions: Conventions, inspect: Inspector, compare: Compare,
};

export function Embed() {
    const shell = useRef<HTMLDivElement>(null);
    useEffect(() => talkToParent(shell.current!), []);
    const shown = Object.entries(parts).filter(([name]) => allows(name));
    const {width, height} = size.value;
    return (
        <div class={`embed${allows('camera') ? ' with-camera' : ''}${allows('text') ? ' with-text' : ''}`} ref={shell} style={{'--width': width, '--height': height}}>
            <main class="columns">
                <Stage />
                {shown.length > 0 && info.value && <div class="panel">{shown.map(([name, Part]) => <Part key={name} />)}</div>}
                <div hidden={!allows('text')} class="embed-text"><TextPane /></div>
            </main>
            <footer class="embed-bar">
                <a href="./" target="_blank" rel="noopener" onClick={async (event) => {
                    event.preventDefault();
                    open(await link(), '_blank', 'noopener');
                }}>Open in glint</a>
            </footer>
        </div>
    );
}
