// Types of glint.mjs.

export type Vec3 = [number, number, number];

/** A place in one of the texts. Lines and columns count from 1, columns in bytes of UTF-8. */
export interface Place {
    file: string;
    line: number;
    column: number;
}

export interface Diagnostic extends Place {
    severity: 'error' | 'warning';
    /** The number of bytes to underline. */
    length: number;
    message: string;
    /** The part of the scene that the message is about, or null. */
    item: 'camera' | 'background' | 'setting' | 'light' | 'material' | 'transform' | 'shape' | 'fog' | null;
    /** Its index in the scene's list of lights, materials, transforms, shapes or settings; else 0. */
    index: number;
    /** Whether this error is about something that `skipUnsupported` leaves out. */
    can_skip: boolean;
    /** The whole message with the line and a caret, as the command prints it. */
    text: string;
}

export interface SceneText {
    /** The name for messages; its extension chooses the format unless `format` is given. */
    name: string;
    text: string;
    /** The bytes of a file that is no text, instead of `text`. */
    base64?: string;
    /** "cgfs", "epfl", "csc473", "povray", "nff", "tachyon", "ply", "stl", "obj", "gltf" or "glint". */
    format?: string;
}

export interface OpenRequest {
    /** Read as one scene, in this order. */
    texts: SceneText[];
    /** The texts that `include` may find, by name. */
    includes?: SceneText[];
    /** Conventions to start from instead of the format's own: "cgfs", "epfl", ... */
    profile?: string;
    /** The scene to use, if a file has several. */
    scene?: string;
    /** Settings that override those of the texts, as with `glint render --convention`: {size: '640x480', aa: '2'}. */
    settings?: Record<string, string>;
    /** The most bytes that reading may take; default: 384 MiB and 64 times the length of the texts, at most 768 MiB. */
    maxMemory?: number;
    /** Objects that glint does not render are left out, with warnings that name and count them; else they are errors. */
    skipUnsupported?: boolean;
}

export interface PrepareRequest {
    settings?: Record<string, string>;
    /** An orthographic camera instead of the scene's own; right and up: the picture's width and height in world units. */
    camera?: {position: Vec3} & View;
}

export interface Report {
    /** True if the scene can be rendered. */
    ready: boolean;
    /** Of the picture, as the scene was prepared last. */
    width?: number;
    height?: number;
    diagnostics: Diagnostic[];
    /** The names of texts that the scene includes and that the request does not have. */
    missing?: string[];
    /** Why the last open, prepare or render failed. */
    error?: string;
}

export interface Setting {
    name: string;
    /** "true | false", "a number from 0 to 1e12", ... */
    values: string;
    description: string;
    /** False: a render setting (size, shading, shadows, reflections, aa, alpha, seed). */
    is_convention: boolean;
    value: string;
    /** The value in the scene's profile. */
    profile_value: string;
    origin: 'profile' | 'file' | 'command' | 'code';
    place: Place | null;
}

/** A field of an item: what a page needs to show it and to change it in the text. */
export interface FieldInfo {
    /** In the item's JSON. */
    name: string;
    /** In .glint, the preferred one first. */
    keys: string[];
    label: string;
    description: string;
    type: 'number' | 'whole' | 'boolean' | 'point' | 'direction' | 'color' | 'attenuation' | 'choice' | 'texture' | 'uv map';
    /** Of a choice. */
    words?: string[];
    /** Of a number, or of each channel of a color. Null: infinite. */
    min?: number;
    max?: number | null;
    required: boolean;
    /** Null: there is none. */
    default: number | boolean | string | Vec3 | null;
}

export type LightKind = 'ambient' | 'point' | 'directional' | 'spot' | 'parallelogram' | 'disc' | 'sphere';

/** Beside these, each of SceneInfo.light_fields that the kind has. */
export interface LightInfo {
    kind: LightKind;
    name: string;
    place: Place | null;
    color: Vec3;
    specular_color?: Vec3;
    position?: Vec3;
    to_light?: Vec3;
    axis?: Vec3;
    inner_angle?: number;
    outer_angle?: number;
    tightness?: number;
    attenuation?: Vec3;
    fade_distance?: number;
    fade_power?: number;
    casts_shadows?: boolean;
    side_u?: Vec3;
    side_v?: Vec3;
    radius?: number;
    samples_u?: number;
    samples_v?: number;
    one_sided?: boolean;
    jitter?: boolean;
    adaptive?: number;
    circular?: boolean;
    oriented?: boolean;
}

