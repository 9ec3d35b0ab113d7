// Two scenes in one text, written as the homework's program keeps them.
// glint render two_scenes.js --scene pipes
export const scenes = [
    {
        name: 'snowman',
        camera: { position: [2.4, -7., 2.6], target: [0, 0, 1.7], up: [0, 0, 1], fov: 45 },
        materials: [
            { name: 'snow', color: [.95, .97, 1.], ambient: .3, diffuse: .6, specular: .1, shininess: 10, mirror: 0 },
            { name: 'ice', color: [.55, .7, .85], ambient: .3, diffuse: .3, specular: .8, shininess: 100, mirror: .45 },
            { name: 'coal', color: [.06, .06, .07], ambient: .3, diffuse: .5, specular: .6, shininess: 30, mirror: 0 },
            { name: 'carrot', color: [1, .45, .1], ambient: .25, diffuse: .7, specular: .2, shininess: 10, mirror: 0 },
            { name: 'dusk', color: [.45, .45, .75], ambient: .6, diffuse: .4, specular: 0, shininess: 1, mirror: 0 },
        ],
        lights: [
            { position: [6, -9, 9], color: [1., .85, .7] },
        ],
        spheres: [
            { center: [0, 0, 0.8], radius: 1., material: 'snow' },
            { center: [0, 0, 2.15], radius: .75, material: 'snow' },
            { center: [0, 0, 3.2], radius: .5, material: 'snow' },
            /* eyes and buttons */
            { center: [.02, -.47, 3.33], radius: .07, material: 'coal' },
            { center: [.32, -.36, 3.33], radius: .07, material: 'coal' },
            { center: [.2, -.72, 2.35], radius: .08, material: 'coal' },
            { center: [.2, -.73, 2.05], radius: .08, material: 'coal' },
            /* the nose */
            { center: [.19, -.5, 3.16], radius: .11, material: 'carrot' },
            { center: [.25, -.62, 3.15], radius: .09, material: 'carrot' },
            { center: [.31, -.74, 3.14], radius: .07, material: 'carrot' },
            { center: [.36, -.85, 3.13], radius: .05, material: 'carrot' },
        ],
        planes: [
            { center: [0, 0, 0], normal: [0, 0, 1], material: 'ice' },
            { center: [0, 30, 0], normal: [0, -1, 0], material: 'dusk' },
        ],
        cylinders: [
            { center: [0, 0, 3.95], axis: [0, 0, 1], radius: .36, height: .7, material: 'coal' },
            { center: [0, 0, 3.62], axis: [0, 0, 1], radius: .6, height: .06, material: 'coal' },
        ],
    },
    {
        name: 'pipes', // open cylinders: one looks through them
        camera: { position: [0, -8, 3], target: [0, 0, 1.2], up: [0, 0, 1], fov: 42 },
        materials: [
            { name: 'copper', color: [.85, .45, .25], ambient: .2, diffuse: .6, specular: .9, shininess: 40, mirror: .15 },
            { name: 'steel', color: [.6, .65, .7], ambient: .2, diffuse: .5, specular: .8, shininess: 80, mirror: .35 },
            { name: 'ground', color: [.5, .55, .5], ambient: .25, diffuse: .8, specular: 0, shininess: 1, mirror: .05 },
            { name: 'wall', color: [.75, .72, .62], ambient: .25, diffuse: .6, specular: 0, shininess: 1, mirror: 0 },
            { name: 'lamp', color: [1, .9, .5], ambient: .9, diffuse: .3, specular: 0, shininess: 1, mirror: 0 },
        ],
        lights: [
            { position: [-4, -6, 7], color: [.9, .85, .8] },
            { position: [5, -7, 3], color: [.35, .4, .55] },
        ],
        spheres: [
            { center: [0, 0, 1], radius: .3, material: 'lamp' },
        ],
        planes: [
            { center: [0, 0, 0], normal: [0, 0, 1], material: 'ground' },
            { center: [0, 9, 0], normal: [0, -1, 0], material: 'wall' },
        ],
        cylinders: [
            { center: [0, 0, 1], axis: [0.25, 1, 0], radius: 1., height: 3., material: 'copper' },
            { center: [-2.3, .6, .6], axis: [1, 2, 0], radius: .6, height: 3., material: 'steel' },
            { center: [2.2, .4, .6], axis: [-1, 1.5, 0], radius: .6, height: 2.4, material: 'steel' },
            { center: [0, .3, 2.45], axis: [1, .15, 0], radius: .45, height: 3.2, material: 'steel' },
        ],
    },
];
