// The causes that are tried by drawing the scene with a fault, as a table: when it can matter, and the fault.
#include "inspect/scene_causes.h"

#include <fmt/format.h>

#include <algorithm>

#include "inspect/picture_edges.h"
#include "world/prepare_camera.h"

namespace glint {
namespace {

bool is_ambient(const Light& light) { return light.kind == LightKind::ambient; }
bool is_zero(const Color& c) { return c == Color{0, 0, 0}; }

template <class Test> bool any_light(const Scene& s, Test&& test) {
    return std::any_of(s.lights.begin(), s.lights.end(), test);
}
template <class Test> bool any_material(const Scene& s, Test&& test) {
    return std::any_of(s.materials.begin(), s.materials.end(), test);
}

bool is_lit(const Scene& s) {
    return any_light(s, [](const Light& l) { return !is_ambient(l); }) &&
           s.settings.shading != Shading::color && s.settings.shading != Shading::normals;
}
bool has_highlights(const Scene& s) {
    return is_lit(s) && s.settings.shading != Shading::diffuse &&
           any_material(s, [](const Material& m) { return !is_zero(m.specular); });
}
bool has_mirrors(const Scene& s) {
    return s.settings.reflections > 0 && any_material(s, [](const Material& m) { return m.mirror > 0; });
}
bool has_glass(const Scene& s) {
    return s.settings.reflections > 0 &&
           any_material(s, [](const Material& m) { return m.transmission > 0; });
}
bool has_shadows(const Scene& s) { return is_lit(s) && s.settings.shadows; }

// ---- Faults that several rows put ----

template <class Change> void for_each_light(Scene& s, Change&& change) {
    for (Light& light : s.lights) {
        if (!is_ambient(light)) change(light);
    }
}
template <class Change> void for_each_material(Scene& s, Change&& change) {
    for (Material& material : s.materials) change(material);
}
template <int Numerator, int Denominator> void scale_exponents(Scene& s) {
    for_each_material(s, [](Material& m) { m.shininess = m.shininess * Numerator / Denominator; });
}
void swap_model(Scene& s) {
    s.settings.shading = s.settings.shading == Shading::phong ? Shading::blinn_phong : Shading::phong;
}
template <int Numerator, int Denominator> void swap_model_and_scale(Scene& s) {
    swap_model(s);
    scale_exponents<Numerator, Denominator>(s);
}
double largest(const Color& c) { return std::max({c.r, c.g, c.b}); }

struct Row {
    const char* name;
    bool (*applies)(const Scene&);
    void (*put)(Scene&);
    const char* explanation;
    const char* part = "";
    const char* scaled = "";
};

constexpr Row k_lighting[] = {
    {"ambient-missing", [](const Scene& s) { return any_light(s, is_ambient); },
     [](Scene& s) { std::erase_if(s.lights, is_ambient); },
     "The ambient term is missing: add k_a I_a to every surface that is hit, once, also in shadow.",
     "the ambient term", "ambient-scaled"},
    {"diffuse-missing", is_lit,
     [](Scene& s) { for_each_material(s, [](Material& m) {
                        m.diffuse = {0, 0, 0};
                    }); },
     "The diffuse term is missing: add k_d I (N.L) for every light that reaches the point.",
     "the diffuse term", "diffuse-scaled"},
    {"specular-missing", has_highlights,
     [](Scene& s) { for_each_material(s, [](Material& m) {
                        m.specular = {0, 0, 0};
                    }); },
     "The specular term is missing: add k_s I (R.V)^n, or (N.H)^n, for every light that reaches the point.",
     "the specular term", "specular-scaled"},
    {"unlit", is_lit, [](Scene& s) { std::erase_if(s.lights, [](const Light&) { return true; }); },
     "No light arrives at all: surfaces that are hit are black.", "the light of all lights together",
     "light-intensity"},
    {"shadows-missing", has_shadows, [](Scene& s) { s.settings.shadows = false; },
     "Shadows are missing: before a light adds anything, see whether a ray from the point to it hits "
     "something."},
    {"shadows-added", [](const Scene& s) { return is_lit(s) && !s.settings.shadows; },
     [](Scene& s) { s.settings.shadows = true; }, "There are shadows where the reference has none."},
    {"shading-model", has_highlights, swap_model,
     "The other model of the highlight: Phong uses (R.V)^n, Blinn-Phong (N.H)^n, which is about as wide as "
     "Phong's "
     "with a quarter of the exponent."},
    {"exponent", has_highlights, scale_exponents<1, 2>,
     "The specular exponent is half of what it should be: highlights are too wide."},
    {"exponent", has_highlights, scale_exponents<2, 1>,
     "The specular exponent is twice what it should be: highlights are too small."},
    {"exponent", has_highlights, scale_exponents<1, 4>,
     "The specular exponent is a quarter of what it should be: highlights are too wide. (Blinn-Phong's needs "
     "to be "
     "about four times Phong's.)"},
    {"exponent", has_highlights, scale_exponents<4, 1>,
     "The specular exponent is four times what it should be: highlights are too small. (Blinn-Phong's needs "
     "to be "
     "about four times Phong's, not Phong's itself.)"},
    {"exponent", has_highlights, [](Scene& s) { for_each_material(s, [](Material& m) { m.shininess = 1; }); },
     "The specular exponent is 1: the highlight is not raised to the power n."},
    {"shading-model-and-exponent", has_highlights, swap_model_and_scale<4, 1>,
     "The other model of the highlight (Phong for Blinn-Phong, or the reverse), with four times the "
     "exponent."},
    {"shading-model-and-exponent", has_highlights, swap_model_and_scale<1, 4>,
     "The other model of the highlight (Phong for Blinn-Phong, or the reverse), with a quarter of the "
     "exponent."},
    {"highlight-not-light-color", has_highlights,
     [](Scene& s) { for_each_light(s, [](Light& l) {
                        l.specular_color = {1, 1, 1};
                    }); },
     "The specular term is not multiplied by the light's colour and intensity: highlights are white whatever "
     "the "
     "light. Multiply all of k_d (N.L) + k_s (R.V)^n by it."},
    {"highlight-surface-color", has_highlights,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.specular = m.specular * m.color; }); },
     "Highlights have the surface's colour: the specular term is multiplied by the diffuse colour, too."},
    {"highlight-not-surface-color", has_highlights,
     [](Scene& s) {
         for_each_material(s, [](Material& m) {
             const double grey = largest(m.specular);
             m.specular = {grey, grey, grey};
         });
     },
     "Highlights are white where the reference has them in the surface's colour: multiply the specular term "
     "by it, "
     "too."},
    {"ambient-per-light", [](const Scene& s) { return any_light(s, is_ambient) && s.lights.size() > 2; },
     [](Scene& s) {
         const auto others = static_cast<double>(
             std::count_if(s.lights.begin(), s.lights.end(), [](const Light& l) { return !is_ambient(l); }));
         for (Light& light : s.lights) {
             if (is_ambient(light)) light.color = light.color * others;
         }
     },
     "The ambient term is added once for every light: move it out of the loop over lights."},
    {"light-direction-reversed",
     [](const Scene& s) {
         return any_light(s, [](const Light& l) { return l.kind == LightKind::directional; });
     },
     [](Scene& s) { for_each_light(s, [](Light& l) { l.to_light = -l.to_light; }); },
     "A directional light shines the wrong way: the direction in the file points to the light, and L is that "
     "direction, not its opposite (or the reverse, by the file's own rule)."},
    {"attenuation-missing",
     [](const Scene& s) {
         return any_light(s, [](const Light& l) { return !(l.attenuation == Attenuation{}); });
     },
     [](Scene& s) { for_each_light(s, [](Light& l) { l.attenuation = {}; }); },
     "Lights do not get weaker with distance: divide by c0 + c1 d + c2 d^2."},
    {"flat-color", is_lit, [](Scene& s) { s.settings.shading = Shading::color; },
     "There is no lighting at all: surfaces show their plain colour."},
    {"normals-shown", is_lit, [](Scene& s) { s.settings.shading = Shading::normals; },
     "Surfaces show their normals as colours, 0.5 (N + 1): what one draws to look for mistakes."},
    {"not-normalized", [](const Scene& s) { return is_lit(s) && s.conventions.normalize; },
     [](Scene& s) { s.conventions.normalize = false; },
     "Vectors are not of unit length: normalise L, V, R (or H) before taking dot products."},
    {"back-sides-lit", [](const Scene& s) { return is_lit(s) && s.conventions.clamp_cosines; },
     [](Scene& s) { s.conventions.clamp_cosines = false; },
     "Light from behind a surface is counted (negative): take max(0, N.L) and max(0, R.V)."},
    {"highlight-behind", [](const Scene& s) { return has_highlights(s) && s.conventions.specular_gate; },
     [](Scene& s) { s.conventions.specular_gate = false; },
     "Highlights appear on sides that face away from the light: add the specular term only where N.L > 0."},
    {"highlight-gated", [](const Scene& s) { return has_highlights(s) && !s.conventions.specular_gate; },
     [](Scene& s) { s.conventions.specular_gate = true; },
     "Highlights are left out where N.L <= 0, and the reference keeps them."},
    {"normals-not-turned", [](const Scene& s) { return s.conventions.facing != Facing::none; },
     [](Scene& s) { s.conventions.facing = Facing::none; },
     "The inner or back side of a surface is dark: turn the normal to the ray that sees it (if N.D > 0, take "
     "-N)."},
    {"normals-turned", [](const Scene& s) { return s.conventions.facing != Facing::all; },
     [](Scene& s) { s.conventions.facing = Facing::all; },
     "Normals are turned to the ray that sees them, and in the reference they are not: back sides are lit."},
    {"normals-turned", [](const Scene& s) { return s.conventions.facing != Facing::open; },
     [](Scene& s) { s.conventions.facing = Facing::open; },
     "Normals of open surfaces alone (planes, open cylinders) are turned to the ray that sees them, unlike "
     "in the "
     "reference."},
};

