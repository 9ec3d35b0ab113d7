// SPDX-License-Identifier: Apache-2.0
// Faults of the lighting equation.
#include <fmt/format.h>

#include "compare/factor_search.h"
#include "compare/scene_faults.h"

namespace glint {
namespace {

void scale_exponents(Scene& s, double factor) {
    for_each_material(s, [=](Material& m) {
        m.shininess *= factor;
        m.phong_shininess *= factor;
    });
}
void swap_model(Scene& s) {
    // A part of a rubric may have no highlights.
    if (s.settings.shading == Shading::phong)
        s.settings.shading = Shading::blinn_phong;
    else if (s.settings.shading == Shading::blinn_phong)
        s.settings.shading = Shading::phong;
}
bool is_about_four(double factor) { return factor > 3 && factor < 5; }
std::string exponent_text(double factor, bool about) {
    std::string text = fmt::format("The specular exponent is {} what it should be: highlights are too {}.",
                                   factor_text(factor, about), factor < 1 ? "wide" : "small");
    if (is_about_four(1 / factor)) text += " (Blinn-Phong's needs to be about four times Phong's.)";
    if (is_about_four(factor))
        text += " (Blinn-Phong's needs to be about four times Phong's, not Phong's itself.)";
    return text;
}
std::string vanished_text(double factor) {
    return fmt::format(
        "The specular exponent is {:.0f} times what it should be, or more: highlights are too small or "
        "too dim to be seen.",
        factor);
}
std::string other_model_text(double factor, bool about) {
    return fmt::format(
        "The other model of the highlight (Phong for Blinn-Phong, or the reverse), with {} the exponent.",
        factor_text(factor, about));
}
void scale_light(Light& light, double factor) {
    light.color = light.color * factor;
    light.specular_color = light.specular_color * factor;
}
bool has_colored_light(const Scene& s) {
    return is_lit(s) && any_light(s, [](const Light& l) {
               return !is_ambient(l) && (l.color.r != l.color.g || l.color.g != l.color.b);
           });
}
void make_lights_grey(Scene& s, double (*level)(const Color&)) {
    for_each_light(s, [=](Light& l) {
        for (Color* const color : {&l.color, &l.specular_color}) {
            const double grey = level(*color);
            *color = {grey, grey, grey};
        }
    });
}
void scale_all_lights(Scene& s, double factor) {
    for (Light& light : s.lights) scale_light(light, factor);
}
void scale_lights(Scene& s, double factor) {
    for_each_light(s, [=](Light& l) { scale_light(l, factor); });
}
void scale_ambient(Scene& s, double factor) {
    for (Light& light : s.lights) {
        if (is_ambient(light)) scale_light(light, factor);
    }
}
void scale_diffuse(Scene& s, double factor) {
    for_each_material(s, [=](Material& m) { m.diffuse = m.diffuse * factor; });
}
void scale_specular(Scene& s, double factor) {
    for_each_material(s, [=](Material& m) {
        m.specular = m.specular * factor;
        m.phong = m.phong * factor;
    });
}

// With grey ones the specular term would only be darker.
bool has_hue(const Material& m) {
    const Color& c = m.diffuse;
    return !is_zero(m.specular) && (c.r != c.g || c.g != c.b);
}

// Where there are highlights, or everywhere.
constexpr const char* k_specular_of_diffuse =
    "Highlights have the surface's color: the specular term has the diffuse coefficient k_d in place of "
    "k_s.";

constexpr SceneFault k_lighting[] = {
    {"ambient-missing", [](const Scene& s) { return any_light(s, is_ambient); },
     [](Scene& s) {
         for (Light& light : s.lights) {
             if (is_ambient(light)) switch_off(light);
         }
     },
     "The ambient term is missing: add k_a I_a to every surface that is hit, once, also in shadow.",
     "the ambient term", "ambient-scaled", scale_ambient},
    {"diffuse-missing", is_lit,
     [](Scene& s) { for_each_material(s, [](Material& m) {
                        m.diffuse = {0, 0, 0};
                    }); },
     "The diffuse term is missing: add k_d I (N.L) for every light that reaches the point.",
     "the diffuse term", "diffuse-scaled", scale_diffuse},
    {"specular-missing", has_highlights,
     [](Scene& s) { for_each_material(s, [](Material& m) {
                        m.specular = m.phong = {0, 0, 0};
                    }); },
     "The specular term is missing, or nowhere large enough to be seen: add k_s I (R.V)^n, or (N.H)^n, for "
     "every light that reaches the point. (Or R is wrong: it is 2 N (N.L) - L; or the power n is not of R.V "
     "alone.)",
     "the specular term", "specular-scaled", scale_specular},
    {"unlit", is_lit, [](Scene& s) { std::for_each(s.lights.begin(), s.lights.end(), switch_off); },
     "There is no light at all: surfaces that are hit are black. (Or colors become whole numbers before they "
     "are multiplied by 255.)",
     "the light of all lights together", "light-intensity", scale_all_lights},
    {"emission-missing",
     [](const Scene& s) {
         return is_lit(s) && any_material(s, [](const Material& m) { return !is_zero(m.emission); });
     },
     [](Scene& s) { for_each_material(s, [](Material& m) {
                        m.emission = {0, 0, 0};
                    }); },
     "The emission of surfaces is missing: add it once, without any light.", "the emission",
     "emission-scaled",
     [](Scene& s, double factor) {
         for_each_material(s, [=](Material& m) { m.emission = m.emission * factor; });
     }},
    {"normals-reversed", [](const Scene& s) { return is_lit(s) && any_light(s, is_ambient); },
     [](Scene& s) { for_each_light(s, switch_off); },
     "There is only the ambient term. N or L is reversed, so that N.L is below 0 where the surface is lit (a "
     "sphere's N is P - C, not C - P, and L goes from P to the light), or no light is "
     "added, or every shadow ray hits the surface that it starts from (it starts on the wrong side, goes "
     "away from the light, or counts hits with t < 0), or all lights stand where they reach nothing that is "
     "visible, or are too dim to "
     "be seen.",
     "the light of all lights but the ambient one", "light-intensity", scale_lights},
    {"shadows-missing", has_shadows, [](Scene& s) { s.settings.shadows = false; },
     "Shadows are missing: before adding a light, test whether a ray from the point to it hits a surface."},
    {"shadows-added", [](const Scene& s) { return is_lit(s) && !s.settings.shadows; },
     [](Scene& s) { s.settings.shadows = true; }, "There are shadows, and the reference has none."},
    {.name = "exponent",
     .applies = has_highlights,
     .scale = scale_exponents,
     .scale_text = exponent_text,
     .limit = "specular-missing",
     .limit_text = vanished_text},
    {"exponent", has_highlights,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.shininess = m.phong_shininess = 1; }); },
     "The specular exponent is 1: the highlight is not raised to the power n."},
    {"shading-model", has_highlights, swap_model,
     "The other model of the highlight: Phong uses (R.V)^n, Blinn-Phong (N.H)^n, which is about as wide as "
     "Phong's with a quarter of the exponent."},
    {.name = "shading-model-and-exponent",
     .applies = has_highlights,
     .put = swap_model,
     .scale = scale_exponents,
     .scale_text = other_model_text},
    {"light-color-ignored", has_colored_light, [](Scene& s) { make_lights_grey(s, largest); },
     "The color of lights is ignored, and they are white: multiply each channel by the light's own."},
    {"light-color-ignored", has_colored_light,
     [](Scene& s) { make_lights_grey(s, [](const Color& c) { return c.r; }); },
     "The first channel of a light's color is used for all three: multiply each channel by the light's own."},
    {"light-color-ignored", has_colored_light,
     [](Scene& s) { for_each_light(s, [](Light& l) { l.color.b = l.color.g; }); },
     "The diffuse term's blue is multiplied by the lights' green: multiply each channel by the light's own."},
    {"highlight-not-light-color", has_highlights,
     [](Scene& s) { for_each_light(s, [](Light& l) {
                        l.specular_color = {1, 1, 1};
                    }); },
     "The specular term is not multiplied by the light's color and intensity: highlights are white for "
     "every light. Multiply the whole sum k_d (N.L) + k_s (R.V)^n by it."},
    {"highlight-surface-color", has_highlights,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.specular = m.specular * m.color; }); },
     "Highlights have the surface's color: the specular term is also multiplied by the diffuse color."},
    {"highlight-surface-color", [](const Scene& s) { return has_highlights(s) && any_material(s, has_hue); },
     [](Scene& s) { for_each_material(s, [](Material& m) { m.specular = m.specular * m.diffuse; }); },
     "Highlights have the surface's color: the specular term is also multiplied by the diffuse color, with "
     "its coefficient."},
    {"highlight-surface-color", [](const Scene& s) { return has_highlights(s) && any_material(s, has_hue); },
     [](Scene& s) {
         for_each_material(s, [](Material& m) {
             if (!is_zero(m.specular)) m.specular = m.diffuse;
         });
     },
     k_specular_of_diffuse},
    {"highlight-surface-color", [](const Scene& s) { return has_highlights(s) && any_material(s, has_hue); },
     [](Scene& s) { for_each_material(s, [](Material& m) { m.specular = m.diffuse; }); },
     k_specular_of_diffuse},
    {"highlight-not-surface-color", has_highlights,
     [](Scene& s) {
         for_each_material(s, [](Material& m) {
             const double grey = largest(m.specular);
             m.specular = {grey, grey, grey};
         });
     },
     "Highlights are white, and in the reference they have the surface's color: multiply the specular term "
     "by it."},
    {"ambient-per-light", [](const Scene& s) { return any_light(s, is_ambient) && s.lights.size() > 2; },
     [](Scene& s) {
         double others = 0;
         for_each_light(s, [&](const Light&) { ++others; });
         for (Light& light : s.lights) {
             if (is_ambient(light)) light.color = light.color * others;
         }
     },
     "The ambient term is added once for every light: move it out of the loop over lights."},
    {"light-direction-reversed",
     [](const Scene& s) { return any_light(s, [](const Light& l) { return l.has_direction(); }); },
     [](Scene& s) { for_each_light(s, [](Light& l) { l.to_light = -l.to_light; }); },
     "A directional light shines in the opposite direction: the direction in the file points to the light, "
     "and L is that direction, not its opposite (or the reverse, if the file's format says so)."},
    {"attenuation-missing",
     [](const Scene& s) {
         return any_light(s, [](const Light& l) { return !(l.attenuation == Attenuation{}); });
     },
     [](Scene& s) { for_each_light(s, [](Light& l) { l.attenuation = {}; }); },
     "Light does not decrease with distance: divide by c0 + c1 d + c2 d^2."},
    {"highlight-not-attenuated",
     [](const Scene& s) { return has_highlights(s) && s.conventions.attenuate_highlights; },
     [](Scene& s) { s.conventions.attenuate_highlights = false; },
     "Highlights do not decrease with distance, nor with a spot's angle: multiply both terms."},
    {"flat-color", is_lit, [](Scene& s) { s.settings.shading = Shading::color; },
     "There is no lighting at all: surfaces show their plain color."},
    {"normals-shown", is_lit, [](Scene& s) { s.settings.shading = Shading::normals; },
     "Surfaces show their normals as colors, 0.5 (N + 1): a picture for debugging."},
    {"not-normalized", [](const Scene& s) { return is_lit(s) && s.conventions.normalize; },
     [](Scene& s) { s.conventions.normalize = false; },
     "Vectors do not have unit length: normalise L, V, R (or H) before computing dot products."},
    {"not-normalized",
     [](const Scene& s) { return has_highlights(s) && s.conventions.normalize && !s.camera.lighting_eye; },
     [](Scene& s) {
         s.conventions.normalize = false;
         s.camera.lighting_eye = s.camera.position;
     },
     "Vectors do not have unit length, V neither: normalise L, V, R (or H) before computing dot products."},
    {"back-sides-lit", [](const Scene& s) { return is_lit(s) && s.conventions.clamp_cosines; },
     [](Scene& s) { s.conventions.clamp_cosines = false; },
     "Light from behind a surface counts: N.L is negative there and makes it darker, and R.V may be "
     "negative, which an even exponent turns into a highlight. Use max(0, N.L) and max(0, R.V)."},
    {"highlight-behind", [](const Scene& s) { return has_highlights(s) && s.conventions.specular_gate; },
     [](Scene& s) { s.conventions.specular_gate = false; },
     "Highlights appear on sides that face away from the light: add the specular term only where N.L > 0."},
    {"highlight-gated", [](const Scene& s) { return has_highlights(s) && !s.conventions.specular_gate; },
     [](Scene& s) { s.conventions.specular_gate = true; },
     "Highlights are omitted where N.L <= 0, and the reference has them."},
    {"normals-not-turned", [](const Scene& s) { return s.conventions.facing != Facing::none; },
     [](Scene& s) { s.conventions.facing = Facing::none; },
     "The inner or back side of a surface is dark: turn the normal to the ray that hits it (if N.D > 0, use "
     "-N)."},
    {"normals-turned", [](const Scene& s) { return s.conventions.facing != Facing::all; },
     [](Scene& s) { s.conventions.facing = Facing::all; },
     "Normals are turned to the ray that hits the surface, and in the reference they are not: back sides are "
     "lit."},
    {"normals-turned", [](const Scene& s) { return s.conventions.facing != Facing::open; },
     [](Scene& s) { s.conventions.facing = Facing::open; },
     "Only the normals of open surfaces (planes, open cylinders) are turned to the ray that hits them, "
     "unlike in the reference."},
};

}  // namespace

std::span<const SceneFault> lighting_faults() { return k_lighting; }

}  // namespace glint
