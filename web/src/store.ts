// What the page knows, and what can be done with it. The scene's text is the one truth: controls edit it, and only what its
// format cannot say is kept beside it, in `overrides`.
import {batch, computed, signal} from '@preact/signals';
import type {CameraInfo, Diagnostic, Explanation, OpenRequest, Place, SceneInfo, SceneText, Setting, Vec3} from 'glint-wasm';

import {type Move, moved} from './camera';
import type {Beside, Editor} from './editor/editor';
import type {Pool} from './engine/pool';
import type {Progress, View} from './engine/view';
import {type GalleryScene, gallery, parts} from './gallery';
import {type Shared, fromFragment, toFragment} from './share';
import type {LightText} from './text/edit';
import {extensions, formatOf} from './text/formats';
import {spanOf} from './text/places';

export const fileName = signal('');
export const text = signal('');
export const sceneName = signal<string | undefined>(undefined);
export const includes = signal<SceneText[]>([]);
/** Settings that hold against the text. */
export const overrides = signal<Record<string, string>>({});
export const history = signal({canUndo: false, canRedo: false});

/** Of the last scene that could be drawn. */
export const info = signal<SceneInfo | null>(null);
export const diagnostics = signal<Diagnostic[]>([]);
/** Why nothing could be drawn, if that is not for the text. */
export const failure = signal('');
export const state = signal<'starting' | 'drawing' | 'done' | 'error'>('starting');
export const progress = signal<Progress>({fraction: 0, rays: 0, milliseconds: 0});
export const notice = signal('');

export type Comparison = {key: string; a: string; b: string};
export const comparison = signal<Comparison | null>(null);
export const difference = signal(false);
export const split = signal(0.5);

export const pixel = signal<[number, number] | null>(null);
export const pinned = signal<Explanation | null>(null);
export const hovered = signal<Explanation | null>(null);
/** The ray and light that the inspector shows in its diagram. */
export const selected = signal<{ray: number; light: number}>({ray: 0, light: 0});
export const tab = signal<'text' | 'controls' | 'inspect' | 'compare'>('controls');

export const format = computed(() => formatOf(fileName.value));

/** What is not a part of the page's state: made once, when it starts. */
export const machinery: {editor?: Editor; pool?: Pool; first?: View; second?: View} = {};
const page = machinery;

function requestWith(extra: Record<string, string>): OpenRequest {
    return {
        texts: [{name: fileName.value, text: text.value}],
        includes: includes.value,
        scene: sceneName.value,
        settings: {...overrides.value, ...extra},
    };
}

/** Draws what is to be seen now. */
export function draw() {
    const compare = comparison.value;
    state.value = 'drawing';
    page.first?.show({request: requestWith(compare ? {[compare.key]: compare.a} : {}), prepare: {}});
    if (compare) {
        page.second?.show({request: requestWith({[compare.key]: compare.b}), prepare: {}});
    } else {
        page.second?.stop();
    }
}

export function setComparison(compare: Comparison | null) {
    comparison.value = compare;
    draw();
}

/** The editor's text changed, by hand or by a control. */
export function textChanged(now: string, beside: Beside | null, canUndo: boolean, canRedo: boolean) {
    history.value = {canUndo, canRedo};
    if (now === text.value && !beside) return;
    const renamed = beside !== null && beside.name !== fileName.value;
    batch(() => {
        text.value = now;
        if (beside) {
            fileName.value = beside.name;
            sceneName.value = beside.scene;
            overrides.value = beside.overrides;
        }
    });
    if (renamed) queueMicrotask(() => page.editor?.setName(fileName.value));
    draw();
}

export const besideNow = (): Beside => ({name: fileName.value, scene: sceneName.value, overrides: overrides.value});

export interface SceneToOpen {
    name: string;
    text: string;
    scene?: string | undefined;
    includes?: SceneText[] | undefined;
    overrides?: Record<string, string> | undefined;
    compare?: Comparison | undefined;
}

