// SPDX-License-Identifier: Apache-2.0
// What only the whole scene decides.
#include <algorithm>

#include "formats/povray/clip.h"
#include "formats/povray/reach.h"
#include "formats/povray/scene_builder.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

constexpr std::uint64_t k_max_jitter_steps = 100'000'000;
// The part of the picture that the edges of shadows may cover, estimated. Measured: of four layers of balls
// with 0.27, 99.1% of the pixels are equal, with 0.54 98.6%, with 1.1 97.5%; of a ball on a table with 0.1
// 99.8%.
constexpr double k_most_jittered = 0.25;
// The outline of a ball over its diameter. Meshes and solids have several outlines.
constexpr double k_outline = 3.1, k_outlines_of_many = 10;

}  // namespace

// What is cut and casts no shadow stays whole if it is outside the picture.
void SceneBuilder::check_clips() {
    const auto& all = scene_.materials;
    const bool has_mirrors = refracts_light() || std::any_of(all.begin(), all.end(),
                                                             [](const Material& m) { return m.mirror > 0; });
    for (const UncutShape& uncut : clips_) {
        if (stream_.failed()) return;
        if (!has_mirrors && !is_seen(*uncut.clip, scene_)) continue;
        const bool is_cut = uncut.has_inside &&
                            std::all_of(uncut.objects.begin(), uncut.objects.end(),
                                        [](const ClipObject& clip) { return encloses_space(*clip.object); });
        if (is_cut) {
            cut(uncut);
        } else {
            report(uncut.clip->missing);
        }
    }
}

void SceneBuilder::finish(const Token& scene_at) {
    check_parallel_lights();
    check_no_reflection();
    check_jitter();
    check_clips();
    check_size(scene_at);
    check_bailout();
    use_interiors();
    check_refraction();
    check_fading();
    if (scene_.fog && media_attenuation_)
        report({"media_attenuation", "of a light in fog", *media_attenuation_});
}

// `no_reflection` matters only where something reflects.
void SceneBuilder::check_no_reflection() {
    const auto& all = scene_.materials;
    const auto is_mirror = [](const Material& m) { return m.mirror > 0 || m.mirror_min > 0; };
    if (no_reflection_ && (refracts_light() || std::any_of(all.begin(), all.end(), is_mirror)))
        report({"no_reflection", "", *no_reflection_});
}

// The places of an area light's samples decide only what is in the edges of shadows. These cover the less of
// the picture, the farther the light is from the shapes, and the fewer outlines the shapes have.
void SceneBuilder::check_jitter() {
    if (jittered_.empty()) return;
    ReachBox all;
    double outlines = 0;
    std::uint64_t steps = 0;
    for (const Shape& shape : scene_.shapes) {
        // Many copies of large meshes are not searched to the end.
        all.is_unbounded |= (steps += 6 * reach_steps(scene_, shape)) > k_max_jitter_steps;
        const bool casts_shadow =
            shape.material >= scene_.materials.size() || scene_.materials[shape.material].casts_shadow;
        if (all.is_unbounded && outlines > 0) break;
        ReachBox own;
        own.add(scene_, shape);
        all.add(own);
        const bool is_many = shape.kind == ShapeKind::mesh || shape.kind == ShapeKind::solid;
        if (casts_shadow)
            outlines += k_outline * (own.is_unbounded ? 1 : own.size()) * (is_many ? k_outlines_of_many : 1);
    }
    if (outlines == 0) return;
    const Vec3 sides = all.most - all.least;
    const double area = std::max({sides.x * sides.y, sides.y * sides.z, sides.z * sides.x});
    const auto step = [](Vec3 side, std::int32_t samples) {
        return samples > 1 ? length(side) / (samples - 1) : 0.0;
    };
    for (const auto& [index, at] : jittered_) {
        const Light& light = scene_.lights[index];
        const Vec3 below = all.least - light.position, above = light.position - all.most;
        const double distance = std::max({below.x, below.y, below.z, above.x, above.y, above.z});
        const double grain =
            std::max(step(light.side_u, light.samples_u), step(light.side_v, light.samples_v));
        const double edge = grain * length(sides) / distance;  // the width of the edge of a shadow
        if (all.is_unbounded || !(distance > 0 && edge * outlines < k_most_jittered * area))
            report({"jitter", "of an area light: glint has its own, with another grain", at});
    }
}

}  // namespace glint::povray
