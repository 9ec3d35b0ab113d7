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

/** Creates an instance of glint from a compiled WebAssembly.Module of glint.wasm. */
export async function instantiate(module) {
    let exports = null;
    const instance = await WebAssembly.instantiate(module, {wasi_snapshot_preview1: wasi(() => exports.memory)});
    exports = instance.exports;
    exports._initialize();
    return new Glint(exports);
}

class Glint {
    #exports;

    constructor(exports) {
        this.#exports = exports;
    }

    get version() {
        return this.#text(this.#exports.glint_version());
    }

    /** Bytes of memory that the instance has allocated from its host. */
    get memoryBytes() {
        return this.#exports.memory.buffer.byteLength;
    }

    /** Reads and prepares a scene. Close it when it is no longer needed. */
    open(request) {
        return new Scene(this.#exports, withText(this.#exports, request, (at, length) => this.#exports.glint_open(at, length)));
    }

    #text(from) {
        return textAt(this.#exports, from);
    }
}

/** The text with a final zero at an address of the instance's memory. */
function textAt(exports, from) {
    const memory = new Uint8Array(exports.memory.buffer);
    return new TextDecoder().decode(memory.slice(from, memory.indexOf(0, from)));
}

/** Calls `use` with the address and length of a request in the instance's memory. */
function withText(exports, request, use) {
    const bytes = new TextEncoder().encode(typeof request === 'string' ? request : JSON.stringify(request));
    const at = exports.glint_allocate(bytes.length + 1);
    if (at === 0) throw new Error('out of memory');
    new Uint8Array(exports.memory.buffer).set(bytes, at);
    const result = use(at, bytes.length);
    exports.glint_free(at);
    return result;
}

class Scene {
    #exports;
    #handle;

    constructor(exports, handle) {
        this.#exports = exports;
        this.#handle = handle;
    }

    get report() {
        return JSON.parse(textAt(this.#exports, this.#exports.glint_report(this.#handle)));
    }

    get info() {
        return JSON.parse(textAt(this.#exports, this.#exports.glint_info(this.#handle)));
    }

    prepare(request) {
        const done = withText(this.#exports, request, (at, length) => this.#exports.glint_prepare(this.#handle, at, length));
        if (done === 0) throw new Error(this.report.error ?? 'the scene has errors');
    }

    render(x, y, width, height) {
        const at = this.#exports.glint_render(this.#handle, x, y, width, height);
        if (at === 0) throw new Error(this.report.error ?? 'the scene has errors');
        return new Float32Array(this.#exports.memory.buffer, at, 3 * width * height).slice();
    }

    renderPixels(x, y, width, height) {
        if (this.#exports.glint_render(this.#handle, x, y, width, height) === 0)
            throw new Error(this.report.error ?? 'the scene has errors');
        const at = this.#exports.glint_pixels(this.#handle);
        const pixels = new Uint8ClampedArray(this.#exports.memory.buffer, at, 4 * width * height).slice();
        return {pixels, rays: this.#exports.glint_rays(this.#handle)};
    }

    explain(x, y) {
        return JSON.parse(textAt(this.#exports, this.#exports.glint_explain(this.#handle, x, y)));
    }

    toGlint() {
        return textAt(this.#exports, this.#exports.glint_convert(this.#handle));
    }

    close() {
        this.#exports.glint_close(this.#handle);
    }
}
