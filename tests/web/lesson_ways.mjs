// SPDX-License-Identifier: Apache-2.0
// Ways to do the steps of the lessons that are not their solutions, and near misses. Each way is done after the solutions of the steps
// before; its actions are those of a solution (docs/lessons/README.md), divided by `;`.
export const ways = {
    '01_ambient': [
        {right: ['replace intensity = 0.2 => intensity = 0.6', 'replace intensity = 0.2 => intensity = 3', 'replace intensity = 0.2 => color = (0.7, 0.7, 0.7)'],
            near: ['replace intensity = 0.2 => intensity = 0.59', 'replace ambient = 1 => ambient = 4']},
        {right: ['replace intensity = 0.8 => intensity = 0.65  color = (0.2, 1, 0.2)', 'replace intensity = 0.8 => intensity = 0.8  color = (0, 1, 0)',
            'replace intensity = 0.8 => color = (0.3, 0.8, 0.3)'],
        near: ['replace intensity = 0.8 => intensity = 0.8  color = (0.9, 1, 0.9)', 'replace color = (1, 0.6, 0.3) => color = (0.2, 1, 0.2)']},
        {right: ['append light { position = (4, 5, 3)  intensity = 0.6 }', 'append light { position = (2, 3, 9)  color = (0.5, 0.5, 0.5) }',
            'append light { position = (6, 6, 6)  intensity = 1 }'],
        near: ['append light { type = ambient  intensity = 0.6 }', 'append light { position = (3, 4, -5)  intensity = 0.6 }']},
    ],
    '02_diffuse': [
        {right: ['pin 0.3,0.5', 'pin 0.5,0.765', 'pin 0.36,0.69'], near: ['pin 0.5,0.5', 'pin 0.9,0.5']},
        {right: ['replace position = (0, 1, 6)  intensity => position = (-5, 1, 0)  intensity', 'replace position = (0, 1, 6)  intensity => position = (-9, 3, 3)  intensity',
            'replace position = (0, 1, 6)  intensity => position = (-3, 1, 1)  intensity'],
        near: ['replace position = (0, 1, 6)  intensity => position = (5, 1, 2)  intensity', 'replace position = (0, 1, 6)  intensity => position = (-1, 1, 6)  intensity']},
        {right: ['pin 0.43,0.5', 'pin 0.44,0.55', 'pin 0.42,0.45'], near: ['pin 0.36,0.5', 'pin 0.65,0.5']},
    ],
    '03_specular': [
        {right: ['replace shininess = 10 => shininess = 10  specular_color = (0.3, 0.3, 0.3)', 'replace shininess = 10 => shininess = 10  specular = 0.4',
            'replace shininess = 10 => shininess = 40  specular_color = (1, 1, 1)'],
        near: ['replace shininess = 10 => shininess = 100', 'replace diffuse = 0.6 => diffuse = 1']},
        {right: ['replace shininess = 10 => shininess = 100', 'replace shininess = 10 => shininess = 1000', 'replace shininess = 10  specular_color = (0.6, 0.6, 0.6) => shininess = 300  specular = 0.3'],
            near: ['replace shininess = 10 => shininess = 99', 'replace shininess = 10  specular_color = (0.6, 0.6, 0.6) => shininess = 200']},
        {right: ['replace shininess = 200 => shininess = 3', 'replace shininess = 200  specular_color = (0.6, 0.6, 0.6) => shininess = 3.5  specular_color = (0.3, 0.3, 0.3)',
            'replace shininess = 200 => shininess = 4'],
        near: ['replace shininess = 200 => shininess = 12', 'replace shininess = 200 => shininess = 1']},
    ],
    '04_blinn': [
        {right: ['replace shading = phong => shading = blinn-phong', 'replace shading = phong => shading  =  blinn-phong', 'replace   shading = phong => \n  shading = blinn-phong'],
            near: ['replace shininess = 20 => shininess = 5', 'replace shading = phong => shading = diffuse']},
        {right: ['pin 0.5,0.5', 'pin 0.47,0.5', 'pin 0.5,0.53'], near: ['pin 0.68,0.5', 'pin 0.9,0.5']},
        {right: ['replace shininess = 20 => shininess = 70', 'replace shininess = 20 => shininess = 90', 'replace shininess = 20 => shininess = 77.7'],
            near: ['replace shininess = 20 => shininess = 40', 'replace shading = blinn-phong => shading = phong; replace shininess = 20 => shininess = 80']},
    ],
    '05_attenuation': [
        {right: ['replace intensity = 1 } => attenuation = (0, 0, 1) }', 'replace intensity = 1 } => intensity = 1  attenuation = (0.0, 0, 1.0) }', 'replace intensity = 1 } => intensity = 2  attenuation = (0, 0, 1) }'],
            near: ['replace intensity = 1 } => intensity = 1  attenuation = (0, 1, 1) }', 'replace intensity = 1 } => intensity = 1  attenuation = (1, 0, 1) }']},
        {right: ['replace intensity = 1  att => intensity = 5  att', 'replace intensity = 1  att => intensity = 100  att', 'replace intensity = 1  att => color = (4, 4, 4)  att'],
            near: ['replace intensity = 1  att => intensity = 3.9  att', 'replace intensity = 0.1 => intensity = 5']},
        {right: ['replace (0, 0, 1) => (1, 0, 1)', 'replace (0, 0, 1) => (1, 0.2, 0.1)', 'replace (0, 0, 1) => (1.0, 0, 3)'], near: ['replace (0, 0, 1) => (1, 1, 0)', 'replace (0, 0, 1) => (0.5, 0, 1)']},
    ],
    '06_colored_lights': [
        {right: ['pin 0.1,0.8', 'pin 0.9,0.85', 'pin 0.5,0.95'], near: ['pin 0.34,0.57', 'pin 0.42,0.57']},
        {right: ['pin 0.34,0.57', 'pin 0.66,0.57', 'pin 0.35,0.58'], near: ['pin 0.1,0.8', 'pin 0.42,0.57']},
        {right: ['pin 0.42,0.57', 'pin 0.58,0.57', 'pin 0.43,0.57'], near: ['pin 0.34,0.57', 'pin 0.1,0.8']},
        {right: ['replace color = (0.6, 0, 0) => color = (0, 0, 0)', 'replace light "red" { position = (-3, 6, 3)  color = (0.6, 0, 0) } => ', 'replace color = (0.6, 0, 0) => color = (0.6, 0, 0)  intensity = 0'],
            near: ['replace color = (0, 0.6, 0) => color = (0, 0, 0)', 'replace color = (0.6, 0, 0) => color = (0.3, 0, 0)']},
    ],
    '07_shadows': [
        {right: ['pin 0.3,0.64', 'pin 0.32,0.66', 'pin 0.27,0.63'], near: ['pin 0.9,0.9', 'pin 0.5,0.4']},
        {right: ['replace epsilon = 0.001 => epsilon = 0.0', 'replace epsilon = 0.001 => epsilon = 0e5', 'replace epsilon = 0.001 => epsilon = 0'], near: ['replace epsilon = 0.001 => epsilon = 0.0000001', 'replace offset = ray  epsilon = 0.001 => offset = ray']},
        {right: ['replace epsilon = 0 } => epsilon = 1 }', 'replace epsilon = 0 } => epsilon = 2.5 }', 'replace epsilon = 0 } => epsilon = 10 }'], near: ['replace epsilon = 0 } => epsilon = 0.1 }', 'replace epsilon = 0 } => epsilon = 0.99 }']},
        {right: ['replace epsilon = 1.5 => epsilon = 0.01', 'replace epsilon = 1.5 => epsilon = 1e-6', 'replace epsilon = 1.5 => epsilon = 0.0001'], near: ['replace epsilon = 1.5 => epsilon = 0', 'replace epsilon = 1.5 => epsilon = 0.1']},
    ],
    '08_mirrors': [
        {right: ['replace mirror = 0 } => mirror = 0.5 }', 'replace mirror = 0 } => mirror = 0.9 }', 'replace mirror = 0 } => mirror = 1 }'], near: ['replace mirror = 0 } => mirror = 0.1 }', 'replace mirror = 0.6 } => mirror = 0.9 }']},
        {right: ['replace reflections = 6 => reflections = 0', 'replace reflections = 6 => reflections = 0  aa = 2', 'replace   reflections = 6 => \n  reflections = 0'], near: ['replace reflections = 6 => reflections = 1', 'replace mirror = 0.6 } => mirror = 0 }']},
        {right: ['replace reflections = 0 => reflections = 4; pin 0.41,0.49', 'replace reflections = 0 => reflections = 10; pin 0.59,0.49', 'replace reflections = 0 => reflections = 5; pin 0.45,0.5'],
            near: ['replace reflections = 0 => reflections = 2; pin 0.41,0.49', 'replace reflections = 0 => reflections = 6; pin 0.1,0.1']},
    ],
    '09_recursion': [
        {right: ['pin 0.5,0.5', 'pin 0.3,0.4', 'pin 0.7,0.6'], near: ['replace reflections = 2 => reflections = 1; pin 0.5,0.5', 'replace mirror = 0.5 => mirror = 0; pin 0.5,0.5']},
        {right: ['replace reflections = 2 => reflections = 4', 'replace reflections = 2 => reflections = 4  aa = 1', 'replace reflections = 2 => aa = 2  reflections = 4'], near: ['replace reflections = 2 => reflections = 3', 'replace reflections = 2 => reflections = 5']},
        {right: ['replace reflections = 4 => reflections = 8', 'replace reflections = 4 => reflections = 9', 'replace reflections = 4 => aa = 1  reflections = 8'], near: ['replace reflections = 4 => reflections = 7', 'replace reflections = 4 => reflections = 10']},
    ],
    '10_glass': [
        {right: ['replace transmission = 0 => transmission = 0.85', 'replace transmission = 0 => transmission = 1', 'replace transmission = 0 => transmission = 0.9'], near: ['replace transmission = 0 => transmission = 0.4', 'replace transmission = 0 => transmission = 0.9; replace reflections = 6 => reflections = 0']},
        {right: ['replace ior = 1 } => ior = 1.4 }', 'replace ior = 1 } => ior = 1.52 }', 'replace ior = 1 } => ior = 1.7 }'], near: ['replace ior = 1 } => ior = 1.1 }', 'replace ior = 1 } => ior = 2.4 }']},
        {right: ['pin 0.5,0.5', 'pin 0.45,0.55', 'pin 0.55,0.45'], near: ['pin 0.1,0.9', 'pin 0.9,0.2']},
    ],
    '11_conventions': [
        {right: ['prepend conventions { specular_gate = false }', 'append conventions { specular_gate = false }', 'prepend conventions { clamp_cosines = true  specular_gate = false }'], near: ['prepend conventions { specular_gate = true }', 'prepend conventions { clamp_cosines = false }']},
        {right: ['replace specular_gate = false => specular_gate = false  clamp_cosines = false', 'append conventions { clamp_cosines = false }', 'replace specular_gate = false => clamp_cosines = false'], near: ['replace specular_gate = false => specular_gate = true', 'append conventions { clamp_cosines = true }']},
        {right: ['replace specular_gate = false  clamp_cosines = false => ', 'replace conventions { specular_gate = false  clamp_cosines = false } => ', 'replace specular_gate = false  clamp_cosines = false => specular_gate = true  clamp_cosines = true'],
            near: ['replace specular_gate = false => specular_gate = true', 'replace clamp_cosines = false => clamp_cosines = true']},
    ],
    '12_finding_a_fault': [
        {right: ['pin 0.5,0.9', 'pin 0.2,0.9', 'pin 0.8,0.8'], near: ['pin 0.5,0.05', 'pin 0.02,0.02']},
        {right: ['replace position = (2, 3, 2) => position = (4, 5, 4)', 'replace sphere "bulb" { center = (2, 3, 2)  radius = 0.2  color = (1, 1, 0.8)  ambient = 1 } => ', 'replace color = (1, 1, 0.8)  ambient = 1 => color = (1, 1, 0.8)  ambient = 1  casts_shadow = false'],
            near: ['replace intensity = 0.1 => intensity = 0.9', 'replace radius = 0.2 => radius = 0.02']},
        {right: ['replace diffuse = 0.05 => diffuse = 1', 'replace diffuse = 0.05 => diffuse = 0.6', 'replace diffuse = 0.05 => diffuse = 0.7  specular = 0.3'], near: ['replace intensity = 0.1 => intensity = 0.5', 'replace diffuse = 0.05 => diffuse = 0.1']},
    ],
    '13_a_bug_by_its_log': [
        {right: ['pin 0.5021,0.1139', 'pin 0.501,0.112', 'pin 0.504,0.116'], near: ['pin 0.5646,0.4194', 'pin 0.1,0.1']},
        {right: ['pin 0.5646,0.4194', 'pin 0.5354,0.3806', 'pin 0.5021,0.3361'], near: ['pin 0.5021,0.1139', 'pin 0.1,0.1']},
        {right: ['replace shading = blinn-phong => shading = phong', 'replace shading = blinn-phong  => shading = phong  aa = 1  ', 'replace   shading = blinn-phong => \n  shading = phong'],
            near: ['replace shininess = 40 => shininess = 160', 'replace shading = blinn-phong => shading = diffuse', 'replace specular_color = (0.6, 0.6, 0.6) => specular_color = (0.3, 0.3, 0.3)']},
    ],
};
