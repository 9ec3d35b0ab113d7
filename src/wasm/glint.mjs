// SPDX-License-Identifier: Apache-2.0
// The API in JavaScript (api.h is its C side), for browsers and node; glint.d.mts describes all parameters
// and results. One instance has one thread: for more threads, create an instance in each of several workers.

/** The functions of wasi_snapshot_preview1 that wasi-libc links; glint itself uses no files and no clock. */
function wasi(memory) {
    const badf = 8;
    return {
        environ_sizes_get(count, size) {
            const view = new DataView(memory().buffer);
            view.setUint32(count, 0, true);
            view.setUint32(size, 0, true);
            return 0;
        },
        environ_get: () => 0,
        fd_write: () => badf,
        fd_close: () => badf,
        fd_seek: () => badf,
        proc_exit(code) {
            throw new Error(`glint ended with ${code}`);
        },
    };
}

/** Compiles glint.wasm, which is next to this file or at another URL, in node or in a browser. */
export async function compile(from = new URL('glint.wasm', import.meta.url)) {
    const url = new URL(String(from), import.meta.url);
    if (url.protocol === 'file:') {
        const {readFile} = await import(/* @vite-ignore */ /* webpackIgnore: true */ 'node:fs/promises');
        return WebAssembly.compile(await readFile(url));
    }
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url.href}: ${response.status} ${response.statusText}`);
    // Compiling while it loads needs a server that knows the type of .wasm files.
    if (response.headers.get('Content-Type') === 'application/wasm') return WebAssembly.compileStreaming(response);
    return WebAssembly.compile(await response.arrayBuffer());
}

/** Creates an instance of glint from the file of compile(). */
export const load = async (from) => instantiate(await compile(from));

/** Creates an instance of glint from a compiled WebAssembly.Module of glint.wasm. */
export async function instantiate(module) {
    let exports = null;
    const host = {progress: null};
    const instance = await WebAssembly.instantiate(module, {
        wasi_snapshot_preview1: wasi(() => exports.memory),
        glint: {progress: (done) => host.progress?.(done)},
    });
    exports = instance.exports;
    exports._initialize();
    return new Glint(checkedExports(exports), host);
}

/** An instance ended in a trap, or has ended before: nothing can be done with it and its scenes. */
export class InstanceError extends WebAssembly.RuntimeError {
    name = 'InstanceError';

    constructor(cause) {
        super(`glint's instance has ended, most likely because its memory ran out (it has at most 2 GiB): create a new one (${cause.message})`);
        this.cause = cause;
    }
}

/** The exports, whose functions throw InstanceError from the first trap on. */
function checkedExports(exports) {
    let trap = null;
    const checked = (call) => (...args) => {
        if (trap !== null) throw new InstanceError(trap);
        try {
            return call(...args);
        } catch (error) {
            trap = error;
            throw new InstanceError(error);
        }
    };
    return Object.fromEntries(Object.entries(exports).map(([name, value]) => [name, typeof value === 'function' ? checked(value) : value]));
}

class Glint {
    #exports;
    #host;

    constructor(exports, host) {
        this.#exports = exports;
        this.#host = host;
    }

