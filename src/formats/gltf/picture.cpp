// SPDX-License-Identifier: Apache-2.0
#include "formats/gltf/picture.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace glint::gltf {
namespace {

// The decoder; it will be that of src/image.
Result<TextureImage> decode(std::string_view) {
    return Status{ErrorCode::invalid_argument, "glint does not draw pictures on surfaces yet", {}};
}

template <class Word> void remove_alpha(std::vector<Word>& words) {
    std::size_t to = 0;
    for (std::size_t i = 0; i + 4 <= words.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) words[to++] = words[i + c];
    }
    words.resize(to);
}

template <class Word> void cut_alpha(std::vector<Word>& words, double cutoff) {
    constexpr Word full = std::numeric_limits<Word>::max();
    for (std::size_t i = 3; i < words.size(); i += 4)
        words[i] = static_cast<double>(words[i]) / full >= cutoff ? full : Word{0};
}

}  // namespace

void apply_alpha(TextureImage& image, const TextureAlpha& alpha) {
    if (!image.has_alpha) return;
    std::visit(
        [&](auto& words) {
            if (!alpha.is_kept) {
                remove_alpha(words);
            } else if (alpha.cutoff) {
                cut_alpha(words, *alpha.cutoff);
            }
        },
        image.words);
    image.has_alpha = alpha.is_kept;
}

std::shared_ptr<const TextureImage> read_texture_image(File& file, JsonValue image, std::string_view bytes,
                                                       const TextureAlpha& alpha) {
    Result<TextureImage> decoded = decode(bytes);
    if (!decoded) {
        file.warn_once("gltf pictures " + decoded.message, image, decoded.message);
        return nullptr;
    }
    apply_alpha(*decoded, alpha);
    return std::make_shared<const TextureImage>(*std::move(decoded));
}

}  // namespace glint::gltf