/** Beside these, each of SceneInfo.gradient_fields or occlusion_fields. */
export interface SkyInfo {
    /** sphere or plane; of occlusion, hashed or fixed. */
    kind: string;
    place: Place | null;
}

/** Beside these, each of SceneInfo.fog_fields that the kind has. */
export interface FogInfo {
    kind: 'linear' | 'exp' | 'exp2';
    place: Place | null;
    color: Vec3;
    density?: number;
    start: number;
    end?: number;
    transmit: number;
    falloff?: number;
    height?: number;
    up?: Vec3;
}

/** Pixel (i, j) of width x height is at s (forward + u right + v up), u = (i + 0.5) / width - 0.5, v from the top. */
export interface View {
    right: Vec3;
    up: Vec3;
    forward: Vec3;
}

export interface CameraInfo {
    projection: 'perspective' | 'orthographic';
    position: Vec3;
    place: Place | null;
    /** True if the text gives the frame: `view` is that frame, and look_at to width are absent. */
    has_frame: boolean;
    look_at?: Vec3;
    up?: Vec3;
    fov?: number;
    fov_axis?: 'x' | 'y';
    width?: number;
    lighting_eye?: Vec3 | null;
    view: View;
}

export interface SceneInfo {
    profile: string;
    files: string[];
    width: number;
    height: number;
    /** The number of shapes by kind; kinds without shapes are absent. */
    shapes: Record<string, number>;
    material_count: number;
    /** The box around all bounded shapes. */
    bounds: {min: Vec3; max: Vec3} | null;
    background: Vec3;
    gradient: SkyInfo | null;
    fog: FogInfo | null;
    occlusion: SkyInfo | null;
    camera: CameraInfo;
    lights: LightInfo[];
    light_fields: FieldInfo[];
    camera_fields: FieldInfo[];
    material_fields: FieldInfo[];
    texture_fields: FieldInfo[];
    gradient_fields: FieldInfo[];
    fog_fields: FieldInfo[];
    occlusion_fields: FieldInfo[];
    /** The keys of each block of .glint: {sphere: ['center', 'radius', ...], ...}. */
    blocks: Record<string, string[]>;
    settings: Setting[];
}

export interface NamedItem extends Partial<Place> {
    index?: number;
    name?: string;
}

export interface ShadowRay {
    origin: Vec3;
    direction: Vec3;
    t_min: number;
    t_max: number | null;
}

export interface Blocker {
    shape: NamedItem & {kind: string};
    distance: number;
    point: Vec3;
}

/** A transparent surface that light passes. */
export interface ShadowFilter {
    shape: NamedItem & {kind: string};
    distance: number;
    point: Vec3;
    factor: Vec3;
    /** Where the way to the light leaves an object that fades it: what is left. */
    fade?: Vec3;
}

export interface LightTerms extends LightTermValues {
    light: NamedItem & {kind: LightKind; has_position: boolean; color: Vec3; specular_color: Vec3};
    /** Why it adds something, or nothing. */
    reason: 'adds' | 'blocked' | 'behind' | 'no_color' | 'faded' | 'in_surface' | 'outside_cone' | 'faint' | 'back_of_light';
    highlight: 'adds' | 'none' | 'unshaded' | 'behind' | 'turned_away';
    /** Of an area light each of whose samples is a light: the factor of the light's color. */
    weight?: number;
    /** The transparent surfaces on the way of the light, from the point on. */
    filters?: ShadowFilter[];
    shadow_ray?: ShadowRay;
    blocker?: Blocker;
    /** Of an area light that shines from its centre: the samples to which shadow rays were traced. */
    samples?: (ShadowSampleTerms & {shadow_ray: ShadowRay; blocker?: Blocker; filters?: ShadowFilter[]})[];
}

export interface ExplainedSecondaryRay {
    state: 'none' | 'traced' | 'limit' | 'faint' | 'cut';
    weight?: Vec3;
    /** Its index in Explanation.rays. */
    ray?: number;
}

