// Types of exr.mjs.

/** The array that `new Uint8Array(n)` makes. */
export type ExrFile = InstanceType<typeof Uint8Array>;

export interface ExrOptions {
    /** Pictures of the setting alpha = true: one number for each pixel, the layer "alpha" of renderLayers(). */
    alpha?: ArrayLike<number> | null;
}

/**
 * Encodes linear floats as OpenEXR: the numbers of the file that `glint render` writes, and its bytes if that has OpenEXR 3.1.
 * rgb: those of render() or renderLayers(), three for each pixel; width and height: from 1 to 65536. Throws a TypeError if these
 * do not fit together.
 */
export function encodeExr(rgb: ArrayLike<number>, width: number, height: number, options?: ExrOptions): ExrFile;