constexpr Row k_tracing[] = {
    {"acne", has_shadows, [](Scene& s) { s.conventions.epsilon = 0; },
     "Dark specks on lit surfaces (acne): a shadow ray hits the very surface it leaves. Start it a little "
     "off the "
     "surface, or ignore hits with t below a small epsilon."},
    {"acne", has_shadows,
     [](Scene& s) {
         s.conventions.offset = Offset::ray;
         s.conventions.epsilon = 0;
     },
     "Dark specks on lit surfaces (acne): a shadow ray hits the very surface it leaves. Start it a little "
     "off the "
     "surface, or ignore hits with t below a small epsilon."},
    {"shadow-past-light", has_shadows, [](Scene& s) { s.conventions.shadow_stops_at_light = false; },
     "What is behind a light casts a shadow, too: a shadow ray to a point light ends at the light, so only "
     "hits "
     "before it (t < distance) count."},
    {"reflections-missing", has_mirrors, [](Scene& s) { s.settings.reflections = 0; },
     "Mirrors are missing: follow the ray reflected at N and mix what it sees with the surface's own "
     "colour."},
    {"reflections-one-fewer", [](const Scene& s) { return has_mirrors(s) && s.settings.reflections > 1; },
     [](Scene& s) { --s.settings.reflections; },
     "One level of reflection too few: the recursion stops one mirror early."},
    {"reflections-one-more",
     [](const Scene& s) { return has_mirrors(s) && s.settings.reflections < k_max_reflections; },
     [](Scene& s) { ++s.settings.reflections; },
     "One level of reflection too many: the recursion stops one mirror late."},
    {"mirror-limit-dark",
     [](const Scene& s) { return has_mirrors(s) && s.conventions.limit != LimitRule::drop; },
     [](Scene& s) { s.conventions.limit = LimitRule::drop; },
     "Mirrors are too dark where the recursion ends: at the last level return the surface's own colour "
     "whole, not "
     "mixed with black."},
    {"mirror-limit-bright",
     [](const Scene& s) { return has_mirrors(s) && s.conventions.limit != LimitRule::keep; },
     [](Scene& s) { s.conventions.limit = LimitRule::keep; },
     "Mirrors are too bright where the recursion ends: at the last level mix the surface's own colour with "
     "black."},
    {"mirror-miss-black",
     [](const Scene& s) { return has_mirrors(s) && s.conventions.mirror_miss != MissRule::black; },
     [](Scene& s) { s.conventions.mirror_miss = MissRule::black; },
     "Mirrors are too dark where they look out of the scene: a reflected ray that hits nothing sees the "
     "background, not black."},
    {"mirror-miss-background",
     [](const Scene& s) { return has_mirrors(s) && s.conventions.mirror_miss != MissRule::background; },
     [](Scene& s) { s.conventions.mirror_miss = MissRule::background; },
     "A reflected ray that hits nothing sees the background, and in the reference black."},
    {"mirror-added", [](const Scene& s) { return has_mirrors(s) && s.conventions.mirror != MirrorRule::add; },
     [](Scene& s) { s.conventions.mirror = MirrorRule::add; },
     "Mirrors are too bright: the reflected colour is added to the local one in place of mixing the two, "
     "(1 - a) local + a reflected."},
    {"mirror-blended",
     [](const Scene& s) { return has_mirrors(s) && s.conventions.mirror != MirrorRule::blend; },
     [](Scene& s) { s.conventions.mirror = MirrorRule::blend; },
     "Mirrors are too dark: the reflected colour is mixed with the local one, and in the reference added to "
     "it."},
    {"glass-missing", has_glass,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.transmission = 0; }); },
     "Glass is opaque: follow the refracted ray."},
    {"refraction-missing", has_glass, [](Scene& s) { for_each_material(s, [](Material& m) { m.ior = 1; }); },
     "Rays go straight through glass: bend them by Snell's law."},
    {"glass-shadow", has_glass,
     [](Scene& s) {
         s.conventions.glass_shadow =
             s.conventions.glass_shadow == GlassShadow::none ? GlassShadow::opaque : GlassShadow::none;
     },
     "Glass casts a shadow and in the reference it does not, or the reverse."},
    {"background", [](const Scene& s) { return !is_zero(s.background); },
     [](Scene& s) {
         s.background = {0, 0, 0};
     },
     "The background is black: a ray that hits nothing returns the scene's background colour."},
    {"field-of-view",
     [](const Scene& s) {
         return !s.camera.frame && s.camera.projection == Projection::perspective &&
                s.settings.width != s.settings.height;
     },
     [](Scene& s) { s.camera.fov_axis = s.camera.fov_axis == FovAxis::x ? FovAxis::y : FovAxis::x; },
     "The field of view is taken along the other side of the picture: width in place of height, or the "
     "reverse."},
};

