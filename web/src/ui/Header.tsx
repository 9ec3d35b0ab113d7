// SPDX-License-Identifier: Apache-2.0
import {useSignal} from '@preact/signals';
import {useEffect, useRef} from 'preact/hooks';

import {commandLine} from '../command';
import {savePicture, saveScene} from '../files';
import {gallery} from '../gallery';
import {isProjected, project} from '../store/projector';
import {presentScene, recent, recentScene} from '../store/memory';
import {keepForBack, setAddress} from '../store/address';
import {bookScene, openGalleryScene, openScene} from '../store/scene';
import {fileName, history, info, services, notice, sceneName, text} from '../store/state';
import {FileButton} from './fields';
import {Help} from './Help';
import {ShareButtons, ShareDialog, copy} from './Share';

const families: [string, string][] = [
    ['cgfs', 'Computer Graphics from Scratch'],
    ['epfl', 'EPFL, RT2'],
    ['csc473', 'CSC 473'],
    ['glint', 'glint'],
    ['nff', 'Standard Procedural Databases'],
    ['faults', 'Faults: find the mistake'],
];

const title = (scene: {name: string; scene?: string | undefined}) =>
    (scene.scene ?? scene.name.split('/').at(-1)!.replace(/\.\w+$/, '')).replaceAll('_', ' ');

function SceneMenu() {
    const dialog = useRef<HTMLDialogElement>(null);
    return (
        <>
            <button class="button" onClick={() => dialog.current?.showModal()} aria-haspopup="dialog">Scenes</button>
            <dialog ref={dialog} class="menu" aria-label="Scenes"
                    onClick={(event) => event.target === event.currentTarget && event.currentTarget.close()}>
                <div class="menu-body">
                    <div class="menu-head of-scenes">
                        <h2>Scenes</h2>
                        <FileButton label="Open files…" opened={() => dialog.current?.close()} />
                        <FileButton label="Open a folder…" folder opened={() => dialog.current?.close()} />
                        <button class="quiet" aria-label="Close" onClick={() => dialog.current?.close()}>✕</button>
                    </div>
                    <Recent done={() => dialog.current?.close()} />
                    {families.map(([folder, family]) => (
                        <section key={folder}>
                            <h3>{family}</h3>
                            <div class="thumbs">
                                {gallery.filter((scene) => scene.name.startsWith(`${folder}/`)).map((scene) => (
                                    <button
                                        key={title(scene)} class="thumb" data-scene={scene.scene ?? scene.id ?? scene.name}
                                        aria-current={scene.name === fileName.value && scene.scene === sceneName.value}
                                        onClick={() => {
                                            openGalleryScene(scene);
                                            dialog.current?.close();
                                        }}
                                    >
                                        <img loading="lazy" src={scene.picture} alt="" width={132} height={99} />
                                        <span>{title(scene)}</span>
                                    </button>
                                ))}
                            </div>
                        </section>
                    ))}
                </div>
            </dialog>
        </>
    );
}

/** The user's own scenes. */
function Recent({done}: {done: () => void}) {
    if (recent.value.length === 0) return null;
    return (
        <section>
            <h3>Recent</h3>
            <div class="presets">
                {recent.value.map((scene) => (
                    <button key={scene.name + (scene.scene ?? '')} class="button recent" title={scene.name} onClick={async () => {
                        done();
                        const whole = await recentScene(scene);
                        if (!whole) {
                            notice.value = `${scene.name.split('/').at(-1)} is kept no longer.`;
                            return;
                        }
                        keepForBack();
                        openScene(whole);
                        setAddress(null);
                    }}>{scene.name.split('/').at(-1)}</button>
                ))}
            </div>
        </section>
    );
}

async function copyCommand() {
    const line = commandLine(presentScene());
    const others = info.value?.files.slice(1).map((file) => file.split('/').at(-1)!) ?? [];
    const needs = others.length > 0 ? `, beside ${others.join(', ')}` : '';
    notice.value = `${await copy(line) ? 'Copied: ' : ''}${line} — in the folder of the saved scene${needs}, this renders the same pixels.`;
}

function Projector() {
    const now = isProjected.value;
    return (
        <button class="quiet" aria-pressed={now} aria-label="For a projector" title="For a projector: task, picture and explanation side by side, in large type (l)" onClick={() => project(!now)}>
            <svg class="icon" viewBox="0 0 14 14" aria-hidden="true"><path d="M1 2h12v7H1zM7 9v2M4 13l3-2 3 2" /></svg>
        </button>
    );
}

function Theme() {
    const dark = useSignal(matchMedia('(prefers-color-scheme: dark)').matches);
    return (
        <button class="quiet" aria-pressed={dark.value} aria-label="Dark theme" title="Dark or light"
                onClick={() => {
                    dark.value = !dark.value;
                    document.documentElement.dataset['theme'] = dark.value ? 'dark' : 'light';
                }}>
            ◐
        </button>
    );
}

/** Whether the page is as narrow as a phone. */
function useNarrow(): boolean {
    const query = useRef(matchMedia('(max-width: 520px)')), isNarrow = useSignal(query.current.matches);
    useEffect(() => {
        const changed = () => {
            isNarrow.value = query.current.matches;
        };
        query.current.addEventListener('change', changed);
        return () => query.current.removeEventListener('change', changed);
    }, []);
    return isNarrow.value;
}

function SaveButtons() {
    return (
        <div class="group" role="group" aria-label="Save">
            <ShareButtons />
            <button class="button" title="Copy the line of the glint command that renders this picture" onClick={() => void copyCommand()}>Copy as command</button>
            <button class="button" title="Save the picture (s)" onClick={() => void savePicture('png')}>Save PNG</button>
            <button class="button" title="Save the picture's linear numbers as OpenEXR" onClick={() => void savePicture('exr')}>EXR</button>
            <button class="button" onClick={() => saveScene(text.value)}>Save scene</button>
        </div>
    );
}

/** On a phone: what else there is room for on a large screen. */
function More() {
    const details = useRef<HTMLDetailsElement>(null);
    return (
        <details ref={details} class="more" onClick={(event) => {
            if ((event.target as Element).closest('button')) details.current!.open = false;
        }}>
            <summary class="button">Save</summary>
            <div class="more-body"><SaveButtons /><Theme /></div>
        </details>
    );
}

export function Header() {
    const isNarrow = useNarrow();
    return (
        <header class="header">
            <h1 class="brand"><a href="#scene=cgfs/three_mirrors.cgfs" title="The first scene: the book’s" aria-label="glint: the book’s scene" onClick={(event) => {
                event.preventDefault();  // the address may be this one already
                openGalleryScene(bookScene());
            }}><img src="./icon.svg" alt="" width={22} height={22} />{!isNarrow && 'glint'}</a></h1>
            <SceneMenu />
            <span class="file-name" title={fileName.value}>{fileName.value.split('/').at(-1)}{sceneName.value ? `: ${sceneName.value}` : ''}</span>
            <div class="group" role="group" aria-label="History">
                <button class="quiet" aria-label="Undo" title="Undo (Ctrl+Z)" disabled={!history.value.canUndo}
                        onClick={() => services.editor?.undo()}>↶</button>
                <button class="quiet" aria-label="Redo" title="Redo (Ctrl+Shift+Z)" disabled={!history.value.canRedo}
                        onClick={() => services.editor?.redo()}>↷</button>
            </div>
            <div class="spacer" />
            <ShareDialog />
            {isNarrow ? <><Help /><More /></> : <><SaveButtons /><Help /><Projector /><Theme /></>}
        </header>
    );
}