export interface ExplainedTexture extends TextureTerms {
    index: number;
    name?: string;
    mix: 'multiply' | 'multiply_all' | 'replace';
    /** Of a texture over others: itself and these, from the front. */
    layers?: ExplainedTexture[];
}

export interface ExplainedHole extends HoleTerms {
    shape: NamedItem & {kind: string};
    /** Not at the back of a one-sided surface. */
    texture?: ExplainedTexture;
}

export interface ExplainedHit extends HitTerms {
    /** color: the shape's own, in place of the material's. */
    shape: NamedItem & {kind: string; color?: Vec3};
    material: NamedItem & MaterialValues;
    side: 'front' | 'back';
    lights: LightTerms[];
    /** Ambient, diffuse, specular and emission times weight and share: the contribution to the pixel. */
    parts: {ambient: Vec3; diffuse: Vec3; specular: Vec3; emission: Vec3};
    reflected: ExplainedSecondaryRay;
    transmitted: ExplainedSecondaryRay;
    /** If the material has a texture that shows something at the point. */
    texture?: ExplainedTexture;
    /** Of a solid: the crossings of the ray's line with all of its shapes, by t. */
    crossings?: CrossingTerms[];
    /** If the scene has occlusion: the light from all directions. */
    occlusion?: OcclusionTerms & {color: Vec3; direct: number; occluders: {shape: NamedItem; samples: number; weight: number}[]};
}

export interface ExplainedRay extends RayTerms {
    kind: 'camera' | 'mirror' | 'transmitted';
    /** Column and row of the sample. */
    sample: [number, number];
    parent: number | null;
    layer: string | null;
    /** If the scene has fog: the part of the light that is seen through it, and the light that it adds. */
    fog?: {visibility: number; added: Vec3};
    /** If it passes holes of textures or backs of one-sided surfaces: the first ones on its way. */
    holes?: ExplainedHole[];
    hit?: ExplainedHit;
}

// Generated by tools/write_terms.cpp.
export interface MaterialValues {
    /** the surface's color */
    color: Vec3;
    /** k_a itself */
    ambient: Vec3;
    /** k_d itself */
    diffuse: Vec3;
    /** k_s itself: white gives white highlights on colored plastic */
    specular: Vec3;
    /** the exponent n of the highlight */
    shininess: number;
    /** a, the part of the light that is reflected */
    mirror: number;
    /** the tint of what the mirror shows */
    mirror_tint: Vec3;
    /** the part of the light that is transmitted */
    transmission: number;
    /** the tint of what is transmitted */
    transmission_tint: Vec3;
    /** the index of refraction */
    ior: number;
    /** false: the surface blocks no light */
    casts_shadow: boolean;
    /** k_e itself: light that the surface emits; it lights no other surface */
    emission: Vec3;
    /** the diffuse term is k_d (N.L)^brilliance */
    brilliance: number;
    /** how far highlights have the surface's color, except at grazing light */
    metallic: number;
    /** k_p: a second highlight, k_p (R.V)^phong_shininess, whatever the shading */
    phong: Vec3;
    /** the exponent of the second highlight */
    phong_shininess: number;
    /** false: highlights do not have the light's color */
    tinted_highlight: boolean;
    /** if > 0, the mirror is mirror_min + (mirror - mirror_min) (1 - cos)^mirror_falloff */
    mirror_falloff: number;
    /** the mirror for rays along the normal, if mirror_falloff > 0; with mirror_fresnel, the least mirror */
    mirror_min: number;
    /** true: the mirror is mirror_min + (mirror - mirror_min) F, with F of Fresnel's equations by the ior */
    mirror_fresnel: boolean;
    /** true: what filter and transmit let through is reduced by what the mirror reflects */
    conserve_energy: boolean;
    /** how far the mirror tints what it shows with the surface's color, except at grazing rays */
    mirror_metallic: number;
    /** transparency without refraction: the part of the light from behind that the color tints */
    filter: number;
    /** the part that is not tinted */
    transmit: number;
    /** how dark diffuse light is where the surface turns away from the ray */
    outline: number;
    /** from 0, a thin outline, to 1, the whole surface */
    outline_width: number;
    /** transmit grows where the surface turns to the ray, as in Raster3D */
    angled_opacity: boolean;
    /** fog_extent = outside_objects: rays inside are in the fog */
    hollow: boolean;
    /** above 0: the shapes of materials with the same number are one object for fog_extent */
    interior: number;
    /** a picture that changes the color */
    texture: number | null;
    /** true: rays that come from behind pass the surface; without effect if transmission > 0 */
    one_sided: boolean;
    /** true: ior refracts the rays that filter and transmit let through */
    refracts: boolean;
    /** above 0: what filter and transmit let out fades with its distance in the shape */
    fade_distance: number;
    /** the power of the distance over fade_distance; from 1000 on the light falls exponentially */
    fade_power: number;
    /** what is left of white light after a long way */
    fade_color: Vec3;
    /** above 0: the shadow's light that filter and transmit let through is times 1 + cos^caustics, of its angle to the normal */
    caustics: number;
}

