// SPDX-License-Identifier: Apache-2.0
// The state of the page. The scene's text is the single source: controls edit it, and only settings that its format
// cannot express are stored in `overrides`.
import {computed, signal} from '@preact/signals';
import type {Diagnostic, Explanation, SceneInfo, SceneText, Setting} from 'glint-wasm';

import type {DocumentState, Editor} from '../editor/editor';
import type {Pool} from '../engine/pool';
import type {Progress, View} from '../engine/view';
import type {SharedChallenge} from '../share';
import {formatOf} from '../text/formats';

/** The number of the scene: another scene, another number. */
export const documentId = signal(0);
/** That of the scene in the picture, and of `info`. */
export const shownId = signal(0);
export const fileName = signal('');
export const text = signal('');
export const sceneName = signal<string | undefined>(undefined);
export const includes = signal<SceneText[]>([]);
/** Settings that override the text. */
export const overrides = signal<Record<string, string>>({});
/** Objects that glint does not render are left out. */
export const skipsUnsupported = signal(false);
export const history = signal({canUndo: false, canRedo: false});

/** Of the last scene that could be rendered. */
export const info = signal<SceneInfo | null>(null);
export const diagnostics = signal<Diagnostic[]>([]);
/** Texts that the scene includes and that are not there, by name. */
export const missing = signal<string[]>([]);
/** Why rendering failed, if the text is not the reason. */
export const failure = signal('');
export const state = signal<'starting' | 'reading' | 'rendering' | 'done' | 'error'>('starting');
export const progress = signal<Progress>({fraction: 0, rays: 0, milliseconds: 0});
export const notice = signal('');
/** The picture's size in pixels. */
export const size = signal({width: 600, height: 600});

export type Comparison = {key: string; a: string; b: string};
export const comparison = signal<Comparison | null>(null);
/** The right picture of a comparison is complete. */
export const isSecondDone = signal(false);
/** Why the right picture of a comparison could not be rendered. */
export const comparisonFailure = signal('');
export const difference = signal(false);
export const split = signal(0.5);

/** A picture of the scene by another program, which the user has dropped; it is shown as the right one. */
export interface OwnPicture {name: string; image: ImageData}
export const ownPicture = signal<OwnPicture | null>(null);

/** What the user's own ray tracer has logged of the scene, whose number is `document`. isOfTask: it came with a lesson or challenge. */
export interface OwnLog {name: string; bytes: Uint8Array<ArrayBuffer>; size: [number, number] | null; document: number; isOfTask: boolean}
export const ownLog = signal<OwnLog | null>(null);

/** Two pictures are shown: the names of both. */
export const besides = computed(() => {
    const compare = comparison.value, own = ownPicture.value;
    if (own) return {left: 'glint', right: own.name};
    return compare ? {left: `${compare.key} = ${compare.a}`, right: `${compare.key} = ${compare.b}`} : null;
});

/** One of the two pictures of a comparison; without a comparison there is only the first. */
export type Side = 'first' | 'second';
export const pixel = signal<[number, number] | null>(null);
export const hovered = signal<Explanation | null>(null);
export const pinned = signal<Explanation | null>(null);
/** The picture of the pinned pixel, and whether its shading is Phong (S = R·V). */
export const pinnedIn = signal<{side: Side; isPhong: boolean}>({side: 'first', isPhong: true});
/** The ray and light that the inspector's diagram shows. */
export const selected = signal<{ray: number; light: number}>({ray: 0, light: 0});
/** The step through the rays of the pinned pixel (stepping.ts); null: all rays are shown. */
export const step = signal<number | null>(null);
const tabs = ['learn', 'text', 'controls', 'inspect', 'compare'] as const;
export type Tab = (typeof tabs)[number];
export const isTab = (name: unknown): name is Tab => tabs.some((one) => one === name);
export const tab = signal<Tab>('controls');
/** The challenge of the link that was opened. */
export const givenChallenge = signal<(SharedChallenge & {name: string; start: string}) | null>(null);
/** The line that says what this page is is shown. */
export const isFirstVisit = signal(false);

/** True if the picture is one of the present scene: not of one that was opened before. */
export const isPictureOfScene = computed(() => shownId.value === documentId.value);
export const format = computed(() => formatOf(fileName.value));

/** Objects that are created once, when the page starts. */
export const services: {editor?: Editor; pool?: Pool; first?: View; second?: View} = {};

export const currentDocumentState = (): DocumentState => ({
    id: documentId.value, name: fileName.value, scene: sceneName.value, overrides: overrides.value, includes: includes.value,
});

export function settingIn(facts: SceneInfo | null | undefined, name: string): Setting | undefined {
    return facts?.settings.find((setting) => setting.name === name);
}
export const settingOf = (name: string) => settingIn(info.value, name);