    get version() {
        return textAt(this.#exports, this.#exports.glint_version());
    }

    /** Bytes of memory that the instance has allocated from its host. */
    get memoryBytes() {
        return this.#exports.memory.buffer.byteLength;
    }

    /** Whether a call has needed what the instance's file leaves out: never of glint.wasm, which leaves out nothing. */
    get leftOut() {
        return this.#exports.glint_left_out?.() === 1;
    }

    /** Reads and prepares a scene. Close it when it is no longer needed. */
    open(request, {progress = null} = {}) {
        this.#host.progress = progress;
        try {
            return new Scene(this.#exports, withText(this.#exports, request, (at, length) => this.#exports.glint_open(at, length)));
        } finally {
            this.#host.progress = null;
        }
    }
}

/** The text with a final zero at an address of the instance's memory. */
function textAt(exports, from) {
    const memory = new Uint8Array(exports.memory.buffer);
    return new TextDecoder().decode(memory.slice(from, memory.indexOf(0, from)));
}

/** Half of a surrogate pair, which no UTF-8 text can have. */
const loneSurrogate = /\p{Surrogate}/u;

/** Throws if a string of the request has a lone surrogate. */
function checkStrings(value) {
    if (typeof value === 'string') {
        const lone = loneSurrogate.exec(value);
        if (!lone) return;
        const line = value.slice(0, lone.index).split('\n').length;
        throw new TypeError(`line ${line} of a text: expected characters, found half of a surrogate pair, U+${lone[0].charCodeAt(0).toString(16).toUpperCase()}`);
    }
    if (typeof value === 'object' && value !== null) Object.values(value).forEach(checkStrings);
}

/** Calls `use` with the address and length of a request in the instance's memory. */
function withText(exports, request, use) {
    const text = typeof request === 'string' ? request : JSON.stringify(request);
    checkStrings(request);
    return withBytes(exports, new TextEncoder().encode(text), use);
}

/** Calls use() with the address and number of the bytes in the instance's memory. */
function withBytes(exports, bytes, use) {
    const at = exports.glint_allocate(bytes.length + 1);
    if (at === 0) throw new Error('out of memory');
    new Uint8Array(exports.memory.buffer).set(bytes, at);
    const result = use(at, bytes.length);
    exports.glint_free(at);
    return result;
}

/** Throws unless all are whole numbers of 32 bits; WebAssembly would cut others. */
function checkWhole(numbers) {
    for (const [name, value] of Object.entries(numbers)) {
        if ((value | 0) !== value) throw new TypeError(`${name}: expected a whole number, found ${String(value)}`);
    }
}

class Scene {
    #exports;
    /** Zero if the scene is closed. */
    #address;

    constructor(exports, address) {
        this.#exports = exports;
        this.#address = address;
    }

    get #handle() {
        if (this.#address === 0) throw new Error('the scene is closed');
        return this.#address;
    }

    #json(text) {
        return JSON.parse(textAt(this.#exports, text));
    }

    get report() {
        return this.#json(this.#exports.glint_report(this.#handle));
    }

    get info() {
        return this.#json(this.#exports.glint_info(this.#handle));
    }

    prepare(request) {
        const handle = this.#handle;
        const done = withText(this.#exports, request, (at, length) => this.#exports.glint_prepare(handle, at, length));
        if (done === 0) throw new Error(this.report.error ?? 'the scene has errors');
    }

    #render(x, y, width, height) {
        const handle = this.#handle;
        checkWhole({x, y, width, height});
        const at = this.#exports.glint_render(handle, x, y, width, height);
        if (at === 0) throw new Error(this.report.error ?? 'the scene has errors');
        return at;
    }

    /** The pixels of the last rectangle, and the number of its rays. */
    #pixels(width, height) {
        const at = this.#exports.glint_pixels(this.#handle);
        const pixels = new Uint8ClampedArray(this.#exports.memory.buffer, at, 4 * width * height).slice();
        return {pixels, rays: this.#exports.glint_rays(this.#handle)};
    }

    render(x, y, width, height) {
        const at = this.#render(x, y, width, height);
        return new Float32Array(this.#exports.memory.buffer, at, 3 * width * height).slice();
    }

    renderPixels(x, y, width, height) {
        this.#render(x, y, width, height);
        return this.#pixels(width, height);
    }

    renderLayers(names, x, y, width, height) {
        const handle = this.#handle;
        checkWhole({x, y, width, height});
        const done = withText(this.#exports, names.join(' '),
                              (at, length) => this.#exports.glint_render_layers(handle, at, length, x, y, width, height));
        if (done === 0) throw new Error(this.report.error ?? 'the scene has errors');
        const {pixels, rays} = this.#pixels(width, height);
        const layers = Object.fromEntries(names.map((name, i) => {
            const count = this.#exports.glint_layer_channels(handle, i) * width * height;
            return [name, new Float32Array(this.#exports.memory.buffer, this.#exports.glint_layer(handle, i), count).slice()];
        }));
        return {pixels, rays, layers};
    }

    explain(x, y) {
        const handle = this.#handle;
        checkWhole({x, y});
        const explanation = this.#json(this.#exports.glint_explain(handle, x, y));
        if (explanation?.error) throw new Error(explanation.error);
        return explanation;
    }

    compare(reference, {causes = false} = {}) {
        if (reference.#exports !== this.#exports) throw new TypeError('the reference is a scene of another instance');
        const comparison = this.#json(this.#exports.glint_compare(this.#handle, reference.#handle, causes ? 1 : 0));
        if (comparison.error) throw new Error(comparison.error);
        return comparison;
    }

    comparePicture({pixels, width, height}, {causes = false} = {}) {
        const handle = this.#handle;
        checkWhole({width, height});
        if (!(pixels?.length === 4 * width * height)) throw new TypeError('pixels: expected four bytes for each of width x height pixels');
        const comparison = this.#json(withBytes(this.#exports, pixels, (at) => this.#exports.glint_compare_picture(handle, at, width, height, causes ? 1 : 0)));
        if (comparison.error) throw new Error(comparison.error);
        return comparison;
    }

    check() {
        return this.#json(this.#exports.glint_check(this.#handle));
    }

    diagnose(log, {name = 'log'} = {}) {
        const handle = this.#handle;
        if (typeof log !== 'string' && !(log instanceof Uint8Array)) throw new TypeError('log: expected a text or its bytes');
        const bytes = typeof log === 'string' ? new TextEncoder().encode(log) : log;
        const {diagnosis, diagnostics, error} = this.#json(withBytes(this.#exports, bytes, (at, length) => withText(
            this.#exports, String(name), (nameAt, nameLength) => this.#exports.glint_diagnose(handle, at, length, nameAt, nameLength))));
        if (error) throw new Error(error);
        return {...diagnosis, diagnostics};
    }

    toGlint() {
        return textAt(this.#exports, this.#exports.glint_convert(this.#handle));
    }

    close() {
        if (this.#address === 0) return;
        this.#exports.glint_close(this.#address);
        this.#address = 0;
    }
}