export interface RayTerms {
    /** 0 for camera rays */
    generation: number;
    /** in the world */
    origin: Vec3;
    /** not normalised: t is measured in units of its length */
    direction: Vec3;
    /** the ray begins here */
    t_min: number;
    /** of the hit; null: no hit */
    t: number | null;
    /** the factor by which its light counts in the pixel */
    weight: Vec3;
    /** true: it goes straight through a transparent surface, along the line of its parent, from t_min on */
    straight?: boolean;
    /** true: it starts at the limit of reflections, and sees the background */
    beyond_limit?: boolean;
    /** true: there is no fog, because the ray is inside an object (fog_extent = outside_objects) */
    inside_object?: boolean;
    /** how many holes of textures (`alpha = mask`) and backs of one-sided surfaces it passes; `holes` has the first 16 */
    hole_count?: number;
    /** what a ray without a hit adds */
    background?: Vec3;
    /** the ray shows the background directly or through glass: the mean of its weight, times 1 - `background_alpha`, is subtracted from alpha */
    transparent?: boolean;
}

export interface HitTerms {
    /** P */
    point: Vec3;
    /** N as used for the lighting, a unit vector */
    normal: Vec3;
    /** V */
    to_eye: Vec3;
    /** whether N was flipped towards the ray */
    normal_turned: boolean;
    /** of a mesh: the number of the triangle, from 0 */
    triangle?: number;
    /** of a mesh: the weights of the triangle's corners, by which normals and colors are interpolated */
    corner_weights?: Vec3;
    /** of a mesh: P in the mesh's coordinates */
    mesh_point?: Vec3;
    /** the ray's weight, reduced by what glass and fog absorbed */
    weight: Vec3;
    /** the part of the light that the mirror reflects towards the ray */
    mirror: number;
    /** the share of the surface's own light; mirror and glass have the rest */
    local_share: number;
    /** k_a I_a; for shadings without lights, the color shown */
    ambient: Vec3;
    /** the sum over the lights */
    diffuse: Vec3;
    /** the sum over the lights */
    specular: Vec3;
    /** k_e */
    emission: Vec3;
    /** the share that glass reflects; 1: total internal reflection */
    fresnel: number;
    /** of a transparent surface (filter, transmit) */
    opacity?: number;
    /** of a transparent surface: the factor of what is behind it, transmit + filter * color; with angled_opacity, the transmit at this angle; with conserve_energy, times 1 - mirror * mirror_tint */
    through?: Vec3;
    /** of a surface where light leaves an object that fades it (`fade_distance`): what is left of it */
    fade?: Vec3;
    /** of a transparent surface: the share of its highlights, as local_share of the rest */
    highlight_share?: number;
    /** of a surface with an outline: the factor of its diffuse light and of the light from all directions */
    outline?: number;
}

