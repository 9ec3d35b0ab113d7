// SPDX-License-Identifier: Apache-2.0
// Modules for the tests, without glint.mjs.

/** The exports of a module that calls nothing outside itself. */
export function instanceOf(bytes) {
    const module = new WebAssembly.Module(bytes);
    const imports = {};
    for (const {module: from, name} of WebAssembly.Module.imports(module)) {
        (imports[from] ??= {})[name] = () => { throw new Error(`${name} was called`); };
    }
    const {exports} = new WebAssembly.Instance(module, imports);
    exports._initialize();
    return exports;
}

/** A text of the module, which ends with 0. */
export function textAt(exports, address) {
    const memory = new Uint8Array(exports.memory.buffer);
    return new TextDecoder().decode(memory.subarray(address, memory.indexOf(0, address)));
}
