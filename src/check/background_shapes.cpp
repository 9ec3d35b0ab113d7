// SPDX-License-Identifier: Apache-2.0
// Shapes that are in the picture and have the color of the background behind them.
#include <fmt/format.h>

#include <algorithm>

#include "check/checks.h"

namespace glint {
namespace {

constexpr std::int32_t k_background_picture = 320;  // longest side, pixels
constexpr double k_same_color = 1.5 / 255;
constexpr double k_min_same = 0.98;                  // of a shape's pixels
constexpr double k_max_outline = 0.1;                // of its outline: pixels of other shapes beside it
constexpr std::size_t k_min_background_pixels = 12;  // smaller shapes are not examined

struct Look {
    std::size_t all = 0, same = 0, lit = 0;     // pixels; lit: not black
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
    if (lit || context.scene().settings.shading == Shading::color) return false;
    const bool glows =
        brightest(m.ambient * context.world().ambient) > k_same_color || brightest(m.emission) > k_same_color;
    return !glows && (brightest(m.diffuse) > k_same_color || brightest(m.specular) > k_same_color ||
                      brightest(m.phong) > k_same_color);
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
    const HitList hits = nearest_hits(world, rays, context.threads());
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
            bool same = true, lit = false;
            for (std::size_t c = i; c < i + 3; ++c) {
                const double color = shown(picture.rgb[c]);
                same = same && number::abs(color - shown(background.rgb[c])) < k_same_color;
                lit = lit || color > k_same_color;
            }
            look.same += same ? 1 : 0;
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
    std::vector<std::uint32_t> found;
    std::size_t pixels = 0;
    for (std::uint32_t i = 0; i < looks.size(); ++i) {
        const Look& look = looks[i];
        if (look.all < k_min_background_pixels || look.outline == 0) continue;
        const auto part = [](std::size_t a, std::size_t b) {
            return static_cast<double>(a) / static_cast<double>(b);
        };
        if (part(look.same, look.all) < k_min_same || part(look.before_other, look.outline) > k_max_outline)
            continue;
        if (may_look_so(context, i, part(look.lit, look.all) > k_min_same)) continue;
        found.push_back(i);
        pixels += look.all;
    }
    if (found.empty()) return;
    const bool single = found.size() == 1;
    context.report(
        "shape-looks-like-background", context.at_shape(found.front()),
        fmt::format(
            "{} cannot be told from the background: {:.2g}% of the picture {} the same color as what is "
            "behind",
            context.some_shapes(found), 100 * static_cast<double>(pixels) / static_cast<double>(rays.size()),
            single ? "is the shape and has" : "are the shapes and have"),
        "give the shape another color than the background's");
}

}  // namespace glint