export interface LightTermValues {
    /** not a unit vector */
    to_light: Vec3;
    /** the length of to_light */
    distance: number;
    /** f_att */
    attenuation: number;
    /** of a spot: the factor of its light in this direction; else 1 */
    spot: number;
    /** of a one-sided area light: the cosine off its normal, 0 behind it; else 1 */
    emitter: number;
    /** of an area light that shines from its centre: the visible part, with colored shadows the mean over the channels of filter; else 1 */
    visible: number;
    /** of an area light each of whose samples is a light: row * samples_u + column */
    sample?: number;
    /** N·L */
    n_l: number | null;
    /** R·V (Phong), N·H (Blinn-Phong) */
    s: number | null;
    /** S^n where there is a highlight, blocked or not */
    power: number;
    /** of k_d I: N·L, to the power of the brilliance */
    diffuse_factor: number | null;
    /** R·V of a second highlight */
    phong_s?: number;
    /** of a second highlight, as power */
    phong_power?: number;
    /** of a metal's highlights; included in specular */
    highlight_tint?: Vec3;
    /** what it adds, before the hit's weight */
    diffuse: Vec3;
    /** likewise */
    specular: Vec3;
    /** the factor of the light that passes the transparent surfaces on its way; of an area light that shines from its centre, the mean of its samples; included in diffuse and specular */
    filter?: Vec3;
}

export interface ShadowSampleTerms {
    /** row * samples_u + column */
    sample: number;
    /** its factor in visible, which is the sum over the visible samples (with colored shadows, of weight times filter) */
    weight: number;
    /** on the light */
    position: Vec3;
    /** whether a shape blocks it */
    blocked: boolean;
    /** as of the light */
    filter?: Vec3;
}

export interface TextureTerms {
    /** u in the picture, to the right; with a `color_map`, the place in it */
    u: number;
    /** v in the picture, up */
    v: number;
    /** of the first texel, from the left, from 0; -1 beside the picture, with the wrap clip; with a `color_map`, the number of its color, from 0 */
    column: number;
    /** of the texel, or color of the map, that is mixed with it */
    next_column: number;
    /** of the first texel, from the top, from 0; -1 as above */
    row: number;
    /** of the texel that is mixed with it */
    next_row: number;
    /** the weight of the next column; the first one has the rest */
    next_column_weight: number;
    /** the weight of the next row */
    next_row_weight: number;
    /** the color of the texels or of the map, decoded and mixed */
    color: Vec3;
    /** their alpha, mixed; 1 without one */
    alpha: number;
    /** the color in k_a, if it is another one */
    ambient?: Vec3;
    /** the color in k_d, if it or that in k_a is another one */
    diffuse?: Vec3;
    /** of one of the layers: its opacity, times what is left of those in front of it; alpha is their sum, and alpha times color is that of weight times color */
    weight?: number;
}

export interface HoleTerms {
    /** of the ray */
    t: number;
    /** the ray meets the back of a one-sided surface (`one_sided`), which it passes; there is no texture then */
    back?: boolean;
    /** `alpha_cutoff` of the texture: its alpha is below it */
    cutoff?: number;
}

export interface CrossingTerms {
    /** the number of the solid's shape, from 0 */
    operand: number;
    /** of the ray */
    t: number;
    /** the shape begins there; otherwise it ends */
    enters: boolean;
    /** the solid has a surface there */
    surface: boolean;
    /** it is the surface that the ray hits */
    hit: boolean;
}

export interface OcclusionTerms {
    /** their number */
    samples: number;
    /** how many of the samples are blocked */
    blocked: number;
    /** f, the part of the light that arrives; if transparent surfaces color it, the mean over the channels */
    factor: number;
    /** f by channel */
    factors: Vec3;
    /** k_d color f */
    light: Vec3;
    /** multiplied by weight and local_share: what is added to the pixel */
    part: Vec3;
}
// End of what is generated.

export type LightLayer = 'background' | 'ambient' | 'diffuse' | 'specular' | 'reflection' | 'transmission' | 'emission' | 'sky' | 'fog';

/** The explanation of a pixel. The layers, added up as floats in their order, are the value. */
export interface Explanation {
    pixel: [number, number];
    /** n for n x n samples. */
    samples: number;
    /** With adaptive sampling: the neighbour from which the pixel differs most with one sample each. */
    adaptive?: {refined: boolean; neighbor: [number, number]; difference: number; one_sample: Vec3; neighbor_one_sample: Vec3};
    value: Vec3;
    /** As in the layer of this name. */
    alpha: number;
    /** How the numbers become these bytes: the scene's conventions of the same names. */
    transfer: 'none' | 'srgb';
    gamma: number;
    rounding: 'half_even' | 'half_up' | 'down';
    bytes: Vec3;
    layers: Record<LightLayer, Vec3>;
    rays: ExplainedRay[];
}

