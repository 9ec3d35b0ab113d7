// SPDX-License-Identifier: Apache-2.0
// Faults of rays: of shadows, mirrors and glass.
#include <fmt/format.h>

#include <algorithm>

#include "compare/factor_search.h"
#include "compare/scene_faults.h"

namespace glint {
namespace {

constexpr int k_usual_reflections = 4;
constexpr double k_large_epsilon = 0.5;

void scale_mirrors(Scene& s, double factor) {
    for_each_material(s, [=](Material& m) { m.mirror = std::min(m.mirror * factor, 1.0); });
}
std::string mirror_text(double factor, bool about) {
    return fmt::format("The mirrors' coefficient is {} what it should be: {} is reflected.",
                       factor_text(factor, about), factor < 1 ? "too little" : "too much");
}

bool has_blended_mirrors(const Scene& s) {
    return has_mirrors(s) && s.conventions.mirror == MirrorRule::blend;
}

constexpr SceneFault k_tracing[] = {
    {"acne", has_shadows, [](Scene& s) { s.conventions.epsilon = 0; },
     "Dark specks on lit surfaces (acne): a shadow ray, or a mirror ray, hits the surface that it starts "
     "from. "
     "Move its origin off the surface, or ignore hits with t below a small epsilon."},
    {"acne", has_shadows,
     [](Scene& s) {
         s.conventions.offset = Offset::ray;
         s.conventions.epsilon = 0;
     },
     "Dark specks on lit surfaces (acne): a shadow ray, or a mirror ray, hits the surface that it starts "
     "from. "
     "Move its origin off the surface, or ignore hits with t below a small epsilon."},
    {.name = "epsilon-too-large",
     .applies = has_shadows,
     .put = [](Scene& s) { s.conventions.offset = Offset::direction; },
     .scale = [](Scene& s, double factor) { s.conventions.epsilon = k_large_epsilon * factor; },
     .scale_text =
         [](double factor, bool) {
             return fmt::format(
                 "Shadows do not begin where shapes touch: hits of shadow rays with t below about {:.2g} do "
                 "not count. Use a much smaller epsilon.",
                 k_large_epsilon * factor);
         }},
    {"shadow-past-light", has_shadows, [](Scene& s) { s.conventions.shadow_stops_at_light = false; },
     "Objects behind a light cast a shadow, too: a shadow ray to a point light ends at the light, so only "
     "hits before it (t < distance) count."},
    {"reflections-missing", has_mirrors, [](Scene& s) { s.settings.reflections = 0; },
     "Mirrors are missing: trace the ray reflected at N, and mix the color that it returns with the "
     "surface's own color."},
    {"reflections-added",
     [](const Scene& s) {
         return s.settings.reflections == 0 &&
                any_material(s, [](const Material& m) { return m.mirror > 0; });
     },
     [](Scene& s) { s.settings.reflections = k_usual_reflections; },
     "There are mirrors, and the reference has none: this part of the task is without reflections."},
    {.name = "mirror-scaled", .applies = has_mirrors, .scale = scale_mirrors, .scale_text = mirror_text},
    {"reflections-one-fewer", [](const Scene& s) { return has_mirrors(s) && s.settings.reflections > 1; },
     [](Scene& s) { --s.settings.reflections; },
     "There is one level of reflection too few: the recursion stops one mirror early."},
    {"reflections-one-more",
     [](const Scene& s) { return has_mirrors(s) && s.settings.reflections < k_max_reflections; },
     [](Scene& s) { ++s.settings.reflections; },
     "There is one level of reflection too many: the recursion stops one mirror late."},
    {"mirror-limit-dark",
     [](const Scene& s) { return has_mirrors(s) && s.conventions.limit != LimitRule::drop; },
     [](Scene& s) { s.conventions.limit = LimitRule::drop; },
     "Mirrors are too dark where the recursion ends: at the last level return the surface's own color, not "
     "mixed with black."},
    {"mirror-limit-bright",
     [](const Scene& s) { return has_mirrors(s) && s.conventions.limit != LimitRule::keep; },
     [](Scene& s) { s.conventions.limit = LimitRule::keep; },
     "Mirrors are too bright where the recursion ends: at the last level mix the surface's own color with "
     "black."},
    {"mirror-miss-black",
     [](const Scene& s) { return has_mirrors(s) && s.conventions.mirror_miss != MissRule::black; },
     [](Scene& s) { s.conventions.mirror_miss = MissRule::black; },
     "Mirrors are too dark where reflected rays leave the scene: a ray that hits nothing returns the "
     "background, not black."},
    {"mirror-miss-background",
     [](const Scene& s) { return has_mirrors(s) && s.conventions.mirror_miss != MissRule::background; },
     [](Scene& s) { s.conventions.mirror_miss = MissRule::background; },
     "A reflected ray that hits nothing returns the background, and in the reference black."},
    {"mirror-added", [](const Scene& s) { return has_mirrors(s) && s.conventions.mirror != MirrorRule::add; },
     [](Scene& s) { s.conventions.mirror = MirrorRule::add; },
     "Mirrors are too bright: the reflected color is added to the local one. Mix the two: (1 - a) local + "
     "a reflected."},
    {"mirror-blended",
     [](const Scene& s) { return has_mirrors(s) && s.conventions.mirror != MirrorRule::blend; },
     [](Scene& s) { s.conventions.mirror = MirrorRule::blend; },
     "Mirrors are too dark: the reflected color is mixed with the local one, and in the reference it is "
     "added."},
    {"mirror-surface-color", has_mirrors,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.mirror_tint = m.mirror_tint * m.color; }); },
     "What mirrors show has the surface's color, too: multiply the reflected color by the coefficient "
     "alone."},
    {"mirror-surface-color", has_mirrors,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.mirror_tint = m.mirror_tint * m.diffuse; }); },
     "What mirrors show is multiplied by k_d, too: multiply the reflected color by the coefficient alone."},
    {"mirror-not-multiplied", has_blended_mirrors,
     [](Scene& s) {
         for_each_material(s, [](Material& m) {
             if (m.mirror > 0) m.mirror_tint = m.mirror_tint * (1 / m.mirror);
         });
     },
     "The reflected color is added as it is to (1 - a) local: multiply it by a."},
    {"mirror-fresnel", has_mirrors,
     [](Scene& s) {
         for_each_material(s, [](Material& m) {
             if (m.mirror <= 0 || m.has_angled_mirror()) return;
             m.mirror_min = m.mirror;
             m.mirror = 1;
             m.mirror_falloff = 5;
         });
     },
     "Mirrors reflect more at grazing angles, by Schlick's formula, and in the reference everywhere alike."},
    {"mirror-weights-exchanged", has_blended_mirrors,
     [](Scene& s) {
         for_each_material(s, [](Material& m) {
             if (m.mirror > 0) m.mirror = 1 - m.mirror;
         });
     },
     "The weights of mirrors are exchanged: the color is (1 - a) local + a reflected."},
    {"mirror-not-multiplied", has_mirrors,
     [](Scene& s) {
         s.conventions.mirror = MirrorRule::add;
         for_each_material(s, [](Material& m) {
             if (m.mirror > 0) m.mirror = 1;
         });
     },
     "The reflected color is added as it is: multiply it by the mirrors' coefficient."},
    {"glass-missing", has_glass,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.transmission = 0; }); },
     "Glass is opaque: follow the refracted ray."},
    {"refraction-missing", has_glass, [](Scene& s) { for_each_material(s, [](Material& m) { m.ior = 1; }); },
     "Rays go straight through glass: bend them by Snell's law."},
    {"refraction-inverted", has_glass,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.ior = 1 / m.ior; }); },
     "Rays are bent the wrong way: where a ray enters, eta is 1 / ior, and where it leaves, ior."},
    {"glass-shadow", has_glass,
     [](Scene& s) {
         s.conventions.glass_shadow =
             s.conventions.glass_shadow == GlassShadow::none ? GlassShadow::opaque : GlassShadow::none;
     },
     "Glass casts a shadow, and in the reference it does not, or the reverse."},
    {"background", [](const Scene& s) { return !is_zero(s.background); },
     [](Scene& s) {
         s.background = {0, 0, 0};
     },
     "The background is black: a ray that hits nothing returns the scene's background color."},
    {"gradient-missing", [](const Scene& s) { return s.gradient.has_value(); },
     [](Scene& s) { s.gradient.reset(); }, "The background has one color: its gradient is missing."},
};

}  // namespace

std::span<const SceneFault> tracing_faults() { return k_tracing; }

}  // namespace glint
