// SPDX-License-Identifier: Apache-2.0
// The playground's tests. One process and one browser: the subjects' files are imported one after the other.
import './gallery.mjs';
import './text.mjs';
import './controls.mjs';
import './camera.mjs';
import './inspector.mjs';
import './sharing.mjs';
import './access.mjs';
import './stress.mjs';
