// SPDX-License-Identifier: Apache-2.0
// Which of some files a scene includes, under the names by which it asks for them.
import type {SceneText} from 'glint-wasm';

export const folderOf = (name: string) => name.slice(0, name.lastIndexOf('/') + 1);

/** A path without `.` and `..`. */
export function plainPath(path: string): string {
    const parts: string[] = [];
    for (const part of path.replaceAll('\\', '/').split('/')) {
        if (part === '..' && parts.length > 0) parts.pop();
        else if (part !== '.' && part !== '' && part !== '..') parts.push(part);
    }
    return parts.join('/');
}

/** The file of a name: that of the same path, else the one that ends like it, else one of the same name. Letters' case is the last to decide. */
export function fileFor(name: string, files: readonly SceneText[]): SceneText | undefined {
    const wanted = plainPath(name), own = wanted.split('/').at(-1)!;
    const paths = files.map((file) => ({file, path: plainPath(file.name)}));
    const ways: ((path: string) => boolean)[] = [
        (path) => path === wanted,
        (path) => path.endsWith(`/${wanted}`) || wanted.endsWith(`/${path}`),
        (path) => path.split('/').at(-1) === own,
        (path) => path.split('/').at(-1)!.toLowerCase() === own.toLowerCase(),
    ];
    for (const fits of ways) {
        const found = paths.find(({path}) => fits(path));
        if (found) return found.file;
    }
    return undefined;
}

/** The name of a file in a URI: %20 is a blank. */
function unescaped(uri: string): string {
    try {
        return decodeURIComponent(uri);
    } catch {
        return uri;
    }
}

/** The name of a picture in a statement of an .mtl, after `-s 2 2 1` and the like. */
const withoutOptions = (said: string) => said.replace(/^(?:-[a-z]+\s+(?:(?:[-+.\d][^\s]*\s+)+|\S+\s+))*/, '').replaceAll('\\', '/');

/**
 * The names that a text includes, as glint asks for them; those in comments are among them. `main`: the scene's own text, from
 * whose folder POV-Ray's includes all start.
 */
export function namesIncludedBy({name, text}: SceneText, main = name): string[] {
    const folder = folderOf(/\.(pov|inc)$/i.test(name) ? main : name);
    if (/\.obj$/i.test(name)) return [...text.matchAll(/^mtllib\s+(.+?)\s*$/gm)].map(([, said]) => folder + said!);
    if (/\.gltf$/i.test(name)) return [...text.matchAll(/"uri"\s*:\s*"(?!data:)([^"\n]+)"/g)].map(([, said]) => folder + unescaped(said!));
    if (/\.mtl$/i.test(name)) return [...text.matchAll(/^[ \t]*map_(?:Kd|d)[ \t]+(.+?)\s*$/gm)].map(([, said]) => folder + withoutOptions(said!));
    const words = /\.glint$/i.test(name) ? /(?:^|[\s{])(?:include\s+|file\s*=\s*)"([^"\n]+)"/g : /(?:^|[\s#])include\s+"([^"\n]+)"/g;
    return [...text.matchAll(words)].map(([, said]) => (said!.startsWith('/') ? said! : folder + said!));
}

/** A converted scene that is placed in a folder: its files' names start from there. */
export const placedIn = (folder: string, glint: string) => (folder === '' ? glint : glint.replaceAll(`file = "${folder}`, 'file = "'));

/** The texts that some names of a scene stand for, and all that these include, as far as they are among the files. */
export function textsFor(names: readonly string[], main: string, files: readonly SceneText[]): SceneText[] {
    const found = new Map<string, SceneText>();
    const waiting = [...names];
    for (let name = waiting.pop(); name !== undefined; name = waiting.pop()) {
        if (found.has(name)) continue;
        const file = fileFor(name, files);
        if (!file) continue;
        const text = {...file, name};
        found.set(name, text);
        waiting.push(...namesIncludedBy(text, main));
    }
    return [...found.values()];
}

/** The files that no other one includes, the nearest to the top first. */
export function rootsOf(files: readonly SceneText[]): SceneText[] {
    const included = new Set(files.flatMap((file) => namesIncludedBy(file).map((name) => fileFor(name, files))));
    const depth = ({name}: SceneText) => name.split('/').length;
    const free = files.filter((file) => !included.has(file));
    return (free.length > 0 ? free : [...files]).sort((a, b) => depth(a) - depth(b));
}
