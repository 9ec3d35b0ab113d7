// SPDX-License-Identifier: Apache-2.0
// Faults of programs that combine the shadow rays of several lights, or the ambient term with shadows.
#include <algorithm>

#include "compare/composed_causes.h"
#include "compare/scene_faults.h"

namespace glint {
namespace {

constexpr std::size_t k_max_shadow_lights = 4;  // each is rendered alone

void keep_only(Scene& scene, std::size_t light) {
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (i != light) switch_off(scene.lights[i]);
    }
}

// The light of one light alone on white surfaces without highlights, also from behind: 0 only where it does
// not reach.
std::optional<Image> light_of(Scene scene, std::size_t light, const RenderScene& render) {
    keep_only(scene, light);
    if (scene.lights[light].is_spot()) scene.lights[light].kind = LightKind::point;  // its cone is no shadow
    scene.lights[light].color = {1, 1, 1};
    for_each_material(scene, [](Material& m) {
        m.diffuse = {1, 1, 1};
        m.specular = m.phong = m.emission = {0, 0, 0};
    });
    scene.background = {0, 0, 0};
    scene.gradient.reset();
    scene.conventions.clamp_cosines = false;
    return render(scene);
}

// The lights whose shadows can be told from the picture; none if there are too many.
std::vector<std::size_t> shadow_lights(const Scene& scene) {
    std::vector<std::size_t> lights;
    if (!has_shadows(scene) || (has_mirrors(scene) && scene.settings.reflections > k_max_composed_levels) ||
        has_glass(scene))
        return lights;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (!is_ambient(scene.lights[i]) && !is_off(scene.lights[i])) lights.push_back(i);
    }
    if (lights.size() > k_max_shadow_lights) lights.clear();
    return lights;
}

// Where light does not reach: nothing is left at all; or what lights add that do reach; or that and half of
// the ambient term for each that does not.
enum class Dark : std::uint8_t { black, without_ambient, half_ambient };

}  // namespace

void add_black_shadows(const Scene& scene, std::vector<SceneCause>& causes) {
    const std::vector<std::size_t> lights = shadow_lights(scene);
    if (lights.empty() || !any_light(scene, is_ambient)) return;
    const auto add = [&](const char* explanation, bool all, Dark dark_is) {
        SceneCause cause{"shadow-black", explanation, {}};
        cause.compose = by_levels([=](const Scene& s, const RenderScene& render) -> std::optional<Image> {
            std::optional<Image> made = render(s);
            Scene no_ambient = s;
            for_each_light(no_ambient, [&](Light& l) {
                if (dark_is == Dark::black) switch_off(l);
            });
            for (Light& l : no_ambient.lights) {
                if (is_ambient(l)) switch_off(l);
            }
            const std::optional<Image> left = render(no_ambient);
            if (!made || !left) return std::nullopt;
            std::vector<std::size_t> dark(made->rgb.size());
            for (const std::size_t light : lights) {
                const std::optional<Image> lit = light_of(s, light, render);
                if (!lit) return std::nullopt;
                for (std::size_t i = 0; i < dark.size(); ++i) dark[i] += lit->rgb[i] == 0;
            }
            for (std::size_t i = 0; i < dark.size(); ++i) {
                if (dark[i] < (all ? lights.size() : 1)) continue;
                float kept = 0;  // of the ambient term
                if (dark_is == Dark::half_ambient) kept = 1 / static_cast<float>(std::size_t{1} << dark[i]);
                made->rgb[i] = left->rgb[i] + kept * (made->rgb[i] - left->rgb[i]);
            }
            return made;
        });
        causes.push_back(std::move(cause));
    };
    add("Shadows are black: a light that does not reach a point adds nothing, and the ambient term stays.",
        true, Dark::black);
    add("The ambient term is halved in the shadow of each light: it does not depend on lights.", false,
        Dark::half_ambient);
    if (lights.size() < 2) return;
    add("Points are black if any light is in shadow: go on with the next light there, do not return "
        "black.",
        false, Dark::black);
    add("There is no ambient term where any light is in shadow: it does not depend on lights.", false,
        Dark::without_ambient);
}

