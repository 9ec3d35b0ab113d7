// SPDX-License-Identifier: Apache-2.0
// Area lights that have more samples than the picture can show, or one, which shows nothing of their size.
#include <fmt/format.h>

#include <algorithm>

#include "check/light_effects.h"

namespace glint {
namespace {

constexpr std::int32_t k_usual_samples = 16;  // the default; they cost little
constexpr std::int32_t k_few_samples = 4;     // columns and rows that show soft shadows
constexpr double k_clear = 8.0 / 255;         // differences in a channel that count
constexpr double k_min_penumbra = 0.002;      // of the picture

// Whether a finding says that a light adds nothing.
bool is_dark(const CheckContext& context, std::uint32_t index) {
    constexpr std::string_view k_ids[] = {
        "light-inside-shape",    "light-behind-everything", "light-behind-plane", "light-blocked",
        "area-light-faces-away", "light-adds-nothing",      "light-too-weak"};
    return std::any_of(std::begin(k_ids), std::end(k_ids),
                       [&](std::string_view id) { return context.is_reported(id, SceneItem::light, index); });
}

Image with_samples(CheckContext& context, std::uint32_t index, std::int32_t u, std::int32_t v,
                   std::int32_t longest) {
    std::vector<Light> lights = context.scene().lights;
    lights[index].samples_u = u;
    lights[index].samples_v = v;
    return context.render_small(with_lights(context.prepared(), lights), longest);
}

void check_too_many_samples(CheckContext& context, std::uint32_t index) {
    const Light& light = context.scene().lights[index];
    const std::int32_t u = (light.samples_u + 1) / 2, v = (light.samples_v + 1) / 2;
    const Image few = with_samples(context, index, u, v, k_second_look);
    const double most = effect_of(context.render_small(k_second_look), few).most;
    if (!(most < k_half_byte)) return;
    context.report(
        "area-light-too-many-samples", context.at_light(index),
        fmt::format(
            "{} has {} x {} samples; the picture with {} x {} differs from it by at most {:.2g} of 255, "
            "which is not visible",
            context.light(index), light.samples_u, light.samples_v, u, v, most * 255),
        fmt::format("set samples_u = {} and samples_v = {}", u, v));
}

void check_one_sample(CheckContext& context, std::uint32_t index) {
    const Scene& scene = context.scene();
    const Light& light = scene.lights[index];
    if (!light.casts_shadows || !scene.settings.shadows) return;
    // The samples of a pixel see the light's samples at different places.
    if (light.moves_samples() && scene.settings.samples > 1) return;
    const Image soft = with_samples(context, index, k_few_samples, k_few_samples, k_first_look);
    const Image now = context.render_small(k_first_look);
    if (soft.rgb.empty()) return;
    const double changed =
        3 * static_cast<double>(count_differing(now, soft, k_clear)) / static_cast<double>(soft.rgb.size());
    if (changed < k_min_penumbra) return;
    context.report(
        "area-light-one-sample", context.at_light(index),
        fmt::format(
            "{} has one sample: {}; with {} x {} samples {} of the picture differs by more "
            "than 8 of 255",
            context.light(index),
            light.jitter ? "its shadows are noise" : "all its light comes from one point, whatever its size",
            k_few_samples, k_few_samples, percent_text(changed)),
        fmt::format("set samples_u = {} and samples_v = {}, or write a point light", k_few_samples,
                    k_few_samples));
}

}  // namespace

void check_light_samples(CheckContext& context) {
    const Scene& scene = context.scene();
    std::size_t looks = 0;
    for (std::uint32_t i = 0; i < scene.lights.size() && looks < k_full_looks; ++i) {
        const Light& light = scene.lights[i];
        const std::int32_t samples = light.samples_u * light.samples_v;
        if (!light.is_area() || (samples > 1 && samples <= k_usual_samples)) continue;
        if (is_black(light.color) && is_black(light.specular_color)) continue;
        if (is_dark(context, i)) continue;
        ++looks;
        if (samples == 1) {
            check_one_sample(context, i);
        } else {
            check_too_many_samples(context, i);
        }
    }
}

}  // namespace glint
