// SPDX-License-Identifier: Apache-2.0
// The causes of a scene: the rows of the tables that apply to it, and those that depend on its lights and
// numbers.
#include "compare/scene_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "compare/composed_causes.h"
#include "compare/edges.h"
#include "compare/item_texts.h"
#include "compare/picture_causes.h"
#include "compare/scene_faults.h"
#include "world/prepare_camera.h"

namespace glint {
namespace {

// A camera that is moved a little shows something like a shift.
constexpr double k_min_shift = 0.7;

// Turns the camera so that its rays pass (dx, dy) pixels further right and down.
void shift_rays(Scene& s, double dx, double dy) {
    const PreparedCamera camera = prepare_camera(s.camera, s.settings);
    const Vec3 step = camera.right * (dx / s.settings.width) - camera.up * (dy / s.settings.height);
    const bool perspective = s.camera.projection == Projection::perspective;
    s.camera.frame = {camera.right, camera.up, perspective ? camera.forward + step : camera.forward};
    if (!perspective) s.camera.position = s.camera.position + step;
}

// In eight directions.
void add_shifts(const char* name, fmt::string_view explanation, double pixels, bool only_pairs,
                std::vector<SceneCause>& causes) {
    for (const auto& [dx, dy] :
         {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
        SceneCause cause{name, fmt::format(fmt::runtime(explanation), direction_text(dx, dy)),
                         [dx = -pixels * dx, dy = -pixels * dy](Scene& s) { shift_rays(s, dx, dy); }};
        cause.least = k_min_shift;
        cause.is_shift = true;
        cause.only_pairs = only_pairs;
        causes.push_back(std::move(cause));
    }
}

constexpr double k_same_factor = 0.01;  // of the factor

bool is_factor(double factor, double of) { return std::fabs(factor - of) <= k_same_factor * of; }

// Of light that is multiplied by its intensity twice, or not at all.
std::string intensity_hint(double factor, double intensity) {
    if (intensity <= 0 || is_factor(1, intensity)) return "";
    if (is_factor(factor, intensity)) return " That is its intensity, which may be applied twice.";
    if (is_factor(factor, 1 / intensity)) return " That is 1 / its intensity, which may be left out.";
    return "";
}

// Of the factor of a part of light.
std::function<std::string(double)> factor_hint(const Scene& scene, std::string_view scaled) {
    double lights = 0, ambient = 0;
    for (const Light& light : scene.lights) {
        if (is_ambient(light)) ambient += largest(light.color);
        if (!is_ambient(light) && !is_off(light)) ++lights;
    }
    if (scaled == "ambient-scaled") return [=](double factor) { return intensity_hint(factor, ambient); };
    if (scaled != "light-intensity" || lights < 2) return {};
    return [=](double factor) -> std::string {
        return is_factor(factor, 1 / lights)
                   ? fmt::format(" That is 1 / {}: lights may be averaged, and are to be added.", lights)
                   : "";
    };
}

constexpr int k_max_single_lights = 8;  // tried one by one

void add_single_lights(const Scene& scene, std::vector<SceneCause>& causes) {
    std::vector<std::uint32_t> lights;
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        if (!is_ambient(scene.lights[i]) && !is_off(scene.lights[i])) lights.push_back(i);
    }
    if (!is_lit(scene) || lights.size() < 2 || lights.size() > k_max_single_lights) return;
    for (const std::uint32_t light : lights) {
        const std::string text = item_text(scene, "light", light, scene.light_texts);
        causes.push_back({"light-missing",
                          fmt::format("The light of {} is missing: sum over all lights.{}", text,
                                      scene.lights[light].has_direction()
                                          ? " (Or its direction is reversed, and shapes block it.)"
                                          : ""),
                          [light](Scene& s) { switch_off(s.lights[light]); }, text, "light-scaled",
                          [light](Scene& s, double factor) {
                              s.lights[light].color = s.lights[light].color * factor;
                              s.lights[light].specular_color = s.lights[light].specular_color * factor;
                          },
                          [intensity = largest(scene.lights[light].color)](double factor) {
                              return intensity_hint(factor, intensity);
                          }});
    }
    for (std::size_t k = 0; lights.size() > 2 && k < lights.size(); ++k) {
        causes.push_back({"light-alone",
                          fmt::format("Only {} is used: add up all lights (an assignment in the loop keeps "
                                      "the last one, a return in "
                                      "the loop the first).",
                                      item_text(scene, "light", lights[k], scene.light_texts)),
                          [i = lights[k]](Scene& s) {
                              for (std::uint32_t other = 0; other < s.lights.size(); ++other) {
                                  if (other != i && !is_ambient(s.lights[other])) switch_off(s.lights[other]);
                              }
                          }});
    }
}

constexpr int k_max_levels = 8;  // of reflection that are tried one by one

void add_reflection_levels(const Scene& scene, std::vector<SceneCause>& causes) {
    const int asked = scene.settings.reflections;
    if (!has_mirrors(scene)) return;
    for (int n = 1; n < std::min(asked - 1, k_max_levels); ++n) {
        causes.push_back({"reflections-fewer",
                          fmt::format("The recursion stops after {} of {} levels of reflection.", n, asked),
                          [n](Scene& s) { s.settings.reflections = n; }});
    }
}

// Numbers of samples that are usual, and those near the scene's own.
void add_area_samples(const Scene& scene, std::vector<SceneCause>& causes) {
    if (!has_area_lights(scene)) return;
    const Light& first =
        *std::find_if(scene.lights.begin(), scene.lights.end(), [](const Light& l) { return l.is_area(); });
    const std::int32_t u = first.samples_u, v = first.samples_v;
    std::vector<std::pair<std::int32_t, std::int32_t>> tried = {{u, v}};
    for (const auto& [columns, rows] :
         {std::pair{1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}, {8, 8}, {u / 2, v / 2}, {v, u}}) {
        const std::pair samples{std::max(columns, 1), std::max(rows, 1)};
        if (std::find(tried.begin(), tried.end(), samples) != tried.end()) continue;
        tried.push_back(samples);
        causes.push_back({"area-light-samples",
                          fmt::format("Area lights have {} x {} samples, and in the scene {} x {}.",
                                      samples.first, samples.second, u, v),
                          [samples](Scene& s) {
                              for_each_area_light(
                                  s, [&](Light& l) { std::tie(l.samples_u, l.samples_v) = samples; });
                          }});
    }
}

void add_sample_counts(const Scene& scene, std::vector<SceneCause>& causes) {
    for (const int n : {1, 2, 3, 4}) {
        if (n == scene.settings.samples) continue;
        causes.push_back(
            {"anti-aliasing",
             fmt::format("Only edges differ: {} x {} samples per pixel, and the scene sets {} x {}.", n, n,
                         scene.settings.samples, scene.settings.samples),
             [n](Scene& s) {
                 s.settings.samples = n;
                 s.settings.aa_threshold.reset();
                 s.settings.jitter = false;
             }});
        causes.back().is_of_samples = true;
    }
}

}  // namespace

std::vector<SceneCause> scene_causes(const Scene& scene) {
    std::vector<SceneCause> causes;
    const auto add = [&](std::span<const SceneFault> rows) {
        for (const SceneFault& row : rows) {
            if (row.applies(scene))
                causes.push_back({row.name,
                                  row.explanation,
                                  row.put,
                                  row.part,
                                  row.scaled,
                                  row.scale_part,
                                  factor_hint(scene, row.scaled),
                                  row.scale,
                                  row.scale_text,
                                  row.limit,
                                  row.limit_text,
                                  {},
                                  row.reshape,
                                  row.fault});
        }
    };
    add_single_lights(scene, causes);
    add(lighting_faults());
    add_turned_cosines(scene, causes);
    add_raw_diffuse(scene, causes);
    add_shown_normals(scene, causes);
    add(light_kind_faults());
    add_area_samples(scene, causes);
    add(tracing_faults());
    add(medium_faults());
    add(texture_faults());
    add(camera_faults());
    add(kernel_faults());
    add_black_shadows(scene, causes);
    add_shadows_of_other_lights(scene, causes);
    add_greatest_light(scene, causes);
    add_faults_in_mirrors(scene, causes);
    add_clamped_parts(scene, causes);
    add_tone_curves(causes);
    add(shape_faults());
    add(mixed_up_faults());
    add_reflection_levels(scene, causes);
    add_shifts("shifted-half-pixel", k_half_shift_text, 0.5, false, causes);
    // Alone it is found in the pictures.
    add_shifts("shifted-one-pixel", k_shift_text, 1, true, causes);
    add_sample_counts(scene, causes);
    return causes;
}

}  // namespace glint
