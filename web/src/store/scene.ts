// SPDX-License-Identifier: Apache-2.0
// Opens a scene, and renders it again when its text or its document state changes.
import {batch} from '@preact/signals';
import type {OpenRequest} from 'glint-wasm';

import type {DocumentState} from '../editor/editor';
import {type KeptHistory, lastIdOf} from '../editor/kept_history';
import {type GalleryScene, gallery, parts} from '../gallery';
import {type Shared, type SharedChallenge, type StoredScene, fromFragment, toFragment} from '../share';
import {longestLine, tooLongLine, withShortLines} from '../text/long_lines';
import {galleryName, keepForBack, placeOf, setAddress} from './address';
import {embedded} from './embedded';
import {forgetLights} from './lights';
import {keptPage, presentScene, remember} from './memory';
import {pinLater} from './pixels';
import {
    type Comparison, currentDocumentState, comparison, comparisonFailure, documentId, fileName, history, hovered, includes, isFirstVisit, isSecondDone, givenChallenge, isTab,
    services as page, notice,
    overrides, ownPicture, pinned, pinnedIn, pixel, sceneName, skipsUnsupported, state, step, tab, text,
} from './state';

function requestWith(extra: Record<string, string>): OpenRequest {
    return {
        texts: [{name: fileName.value, text: text.value}],
        includes: includes.value,
        scene: sceneName.value,
        settings: {...overrides.value, ...extra},
        skipUnsupported: skipsUnsupported.value,
    };
}

/** The request that opens the present scene. */
export const presentRequest = () => requestWith({});

/** Renders the present scene. */
export function render() {
    const compare = comparison.value;
    state.value = 'rendering';
    page.first?.show({request: requestWith(compare ? {[compare.key]: compare.a} : {}), prepare: {}, document: documentId.value, version: page.editor?.version});
    isSecondDone.value = false;
    if (compare) {
        page.second?.show({request: requestWith({[compare.key]: compare.b}), prepare: {}, document: documentId.value});
    } else {
        page.second?.stop();
    }
}

export function skipUnsupported(skips: boolean) {
    skipsUnsupported.value = skips;
    render();
}

export function setComparison(compare: Comparison | null) {
    if (compare) ownPicture.value = null;
    comparison.value = compare;
    comparisonFailure.value = '';
    if (!compare) pinnedIn.value = {...pinnedIn.value, side: 'first'};
    render();
}

let lastId = 0;
const newId = () => ++lastId;

