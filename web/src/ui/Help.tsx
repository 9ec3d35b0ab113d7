// SPDX-License-Identifier: Apache-2.0
// Help: the guide with the keys, and the reference of each format and of the conventions, from the project's documents.
import {useSignal} from '@preact/signals';
import {useEffect, useRef} from 'preact/hooks';

import type {Topic} from '../learn/types';
import {slugOf, wantedHelp} from '../store/help';
import {info, tab} from '../store/state';

export function Help() {
    const dialog = useRef<HTMLDialogElement>(null), text = useRef<HTMLDivElement>(null);
    const topics = useSignal<Topic[]>([]), now = useSignal('guide');
    const open = async () => {
        dialog.current?.showModal();
        topics.value = (await import('../lessons/help')).help;
    };
    const show = (id: string) => {
        now.value = id;
        text.current?.scrollTo(0, 0);
    };
    const wanted = wantedHelp.value;
    useEffect(() => {
        if (!wanted) return;
        wantedHelp.value = null;
        void open().then(() => {
            show(wanted.topic);
            // When the topic's text is there.
            requestAnimationFrame(() => [...text.current?.querySelectorAll('h2, h3, h4') ?? []].find((one) => slugOf(one.textContent ?? '') === wanted.heading)?.scrollIntoView());
        });
    }, [wanted]);
    // A scene's profile is that of its format; others are .glint's.
    const own = topics.value.find(({id}) => id === info.value?.profile)?.id ?? 'glint';
    const topic = topics.value.find(({id}) => id === now.value);
    return (
        <>
            <button class="button" aria-haspopup="dialog" onClick={() => void open()}>Help</button>
            <dialog ref={dialog} class="menu help" aria-label="Help" onClick={(event) => event.target === event.currentTarget && event.currentTarget.close()}>
                <div class="menu-body">
                    <div class="menu-head">
                        <h2>Help</h2>
                        <button class="button" onClick={() => {
                            tab.value = 'learn';
                            dialog.current?.close();
                        }}>Lessons</button>
                        <button class="quiet" aria-label="Close" onClick={() => dialog.current?.close()}>✕</button>
                    </div>
                    <div class="presets" role="group" aria-label="Topics">
                        {topics.value.map(({id, title}) => (
                            <button key={id} class="button" aria-pressed={id === now.value} title={id === own ? 'The format of the present scene' : undefined} onClick={() => show(id)}>{title}{id === own ? ' •' : ''}</button>
                        ))}
                    </div>
                    <div ref={text} class="help-text" tabIndex={0} role="region" aria-label={topic?.title ?? 'Help'} dangerouslySetInnerHTML={{__html: topic?.html ?? ''}} />
                </div>
            </dialog>
        </>
    );
}
