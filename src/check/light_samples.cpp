// SPDX-License-Identifier: Apache-2.0
// Area lights that have more samples than the picture can show.
#include <fmt/format.h>

#include <algorithm>

#include "check/light_effects.h"

namespace glint {
namespace {

constexpr std::int32_t k_usual_samples = 16;  // the default; they cost little

// Whether a finding says that a light adds nothing.
bool is_dark(const CheckContext& context, std::uint32_t index) {
    constexpr std::string_view k_ids[] = {
        "light-inside-shape",    "light-behind-everything", "light-behind-plane", "light-blocked",
        "area-light-faces-away", "light-adds-nothing",      "light-too-weak"};
    return std::any_of(std::begin(k_ids), std::end(k_ids),
                       [&](std::string_view id) { return context.is_reported(id, SceneItem::light, index); });
}

}  // namespace

void check_light_samples(CheckContext& context) {
    const Scene& scene = context.scene();
    std::size_t looks = 0;
    for (std::uint32_t i = 0; i < scene.lights.size() && looks < k_full_looks; ++i) {
        const Light& light = scene.lights[i];
        if (!light.is_area() || light.samples_u * light.samples_v <= k_usual_samples) continue;
        if (is_black(light.color) && is_black(light.specular_color)) continue;
        if (is_dark(context, i)) continue;
        ++looks;
        std::vector<Light> fewer = scene.lights;
        fewer[i].samples_u = (light.samples_u + 1) / 2;
        fewer[i].samples_v = (light.samples_v + 1) / 2;
        const Image few = context.render_small(with_lights(context.prepared(), fewer), k_second_look);
        const double most = effect_of(context.render_small(k_second_look), few).most;
        if (!(most < k_half_byte)) continue;
        context.report(
            "area-light-too-many-samples", context.at_light(i),
            fmt::format(
                "{} has {} x {} samples; the picture with {} x {} differs from it by at most {:.2g} of 255, "
                "which is not visible",
                context.light(i), light.samples_u, light.samples_v, fewer[i].samples_u, fewer[i].samples_v,
                most * 255),
            fmt::format("set samples_u = {} and samples_v = {}", fewer[i].samples_u, fewer[i].samples_v));
    }
}

}  // namespace glint
