// SPDX-License-Identifier: Apache-2.0
// The page in an iframe of another page (docs/embedding.md): what the address asks for, and the messages to and from that page.
import {effect} from '@preact/signals';

import {checkedScene} from '../share';
import {openScene} from './scene';
import {setSetting} from './settings';
import {diagnostics, documentId, failure, fileName, info, isPictureOfScene, overrides, progress, settingOf, shownId, size, state, text} from './state';
import {embedded} from './embedded';

type Message = {glint: string} & Record<string, unknown>;

function send(message: Message) {
    if (embedded && parent !== window) parent.postMessage(message, embedded.origin);
}

/** The largest text of a message, in characters; that of a link. */
const largest = 4e6;

/** Does what a message of the other page asks for. Its texts are scenes and settings for glint; nothing of them is run. */
function answer(message: Record<string, unknown>) {
    if (message['glint'] === 'open') {
        const scene = checkedScene(message['scene']);
        if (!scene || scene.text.length > largest) {
            send({glint: 'refused', why: 'open: expected a scene with a name and a text'});
        } else {
            openScene(scene);
        }
    } else if (message['glint'] === 'set') {
        const {name, value} = message;
        if (typeof name !== 'string' || typeof value !== 'string' || value.length > 200) {
            send({glint: 'refused', why: 'set: expected the name of a setting and its value, both as texts'});
        } else if (!info.value) {
            send({glint: 'refused', why: 'set: there is no scene yet; wait for the message ready'});
        } else if (!settingOf(name)) {
            send({glint: 'refused', why: `set: no setting is called ${name.slice(0, 60)}; they are ${info.value.settings.map((one) => one.name).join(', ')}`});
        } else {
            setSetting(name, value);
        }
    } else if (message['glint'] === 'get') {
        send({glint: 'scene', scene: {name: fileName.value, text: text.value, overrides: overrides.value}});
    } else {
        send({glint: 'refused', why: 'expected a message with glint: open, set or get'});
    }
}

/** Listens to the page around, and tells it what happens here. `whole`: all that is shown. */
export function talkToParent(whole: HTMLElement) {
    if (!embedded) return;
    const {origin} = embedded;
    addEventListener('message', ({data, origin: from, source}: MessageEvent<unknown>) => {
        if (from !== origin || source !== parent || source === window) return;
        if (typeof data === 'object' && data !== null && 'glint' in data) answer(data as Record<string, unknown>);
    });
    new ResizeObserver(() => send({glint: 'size', width: whole.offsetWidth, height: whole.offsetHeight})).observe(whole);
    effect(() => {
        if (state.value !== 'done' || !isPictureOfScene.value) return;
        void [documentId.value, shownId.value, progress.value];
        send({glint: 'rendered', ...size.value});
    });
    effect(() => {
        if (state.value !== 'error') return;
        send({glint: 'errors', messages: failure.value ? [failure.value] : diagnostics.value.map((one) => one.text)});
    });
    let isReady = false;
    effect(() => {
        if (isReady || !info.value) return;
        isReady = true;
        send({glint: 'ready'});
    });
}
