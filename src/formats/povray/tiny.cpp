// SPDX-License-Identifier: Apache-2.0
// What differs from POV-Ray by the numbers of the whole scene: sizes below its fixed tolerances, adc_bailout.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/reach.h"
#include "formats/povray/scene_builder.h"

namespace glint::povray {
namespace {

// Measured with four spheres on a box: of 0.02 units, with mirrors, 99.99% of the pixels are equal, of
// 0.008 99.8%, of 0.004 98.8%; without mirrors, of 0.008 99.98%, of 0.004 99.9%, of 0.002 98.8%.
constexpr double k_least_with_mirrors = 0.01, k_least = 0.005;
constexpr std::uint64_t k_max_size_steps = 100'000'000;

// The longest side of the box around all shapes but planes, or a number above `limit`; nothing without
// shapes.
std::optional<double> size_of(const Scene& scene, double limit) {
    ReachBox box;
    std::uint64_t steps = 0;
    for (const Shape& shape : scene.shapes) {
        // Many copies of large meshes that are all tiny: not searched to the end.
        if ((steps += 6 * reach_steps(scene, shape)) > k_max_size_steps && box.size() >= 0) return limit;
        box.add(scene, shape);
        if (box.size() > limit) break;
    }
    return box.size() < 0 ? std::nullopt : std::optional(box.size());
}

}  // namespace

void SceneBuilder::check_size(const Token& scene_at) {
    const auto reflects = [](const Material& m) { return m.mirror > 0 || m.mirror_min > 0; };
    const bool has_mirrors = std::any_of(scene_.materials.begin(), scene_.materials.end(), reflects);
    const double limit = has_mirrors ? k_least_with_mirrors : k_least;
    const auto size = size_of(scene_, limit);
    if (!size || *size >= limit) return;
    stream_.warn(
        scene_at,
        fmt::format("all shapes are within {:.2g} units: POV-Ray's fixed tolerances change {} of scenes "
                    "below {} units, and "
                    "the picture will differ; scale the scene up to compare",
                    *size, has_mirrors ? "the mirrors" : "the shadows", limit));
}

// POV-Ray compares the product of the reflections at their greatest angles, glint the product of what they
// are (measured; by default it shows little).
void SceneBuilder::check_bailout() {
    if (!high_bailout_) return;
    const auto turns = [](const Material& m) { return m.has_angled_mirror() && m.mirror_min < m.mirror; };
    if (std::any_of(scene_.materials.begin(), scene_.materials.end(), turns))
        report({"adc_bailout", "with reflections by the angle", *high_bailout_});
}

}  // namespace glint::povray
