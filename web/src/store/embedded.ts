// SPDX-License-Identifier: Apache-2.0
// Whether this is a page in an iframe, and what it shows (docs/embedding.md).

export interface Embedded {
    controls: ReadonlySet<string>;
    /** Of the page around: messages of others are ignored. */
    origin: string;
}

function originOf(address: string | null): string {
    try {
        return new URL(address ?? '').origin;
    } catch {
        return location.origin;
    }
}

function read(): Embedded | null {
    const parameters = new URLSearchParams(location.search);
    const list = parameters.get('embed');
    return list === null ? null : {controls: new Set(list.split(',').filter(Boolean)), origin: originOf(parameters.get('origin'))};
}

/** Null: this is the whole page. */
export const embedded = read();

/** Whether the user may use a part of the page: `camera`, `inspect`, ... */
export const allows = (control: string) => embedded === null || embedded.controls.has(control);
