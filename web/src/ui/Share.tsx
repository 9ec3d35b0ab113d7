// SPDX-License-Identifier: Apache-2.0
// The scene for others: a link, a file where the link is long, and the code that shows the scene in another page.
import {signal, useSignal} from '@preact/signals';
import {useEffect, useRef} from 'preact/hooks';

import {saveScene} from '../files';
import {link} from '../store/scene';
import {fileName, info, notice, text} from '../store/state';

/** The present link; null: the dialog is closed. */
const shown = signal<string | null>(null);

/** Characters of a link that mail programs and learning platforms keep. */
const longest = 8000;

/** False if the browser does not allow it. */
export async function copy(words: string): Promise<boolean> {
    try {
        await navigator.clipboard.writeText(words);
        return true;
    } catch {
        return false;
    }
}

async function share() {
    const address = await link();
    globalThis.history.replaceState(null, '', address);
    const words = await copy(address) ? 'The link is copied. It contains the scene and its settings. Nothing was sent.'
        : 'The link is in the address bar. It contains the scene and its settings.';
    notice.value = words;
    if (address.length > longest) shown.value = address;
}

/** The controls of a frame (docs/embedding.md). */
const controls = ['camera', 'inspect', 'shading', 'lights', 'faults', 'epsilon', 'picture', 'conventions', 'compare', 'text'];

const escaped = (words: string) => words.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');

/** The HTML of a frame with the scene of a link. */
function frameCode(address: string, chosen: readonly string[]): string {
    const url = new URL(address), {width, height} = info.value ?? {width: 600, height: 600};
    const wide = Math.max(320, Math.min(600, width)), panel = chosen.some((one) => one !== 'camera') ? 320 : 0;
    const title = `${fileName.value.split('/').at(-1)} in glint`;
    return `<iframe src="${escaped(`${url.origin}${url.pathname}?embed=${chosen.join(',')}${url.hash}`)}" title="${escaped(title)}"` +
        ` width="${wide}" height="${Math.round((wide * height) / width) + 110 + panel}" loading="lazy"></iframe>`;
}

function EmbedCode({address}: {address: string}) {
    const chosen = useSignal(['camera']), isCopied = useSignal('');
    const code = frameCode(address, chosen.value);
    return (
        <section>
            <h3>In another page</h3>
            <fieldset class="presets"><legend class="note">The frame has the picture and these controls:</legend>
                {controls.map((name) => (
                    <label key={name}><input type="checkbox" checked={chosen.value.includes(name)} onChange={(event) => {
                        const on = event.currentTarget.checked;
                        chosen.value = controls.filter((one) => (one === name ? on : chosen.value.includes(one)));
                        isCopied.value = '';
                    }} /> {name}</label>
                ))}
            </fieldset>
            <textarea class="code" readOnly rows={4} aria-label="Code of the frame" value={code} onFocus={(event) => event.currentTarget.select()} />
            <div class="presets">
                <button class="button" onClick={async () => {
                    isCopied.value = await copy(code) ? 'Copied.' : 'Not copied: select the code.';
                }}>Copy the code</button>
                <span role="status">{isCopied.value}</span>
            </div>
        </section>
    );
}

function Dialog() {
    const dialog = useRef<HTMLDialogElement>(null), address = shown.value!;
    useEffect(() => dialog.current!.showModal(), []);
    const isLong = address.length > longest, size = `${address.length.toLocaleString('en')} characters`;
    return (
        <dialog ref={dialog} class="menu share" aria-label="Share" onClose={() => {
            shown.value = null;
        }} onClick={(event) => event.target === event.currentTarget && event.currentTarget.close()}>
            <div class="menu-body">
                <div class="menu-head">
                    <h2>Share</h2>
                    <button class="quiet" aria-label="Close" onClick={() => dialog.current!.close()}>✕</button>
                </div>
                <section>
                    <h3>Link</h3>
                    <input class="code" readOnly aria-label="Link" value={address} onFocus={(event) => event.currentTarget.select()} />
                    <p class="note">{isLong ? `The link has ${size}: some programs cut links of that length off. A file holds the scene, too; who has it drops it onto this page.`
                        : `The link has ${size}, and holds the scene and its settings.`}</p>
                    {isLong && <div><button class="button" onClick={() => saveScene(text.value)}>Save scene as a file</button></div>}
                </section>
                <EmbedCode address={address} />
            </div>
        </dialog>
    );
}

export function ShareButtons() {
    return (
        <>
            <button class="button" onClick={() => void share()}>Share link</button>
            <button class="button" title="The code that shows this scene in another page" onClick={async () => {
                shown.value = await link();
            }}>Embed…</button>
        </>
    );
}

/** Not beside its buttons: they may be in a menu that closes. */
export const ShareDialog = () => (shown.value === null ? null : <Dialog />);
