// SPDX-License-Identifier: Apache-2.0
// Opens a scene, and renders it again when its text or its document state changes.
import {batch} from '@preact/signals';
import type {OpenRequest, SceneText} from 'glint-wasm';

import type {DocumentState} from '../editor/editor';
import {gallery, parts} from '../gallery';
import {type Shared, fromFragment, toFragment} from '../share';
import {extensions, formatOf} from '../text/formats';
import {forgetLights} from './lights';
import {
    type Comparison, currentDocumentState, comparison, comparisonFailure, fileName, history, hovered, includes, services as page, notice,
    overrides, pinned, pinnedIn, pixel, sceneName, state, text,
} from './state';

function requestWith(extra: Record<string, string>): OpenRequest {
    return {
        texts: [{name: fileName.value, text: text.value}],
        includes: includes.value,
        scene: sceneName.value,
        settings: {...overrides.value, ...extra},
    };
}

/** Renders the present scene. */
export function render() {
    const compare = comparison.value;
    state.value = 'rendering';
    page.first?.show({request: requestWith(compare ? {[compare.key]: compare.a} : {}), prepare: {}, version: page.editor?.version});
    if (compare) {
        page.second?.show({request: requestWith({[compare.key]: compare.b}), prepare: {}});
    } else {
        page.second?.stop();
    }
}

export function setComparison(compare: Comparison | null) {
    comparison.value = compare;
    comparisonFailure.value = '';
    if (!compare) pinnedIn.value = {...pinnedIn.value, side: 'first'};
    render();
}

function take(documentState: DocumentState) {
    fileName.value = documentState.name;
    sceneName.value = documentState.scene;
    overrides.value = documentState.overrides;
    includes.value = documentState.includes;
}

/** The editor's text was changed, by the user or by a control. */
export function textChanged(now: string, documentState: DocumentState | null, canUndo: boolean, canRedo: boolean) {
    history.value = {canUndo, canRedo};
    if (now === text.value && !documentState) return;
    const renamed = documentState !== null && documentState.name !== fileName.value;
    batch(() => {
        notice.value = '';
        text.value = now;
        if (documentState) take(documentState);
        if (renamed) forgetLights();
    });
    if (renamed) queueMicrotask(() => page.editor?.setName(fileName.value));
    render();
}

/** Selects one of several scenes in the text. */
export function chooseScene(name: string) {
    page.editor?.setDocumentState({...currentDocumentState(), scene: name});
}

export interface SceneToOpen {
    name: string;
    text: string;
    scene?: string | undefined;
    includes?: SceneText[] | undefined;
    overrides?: Record<string, string> | undefined;
    compare?: Comparison | undefined;
}

/** Opens a scene in place of the previous one, which undo restores. */
export function openScene(scene: SceneToOpen) {
    const documentState: DocumentState = {
        name: scene.name, scene: scene.scene, overrides: scene.overrides ?? {}, includes: scene.includes ?? parts,
    };
    batch(() => {
        comparison.value = scene.compare ?? null;
        comparisonFailure.value = '';
        pinned.value = null;
        hovered.value = null;
        pixel.value = null;
    });
    if (fileName.value !== '') {
        page.editor?.setDocumentState(documentState, scene.text);
        return;
    }
    take(documentState);
    text.value = scene.text;
    page.editor?.begin(scene.text, scene.name);
    render();
}

/** The scene of the address, or that of the book. */
export async function openFirst() {
    const shared = location.hash ? await fromFragment(location.hash) : null;
    openScene(shared ?? gallery.find((scene) => scene.name === 'cgfs/three_mirrors.cgfs')!);
    if (location.hash && !shared) notice.value = 'The link contains no scene. This is the default scene.';
}

export async function link(): Promise<string> {
    const own = includes.value === parts ? undefined : includes.value;
    const shared: Shared = {
        name: fileName.value, text: text.value, scene: sceneName.value, includes: own,
        overrides: Object.keys(overrides.value).length > 0 ? overrides.value : undefined,
        compare: comparison.value ?? undefined,
    };
    const url = new URL(location.href);
    url.hash = await toFragment(shared);
    return url.href;
}

/** Files were dropped: opens the first scene; it may include the other files. */
export async function openFiles(files: File[]) {
    const read = await Promise.all(files.map(async (file) => ({name: file.name, text: await file.text()})));
    const main = read.find((file) => formatOf(file.name));
    if (!main) {
        notice.value = `Not a scene: ${files.map((file) => file.name).join(', ')}. Scenes end in .${extensions.join(', .')}.`;
        return;
    }
    openScene({...main, includes: read.filter((file) => file !== main)});
}

let conversions = 0;

/** Replaces the text by glint's own language, which can express everything. */
export async function convertToGlint() {
    if (!page.pool) return;
    // Not the rendered scene, which may be from an older text or include one side of a comparison.
    const before = text.value;
    const converted = await page.pool.run(
        {view: 'converted', key: ++conversions, request: requestWith({}), prepare: {}, task: {what: 'convert'}}, true).catch(() => '');
    if (text.value !== before) return;
    if (converted === '') {
        notice.value = 'Only a scene without errors can be converted.';
        return;
    }
    const name = fileName.value.replace(/\.\w+$/, '') + '.glint';
    page.editor?.setDocumentState({...currentDocumentState(), name, scene: undefined, overrides: {}}, converted);
    notice.value = `The scene is now ${name.split('/').at(-1)}; undo restores the old text.`;
}