/** How a picture differs from a reference. Differences are in 255ths, of bytes as in a PNG. */
export interface Comparison {
    /** Numbers of pixels; an equal pixel is also within 1 (`within`: 2). */
    pixels: number;
    equal: number;
    within_1: number;
    within: number;
    mean: number;
    rms: number;
    /** Null for equal pictures. */
    psnr: number | null;
    /** Null for pictures of less than 11 pixels. */
    ssim: number | null;
    largest: {value: number; x: number; y: number};
    /** The following are there if causes were asked for (docs/compare.md). */
    /** No channel of a byte differs by more than 1. */
    agrees?: boolean;
    remark?: string;
    /** The best first. */
    causes?: Cause[];
    /** Further causes, which explain the difference together with the first. */
    then?: Cause[];
    /** The shapes that show the difference, if no cause is sure. */
    where?: string;
}

export interface Cause {
    name: string;
    explanation: string;
    /** The fraction of the difference that it explains. */
    explained: number;
    perhaps: boolean;
}

/** A likely mistake of a scene (docs/checks.md). */
export interface Finding extends Diagnostic {
    id: string;
    remedy: string;
    /** The picture is as it should be all the same: of exported models. The severity is 'warning'. */
    note: boolean;
}

/** A value of a log: one number, three of a vector or a color, or nothing. A number that is not finite is null. */
export type DiagnosedValue = number | null | [number | null, number | null, number | null];

/** A value of a log beside what it should be, as far as that follows from the scene and from the log's earlier values. */
export interface DiagnosedRow {
    /** Column and row as the log counts them. */
    pixel: [number, number];
    /** The ray whose value it is, in the order of the pixel; absent: it is the pixel's. */
    ray?: {number: number; kind: 'camera' | 'mirror' | 'glass'; generation: number};
    /** Index in SceneInfo.lights; absent: it is the ray's. */
    light?: {index: number; name?: string};
    /** Its key in the log. */
    quantity: string;
    /** Of the log, from 1; 0: none. */
    line: number;
    verdict: 'right' | 'wrong' | 'unknown';
    yours: DiagnosedValue;
    expected: DiagnosedValue;
}

/** A quantity that differs, at some places for one reason. */
export interface DiagnosisFinding {
    quantity: string;
    /** Its name in sentences. */
    word: string;
    of: 'light' | 'ray' | 'pixel';
    /** The only cause is certain. */
    sure: boolean;
    /** The known mistakes that give the log's numbers. */
    causes: {id: string; explanation: string}[];
    /** Where alone it happens; empty: everywhere. */
    only: string;
    /** "yours is -1 times what it should be"; empty: none is known. */
    relation: string;
    formula: string;
    /** Where the documents explain it; may be empty. */
    where: string;
    pixels: number;
    /** Pixels in which it is the first difference. */
    first_pixels: number;
    places: number;
    judged_places: number;
    example: DiagnosedRow;
}

/** The log of another ray tracer beside a scene (docs/diagnose.md). */
export interface Diagnosis {
    /** What the log's numbers mean, a sentence each. */
    conventions: string[];
    pixels: number;
    rays: number;
    values: number;
    judged: number;
    unknown: number;
    /** Pixels of the log that are not in the picture. */
    outside: number;
    wrong_pixels: number;
    /** The log's row 0 is the picture's lowest. */
    rows_from_bottom: boolean;
    /** That which is the first difference in most pixels first. */
    findings: DiagnosisFinding[];
    /** The values of the first pixels. */
    rows: DiagnosedRow[];
    /** Warnings about the log's lines. */
    diagnostics: Diagnostic[];
}

/** The host's WebAssembly.Module, where its types are known. */
export type CompiledModule = typeof globalThis extends {WebAssembly: {Module: {prototype: infer Module}}} ? Module : object;
/** The array that `new Uint8ClampedArray(n)` makes. */
export type Bytes = InstanceType<typeof Uint8ClampedArray>;
/** The array that `new Float32Array(n)` makes. */
export type Floats = InstanceType<typeof Float32Array>;

