// SPDX-License-Identifier: Apache-2.0
// Shapes that are in the picture and have the color of the background behind them.
#include <fmt/format.h>

#include <algorithm>

#include "check/checks.h"

namespace glint {
namespace {

constexpr std::int32_t k_background_picture = 320;  // longest side, pixels
constexpr double k_same_color = 1.5 / 255;
constexpr double k_similar_color = 0.15;             // for shapes whose material has the background's color
constexpr double k_min_same = 0.98;                  // of a shape's pixels
constexpr double k_max_outline = 0.1;                // of its outline: pixels of other shapes beside it
constexpr std::size_t k_min_background_pixels = 12;  // smaller shapes are not examined

struct Look {
    std::size_t all = 0, lit = 0;               // pixels; lit: not black
    std::size_t same = 0, similar = 0;          // of them: like the background
    std::size_t outline = 0, before_other = 0;  // neighbours of these pixels
};

// A channel as a picture shows it: white at most.
double shown(float channel) { return number::min(static_cast<double>(channel), 1.0); }

// The scene without its shapes.
Image background_of(CheckContext& context) {
    Scene empty;
    const Scene& scene = context.scene();
    empty.camera = scene.camera;
    empty.background = scene.background;
    empty.gradient = scene.gradient;
    empty.conventions = scene.conventions;
    empty.settings = scene.settings;
    return context.render_small(prepare(empty, {.threads = context.threads()}), k_background_picture);
}

// Surfaces that show what is behind or before them, and those that would be visible if a light reached them.
// lit: a light reaches most of the shape.
bool may_look_so(const CheckContext& context, std::uint32_t shape, bool lit) {
    const Material m = context.material_of(shape);
    if (m.is_transparent() || m.transmission > 0 || m.mirror > 0) return true;
    if (m.texture < context.scene().textures.size() && context.scene().textures[m.texture].has_alpha())
        return true;
    if (lit || context.scene().settings.shading == Shading::color) return false;
    const bool glows =
        brightest(m.ambient * context.world().ambient) > k_same_color || brightest(m.emission) > k_same_color;
    return !glows && (brightest(m.diffuse) > k_same_color || brightest(m.specular) > k_same_color ||
                      brightest(m.phong) > k_same_color);
}

// Only the shading tells such a shape from the background.
bool has_color_of_background(const CheckContext& context, std::uint32_t shape) {
    const Scene& scene = context.scene();
    if (scene.gradient || brightest(scene.background) <= k_same_color) return false;
    const Color color = context.material_of(shape).color, behind = scene.background;
    return number::abs(color.r - behind.r) < k_same_color && number::abs(color.g - behind.g) < k_same_color &&
           number::abs(color.b - behind.b) < k_same_color;
}

}  // namespace

void check_background_shapes(CheckContext& context) {
    const Scene& scene = context.scene();
    const WorldParts& world = context.world();
    // Fog gives distant shapes the color of the background.
    if (scene.fog || scene.settings.shading == Shading::normals) return;
    const Image picture = context.render_small(k_background_picture);
    const Image background = background_of(context);
    if (picture.rgb.empty() || picture.rgb.size() != background.rgb.size()) return;
    const SmallSize size{picture.width, picture.height};
    const RayList rays = camera_rays(world, size);
    const HitList hits = nearest_surfaces(world, rays, context.threads());
    const auto shape_at = [&](std::int32_t x, std::int32_t y) {
        const SurfaceId id = hits.surface[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                          static_cast<std::size_t>(x)];
        return id.exists() ? world.geometry->shape_of(id) : k_none;
    };
    std::vector<Look> looks(scene.shapes.size());
    for (std::int32_t y = 0; y < size.height; ++y) {
        for (std::int32_t x = 0; x < size.width; ++x) {
            const std::uint32_t shape = shape_at(x, y);
            if (shape == k_none) continue;
            Look& look = looks[shape];
            ++look.all;
            const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                       static_cast<std::size_t>(x));
            double difference = 0;
            bool lit = false;
            for (std::size_t c = i; c < i + 3; ++c) {
                const double color = shown(picture.rgb[c]);
                difference = number::max(difference, number::abs(color - shown(background.rgb[c])));
                lit = lit || color > k_same_color;
            }
            look.same += difference < k_same_color ? 1 : 0;
            look.similar += difference < k_similar_color ? 1 : 0;
            look.lit += lit ? 1 : 0;
            const auto beside = [&](std::int32_t u, std::int32_t v) {
                if (u < 0 || v < 0 || u >= size.width || v >= size.height) return;
                const std::uint32_t other = shape_at(u, v);
                if (other == shape) return;
                ++look.outline;
                look.before_other += other != k_none ? 1 : 0;
            };
            beside(x - 1, y), beside(x + 1, y), beside(x, y - 1), beside(x, y + 1);
        }
    }
    std::vector<std::uint32_t> same, similar;
    std::size_t pixels_of_same = 0, pixels_of_similar = 0;
    for (std::uint32_t i = 0; i < looks.size(); ++i) {
        const Look& look = looks[i];
        if (look.all < k_min_background_pixels || look.outline == 0) continue;
        const auto part = [](std::size_t a, std::size_t b) {
            return static_cast<double>(a) / static_cast<double>(b);
        };
        const bool is_same = part(look.same, look.all) >= k_min_same;
        if (!is_same && (part(look.similar, look.all) < k_min_same || !has_color_of_background(context, i)))
            continue;
        if (part(look.before_other, look.outline) > k_max_outline) continue;
        if (may_look_so(context, i, part(look.lit, look.all) > k_min_same)) continue;
        (is_same ? same : similar).push_back(i);
        (is_same ? pixels_of_same : pixels_of_similar) += look.all;
    }
    const auto report = [&](const std::vector<std::uint32_t>& shapes, std::size_t pixels,
                            std::string_view what) {
        if (shapes.empty()) return;
        const double share = static_cast<double>(pixels) / static_cast<double>(rays.size());
        context.report(
            "shape-looks-like-background", context.at_shape(shapes.front()),
            fmt::format("{} {}: {} of the picture", context.some_shapes(shapes), what, percent_text(share)),
            "give the shape another color than the background's");
    };
    report(same, pixels_of_same, "cannot be told from the background, which has the same color");
    const bool single = similar.size() == 1;
    report(similar, pixels_of_similar,
           fmt::format("{} the color of the background, and only the shading shows where {}",
                       single ? "has" : "have", single ? "it is" : "they are"));
}

}  // namespace glint