// Turns the camera so that its rays pass (dx, dy) pixels further right and down.
void shift_rays(Scene& s, double dx, double dy) {
    const PreparedCamera camera = prepare_camera(s.camera, s.settings);
    const Vec3 step = camera.right * (dx / s.settings.width) - camera.up * (dy / s.settings.height);
    const bool perspective = s.camera.projection == Projection::perspective;
    s.camera.frame = {camera.right, camera.up, perspective ? camera.forward + step : camera.forward};
    if (!perspective) s.camera.position = s.camera.position + step;
}

void add_half_shifts(const Scene& scene, std::vector<SceneCause>& causes) {
    if (scene.conventions.pixel_sample == PixelSample::whole) return;  // its pixels are world units
    for (const auto& [dx, dy] :
         {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}) {
        causes.push_back(
            {"shifted-half-pixel",
             fmt::format("Everything is half a pixel {}: rays pass through a pixel's middle (x + "
                         "0.5) here and its corner there.",
                         direction_text(dx, dy)),
             [dx = dx, dy = dy](Scene& s) { shift_rays(s, -0.5 * dx, -0.5 * dy); }});
    }
}

// "light 2 (\"lamp\")": lights other than ambient count from 1.
std::string light_text(const Scene& scene, std::uint32_t index, int number) {
    const std::string_view name = scene.light_texts.name(index);
    return name.empty() ? fmt::format("light {}", number) : fmt::format("light {} (\"{}\")", number, name);
}

