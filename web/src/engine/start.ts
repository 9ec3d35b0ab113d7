// SPDX-License-Identifier: Apache-2.0
// Fetches the engine and starts the workers: first its core, which is two thirds of it, and the whole when the core says that a job
// needs it (src/wasm/left_out.cpp), or when the first picture is there.
import wholeUrl from 'glint-wasm/glint.wasm?url';

import coreUrl from '../../../build/wasm/glint-core.wasm?url';
import {Pool} from './pool';

export async function startPool(): Promise<Pool> {
    const core = await WebAssembly.compileStreaming(fetch(coreUrl));
    const whole = () => WebAssembly.compileStreaming(fetch(wholeUrl));
    return new Pool(core, whole, Math.max(1, Math.min(16, navigator.hardwareConcurrency || 2)));
}
