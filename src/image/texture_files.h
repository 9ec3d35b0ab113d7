// SPDX-License-Identifier: Apache-2.0
#pragma once
// One function per file format for decode_texture(), for bytes that begin as that format does. They throw
// only bad_alloc: the browser build has no exceptions.
#include <cstddef>
#include <cstdint>
#include <string>

#include "glint/texture.h"
#include "image/decoders.h"

namespace glint {

Result<TextureImage> decode_png_texture(ByteSpan file, const DecoderOptions& options);
Result<TextureImage> decode_jpeg_texture(ByteSpan file, const DecoderOptions& options);
Result<TextureImage> decode_tga_texture(ByteSpan file, const DecoderOptions& options);

/// Whether the bytes begin with a possible header of a TGA file.
bool may_be_tga(ByteSpan file);

/// Texels from 1 to 4 channels a pixel: grey, grey and alpha, RGB, RGBA.
template <class Word>
TextureImage texels_of(std::uint32_t width, std::uint32_t height, std::size_t channels, const Word* from) {
    TextureImage image{width, height, channels % 2 == 0, {}};
    const std::size_t count = std::size_t{width} * height, each = image.channels();
    std::vector<Word> words(each * count);
    for (std::size_t i = 0; i < count; ++i) {
        const Word* const pixel = from + channels * i;
        Word* const to = words.data() + each * i;
        for (std::size_t c = 0; c < 3; ++c) to[c] = pixel[channels < 3 ? 0 : c];
        if (image.has_alpha) to[3] = pixel[channels - 1];
    }
    image.words = std::move(words);
    return image;
}

/// The bytes of such an image.
inline std::uint64_t texel_bytes(std::uint64_t pixels, bool has_alpha, bool is_wide) {
    return pixels * (has_alpha ? 4 : 3) * (is_wide ? 2 : 1);
}

/// What stb_image may take for a picture whose header has been read.
struct StbPicture {
    const char* format;  ///< "PNG"
    std::uint32_t width, height;
    bool is_wide;          ///< 16 bits a channel
    std::uint64_t memory;  ///< bytes that it needs for such a picture, at most
};

/// Decodes a PNG or JPEG by stb_image, which must be called with checked files only: of hostile ones, it
/// writes beyond its tables.
Result<TextureImage> decode_by_stb(ByteSpan file, const StbPicture& picture);

}  // namespace glint