/** A URL: a string, or the host's URL. */
export type Address = string | {readonly href: string};

/**
 * Creates an instance of glint, in node or in a browser. from: the URL of glint.wasm; without it, the file next to glint.mjs.
 * Rejects if it cannot be read.
 */
export function load(from?: Address): Promise<Glint>;

/** The first half of load(): the module, to be posted to workers, each of which calls instantiate(). */
export function compile(from?: Address): Promise<CompiledModule>;

/** Creates an instance of glint from a compiled WebAssembly.Module of glint.wasm. */
export function instantiate(module: CompiledModule): Promise<Glint>;

/**
 * Thrown where an instance ends in a trap, most likely because its memory ran out, and by all later calls of it and its
 * scenes. Create a new instance then. `cause` is the trap.
 */
export class InstanceError extends Error {
    readonly cause: unknown;
}

export interface Glint {
    readonly version: string;
    /** Bytes of memory that the instance has allocated from its host, at most 2 GiB. It never frees them. */
    readonly memoryBytes: number;
    /**
     * Whether a call has needed what the instance's file leaves out, so that its result is not that of glint.wasm: never of
     * glint.wasm. The playground starts with a smaller file, without the languages of POV-Ray and Tachyon, causes,
     * check() and diagnose().
     */
    readonly leftOut: boolean;
    /**
     * Reads and prepares a scene. Close it when it is no longer needed. Throws if a string has a lone surrogate. `progress` is
     * called now and then with the part that is done, from 0 to 1, and must not throw.
     */
    open(request: OpenRequest | string, options?: {progress?: ((done: number) => void) | null}): Scene;
}

/** All but close() throw after close(). Numbers of pixels must be whole. */
export interface Scene {
    readonly report: Report;
    /** Null if the scene is not ready. */
    readonly info: SceneInfo | null;
    /** Prepares the scene with changes. Throws if that is impossible; the scene then stays as it was. */
    prepare(request: PrepareRequest): void;
    /**
     * The linear RGB floats of a rectangle, row by row from the top. Throws if the scene is not ready, if the picture does not
     * contain the rectangle, or if that has more than 2^26 pixels.
     */
    render(x: number, y: number, width: number, height: number): Floats;
    /** The same as bytes (red, green, blue, 255), and the number of rays. */
    renderPixels(x: number, y: number, width: number, height: number): {pixels: Bytes; rays: number};
    /**
     * The same, and layers of the rectangle (`glint render --help` lists them): "depth" has one float for each pixel, "albedo" and
     * "normal" have three, and so has "light:2", the picture with the second light alone. Throws also for unknown and repeated names.
     */
    renderLayers<Name extends string>(names: Name[], x: number, y: number, width: number, height: number):
        {pixels: Bytes; rays: number; layers: Record<Name, Floats>};
    /** Null if the scene is not ready. Throws for a pixel outside the picture. */
    explain(x: number, y: number): Explanation | null;
    /**
     * Compares the scene's picture with that of a reference of the same instance and size. Causes take as long as some hundred
     * pictures. Throws if one is not ready, or the sizes differ.
     */
    compare(reference: Scene, options?: {causes?: boolean}): Comparison;
    /**
     * Compares a picture of this scene that another program has drawn with glint's: `pixels` has the bytes red, green, blue and alpha
     * (which is not compared) of each pixel, row by row from the top, as ImageData has. Causes take as long as some hundred pictures.
     * Throws if the scene is not ready, or has another size.
     */
    comparePicture(picture: {pixels: Bytes | Uint8Array; width: number; height: number}, options?: {causes?: boolean}): Comparison;
    /** The scene's likely mistakes, which `glint check` prints. */
    check(): Finding[];
    /**
     * Compares the log that another ray tracer has written of this scene, value by value (docs/formats/trace_log.md): a text, or its
     * bytes. `name` is that of the log in messages. Throws if the scene is not ready, if a line of the log is wrong, or if no pixel of
     * the log is in the picture.
     */
    diagnose(log: string | Uint8Array, options?: {name?: string}): Diagnosis;
    /** The scene as .glint; empty if it is not ready. */
    toGlint(): string;
    close(): void;
}
