// SPDX-License-Identifier: Apache-2.0
// The lobes of the diagram: in the direction of the eye they are the terms of the pixel.
import assert from 'node:assert/strict';
import {test} from 'node:test';

import {load, pageModule} from './page_module.mjs';

const glint = await load();
const {lobes} = await pageModule('ui/lobes.ts');

/** Camera, light and the points of the middle row are in the plane y = 0. */
const text = (shading) => `render { size = 101 x 101  shading = ${shading} }
camera { position = (0, 0, 6)  look_at = (0, 0, 0)  fov_x = 40 }
light { position = (4, 0, 5)  color = (0.9, 0.6, 0.3)  attenuation = (0.5, 0.1, 0) }
sphere { center = (0, 0, 0)  radius = 1.5  color = (0.3, 0.6, 0.9)  diffuse = 0.7  specular_color = (0.5, 0.4, 0.4)  shininess = 9 }\n`;

for (const shading of ['phong', 'blinn-phong']) {
    test(`${shading}: diffuse light and highlight towards the eye`, () => {
        const scene = glint.open({texts: [{name: 'lobes.glint', text: text(shading)}]});
        let shown = 0;
        for (let x = 20; x <= 80; x += 5) {
            const [{hit}] = scene.explain(x, 50).rays;
            const [terms] = hit.lights, found = lobes(hit, terms, shading === 'phong');
            if (terms.reason !== 'adds') {
                assert.equal(found, null);
                continue;
            }
            const dot = (a, b) => a.reduce((sum, value, c) => sum + value * b[c], 0);
            const angleOf = (vector) => Math.atan2(vector[0] * hit.normal[2] - vector[2] * hit.normal[0], dot(vector, hit.normal)) * 180 / Math.PI;
            const towards = Math.sign(angleOf(terms.to_light)) || 1;
            assert.ok(Math.abs(found.diffuse - Math.max(...terms.diffuse)) < 1e-9);
            assert.ok(Math.abs(found.highlight(towards * angleOf(hit.to_eye)) - Math.max(...terms.specular)) < 1e-6, `x = ${x}`);
            ++shown;
        }
        assert.ok(shown > 8);
        scene.close();
    });
}
