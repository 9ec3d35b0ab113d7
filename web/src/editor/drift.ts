// The places of a scene are those in the text that it was read from; this takes them along as the text changes.
import {type ChangeDesc, MapMode} from '@codemirror/state';

import {spanOf} from '../text/places';

export class Drift {
    /** Of the text; each change makes a new one. */
    version = 0;
    /** The text that places are of, and what has changed since; null: no place is known. */
    #read: {text: string; since: {version: number; changes: ChangeDesc}[]} | null = null;

    changed(changes: ChangeDesc) {
        ++this.version;
        this.#read?.since.push({version: this.version, changes});
    }

    /** Another text. */
    restart() {
        ++this.version;
        this.#read = null;
    }

    /** A scene was read from a version of the text: places are of that one now. */
    read(version: number, text: string) {
        this.#read = {text, since: this.#read?.since.filter((one) => one.version > version) ?? []};
    }

    /** Where a place is now, counted in lines and bytes from 1; null if it was deleted. */
    now(line: number, column: number): number | null {
        if (!this.#read) return null;
        this.#shorten(this.#read.since);
        let at: number | null = spanOf(this.#read.text, line, column)[0];
        for (const {changes} of this.#read.since) at = at === null ? null : changes.mapPos(at, 1, MapMode.TrackDel);
        return at;
    }

    /** While a mistake lasts, changes pile up. Those that are older than what may be being read become one. */
    #shorten(since: {version: number; changes: ChangeDesc}[]) {
        const many = 200;
        if (since.length < 2 * many) return;
        const old = since.splice(0, many);
        since.unshift({version: old.at(-1)!.version, changes: old.map((one) => one.changes).reduce((all, next) => all.composeDesc(next))});
    }
}
