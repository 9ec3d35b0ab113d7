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
// In steps between two samples. Measured at this distance: of a ball on a table that fills the picture, 99.8%
// of the pixels are equal, of a molecule of ASE's 99.98%.
constexpr double k_far_jitter = 100;

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

// The places of an area light's samples decide only what is in shadow, and change it the less, the farther
// the light is from the shapes.
void SceneBuilder::check_jitter() {
    const auto casts_shadow = [&](const Shape& shape) {
        return shape.material >= scene_.materials.size() || scene_.materials[shape.material].casts_shadow;
    };
    if (jittered_.empty() || std::none_of(scene_.shapes.begin(), scene_.shapes.end(), casts_shadow)) return;
    ReachBox box;
    std::uint64_t steps = 0;
    for (const Shape& shape : scene_.shapes) {
        // Many copies of large meshes are not searched to the end.
        box.is_unbounded |= (steps += 6 * reach_steps(scene_, shape)) > k_max_jitter_steps;
        if (box.is_unbounded) break;
        box.add(scene_, shape);
    }
    const auto step = [](Vec3 side, std::int32_t samples) {
        return samples > 1 ? length(side) / (samples - 1) : 0.0;
    };
    for (const auto& [index, at] : jittered_) {
        const Light& light = scene_.lights[index];
        const Vec3 below = box.least - light.position, above = light.position - box.most;
        const double distance = std::max({below.x, below.y, below.z, above.x, above.y, above.z});
        const double grain =
            std::max(step(light.side_u, light.samples_u), step(light.side_v, light.samples_v));
        if (box.is_unbounded || distance < k_far_jitter * grain)
            report({"jitter", "of an area light: glint has its own, with another grain", at});
    }
}

}  // namespace glint::povray
