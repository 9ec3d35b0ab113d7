// SPDX-License-Identifier: Apache-2.0
// Faults of spots and of area lights.
#include <fmt/format.h>

#include <algorithm>

#include "compare/factor_search.h"
#include "compare/scene_faults.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr double k_max_angle = 180;

bool is_spot(const Light& light) { return light.is_spot(); }
bool has_spots(const Scene& s) { return is_lit(s) && any_light(s, is_spot); }
template <class Change> void for_each_spot(Scene& s, Change&& change) {
    for_each_light(s, [&](Light& l) {
        if (l.is_spot()) change(l);
    });
}

void scale_angles(Scene& s, double factor) {
    for_each_spot(s, [=](Light& l) {
        l.inner_angle = std::min(l.inner_angle * factor, k_max_angle);
        l.outer_angle = std::min(l.outer_angle * factor, k_max_angle);
    });
}
std::string angle_text(double factor, bool about) {
    return fmt::format(
        "The angles of spots are {} what they should be: their cones are too {}. Angles are measured off the "
        "axis, so that the whole cone is twice as wide.",
        factor_text(factor, about), factor < 1 ? "narrow" : "wide");
}

void scale_sides(Scene& s, double factor) {
    for_each_area_light(s, [=](Light& l) {
        l.side_u = l.side_u * factor;
        l.side_v = l.side_v * factor;
        l.radius *= factor;
    });
}
std::string size_text(double factor, bool about) {
    return fmt::format("Area lights are {} as large as they should be: the edges of shadows are too {}.",
                       factor_text(factor, about), factor < 1 ? "hard" : "soft");
}

// One sample at the centre, with the emitter's cosine.
void reduce_to_center(Light& light) {
    if (!light.is_flat()) return;
    if (light.is_disc()) {
        const Vec3 axis = normalize(light.axis);
        const Vec3 other = std::abs(axis.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
        light.side_u = normalize(cross(other, axis));
        light.side_v = cross(axis, light.side_u);
        light.kind = LightKind::parallelogram;
    }
    light.samples_u = light.samples_v = 1;
    light.jitter = false;
}

constexpr const char* k_hard_text =
    "Shadows have hard edges: an area light is a point at its centre. Take the mean over points of the "
    "light, with a shadow ray to each.";

constexpr SceneFault k_lights[] = {
    {"spot-missing", has_spots,
     [](Scene& s) { for_each_spot(s, [](Light& l) { l.kind = LightKind::point; }); },
     "Spots shine in all directions, as point lights do: multiply their light by a factor that decreases "
     "with the angle off the axis."},
    {"spot-edge-hard", has_spots,
     [](Scene& s) {
         for_each_spot(s, [](Light& l) {
             l.inner_angle = l.outer_angle;
             l.tightness = 0;
         });
     },
     "The light of spots ends abruptly: between the inner and the outer angle it decreases from 1 to 0."},
    {"spot-falloff", has_spots,
     [](Scene& s) {
         SpotFalloff& rule = s.conventions.spot_falloff;
         rule = rule == SpotFalloff::cubic ? SpotFalloff::linear : SpotFalloff::cubic;
     },
     "The light of spots decreases linearly with the angle, and in the reference by the cubic function of "
     "its cosine, or the reverse."},
    {"spot-tightness-missing",
     [](const Scene& s) {
         return has_spots(s) && any_light(s, [](const Light& l) { return l.tightness > 0; });
     },
     [](Scene& s) { for_each_spot(s, [](Light& l) { l.tightness = 0; }); },
     "The tightness of spots is missing: multiply their light by the cosine off the axis to this power."},
    {.name = "spot-angle-scaled", .applies = has_spots, .scale = scale_angles, .scale_text = angle_text},
    {"shadows-hard", has_area_lights,
     [](Scene& s) { for_each_area_light(s, [](Light& l) { l.kind = LightKind::point; }); }, k_hard_text},
    {"shadows-hard",
     [](const Scene& s) {
         return has_area_lights(s) && any_light(s, [](const Light& l) { return l.has_emitter_cosine(); });
     },
     [](Scene& s) { for_each_area_light(s, reduce_to_center); }, k_hard_text},
    {.name = "area-light-scaled", .applies = has_area_lights, .scale = scale_sides, .scale_text = size_text},
    {"area-light-two-sided",
     [](const Scene& s) {
         return has_area_lights(s) && any_light(s, [](const Light& l) { return l.has_emitter_cosine(); });
     },
     [](Scene& s) { for_each_area_light(s, [](Light& l) { l.one_sided = false; }); },
     "An area light is as bright in all directions: multiply its light by the cosine off its normal, and by "
     "0 behind it."},
    {"area-light-one-sided",
     [](const Scene& s) {
         return has_area_lights(s) &&
                any_light(s, [](const Light& l) { return l.is_flat() && !l.one_sided; });
     },
     [](Scene& s) { for_each_area_light(s, [](Light& l) { l.one_sided = true; }); },
     "The light of an area light decreases with the cosine off its normal, and in the reference it does "
     "not."},
    {"area-light-jitter", has_area_lights,
     [](Scene& s) { for_each_area_light(s, [](Light& l) { l.jitter = !l.jitter; }); },
     "The samples of area lights are moved within their cells, and in the reference they are not, or the "
     "reverse."},
    {"area-light-shading", has_area_lights,
     [](Scene& s) {
         AreaShading& rule = s.conventions.area_shading;
         rule = rule == AreaShading::center ? AreaShading::samples : AreaShading::center;
     },
     "Surfaces are shaded from the centre of an area light, and only its shadow is sampled; in the reference "
     "each sample is a light of its own, or the reverse."},
};

}  // namespace

std::span<const SceneFault> light_kind_faults() { return k_lights; }

}  // namespace glint
