// SPDX-License-Identifier: Apache-2.0
// Selects the decoder of a texture's picture. A file by itself, because glint-core.wasm leaves it out
// (src/wasm/left_out.cpp): other files may use nothing else of it.
#include "image/texture_image.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/status.h"
#include "image/texture_files.h"

namespace glint {
namespace {

bool has_mark(ByteSpan file, std::string_view mark) {
    return file.size() >= mark.size() &&
           std::equal(mark.begin(), mark.end(), file.begin(),
                      [](char c, std::uint8_t b) { return static_cast<std::uint8_t>(c) == b; });
}

// n of `most`, as the nearest of the words up to `all`.
template <class Word>
std::vector<Word> scale_words(const std::vector<Word>& from, std::uint32_t most, std::uint32_t all) {
    std::vector<Word> to(from.size());
    std::transform(from.begin(), from.end(), to.begin(), [most, all](Word n) {
        return static_cast<Word>((std::uint64_t{n} * all + most / 2) / most);
    });
    return to;
}

Result<TextureImage> decode_ppm_texture(ByteSpan file, const DecoderOptions& options) {
    Result<DecodedPicture> decoded = decode_ppm(file, options);
    if (!decoded) return Status(std::move(decoded));
    StoredPicture& picture = decoded->picture;
    TextureImage image{
        static_cast<std::uint32_t>(picture.width), static_cast<std::uint32_t>(picture.height), false, {}};
    const std::uint32_t all = picture.most < 256 ? 255 : 65535;
    if (picture.most != all) {
        const std::uint64_t pixels = picture.pixels();
        Status fault = decoding_fault(2 * picture.bytes(), pixels, options);
        if (!fault.ok()) return fault;
    }
    const auto take = [&](auto& words) {
        if (picture.most != all) words = scale_words(words, picture.most, all);
        image.words = std::move(words);
    };
    if (auto* bytes = std::get_if<std::vector<std::uint8_t>>(&picture.rgb))
        take(*bytes);
    else
        take(std::get<std::vector<std::uint16_t>>(picture.rgb));
    return image;
}

Result<TextureImage> decode_any_texture(ByteSpan file, const DecoderOptions& options) {
#if defined(GLINT_WITH_TEXTURE_FILES)
    if (has_mark(file, "\x89PNG")) return decode_png_texture(file, options);
    if (has_mark(file, "\xff\xd8\xff")) return decode_jpeg_texture(file, options);
#else
    if (has_mark(file, "\x89PNG") || has_mark(file, "\xff\xd8\xff"))
        return undecodable("this build reads no textures in PNG and JPEG");
#endif
    for (const std::string_view mark : {"P2", "P3", "P5", "P6"}) {
        if (has_mark(file, mark)) return decode_ppm_texture(file, options);
    }
    if (may_be_tga(file)) return decode_tga_texture(file, options);
    return undecodable(file.empty() ? "an empty file" : "no PNG, JPEG, TGA, PPM or PGM file");
}

}  // namespace

Result<TextureImage> decode_texture(std::span<const std::uint8_t> bytes, const DecodeOptions& options) {
    return result_of([&] { return decode_any_texture(bytes, {options, false, k_max_texture_size}); });
}

}  // namespace glint
