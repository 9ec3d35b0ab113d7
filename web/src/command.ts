// SPDX-License-Identifier: Apache-2.0
// The line of the command that renders the page's picture.
import type {StoredScene} from './share';

/** A word of a shell's command line. */
const quoted = (word: string) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

/** Settings with options of their own; the others are `--convention KEY=VALUE`. */
const options: Record<string, (value: string) => string[]> = {
    size: (value) => ['-s', value],
    shading: (value) => ['--shading', value],
    reflections: (value) => ['--reflections', value],
    aa: (value) => ['--aa', value],
};

function optionOf([key, value]: [string, string]): string[] {
    if (key === 'shadows' && value === 'false') return ['--no-shadows'];
    return options[key]?.(value) ?? ['--convention', `${key}=${value}`];
}

/** `glint render` of the saved scene, with the settings that its text does not say; of a comparison, the left picture. */
export function commandLine({name, scene, overrides, compare}: StoredScene): string {
    const file = name.split('/').at(-1)!;
    const settings = {...overrides, ...(compare ? {[compare.key]: compare.a} : {})};
    return ['glint', 'render', file.startsWith('-') ? `./${file}` : file, ...(scene === undefined ? [] : ['--scene', scene]),
            ...Object.entries(settings).flatMap(optionOf)].map(quoted).join(' ');
}
