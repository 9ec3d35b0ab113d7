// SPDX-License-Identifier: Apache-2.0
// The vectors of the browser build compute what plain code computes. GLINT_LANES_FAULT: the module of lanes_fault.cpp.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {test} from 'node:test';

import {instanceOf, textAt} from './module.mjs';

test('lanes compute what plain code computes', () => {
    const exports = instanceOf(readFileSync(process.env.GLINT_LANES_FAULT));
    assert.equal(textAt(exports, exports.lanes_fault()), '');
});
