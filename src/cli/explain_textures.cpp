// SPDX-License-Identifier: Apache-2.0
#include "cli/explain_textures.h"

#include <fmt/format.h>

#include "cli/explain_numbers.h"
#include "cli/explain_text.h"

namespace glint::cli {
namespace {

// A coordinate, and whether the border of the picture is shown in place of what is there.
std::string coordinate_text(double x, TextureWrap wrap) {
    const bool is_clamped = wrap == TextureWrap::clamp && (x < 0 || x > 1);
    return number(x) + (is_clamped ? " (clamped)" : "");
}

std::string uv_text(const Texture& texture, const ExplainedTexture& t) {
    if (!texture.image)
        return fmt::format("u {} of {}", coordinate_text(t.u, texture.wrap_u), to_string(texture.mapping));
    return fmt::format("u {}, v {}", coordinate_text(t.u, texture.wrap_u),
                       coordinate_text(t.v, texture.wrap_v));
}

// The colors of the map beside u, counted from 1.
std::string colors_text(const Texture& texture, const ExplainedTexture& t) {
    const auto one = [&](int i) {
        const TextureColor& c = texture.color_map[static_cast<std::size_t>(i)];
        return fmt::format("{} of the color map (at {}: {})", i + 1, number(c.at), color(c.color));
    };
    if (t.column == t.next_column) return "color " + one(t.column);
    return fmt::format("between color {} and color {}, {} of the way", one(t.column), one(t.next_column),
                       number(t.next_column_weight));
}

// Where it is, and what it shows there.
std::string sample_text(const Scene& scene, const ExplainedTexture& t) {
    const Texture& texture = scene.textures[t.texture];
    std::string text = fmt::format("{} at {}: ", texture_item_text(scene, t.texture), uv_text(texture, t));
    if (t.column < 0) {
        text += "beside the picture";
    } else if (!texture.image) {
        text += colors_text(texture, t);
    } else if (texture.filter == TextureFilter::nearest) {
        text += fmt::format("texel in column {}, row {}", t.column, t.row);
    } else {
        if (texture.filter == TextureFilter::distance) text += "by distance, ";
        text += fmt::format("texels in columns {} ({}) and {} ({}), rows {} ({}) and {} ({})", t.column,
                            number(1 - t.next_column_weight), t.next_column, number(t.next_column_weight),
                            t.row, number(1 - t.next_row_weight), t.next_row, number(t.next_row_weight));
    }
    return text;
}

}  // namespace

std::vector<std::string> texture_lines(const Scene& scene, const ExplainedTexture& t) {
    const Texture& texture = scene.textures[t.texture];
    std::string text =
        t.layers.empty() ? sample_text(scene, t) : texture_item_text(scene, t.texture) + " over others";
    text += fmt::format(", color {}", color(t.color));
    if (t.alpha != 1) text += fmt::format(", alpha {}", number(t.alpha));
    text += texture.mix == TextureMix::multiply  ? ", which multiplies color, k_a and k_d"
            : texture.mix == TextureMix::replace ? ", which replaces the color"
                                                 : ", which multiplies color, k_a, k_d and k_e";
    if (!(t.ambient == t.color && t.diffuse == t.color))
        text += fmt::format("; in k_a it is {}, in k_d {}", color(t.ambient), color(t.diffuse));
    if (!t.layers.empty()) text += "; the sum of";
    std::vector<std::string> lines{text};
    for (const ExplainedTexture& layer : t.layers)
        lines.push_back(fmt::format("  {} of {}, color {}", number(layer.weight), sample_text(scene, layer),
                                    color(layer.color)));
    return lines;
}

std::vector<std::string> hole_lines(const Scene& scene, const ExplainedRay& ray) {
    std::vector<std::string> lines;
    for (const ExplainedHole& hole : ray.holes) {
        if (!hole.texture) {
            lines.push_back(fmt::format("passes the back of {} at t = {}: its material is one-sided",
                                        shape_text(scene, hole.shape), number(hole.t)));
            continue;
        }
        const ExplainedTexture& t = *hole.texture;
        lines.push_back(
            fmt::format("passes a hole of {} at t = {}: {} at {}, alpha {} is below the cutoff {}",
                        shape_text(scene, hole.shape), number(hole.t), texture_item_text(scene, t.texture),
                        uv_text(scene.textures[t.texture], t), number(t.alpha), number(hole.cutoff)));
    }
    const auto listed = static_cast<int>(ray.holes.size());
    if (ray.hole_count > listed)
        lines.push_back(
            fmt::format("passes {} more such places, which are not listed", ray.hole_count - listed));
    return lines;
}

}  // namespace glint::cli
