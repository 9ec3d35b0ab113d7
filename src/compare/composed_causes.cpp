// SPDX-License-Identifier: Apache-2.0
#include "compare/composed_causes.h"

#include <algorithm>

#include "compare/scene_faults.h"
#include "math/elementary.h"

namespace glint {
namespace {

bool has_diffuse_light(const Scene& scene) {
    return is_lit(scene) && any_material(scene, [](const Material& m) { return !is_zero(m.diffuse); });
}

// The diffuse term of lights behind surfaces, with |N.L|: the picture with max(0, N.L) minus the one with
// N.L.
std::optional<Image> diffuse_from_behind(Scene scene, const RenderScene& render) {
    std::erase_if(scene.lights, is_ambient);
    for_each_material(scene, [](Material& m) { m.specular = {0, 0, 0}; });
    scene.background = {0, 0, 0};
    scene.conventions.clamp_cosines = true;
    std::optional<Image> clamped = render(scene);
    scene.conventions.clamp_cosines = false;
    const std::optional<Image> signed_sum = render(scene);
    if (!clamped || !signed_sum) return std::nullopt;
    for (std::size_t i = 0; i < clamped->rgb.size(); ++i) clamped->rgb[i] -= signed_sum->rgb[i];
    return clamped;
}

}  // namespace

// Light is a sum, so the pictures of these faults are sums, too.
void add_turned_cosines(const Scene& scene, std::vector<SceneCause>& causes) {
    if (!has_diffuse_light(scene) || !scene.conventions.clamp_cosines) return;
    const auto add = [&](const char* name, const char* explanation, bool lit) {
        SceneCause cause{name, explanation, {}};
        cause.compose = [lit](const Scene& s, const RenderScene& render) -> std::optional<Image> {
            Scene base = s;
            if (!lit) std::erase_if(base.lights, [](const Light& l) { return !is_ambient(l); });
            std::optional<Image> sum = render(base);
            const std::optional<Image> behind = diffuse_from_behind(s, render);
            if (!sum || !behind) return std::nullopt;
            for (std::size_t i = 0; i < sum->rgb.size(); ++i) sum->rgb[i] += behind->rgb[i];
            return sum;
        };
        causes.push_back(std::move(cause));
    };
    add("abs-cosine",
        "Light from behind a surface is added as if it came from the front: |N.L| is used instead of "
        "max(0, N.L).",
        true);
    add("normals-reversed",
        "Surfaces are lit from behind and dark in front: N is reversed (a sphere's N is P - C, not C - P), "
        "or L is reversed.",
        false);
}

// What else there is, and that term.
void add_raw_diffuse(const Scene& scene, std::vector<SceneCause>& causes) {
    if (!has_diffuse_light(scene) || !scene.conventions.normalize || !has_highlights(scene)) return;
    SceneCause cause{
        "not-normalized", "L is not of unit length in the diffuse term: normalise it before taking N.L.", {}};
    cause.compose = [](const Scene& s, const RenderScene& render) -> std::optional<Image> {
        Scene others = s, diffuse = s;
        for_each_material(others, [](Material& m) { m.diffuse = {0, 0, 0}; });
        for_each_material(diffuse, [](Material& m) { m.specular = m.phong = {0, 0, 0}; });
        for (Light& light : diffuse.lights) {
            if (is_ambient(light)) switch_off(light);
        }
        // What does not depend on normals is in the other picture.
        for_each_material(diffuse, [](Material& m) { m.emission = {0, 0, 0}; });
        if (diffuse.fog) diffuse.fog->color = {0, 0, 0};
        diffuse.background = {0, 0, 0};
        diffuse.gradient.reset();
        diffuse.conventions.normalize = false;
        std::optional<Image> sum = render(others);
        const std::optional<Image> part = render(diffuse);
        if (!sum || !part) return std::nullopt;
        for (std::size_t i = 0; i < sum->rgb.size(); ++i) sum->rgb[i] += part->rgb[i];
        return sum;
    };
    causes.push_back(std::move(cause));
}

std::optional<Image> surfaces_of(Scene scene, const RenderScene& render) {
    for_each_material(scene, [](Material& m) { m.color = {1, 1, 1}; });
    scene.settings.shading = Shading::color;
    scene.settings.reflections = 0;
    scene.background = {0, 0, 0};
    scene.gradient.reset();
    scene.fog.reset();
    return render(scene);
}

// Without the color that stands for "no shape" then.
void add_shown_normals(const Scene& scene, std::vector<SceneCause>& causes) {
    if (!is_lit(scene)) return;
    SceneCause cause{
        "normals-shown", "Surfaces show their normals as colors, 0.5 (N + 1): a picture for debugging.", {}};
    cause.compose = [](const Scene& s, const RenderScene& render) -> std::optional<Image> {
        Scene shown = s;
        shown.settings.shading = Shading::normals;
        std::optional<Image> made = render(shown);
        const std::optional<Image> surfaces = surfaces_of(s, render), plain = render(s);
        if (!made || !surfaces || !plain) return std::nullopt;
        for (std::size_t i = 0; i < made->rgb.size(); i += 3) {
            const float* surface = &surfaces->rgb[i];
            if (std::all_of(surface, surface + 3, [](float v) { return v == 0; }))
                std::copy_n(&plain->rgb[i], 3, &made->rgb[i]);
        }
        return made;
    };
    causes.push_back(std::move(cause));
}

void add_tone_curves(std::vector<SceneCause>& causes) {
    const auto add = [&](const char* explanation, double (*curve)(double)) {
        SceneCause cause{"tone-curve", explanation, {}};
        cause.compose = [curve](const Scene& s, const RenderScene& render) -> std::optional<Image> {
            std::optional<Image> made = render(s);
            if (!made) return std::nullopt;
            for (float& v : made->rgb) v = static_cast<float>(curve(static_cast<double>(v)));
            return made;
        };
        causes.push_back(std::move(cause));
    };
    add("Colors go through a tone curve, c / (1 + c): the scene has none.",
        [](double c) { return c / (1 + c); });
    add("Colors go through a tone curve, 1 - exp(-c): the scene has none.",
        [](double c) { return 1 - exp(-c); });
}

}  // namespace glint
