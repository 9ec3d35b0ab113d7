// SPDX-License-Identifier: Apache-2.0
// What lights add to the picture; spots that are dots, and lights that attenuation makes faint.
#include "check/light_effects.h"

#include <fmt/format.h>

#include <algorithm>

#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr double k_max_radians = 1.6;  // a little more than a right angle
// Shares of the picture, and their ratio: a spot of a degree or two is a dot.
constexpr double k_max_dot = 0.006, k_min_cone = 0.01, k_min_growth = 10;
// Exponents of the cosine: with more than the first, a half of the light is within 2 degrees.
constexpr double k_max_tightness = 1000, k_usual_tightness = 10;
constexpr double k_max_faint_sum = 0.1;  // of several faint lights
constexpr double k_min_dimming = 10;     // by attenuation
constexpr std::size_t k_max_faint_named = 3;

// The distance of the nearest visible point that faces the light; 0: there is none.
double nearest_facing(const VisibleHits& visible, const Light& light) {
    double nearest = 0;
    for (const SurfaceHit& h : visible.seen()) {
        const Vec3 way = light.way_from(h.point);
        if (!(dot(h.normal, way) > 0)) continue;
        const double distance = length(way);
        if (nearest == 0 || distance < nearest) nearest = distance;
    }
    return nearest;
}

}  // namespace

Effect effect_of(const Image& a, const Image& b) {
    Effect effect;
    if (a.rgb.empty()) return effect;
    std::vector<double> differences;
    for (std::size_t i = 0; i + 2 < a.rgb.size() && i + 2 < b.rgb.size(); i += 3) {
        double here = 0;
        for (std::size_t c = i; c < i + 3; ++c)
            here =
                number::max(here, number::abs(static_cast<double>(a.rgb[c]) - static_cast<double>(b.rgb[c])));
        effect.most = number::max(effect.most, here);
        differences.push_back(here);
    }
    const auto share_from = [&](double least) {
        return 3 *
               static_cast<double>(std::count_if(differences.begin(), differences.end(),
                                                 [&](double d) { return d >= least; })) /
               static_cast<double>(a.rgb.size());
    };
    effect.share = share_from(k_half_byte);
    if (effect.most > 0) effect.core = share_from(effect.most / 2);
    return effect;
}

Effect Effects::of(std::span<const std::uint32_t> lights, std::int32_t longest) {
    std::vector<Light> list;
    for (const std::uint32_t index : lights) list.push_back(context_.scene().lights[index]);
    return of(list, longest);
}

Effect Effects::of(const std::vector<Light>& lights, std::int32_t longest) {
    const auto dark = dark_.find(longest);
    const Image& unlit =
        dark == dark_.end() ? dark_.emplace(longest, render_with({}, longest)).first->second : dark->second;
    return effect_of(unlit, render_with(lights, longest));
}

bool check_spot_angle(CheckContext& context, Effects& effects, std::uint32_t index) {
    const Light& light = context.scene().lights[index];
    if (!light.is_spot() || light.outer_angle > k_max_radians) return true;
    Light wide = light;
    wide.inner_angle *= k_degrees_per_radian;
    wide.outer_angle *= k_degrees_per_radian;
    const double now = effects.of(std::vector{light}, k_first_look).share,
                 then = effects.of(std::vector{wide}, k_first_look).share;
    if (now > k_max_dot || then < k_min_cone || then < k_min_growth * now) return true;
    context.report(
        "spot-angle-in-radians", context.at_light(index),
        fmt::format(
            "{} has an outer angle of {:.4g} degrees, so that it lights {} of the picture: is the angle "
            "in radians? {:.4g} radians are {:.3g} degrees, which light {} of it",
            context.light(index), light.outer_angle,
            now == 0 ? "nothing" : fmt::format("only {:.1g}%", 100 * now), light.outer_angle,
            wide.outer_angle, percent_text(then)),
        fmt::format("write the angles in degrees: {:.3g} instead of {:.4g}", wide.outer_angle,
                    light.outer_angle));
    return false;
}

bool check_spot_tightness(CheckContext& context, Effects& effects, std::uint32_t index) {
    Light light = context.scene().lights[index];
    if (!light.is_spot() || light.tightness <= k_max_tightness ||
        context.scene().conventions.spot_falloff != SpotFalloff::cubic)
        return true;
    const double tightness = light.tightness;
    light.specular_color = {0, 0, 0};  // a highlight is a dot, whatever the spot is
    const double now = effects.of(std::vector{light}, k_first_look).core;
    light.tightness = k_usual_tightness;
    const double then = effects.of(std::vector{light}, k_first_look).core;
    if (now > k_max_dot || then < k_min_cone || then < k_min_growth * now) return true;
    context.report(
        "spot-too-tight", context.at_light(index),
        fmt::format(
            "{} has the tightness {:.4g}: its light is cos^{:.4g}, {}; with a tightness of {:.0f} it would "
            "light {} of the picture",
            context.light(index), tightness, tightness,
            now == 0 ? "of which nothing is visible" : fmt::format("a dot of {:.1g}%", 100 * now),
            k_usual_tightness, percent_text(then)),
        "give it a tightness from 0 to 100; for a narrow beam, a small `outer_angle`");
    return false;
}

void check_attenuation(CheckContext& context, const VisibleHits& visible, Effects& effects,
                       std::span<const std::uint32_t> faint) {
    if (faint.empty()) return;
    const double now = effects.of(faint, k_first_look).most;
    if (!(now > 0) || now >= k_max_faint_sum) return;
    std::vector<Light> whole;
    for (const std::uint32_t index : faint) {
        Light light = context.scene().lights[index];
        light.attenuation = {};
        light.fade_distance = light.fade_power = 0;
        whole.push_back(light);
    }
    const double times = effects.of(whole, k_first_look).most / now;
    if (times < k_min_dimming) return;
    const Light& first = context.scene().lights[faint[0]];
    const double distance = nearest_facing(visible, first);
    if (distance == 0) return;
    std::string names;
    for (std::size_t i = 0; i < faint.size() && i < k_max_faint_named; ++i)
        names += (i == 0 ? "" : ", ") + context.light(faint[i]);
    if (faint.size() > k_max_faint_named)
        names += fmt::format(" and {} more", faint.size() - k_max_faint_named);
    context.report(
        "light-attenuated-away", context.at_light(faint[0]),
        fmt::format("attenuation leaves {} of the light of {}: {} {:.3g} units away from the nearest surface "
                    "that faces it, and at most {:.2g} of 255 {} added to a pixel",
                    percent_text(1 / times), names, faint.size() == 1 ? "it is" : "the first is", distance,
                    255 * now, faint.size() == 1 ? "is" : "are together"),
        fmt::format("raise the intensity about {:.2g} times, or reduce the attenuation", times));
}

}  // namespace glint
