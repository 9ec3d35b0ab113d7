// SPDX-License-Identifier: Apache-2.0
// What the page knows. The scene's text is the one truth: controls edit it, and only what its format cannot say is kept
// beside it, in `overrides`.
import {computed, signal} from '@preact/signals';
import type {Diagnostic, Explanation, SceneInfo, SceneText, Setting} from 'glint-wasm';

import type {DocumentState, Editor} from '../editor/editor';
import type {Pool} from '../engine/pool';
import type {Progress, View} from '../engine/view';
import {formatOf} from '../text/formats';

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
/** Of the picture, in pixels. */
export const size = signal({width: 600, height: 600});

export type Comparison = {key: string; a: string; b: string};
export const comparison = signal<Comparison | null>(null);
/** Why the right picture of a comparison could not be drawn. */
export const comparisonFailure = signal('');
export const difference = signal(false);
export const split = signal(0.5);

/** One of the two pictures of a comparison; the first is all there is without one. */
export type Side = 'first' | 'second';
export const pixel = signal<[number, number] | null>(null);
export const hovered = signal<Explanation | null>(null);
export const pinned = signal<Explanation | null>(null);
/** In which picture, and whether that is shaded by Phong's S = R·V. */
export const pinnedIn = signal<{side: Side; isPhong: boolean}>({side: 'first', isPhong: true});
/** The ray and light that the inspector shows in its diagram. */
export const selected = signal<{ray: number; light: number}>({ray: 0, light: 0});
export const tab = signal<'text' | 'controls' | 'inspect' | 'compare'>('controls');

export const format = computed(() => formatOf(fileName.value));

/** What is not a part of the page's state: made once, when it starts. */
export const services: {editor?: Editor; pool?: Pool; first?: View; second?: View} = {};

export const currentDocumentState = (): DocumentState => ({
    name: fileName.value, scene: sceneName.value, overrides: overrides.value, includes: includes.value,
});

export function settingIn(facts: SceneInfo | null | undefined, name: string): Setting | undefined {
    return facts?.settings.find((setting) => setting.name === name);
}
export const settingOf = (name: string) => settingIn(info.value, name);