function take(documentState: DocumentState) {
    documentId.value = documentState.id;
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

/** A file's name without its folders, for a message. */
export function shortName(name: string): string {
    const own = name.split('/').at(-1)!;
    return own.length > 60 ? `${own.slice(0, 40)}…${own.slice(-15)}` : own;
}

/** Selects one of several scenes in the text. */
export function chooseScene(name: string) {
    page.editor?.setDocumentState({...currentDocumentState(), id: newId(), scene: name});
}

/** Opens a scene in place of the previous one, which undo restores; fresh: which only Back restores. `kept`: its number and what undo takes back. */
export function openScene(given: StoredScene, fresh = false, kept?: {id?: number | undefined; undo?: KeptHistory | undefined}) {
    const scene = {...given, text: withShortLines(given.name, given.text)};
    const tooLong = tooLongLine(scene.text);
    if (tooLong > 0) {
        notice.value = `${shortName(scene.name)} is not opened: line ${tooLong} has more than ${longestLine} characters.`;
        return;
    }
    if (fileName.value !== '' && !embedded) remember(presentScene());
    const documentState: DocumentState = {
        id: kept?.id ?? newId(), name: scene.name, scene: scene.scene, overrides: scene.overrides ?? {},
        includes: scene.includes ?? parts,
    };
    isFirstVisit.value = false;
    batch(() => {
        comparison.value = scene.compare ?? null;
        ownPicture.value = null;
        comparisonFailure.value = '';
        pinned.value = null;
        hovered.value = null;
        pixel.value = null;
    });
    if (fileName.value !== '' && !fresh) {
        page.editor?.setDocumentState(documentState, scene.text);
    } else {
        take(documentState);
        forgetLights();
        text.value = scene.text;
        page.editor?.begin(scene.text, scene.name, kept?.undo);
        render();
    }
    if (scene.text !== given.text)
        notice.value = `${shortName(scene.name)} had a line of more than ${longestLine} characters, which the editor cannot show. It is now divided at commas; the scene is the same.`;
}

/** A scene of the gallery, whose address it gets. */
export function openGalleryScene(scene: GalleryScene) {
    keepForBack();
    openScene(scene);
    setAddress({what: 'scene', name: galleryName(scene)});
}

/** The first scene. */
export const bookScene = () => gallery.find((scene) => scene.name === 'cgfs/three_mirrors.cgfs')!;

export const openBookScene = () => openScene(bookScene());

/** Opens the scene of the address; without one the page as it was, or the scene of the book. False: the address is a place of address.ts. */
export async function openFirst(): Promise<boolean> {
    const kept = embedded ? null : await keptPage();  // another page shall not see the user's scenes
    const {hash} = location;
    if (kept && (hash === '' || hash === kept.hash) && tooLongLine(kept.text) === 0) {
        tab.value = kept.tab;
        lastId = Math.max(kept.id ?? 0, kept.undo ? lastIdOf(kept.undo) : 0);
        openScene(kept, false, kept);
        if (kept.pixel) pinLater(kept.pixel, kept.step ?? null);
        if (hash !== '') await resumeChallenge(hash);
        return true;
    }
    if (kept) remember(kept);
    if (placeOf(hash)) return false;
    if (hash === '') {
        openBookScene();
        isFirstVisit.value = !kept;
    } else {
        await openLink(hash);
    }
    return true;
}

/** The challenge of a link is open again, beside the scene as it was. */
export async function resumeChallenge(hash: string) {
    const shared = await fromFragment(hash);
    if (typeof shared === 'object' && shared?.challenge) givenChallenge.value = {...shared.challenge, name: shared.name, start: shared.text};
}

/** The address was changed to another link. */
export async function openLink(hash: string) {
    const shared = await fromFragment(hash);
    const isScene = typeof shared === 'object' && shared !== null && tooLongLine(withShortLines(shared.name, shared.text)) === 0;
    if (isScene || fileName.value === '') openScene(isScene ? shared : bookScene());
    if (isScene && isTab(shared.tab)) tab.value = shared.tab;
    if (isScene && shared.pixel) pinLater(shared.pixel, shared.step ?? null);
    if (isScene && shared.challenge) givenChallenge.value = {...shared.challenge, name: shared.name, start: shared.text};
    if (isScene) return;
    const why = typeof shared === 'string' ? shared : shared ? `The scene of the link has a line of more than ${longestLine} characters.` : 'The link contains no scene.';
    notice.value = `${why} This is the ${fileName.value === bookScene().name ? 'default' : 'same'} scene.`;
}

/** The address of the present scene, or of a challenge that starts with it. */
export async function link(challenge?: SharedChallenge): Promise<string> {
    const shared: Shared = {...presentScene(), challenge};
    if (!challenge) Object.assign(shared, {tab: tab.value, pixel: pinned.value?.pixel, step: step.value ?? undefined});
    const url = new URL(location.href);
    url.search = '';  // of the whole page
    url.hash = await toFragment(shared);
    return url.href;
}

let conversions = 0;

/** A mesh by itself in glint's own language, which refers to its file; or what is wrong with it. */
export async function sceneOfMesh(request: OpenRequest): Promise<{text: string} | {error: string}> {
    const job = {view: 'converted', key: ++conversions, request, prepare: {}};
    let said = '';
    const opening = (done: number) => {
        notice.value = said = `Reading ${shortName(request.texts[0]!.name)}: ${Math.round(100 * done)}%`;
    };
    try {
        const {report} = await page.pool!.run({...job, task: {what: 'open'}}, true, opening);
        const error = report.diagnostics.find(({severity}) => severity === 'error');
        if (error) return {error: error.message};
        return {text: await page.pool!.run({...job, task: {what: 'convert'}}, true)};
    } catch (error) {
        return {error: error instanceof Error ? error.message : String(error)};
    } finally {
        if (said !== '' && notice.value === said) notice.value = '';
    }
}

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
    notice.value = `The scene is now ${shortName(name)}; undo restores the old text.`;
}
