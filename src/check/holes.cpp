// SPDX-License-Identifier: Apache-2.0
// Shapes of which the camera sees nothing but holes of their textures, or their backs.
#include <fmt/format.h>

#include "check/checks.h"

namespace glint {
namespace {

constexpr std::size_t k_min_passing = 20;  // hits, of a shape of which the picture may show more

// The texture of a shape; k_none without one.
std::uint32_t texture_of_shape(const Scene& scene, std::uint32_t shape) {
    const std::uint32_t material = scene.shapes[shape].material;
    return material == k_none ? k_none : scene.materials[material].texture;
}

void report_backs(CheckContext& context, const std::vector<std::uint32_t>& shapes) {
    if (shapes.empty()) return;
    const bool single = shapes.size() == 1;
    context.report("shape-only-back", context.at_shape(shapes.front()),
                   fmt::format("{} {} seen only from behind, and {} one-sided material does not show there",
                               context.some_shapes(shapes), single ? "is" : "are", single ? "its" : "their"),
                   "reverse the order of the vertices, or set `one_sided` to false",
                   context.is_model() ? Severity::note : Severity::warning);
}

}  // namespace

void check_holes(CheckContext& context, const VisibleHits& visible) {
    if (visible.passed.empty()) return;
    const Scene& scene = context.scene();
    const std::vector<bool> hit = visible.hit_shapes(scene);
    // Where the picture shows nothing else, one ray is enough.
    const std::size_t least = visible.seen().empty() ? 1 : k_min_passing;
    std::vector<std::uint32_t> only_holes, only_backs;
    std::size_t times = 0;
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        if (hit[i] || visible.passed[i] < least) continue;
        const std::uint32_t texture = texture_of_shape(scene, i);
        if (texture == k_none || !scene.textures[texture].has_holes()) {
            only_backs.push_back(i);
        } else if (!context.is_reported("texture-invisible", SceneItem::texture, texture)) {
            only_holes.push_back(i);
            times += visible.passed[i];
        }
    }
    report_backs(context, only_backs);
    if (only_holes.empty()) return;
    const bool single = only_holes.size() == 1;
    const std::uint32_t first = only_holes.front();
    context.report(
        "shape-only-holes", context.at_shape(first),
        fmt::format("{} {} seen only where {} a hole: rays meet {} {}, and always go on behind {}",
                    context.some_shapes(only_holes), single ? "is" : "are",
                    single ? context.texture(texture_of_shape(scene, first)) + " has" : "their textures have",
                    single ? "it" : "them", times == 1 ? "once" : fmt::format("{} times", times),
                    single ? "it" : "them"),
        "correct the texture coordinates or `uv_map`, lower `alpha_cutoff`, or set `alpha` to ignore",
        context.is_model() ? Severity::note : Severity::warning);
}

}  // namespace glint