constexpr int k_most_lights = 8;  // tried one by one

void add_single_lights(const Scene& scene, std::vector<SceneCause>& causes) {
    std::vector<std::uint32_t> lights;
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        if (!is_ambient(scene.lights[i])) lights.push_back(i);
    }
    if (!is_lit(scene) || lights.size() < 2 || lights.size() > k_most_lights) return;
    for (std::size_t k = 0; k < lights.size(); ++k) {
        const std::string text = light_text(scene, lights[k], static_cast<int>(k) + 1);
        causes.push_back(
            {"light-missing",
             fmt::format("The light of {} is missing, or never arrives: sum over all lights.", text),
             [i = lights[k]](Scene& s) { s.lights.erase(s.lights.begin() + i); }, text, "light-scaled"});
    }
    for (std::size_t k = 0; lights.size() > 2 && k < lights.size(); ++k) {
        causes.push_back(
            {"light-alone",
             fmt::format("Only {} shines: add up the lights (a sum that is overwritten keeps the "
                         "last, a return inside the loop the first).",
                         light_text(scene, lights[k], static_cast<int>(k) + 1)),
             [i = lights[k]](Scene& s) {
                 const Light kept = s.lights[i];
                 std::erase_if(s.lights, [](const Light& l) { return !is_ambient(l); });
                 s.lights.push_back(kept);
             }});
    }
}