namespace {

// What a light adds, with shadows or without.
std::optional<Image> terms_of(Scene scene, std::size_t light, bool shadows, const RenderScene& render) {
    keep_only(scene, light);
    for_each_material(scene, [](Material& m) { m.emission = {0, 0, 0}; });
    scene.settings.shadows = scene.settings.shadows && shadows;
    scene.background = {0, 0, 0};
    scene.gradient.reset();
    if (scene.fog) scene.fog->color = {0, 0, 0};
    return render(scene);
}

// The shadow rays that count for a light: its own and those of the lights before it, all, or the first.
enum class ShadowState : std::uint8_t { so_far, so_far_in_front, any, first };

}  // namespace

void add_greatest_light(const Scene& scene, std::vector<SceneCause>& causes) {
    const std::vector<std::size_t> lights = shadow_lights(scene);
    if (lights.size() < 2) return;
    SceneCause cause{"light-maximum",
                     "The greatest of the lights' colors is taken, not their sum: add up all lights.",
                     {}};
    cause.compose = by_levels([lights](const Scene& s, const RenderScene& render) -> std::optional<Image> {
        Scene unlit = s;
        for_each_light(unlit, switch_off);
        std::optional<Image> sum = render(unlit);
        if (!sum) return std::nullopt;
        std::vector<float> most(sum->rgb.size());
        for (const std::size_t light : lights) {
            const std::optional<Image> own = terms_of(s, light, true, render);
            if (!own) return std::nullopt;
            for (std::size_t i = 0; i < most.size(); ++i) most[i] = std::max(most[i], own->rgb[i]);
        }
        for (std::size_t i = 0; i < most.size(); ++i) sum->rgb[i] += most[i];
        return sum;
    });
    causes.push_back(std::move(cause));
}

void add_shadows_of_other_lights(const Scene& scene, std::vector<SceneCause>& causes) {
    const std::vector<std::size_t> lights = shadow_lights(scene);
    if (lights.size() < 2) return;
    const auto add = [&](const char* explanation, ShadowState state) {
        SceneCause cause{"shadow-of-another-light", explanation, {}};
        cause.compose =
            by_levels([lights, state](const Scene& s, const RenderScene& render) -> std::optional<Image> {
                Scene unlit = s;
                for_each_light(unlit, switch_off);
                std::optional<Image> sum = render(unlit);
                std::vector<std::uint8_t> reached;  // by the lights that have been rendered
                const auto look = [&](std::size_t light) {
                    const std::optional<Image> found = light_of(s, light, render);
                    std::optional<Image> in_front;
                    if (state == ShadowState::so_far_in_front) {
                        Scene lit = s;
                        lit.settings.shadows = false;
                        in_front = light_of(std::move(lit), light, render);
                    }
                    if (!found || (state == ShadowState::so_far_in_front && !in_front)) return false;
                    reached.resize(found->rgb.size(), 1);
                    for (std::size_t i = 0; i < reached.size(); ++i) {
                        if (found->rgb[i] == 0 && (!in_front || in_front->rgb[i] > 0)) reached[i] = 0;
                    }
                    return true;
                };
                if (state == ShadowState::any && !std::all_of(lights.begin(), lights.end(), look))
                    return std::nullopt;
                for (const std::size_t light : lights) {
                    const bool looks = state == ShadowState::so_far ||
                                       state == ShadowState::so_far_in_front ||
                                       (state == ShadowState::first && light == lights.front());
                    if (looks && !look(light)) return std::nullopt;
                    const std::optional<Image> own = terms_of(s, light, false, render);
                    if (!sum || !own) return std::nullopt;
                    for (std::size_t i = 0; i < reached.size(); ++i) {
                        if (reached[i] != 0) sum->rgb[i] += own->rgb[i];
                    }
                }
                return sum;
            });
        causes.push_back(std::move(cause));
    };
    add("A light whose shadow ray is blocked ends the light of the lights after it, too: go on with the next "
        "one, and begin its test anew.",
        ShadowState::so_far);
    add("A light that is in front of a surface and whose shadow ray is blocked ends the light of the lights "
        "after it, too: "
        "go on with the next one, and begin its test anew.",
        ShadowState::so_far_in_front);
    add("No light is added where any light is blocked: leave out only the light whose shadow ray is blocked.",
        ShadowState::any);
    add("The shadow ray of the first light counts for all lights: each has its own.", ShadowState::first);
}

}  // namespace glint
