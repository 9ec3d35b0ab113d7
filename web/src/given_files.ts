// SPDX-License-Identifier: Apache-2.0
// The files that the user gives: single ones, those of a folder, and those in a .zip.
import {bufferExtensions, meshExtensions} from './mesh_file';
import {isPictureName} from './picture_file';
import {extensions} from './text/formats';

export interface GivenFile {
    /** With its folders, if it is of a folder or a .zip. */
    path: string;
    file: File;
}

/** What is read of folders and archives: the texts of scenes, within limits. */
const mostFiles = 2000, mostBytes = 64e6;
const texts = new RegExp(`\\.(${[...extensions, ...meshExtensions, ...bufferExtensions, 'mtl', 'inc', 'log', 'jsonl'].join('|')})$`, 'i');
const isWanted = (path: string) => (texts.test(path) || isPictureName(path)) && !/(^|\/)(\.|__MACOSX)/.test(path);

const isArchive = ({name}: File) => /\.zip$/i.test(name);

async function filesIn(entry: FileSystemEntry, into: GivenFile[]): Promise<void> {
    if (into.length >= mostFiles) return;
    const path = entry.fullPath.replace(/^\//, '');
    if (entry.isFile) {
        if (isWanted(path)) into.push({path, file: await new Promise((found, failed) => (entry as FileSystemFileEntry).file(found, failed))});
        return;
    }
    const reader = (entry as FileSystemDirectoryEntry).createReader();
    for (;;) {
        const some = await new Promise<FileSystemEntry[]>((found, failed) => reader.readEntries(found, failed));
        if (some.length === 0) return;
        for (const one of some) await filesIn(one, into);
    }
}

/** The files of a drop. What it holds is asked for at once: it is gone when the event is over. */
export async function droppedFiles(transfer: DataTransfer): Promise<GivenFile[]> {
    const single: GivenFile[] = [], folders: FileSystemEntry[] = [];
    for (const item of transfer.items) {
        const entry = item.kind === 'file' ? item.webkitGetAsEntry?.() : null, file = item.getAsFile();
        if (entry?.isDirectory) folders.push(entry);
        else if (file) single.push({path: file.name, file});
    }
    for (const folder of folders) await filesIn(folder, single);
    return single;
}

/** Those of an input field, for files or for a folder. */
export const chosenFiles = (list: Iterable<File>): GivenFile[] =>
    [...list].map((file) => ({path: file.webkitRelativePath || file.name, file})).filter(({path, file}) => path === file.name || isWanted(path)).slice(0, mostFiles);

export const unpacker = () => import('./unzip');

async function unpacked({file}: GivenFile): Promise<GivenFile[]> {
    const {unzipSync} = await unpacker();
    let total = 0, count = 0;
    const found = unzipSync(new Uint8Array(await file.arrayBuffer()), {
        filter: ({name, originalSize}) => isWanted(name) && ++count <= mostFiles && (total += originalSize) <= mostBytes,
    });
    return Object.entries(found).map(([path, bytes]) => ({path, file: new File([bytes as Uint8Array<ArrayBuffer>], path.split('/').at(-1)!)}));
}

/** The files, with those in archives in the place of the archives. Throws an Error that says what is wrong. */
export async function withoutArchives(files: readonly GivenFile[]): Promise<GivenFile[]> {
    const lists = await Promise.all(files.map((one) => (isArchive(one.file) ? unpacked(one).catch(() => {
        throw new Error(`${one.file.name} is not opened: it is no .zip, or is damaged.`);
    }) : [one])));
    return lists.flat();
}
