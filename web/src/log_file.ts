// SPDX-License-Identifier: Apache-2.0
// Finds out which of the user's files is the log of a ray tracer (docs/formats/trace_log.md).

/** The bytes in which a log shows what it is. */
const head = 4096;
/** A log should have a few pixels; this is some hundred thousand values. */
const mostBytes = 64e6;

/** A line, or a member of a JSON line, that begins a pixel or a ray. */
const begins = /^\W*pixel\W+-?\d|^\W*ray\W+(camera|primary|eye|mirror|reflect|glass|refract|transmitted|shadow|\d)|^\s*\{.*"(pixel|ray)"\s*:/im;

const headOf = async (file: Blob) => (await file.slice(0, head).text()).replaceAll('\0', '');  // UTF-16 has a 0 beside each letter

/** A .txt is one only if it looks like one. */
export async function isLog(file: File): Promise<boolean> {
    if (/\.(log|jsonl)$/i.test(file.name)) return true;
    return /\.txt$/i.test(file.name) && begins.test(await headOf(file));
}

export interface Log {
    bytes: Uint8Array<ArrayBuffer>;
    /** Of the picture, if the log says it. */
    size: [number, number] | null;
}

function logOf(bytes: Uint8Array<ArrayBuffer>, start: string): Log {
    const said = /^\W*size\W+(\d+)\W+(\d+)/im.exec(start);
    return {bytes, size: said ? [Number(said[1]), Number(said[2])] : null};
}

export const logOfText = (text: string): Log => logOf(new TextEncoder().encode(text), text.slice(0, head));

/** Throws an Error that says what is wrong. */
export async function readLog(file: File): Promise<Log> {
    if (file.size > mostBytes) throw new Error(`it has ${Math.round(file.size / 1e6)} MB, and the page reads logs of up to ${mostBytes / 1e6}: log fewer pixels`);
    return logOf(new Uint8Array(await file.arrayBuffer()), await headOf(file));
}
