// SPDX-License-Identifier: Apache-2.0
#include "scene/validate_texture.h"

#include <fmt/format.h>

namespace glint {

std::string mistake_in(const Texture& texture) {
    if (!texture.image) return "expected an image, found none";
    const TextureImage& image = *texture.image;
    const auto is_size = [](std::uint32_t n) { return n >= 1 && n <= k_max_texture_size; };
    if (!is_size(image.width) || !is_size(image.height))
        return fmt::format("expected an image of 1 to {} texels a side, found {} x {}", k_max_texture_size,
                           image.width, image.height);
    const std::size_t expected = std::size_t{image.width} * image.height * image.channels(),
                      found = std::visit([](const auto&words) { return words.size(); }, image.words);
    if (found != expected) return fmt::format("expected {} words in the image, found {}", expected, found);
    return {};
}

}  // namespace glint
