// SPDX-License-Identifier: Apache-2.0
// A scene and its settings as a link. All data is in the fragment, which browsers do not send to servers.
import type {SceneText} from 'glint-wasm';

/** A scene with all that belongs to it: of a link, of the browser's storage, or to be opened. */
export interface StoredScene {
    name: string;
    text: string;
    scene?: string | undefined;
    /** Absent: those of the gallery. */
    includes?: SceneText[] | undefined;
    overrides?: Record<string, string> | undefined;
    compare?: {key: string; a: string; b: string} | undefined;
}

export interface Shared extends StoredScene {
    /** The pixel that is explained, the ray that is shown of it, and the open panel. */
    pixel?: [number, number] | undefined;
    step?: number | undefined;
    tab?: string | undefined;
    /** A challenge of a teacher: make this scene's picture equal to the target's. */
    challenge?: SharedChallenge | undefined;
}

export interface SharedChallenge {
    task: string;
    /** The text of the target, of the same name, and its settings outside the text. */
    target: string;
    overrides?: Record<string, string> | undefined;
    /** Only lines with one of these words may be changed. */
    may?: string[] | undefined;
}

class TooLarge extends Error {}

async function through(bytes: Uint8Array<ArrayBuffer>, stream: CompressionStream | DecompressionStream, most = Infinity) {
    const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
    const parts: BlobPart[] = [];
    let total = 0;
    for (;;) {
        const {done, value} = await reader.read();
        if (done) break;
        total += value.length;
        if (total > most) {
            void reader.cancel();
            throw new TooLarge();
        }
        parts.push(value as Uint8Array<ArrayBuffer>);
    }
    return new Uint8Array(await new Blob(parts).arrayBuffer());
}

/** The largest scene of a link, in bytes. */
const largest = 4e6;

/** The fragment of a link, without #. */
export async function toFragment(shared: Shared): Promise<string> {
    const bytes = await through(new TextEncoder().encode(JSON.stringify(shared)), new CompressionStream('deflate-raw'));
    let binary = '';
    for (const byte of bytes) binary += String.fromCharCode(byte);
    return `1=${btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '')}`;
}

/** Decodes a fragment: a scene, or why there is none; null if it is not from this page. */
export async function fromFragment(fragment: string): Promise<Shared | string | null> {
    const match = /^#?1=([\w-]+)$/.exec(fragment);
    if (!match) return null;
    try {
        const binary = atob(match[1]!.replaceAll('-', '+').replaceAll('_', '/'));
        const bytes = Uint8Array.from(binary, (c) => c.charCodeAt(0));
        const value: unknown = JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream('deflate-raw'), largest)));
        return checkedScene(value);
    } catch (error) {
        return error instanceof TooLarge ? 'The scene of the link is larger than 4 MB.' : null;
    }
}

function checkedChallenge(value: unknown): SharedChallenge | undefined {
    if (typeof value !== 'object' || value === null) return undefined;
    const {task, target, overrides, may} = value as Record<string, unknown>;
    if (typeof task !== 'string' || typeof target !== 'string') return undefined;
    return {
        task: task.slice(0, 1000), target,
        overrides: typeof overrides === 'object' && overrides !== null && Object.values(overrides).every((v) => typeof v === 'string')
            ? (overrides as Record<string, string>) : undefined,
        may: Array.isArray(may) && may.every((word) => typeof word === 'string') ? may : undefined,
    };
}

/** A link may come from anyone: only values of the right types are accepted. */
export function checkedScene(value: unknown): Shared | null {
    if (typeof value !== 'object' || value === null) return null;
    const {name, text, scene, includes, overrides, compare, challenge, pixel, step, tab} = value as Record<string, unknown>;
    if (typeof name !== 'string' || typeof text !== 'string') return null;
    const strings = (o: unknown): o is Record<string, string> =>
        typeof o === 'object' && o !== null && Object.values(o).every((v) => typeof v === 'string');
    const isText = (o: unknown): o is SceneText => strings(o) && 'name' in o && 'text' in o;
    return {
        name,
        text,
        scene: typeof scene === 'string' ? scene : undefined,
        includes: Array.isArray(includes) && includes.every(isText) ? includes : undefined,
        overrides: strings(overrides) ? overrides : undefined,
        compare: strings(compare) && 'key' in compare && 'a' in compare && 'b' in compare
            ? (compare as {key: string; a: string; b: string})
            : undefined,
        challenge: checkedChallenge(challenge),
        pixel: Array.isArray(pixel) && pixel.length === 2 && pixel.every((c) => Number.isInteger(c) && c >= 0) ? (pixel as [number, number]) : undefined,
        step: Number.isInteger(step) && (step as number) >= 0 ? (step as number) : undefined,
        tab: typeof tab === 'string' ? tab : undefined,
    };
}