export function openScene(scene: SceneToOpen) {
    batch(() => {
        fileName.value = scene.name;
        sceneName.value = scene.scene;
        includes.value = scene.includes ?? parts;
        overrides.value = scene.overrides ?? {};
        comparison.value = scene.compare ?? null;
        pinned.value = null;
        hovered.value = null;
        pixel.value = null;
        notice.value = '';
        lightsOff.clear();
        text.value = scene.text;
    });
    page.editor?.open(scene.text, scene.name);
    draw();
}

export function openFromGallery(scene: GalleryScene) {
    openScene(scene);
}

/** The address' scene, or the book's. */
export async function openFirst() {
    const shared = location.hash ? await fromFragment(location.hash) : null;
    if (location.hash && !shared) notice.value = 'The link holds no scene; here is the book’s.';
    const kept = notice.value;
    openScene(shared ?? gallery.find((scene) => scene.name === 'cgfs/three_mirrors.cgfs')!);
    notice.value = kept;
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

/** Files that were dropped: the first that is a scene is opened, the others are what it may include. */
export async function openFiles(files: File[]) {
    const read = await Promise.all(files.map(async (file) => ({name: file.name, text: await file.text()})));
    const main = read.find((file) => formatOf(file.name));
    if (!main) {
        notice.value = `Not a scene: ${files.map((file) => file.name).join(', ')}. Scenes end in .${extensions.join(', .')}.`;
        return;
    }
    openScene({...main, includes: read.filter((file) => file !== main)});
}

// ---- settings

export function settingOf(name: string): Setting | undefined {
    return info.value?.settings.find((setting) => setting.name === name);
}

let lastOverride = {name: '', time: 0};

function setOverrides(now: Record<string, string>, again = false) {
    page.editor?.setBeside({...besideNow(), overrides: now}, undefined, again);
}

/** Sets a key: in the text where its format can say it, else beside it. */
export function setSetting(name: string, value: string) {
    const setting = settingOf(name);
    const edits = format.value?.setting(text.value, name, value, setting?.is_convention ?? false);
    if (edits) {
        if (name in overrides.value) setOverrides(without(overrides.value, name));
        page.editor?.apply(edits);
        return;
    }
    // Dragging a slider is one change.
    const again = lastOverride.name === name && performance.now() - lastOverride.time < 500;
    lastOverride = {name, time: performance.now()};
    setOverrides({...overrides.value, [name]: value}, again);
}

export function dropOverride(name: string) {
    setOverrides(without(overrides.value, name));
}

function without(record: Record<string, string>, key: string) {
    const {[key]: _, ...rest} = record;
    return rest;
}

/** Puts glint's own language in the text's place; that can say everything. */
export async function convertToGlint() {
    const current = page.first?.current;
    if (!current || !page.pool) return;
    const converted = await page.pool.run(
        {view: 'first', key: current.key, request: current.subject.request, prepare: {}, task: {what: 'convert'}}, true);
    if (converted === '') {
        notice.value = 'This scene could not be converted.';
        return;
    }
    const name = fileName.value.replace(/\.\w+$/, '') + '.glint';
    page.editor?.setBeside({name, scene: undefined, overrides: {}}, converted);
    notice.value = `The scene is now ${name}; undo brings its old text back.`;
}

// ---- lights

const lightsOff = new Map<number, number>();

/** True if a place is in the text that is edited here, and not in one that it includes. */
const isHere = (place: Place | null | undefined): place is Place => place?.file === fileName.value;

const offsetOf = (place: Place) => spanOf(text.value, place.line, place.column)[0];

/** A light of the scene as the text says it; null if it cannot be changed there. */
export function lightText(index: number): LightText | null {
    const place = info.value?.lights[index]?.place;
    return isHere(place) ? (format.value?.light(text.value, offsetOf(place)) ?? null) : null;
}

export function setLight(index: number, change: {intensity?: number; place?: Vec3}) {
    const light = lightText(index);
    if (!light) return;
    const edits = change.intensity !== undefined ? light.setIntensity(change.intensity) : light.setPlace(change.place!);
    if (edits) page.editor?.apply(edits);
}

export function switchLight(index: number, on: boolean) {
    const light = lightText(index);
    if (!light) return;
    if (!on) lightsOff.set(index, light.intensity);
    setLight(index, {intensity: on ? (lightsOff.get(index) ?? 1) : 0});
}

// ---- camera

export function canMoveCamera(): boolean {
    const camera = info.value?.camera;
    return !!camera && moveEdits(camera) !== null;
}

function moveEdits(camera: CameraInfo) {
    if (camera.place && !isHere(camera.place)) return null;
    return format.value?.camera(text.value, camera.place ? offsetOf(camera.place) : null, camera) ?? null;
}

/** Moves the camera, from where it was when the movement began. */
export function moveCamera(from: CameraInfo, move: Move, distance: number) {
    const now = info.value?.camera;
    if (!now) return;
    const edits = moveEdits({...moved(from, move, distance), place: now.place});
    if (edits) {
        page.editor?.apply(edits);
    } else {
        notice.value = 'This text does not say where its camera is; as .glint it would.';
    }
}

// ---- pixels

let asking = false;
let wanted: [number, number] | null = null;

async function ask(at: [number, number]): Promise<Explanation | null> {
    const current = page.first?.current;
    if (!current || !page.pool) return null;
    const {subject, key, prepare} = current;
    try {
        const told = await page.pool.run(
            {view: 'first', key, request: subject.request, prepare, task: {what: 'explain', x: at[0], y: at[1]}}, true);
        return told && !told.error ? told : null;
    } catch {
        return null;
    }
}

/** Points at a pixel; the newest one is explained as soon as the one before it is. */
export async function hover(at: [number, number] | null) {
    pixel.value = at;
    wanted = at;
    if (!at) hovered.value = null;
    if (asking) return;
    asking = true;
    while (wanted) {
        const next: [number, number] = wanted;
        wanted = null;
        const told = await ask(next);
        if (pixel.value) hovered.value = told;
    }
    asking = false;
}

export async function pin(at: [number, number] | null) {
    if (!at) {
        pinned.value = null;
        return;
    }
    const told = await ask(at);
    if (!told) return;
    batch(() => {
        pinned.value = told;
        selected.value = {ray: 0, light: strongestLight(told, 0)};
        tab.value = 'inspect';
    });
}

/** The scene changed: the pinned pixel is explained anew. */
export async function refreshPin() {
    const at = pinned.value?.pixel;
    const size = page.first?.current?.info;
    if (!at || !size) return;
    const told = at[0] < size.width && at[1] < size.height ? await ask([at[0], at[1]]) : null;
    if (!pinned.value) return;
    batch(() => {
        pinned.value = told;
        if (told && selected.value.ray >= told.rays.length) selected.value = {ray: 0, light: strongestLight(told, 0)};
    });
}

export function strongestLight(told: Explanation, ray: number): number {
    const sums = told.rays[ray]?.hit?.lights.map((light) => [...light.diffuse, ...light.specular].reduce((a, b) => a + b, 0));
    return sums && sums.length > 0 ? sums.indexOf(Math.max(...sums)) : 0;
}

/** Goes to a place in the text. */
export function reveal(place: Partial<Place> | null | undefined) {
    if (place?.line === undefined || place.column === undefined) return;
    if (place.file !== fileName.value) {
        notice.value = `That is line ${place.line} of ${place.file}, which this scene includes.`;
        return;
    }
    const [from] = spanOf(text.value, place.line, place.column);
    const end = text.value.indexOf('\n', from);
    if (matchMedia('(max-width: 1099px)').matches) tab.value = 'text';
    // After the editor's panel is shown.
    requestAnimationFrame(() => page.editor?.reveal(from, end < 0 ? text.value.length : end));
}
