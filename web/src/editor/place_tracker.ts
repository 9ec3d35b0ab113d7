// SPDX-License-Identifier: Apache-2.0
// The places of a scene belong to the text that it was read from; this moves them along as the text changes.
import {type ChangeDesc, MapMode, type Text} from '@codemirror/state';

import {unitsOf} from '../text/places';

interface Version {
    number: number;
    text: Text;
}

export class PlaceTracker {
    /** The version of the present text; each change makes a new one. */
    version = 0;
    /** The text of the places, and the changes since. */
    #base: Version | null = null;
    #since: (Version & {changes: ChangeDesc})[] = [];
    #isRead = false;

    /** Sets another text. */
    restart(text: Text) {
        this.#base = {number: ++this.version, text};
        this.#since = [];
        this.#isRead = false;
    }

    changed(changes: ChangeDesc, text: Text) {
        this.#since.push({number: ++this.version, text, changes});
        this.#shorten();
    }

    /** A scene was read from a version of the text: places now belong to that version. */
    read(version: number) {
        const at = this.#since.findIndex((one) => one.number === version);
        if (at < 0 && this.#base?.number !== version) return;
        this.#base = this.#since[at] ?? this.#base;
        this.#since = this.#since.slice(at + 1);
        this.#isRead = true;
    }

    /** The present position of a place, with lines and bytes counted from 1; null if it was deleted or nothing has been read. */
    now(line: number, column: number): number | null {
        if (!this.#base || !this.#isRead || line > this.#base.text.lines) return null;
        const {from, text} = this.#base.text.line(line);
        let at: number | null = from + unitsOf(text, column - 1);
        for (const {changes} of this.#since) at = at === null ? null : changes.mapPos(at, 1, MapMode.TrackDel);
        return at;
    }

    /** While the text has an error, changes pile up. Those older than any version that may still be read are merged. */
    #shorten() {
        const many = 200;
        if (this.#since.length < 2 * many) return;
        const old = this.#since.splice(0, many);
        const changes = old.map((one) => one.changes).reduce((all, next) => all.composeDesc(next));
        this.#since.unshift({...old.at(-1)!, changes});
    }
}
