// Types of png.mjs.

/** The array that `new Uint8Array(n)` makes. */
export type PngFile = InstanceType<typeof Uint8Array>;

export interface PngOptions {
    /** Pictures of the setting alpha = true: the file has an alpha channel, the fourth byte of each pixel. */
    alpha?: boolean;
    /** Pictures of the convention transfer = srgb: the file says that its bytes have this curve. */
    srgb?: boolean;
}

/**
 * Encodes a picture as PNG: the bytes of the file that `glint render` writes, if the options are those of the scene.
 * pixels: those of renderPixels(), four bytes each, of which the fourth is ignored without alpha; width and height: from 1
 * to 65536. Throws a TypeError if these do not fit together.
 */
export function encodePng(pixels: ArrayLike<number>, width: number, height: number, options?: PngOptions): PngFile;
