// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures of textures, with the same words in every build: for the renderer, unlike decode() of
// glint/image.h.
#include <cstdint>
#include <span>

#include "glint/image.h"
#include "glint/result.h"
#include "glint/texture.h"

namespace glint {

/// Decodes a PNG, JPEG, TGA, PPM or PGM file (P2, P3, P5, P6) with at most k_max_texture_size texels a side.
/// Its first bytes decide the format, or, for TGA, which has no such mark, a possible header.
///
/// The words are those of the file, without gamma or color profile. Files with 16 bits a channel give 16
/// bits, others 8; fewer bits, and a PPM's maximum m other than 255 and 65535, are scaled to the nearest
/// word. Grey becomes r = g = b. JPEG and the usual JPEG of CMYK (Adobe's, inverted) become RGB.
///
/// has_alpha: PNG with an alpha channel or tRNS; TGA with 32 bits, and TGA with 16 bits whose header declares
/// attribute bits, unless all of the file's alpha is 0, which is how many programs leave bits that they do
/// not use.
///
/// What follows the end of a picture is ignored. A file that is cut off is an error. So is a PNG with a wrong
/// checksum, and an index beyond a TGA's palette; beyond a PNG's palette it is black, as with libpng. JPEG
/// has no checksum: damaged data may give other words, the same in every build. The words of JPEG differ a
/// little from those of libjpeg, most in the last columns where colors are stored at half the width only
/// (4:2:2).
///
/// An error if options.max_pixels or max_memory is exceeded. Never throws.
Result<TextureImage> decode_texture(std::span<const std::uint8_t> bytes, const DecodeOptions& options = {});

}  // namespace glint