constexpr int k_most_levels = 8;  // of reflection that are tried one by one

void add_reflection_levels(const Scene& scene, std::vector<SceneCause>& causes) {
    const int asked = scene.settings.reflections;
    if (!has_mirrors(scene)) return;
    for (int n = 1; n < std::min(asked - 1, k_most_levels); ++n) {
        causes.push_back({"reflections-fewer",
                          fmt::format("The recursion stops after {} of {} levels of reflection.", n, asked),
                          [n](Scene& s) { s.settings.reflections = n; }});
    }
}

void add_sample_counts(const Scene& scene, std::vector<SceneCause>& causes) {
    for (const int n : {1, 2, 3, 4}) {
        if (n == scene.settings.samples) continue;
        causes.push_back(
            {"anti-aliasing",
             fmt::format("Only edges differ: {} x {} samples in a pixel, where the scene asks for {} x {}.",
                         n, n, scene.settings.samples, scene.settings.samples),
             [n](Scene& s) { s.settings.samples = n; }});
    }
}

}  // namespace

std::vector<SceneCause> scene_causes(const Scene& scene) {
    std::vector<SceneCause> causes;
    const auto add = [&](std::span<const Row> rows) {
        for (const Row& row : rows) {
            if (row.applies(scene))
                causes.push_back({row.name, row.explanation, row.put, row.part, row.scaled});
        }
    };
    add_single_lights(scene, causes);
    add(k_lighting);
    add(k_tracing);
    add_reflection_levels(scene, causes);
    add_half_shifts(scene, causes);
    add_sample_counts(scene, causes);
    return causes;
}

}  // namespace glint
