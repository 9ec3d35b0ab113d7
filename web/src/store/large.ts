// SPDX-License-Identifier: Apache-2.0
// Values that are larger than what sessionStorage and localStorage hold: in IndexedDB, where there is room.

const name = 'glint', store = 'large';
/** So many are kept, of all tabs; the oldest are deleted. */
const most = 12;

interface Kept {
    key: string;
    time: number;
    value: unknown;
}

const answer = <T>(request: IDBRequest<T>) => new Promise<T>((done, failed) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => failed(request.error ?? new Error());
});

let opened: Promise<IDBDatabase> | null = null;

/** Rejected where storage is forbidden. */
function database(): Promise<IDBDatabase> {
    opened ??= (async () => {
        const request = indexedDB.open(name, 1);
        request.onupgradeneeded = () => request.result.createObjectStore(store, {keyPath: 'key'}).createIndex('time', 'time');
        return answer(request);
    })();
    opened.catch(() => {
        opened = null;
    });
    return opened;
}

/** Keeps a value. False: there is no storage, or no room in it. */
export async function keepLarge(key: string, value: unknown): Promise<boolean> {
    try {
        const transaction = (await database()).transaction(store, 'readwrite'), all = transaction.objectStore(store);
        const done = new Promise<void>((end, failed) => {
            transaction.oncomplete = () => end();
            transaction.onabort = transaction.onerror = () => failed(transaction.error);
        });
        all.put({key, time: Date.now(), value} satisfies Kept);
        const keys = await answer(all.index('time').getAllKeys());
        for (const old of keys.slice(0, Math.max(0, keys.length - most))) all.delete(old);
        await done;
        return true;
    } catch {
        return false;
    }
}

/** What is kept of a key; null: nothing. */
export async function largeOf(key: string): Promise<unknown> {
    try {
        const kept = await answer((await database()).transaction(store).objectStore(store).get(key)) as Kept | undefined;
        return kept?.value ?? null;
    } catch {
        return null;
    }
}
