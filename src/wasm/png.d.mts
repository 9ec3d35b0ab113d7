// Types of png.mjs.

/** The array that `new Uint8Array(n)` makes. */
export type PngFile = InstanceType<typeof Uint8Array>;

/**
 * Encodes a picture as PNG: the bytes of the file that `glint render` writes.
 * pixels: those of renderPixels(), four bytes each, of which the fourth is ignored; width and height: from 1 to 65536.
 * Throws a TypeError if these do not fit together.
 */
export function encodePng(pixels: ArrayLike<number>, width: number, height: number): PngFile;
