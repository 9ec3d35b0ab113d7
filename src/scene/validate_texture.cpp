// SPDX-License-Identifier: Apache-2.0
#include "scene/validate_texture.h"

#include <fmt/format.h>

#include <string_view>

#include "scene/ranges.h"

namespace glint {

std::string mistake_in(const std::vector<TextureColor>& colors) {
    if (colors.size() > k_max_texture_colors)
        return fmt::format("color_map: expected at most {} colors, found {}", k_max_texture_colors,
                           colors.size());
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const TextureColor& c = colors[i];
        const auto wrong = [&](std::string_view what, const Range& range, double found) {
            return fmt::format("color_map: {} {}: expected {}, found {}", what, i + 1, range.text, found);
        };
        if (!k_fraction.contains(c.at)) return wrong("the place of color", k_fraction, c.at);
        if (!k_fraction.contains(c.alpha)) return wrong("the alpha of color", k_fraction, c.alpha);
        for (const double channel : {c.color.r, c.color.g, c.color.b})
            if (!k_channel.contains(channel)) return wrong("color", k_channel, channel);
        if (i > 0 && c.at < colors[i - 1].at)
            return fmt::format("color_map: expected places in ascending order, found {} after {}", c.at,
                               colors[i - 1].at);
    }
    return {};
}

std::string mistake_in(const Texture& texture) {
    if (texture.mapping == TextureMapping::uv && !(texture.turbulence == Vec3{}))
        return "turbulence: expected a mapping other than uv, found uv";
    if (texture.from_uv && texture.mapping == TextureMapping::uv)
        return "from_uv: expected a mapping other than uv, found uv";
    if (texture.from_uv && texture.image) return "from_uv: expected a color_map, found an image";
    if (!texture.color_map.empty())
        return texture.image ? "expected an image or a color_map, found both" : mistake_in(texture.color_map);
    if (!texture.image) return "expected an image or a color_map, found neither";
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
