// SPDX-License-Identifier: Apache-2.0
import {cgfs, glint} from './blocks';
import type {SceneFormat} from './edit';
import {json} from './json';
import {dat, nff, pov} from './lines';
import {moveBlock} from './moving';

const byExtension: Record<string, SceneFormat> = {
    glint: {...glint, moveShape: moveBlock}, cgfs: {...cgfs, moveShape: moveBlock}, json, js: {...json, name: '.js'}, nff, pov, dat,
};

export const extensions = Object.keys(byExtension);

/** The format for a name's extension, if any. */
export function formatOf(name: string): SceneFormat | null {
    return byExtension[name.split('.').at(-1)!.toLowerCase()] ?? null;
}
