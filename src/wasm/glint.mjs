// The door from JavaScript's side (door.h is the other), for browsers and node alike. One instance has one thread: a page
// that wants more makes one in each of its workers.

/** The few functions of wasi_snapshot_preview1 that wasi-libc links; glint itself reaches no file and no clock. */
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

/** Makes an instance of glint from a compiled WebAssembly.Module of glint.wasm. */
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

    /** Bytes of memory that the instance has taken from its host. */
    get memoryBytes() {
        return this.#exports.memory.buffer.byteLength;
    }

    /** Reads and prepares a scene; the request is glint_open's (door.h). Close it when it is no longer needed. */
    open(request) {
        const bytes = new TextEncoder().encode(typeof request === 'string' ? request : JSON.stringify(request));
        const at = this.#exports.glint_allocate(bytes.length + 1);
        if (at === 0) throw new Error('out of memory');
        new Uint8Array(this.#exports.memory.buffer).set(bytes, at);
        const handle = this.#exports.glint_open(at, bytes.length);
        this.#exports.glint_free(at);
        return new Scene(this.#exports, handle, (from) => this.#text(from));
    }

    #text(from) {
        const memory = new Uint8Array(this.#exports.memory.buffer);
        return new TextDecoder().decode(memory.slice(from, memory.indexOf(0, from)));
    }
}

class Scene {
    #exports;
    #handle;
    #text;

    constructor(exports, handle, text) {
        this.#exports = exports;
        this.#handle = handle;
        this.#text = text;
    }

    /** {ready, width, height, diagnostics, error}: see glint_report. */
    get report() {
        return JSON.parse(this.#text(this.#exports.glint_report(this.#handle)));
    }

    /** The linear RGB floats of a rectangle of the picture, row by row from the top. Throws what glint_report says. */
    render(x, y, width, height) {
        const at = this.#exports.glint_render(this.#handle, x, y, width, height);
        if (at === 0) throw new Error(this.report.error ?? 'the scene has errors');
        return new Float32Array(this.#exports.memory.buffer, at, 3 * width * height).slice();
    }

    close() {
        this.#exports.glint_close(this.#handle);
    }
}
