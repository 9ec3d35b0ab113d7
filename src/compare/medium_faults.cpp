// SPDX-License-Identifier: Apache-2.0
// Faults of fog, of transparency without refraction, and of light from all directions.
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "compare/factor_search.h"
#include "compare/scene_faults.h"

namespace glint {
namespace {

bool is_shaded(const Scene& s) {
    return s.settings.shading != Shading::color && s.settings.shading != Shading::normals;
}
bool has_fog(const Scene& s) { return s.fog && is_shaded(s); }
template <FogKind kind> bool has_other_fog(const Scene& s) { return has_fog(s) && s.fog->kind != kind; }

// Rays pass surfaces.
bool has_fog_behind_surfaces(const Scene& s) {
    return has_fog(s) && std::any_of(s.materials.begin(), s.materials.end(), [](const Material& m) {
               return m.is_transparent() || m.transmission > 0;
           });
}

void scale_fog(Scene& s, double factor) {
    Fog& fog = *s.fog;
    fog.density *= factor;
    fog.end = fog.start + (fog.end - fog.start) / factor;
}
std::string fog_text(double factor, bool about) {
    return fmt::format("The fog is {} as dense as it should be.", factor_text(factor, about));
}

// Another function of the distance, with 1 / density for the length of the linear one and the reverse.
template <FogKind kind> void set_fog_kind(Scene& s) {
    Fog& fog = *s.fog;
    if (kind == FogKind::linear)
        fog.end = fog.start + 1 / fog.density;
    else if (fog.kind == FogKind::linear)
        fog.density = 1 / (fog.end - fog.start);
    fog.kind = kind;
}
constexpr const char* k_linear_text =
    "The light that passes the fog decreases linearly with the distance, and in the reference exponentially.";
constexpr const char* k_exp_text =
    "The light that passes the fog is exp(-x), x the distance times the density; in the reference it is "
    "another function of the distance.";
constexpr const char* k_exp2_text =
    "The light that passes the fog is exp(-x^2), x the distance times the density; in the reference it is "
    "another function of the distance.";

bool has_transparency(const Scene& s) {
    return is_shaded(s) && any_material(s, [](const Material& m) { return m.is_transparent(); });
}
bool has_filter(const Scene& s) {
    return is_shaded(s) && any_material(s, [](const Material& m) { return m.filter > 0; });
}
bool has_angled_opacity(const Scene& s) {
    return any_material(s, [](const Material& m) { return m.transmit > 0 && m.angled_opacity; });
}
void make_opaque(Scene& s) {
    for_each_material(s, [](Material& m) { m.filter = m.transmit = 0; });
}
bool has_transparent_shadows(const Scene& s) { return has_shadows(s) && has_transparency(s); }
template <TransparentShadow rule> bool has_other_shadow(const Scene& s) {
    return has_transparent_shadows(s) && s.conventions.transparent_shadow != rule;
}
template <TransparentShadow rule> void set_shadow(Scene& s) { s.conventions.transparent_shadow = rule; }
template <Transparency rule> bool has_other_transparency(const Scene& s) {
    return has_transparency(s) && s.conventions.transparency != rule;
}
template <Transparency rule> void set_transparency(Scene& s) { s.conventions.transparency = rule; }

bool has_occlusion(const Scene& s) { return is_lit(s) && s.occlusion.has_value(); }
void scale_occlusion(Scene& s, double factor) { s.occlusion->color = s.occlusion->color * factor; }

constexpr SceneFault k_media[] = {
    {"fog-missing", has_fog, [](Scene& s) { s.fog.reset(); },
     "The fog is missing: mix the light that arrives at the camera with the fog's color, by the distance."},
    {"fog-background", has_fog,
     [](Scene& s) { s.conventions.fog_background = !s.conventions.fog_background; },
     "The background is in the fog, and in the reference it is not, or the reverse."},
    {"fog-distance", has_fog,
     [](Scene& s) {
         FogDistance& rule = s.conventions.fog_distance;
         rule = rule == FogDistance::ray ? FogDistance::depth : FogDistance::ray;
     },
     "The fog depends on the distance along the ray, and in the reference on the depth along the view, or "
     "the reverse."},
    {"fog-extent", has_fog_behind_surfaces,
     [](Scene& s) {
         FogExtent& rule = s.conventions.fog_extent;
         rule = rule == FogExtent::everywhere ? FogExtent::outside_objects : FogExtent::everywhere;
     },
     "Inside transparent objects there is fog, and in the reference there is none, or the reverse."},
    {"fog-start-missing", [](const Scene& s) { return has_fog(s) && s.fog->start != 0; },
     [](Scene& s) { s.fog->start = 0; }, "The fog begins at the camera: subtract `start` from the distance."},
    {.name = "fog-scaled", .applies = has_fog, .scale = scale_fog, .scale_text = fog_text},
    {"fog-kind", has_other_fog<FogKind::exp>, set_fog_kind<FogKind::exp>, k_exp_text},
    {"fog-kind", has_other_fog<FogKind::exp2>, set_fog_kind<FogKind::exp2>, k_exp2_text},
    {"fog-kind", has_other_fog<FogKind::linear>, set_fog_kind<FogKind::linear>, k_linear_text},
    {.name = "fog-kind",
     .applies = has_other_fog<FogKind::exp>,
     .put = set_fog_kind<FogKind::exp>,
     .scale = scale_fog,
     .scale_text = [](double, bool) { return std::string(k_exp_text); }},
    {.name = "fog-kind",
     .applies = has_other_fog<FogKind::exp2>,
     .put = set_fog_kind<FogKind::exp2>,
     .scale = scale_fog,
     .scale_text = [](double, bool) { return std::string(k_exp2_text); }},
    {.name = "fog-kind",
     .applies = has_other_fog<FogKind::linear>,
     .put = set_fog_kind<FogKind::linear>,
     .scale = scale_fog,
     .scale_text = [](double, bool) { return std::string(k_linear_text); }},
    {"transparency-missing", [](const Scene& s) { return has_transparency(s) && !has_angled_opacity(s); },
     make_opaque,
     "Transparent surfaces are opaque: continue the ray straight on, and add what it sees times transmit + "
     "filter * color."},
    {"transparency-missing", [](const Scene& s) { return has_transparency(s) && has_angled_opacity(s); },
     make_opaque,
     "Transparent surfaces are opaque: continue the ray straight on, and add what it sees times transmit + "
     "filter * color; with `angled_opacity`, times 1 - the opacity at this angle."},
    {"transparent-shadow-opaque", has_other_shadow<TransparentShadow::opaque>,
     set_shadow<TransparentShadow::opaque>,
     "Transparent surfaces cast opaque shadows: they must let light through."},
    {"transparent-shadow-missing", has_other_shadow<TransparentShadow::none>,
     set_shadow<TransparentShadow::none>,
     "Transparent surfaces cast no shadow, and in the reference they do."},
    {"transparent-shadow-colored", has_other_shadow<TransparentShadow::colored>,
     set_shadow<TransparentShadow::colored>,
     "The light that passes transparent surfaces is multiplied by transmit + filter * color of each, and in "
     "the reference it is not."},
    {"filter-not-tinted", has_filter,
     [](Scene& s) {
         for_each_material(s, [](Material& m) {
             m.transmit += m.filter;
             m.filter = 0;
         });
     },
     "What is seen through transparent surfaces does not have their color: `filter` multiplies it by the "
     "color, unlike `transmit`."},
    {"transmit-tinted",
     [](const Scene& s) {
         return is_shaded(s) &&
                any_material(s, [](const Material& m) { return m.transmit > 0 && !m.angled_opacity; });
     },
     [](Scene& s) {
         for_each_material(s, [](Material& m) {
             if (m.angled_opacity) return;  // which excludes `filter`
             m.filter += m.transmit;
             m.transmit = 0;
         });
     },
     "What is seen through transparent surfaces has their color: `transmit` is not multiplied by it, unlike "
     "`filter`."},
    {"transparency-highlights", has_other_transparency<Transparency::highlights>,
     set_transparency<Transparency::highlights>,
     "Of a transparent surface's own light, all but the highlights is multiplied by its opacity, unlike in "
     "the reference."},
    {"transparency-blended", has_other_transparency<Transparency::blend>,
     set_transparency<Transparency::blend>,
     "All of a transparent surface's own light is multiplied by its opacity, unlike in the reference."},
    {"transparency-added", has_other_transparency<Transparency::add>, set_transparency<Transparency::add>,
     "Transparent surfaces are too bright: their own light is not multiplied by their opacity."},
    {"transparency-opacity", has_filter,
     [](Scene& s) {
         OpacityRule& rule = s.conventions.opacity;
         rule = rule == OpacityRule::whole ? OpacityRule::brightest : OpacityRule::whole;
     },
     "The opacity of transparent surfaces is 1 - filter - transmit, and in the reference the filter is "
     "multiplied by the brightest channel of the color, or the reverse."},
    {"transparency-counts", has_transparency,
     [](Scene& s) { s.conventions.transparency_counts = !s.conventions.transparency_counts; },
     "A ray through a transparent surface counts as a reflection, and in the reference it does not, or the "
     "reverse."},
    {"occlusion-missing", has_occlusion,
     [](Scene& s) {
         if (s.occlusion->direct == 1)
             s.occlusion.reset();
         else  // it stays, because `direct` applies to other lights
             s.occlusion->color = {0, 0, 0};
     },
     "The light from all directions is missing: k_d times its color, times the part that no shape blocks.",
     "the light from all directions", "occlusion-scaled", scale_occlusion},
    {"occlusion-missing", [](const Scene& s) { return has_occlusion(s) && s.occlusion->direct != 1; },
     [](Scene& s) { s.occlusion.reset(); },
     "The light from all directions is missing, and the other lights are not multiplied by `direct`."},
    {"occlusion-unblocked", [](const Scene& s) { return has_occlusion(s) && s.settings.shadows; },
     [](Scene& s) { s.occlusion->reach = std::numeric_limits<double>::denorm_min(); },
     "Nothing blocks the light from all directions: trace a ray for each of its samples, and leave out those "
     "that hit a shape."},
    {"occlusion-reach",
     [](const Scene& s) {
         return has_occlusion(s) && s.occlusion->reach < std::numeric_limits<double>::infinity();
     },
     [](Scene& s) { s.occlusion->reach = std::numeric_limits<double>::infinity(); },
     "Shapes at any distance block the light from all directions: ignore hits beyond `reach`."},
    {"occlusion-method", has_occlusion,
     [](Scene& s) {
         OcclusionMethod& method = s.occlusion->method;
         method = method == OcclusionMethod::hashed ? OcclusionMethod::fixed : OcclusionMethod::hashed;
     },
     "The samples of the light from all directions are chosen in proportion to the cosine, and in the "
     "reference evenly over the hemisphere, or the reverse."},
};

}  // namespace

std::span<const SceneFault> medium_faults() { return k_media; }

}  // namespace glint
