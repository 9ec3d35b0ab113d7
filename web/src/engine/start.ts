// SPDX-License-Identifier: Apache-2.0
// Fetches the engine once and starts the workers.
import wasmUrl from 'glint-wasm/glint.wasm?url';

import {Pool} from './pool';

export async function startPool(): Promise<Pool> {
    const module = await WebAssembly.compileStreaming(fetch(wasmUrl));
    return new Pool(module, Math.max(1, Math.min(16, navigator.hardwareConcurrency || 2)));
}
