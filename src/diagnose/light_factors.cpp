// SPDX-License-Identifier: Apache-2.0
// The factors of a light's terms: attenuation, spot, the power of the highlight.
#include <algorithm>

#include "diagnose/ray_model.h"
#include "math/elementary.h"

namespace glint {

std::optional<Approx> RayModel::attenuation(std::uint32_t index) const {
    const Light& light = model_.scene.lights[index];
    if (!light.has_attenuation()) return Approx(1);
    const Maybe distance = value(Quantity::distance, index);
    if (!distance) return std::nullopt;
    const Attenuation& c = light.attenuation;
    const Approx d = distance->x;
    const auto faded = [&](Approx a) {
        return light.fades()
                   ? a * Approx(2) / (Approx(1) + pow(d / Approx(light.fade_distance), light.fade_power))
                   : a;
    };
    const auto at = [&](double c0, Approx linear, Approx square) {
        return Approx(1) / (Approx(c0) + Approx(c.c1) * linear + Approx(c.c2) * square);
    };
    const auto most_one = [&](Approx a) {
        return model_.scene.conventions.clamp_attenuation ? min(a, Approx(1)) : a;
    };
    switch (trial_.mistake) {
        case TracerMistake::attenuation_missing:
            return Approx(1);
        case TracerMistake::attenuation_linear:
            return faded(most_one(at(c.c0, d, d)));
        case TracerMistake::attenuation_fourth_power:
            return faded(most_one(at(c.c0, trial_.variant == 0 ? d : d * d, d * d * d * d)));
        case TracerMistake::attenuation_without_constant:
            return faded(most_one(at(0, d, d * d)));
        case TracerMistake::attenuation_squared_only:
            return trial_.variant == 0 ? Approx(1) / (d * d) : min(Approx(1) / (d * d), Approx(1));
        case TracerMistake::attenuation_above_one:
            return faded(at(c.c0, d, d * d));
        case TracerMistake::attenuation_of_unit:
            return most_one(at(c.c0, Approx(1), Approx(1)));
        case TracerMistake::attenuation_inverted:
            return Approx(c.c0) + Approx(c.c1) * d + Approx(c.c2) * d * d;
        default:
            return faded(most_one(at(c.c0, d, d * d)));
    }
}

std::optional<Approx> RayModel::spot(std::uint32_t index) const {
    const Light& light = model_.scene.lights[index];
    if (!light.is_spot() || is(TracerMistake::spot_missing)) return Approx(1);
    const Maybe l = value(Quantity::to_light, index);
    if (!l) return std::nullopt;
    const Approx cosine =
        dot(is(TracerMistake::spot_reversed) ? unit(*l) : -unit(*l), unit(ApproxVec(light.axis)));
    double inner = light.inner_angle * k_pi / 180, outer = light.outer_angle * k_pi / 180;
    if (is(TracerMistake::spot_half_angles)) inner /= 2, outer /= 2;
    if (is(TracerMistake::spot_double_angles)) inner *= 2, outer *= 2;
    if (is(TracerMistake::spot_radians)) inner = light.inner_angle, outer = light.outer_angle;
    const double inner_cosine = cos(inner), outer_cosine = cos(outer);
    const auto hard = [&](double edge) {
        return Approx(cosine.v >= edge ? 1 : 0, std::fabs(cosine.v - edge) <= cosine.e ? 1 : 0);
    };
    if (is(TracerMistake::spot_hard_outer)) return hard(outer_cosine);
    if (is(TracerMistake::spot_hard_inner)) return hard(inner_cosine);
    if (inner_cosine == outer_cosine) return hard(outer_cosine);
    const auto inside = [](Approx s) { return min(max(s, Approx(0)), Approx(1)); };
    const Approx by_cosine = inside((cosine - Approx(outer_cosine)) / Approx(inner_cosine - outer_cosine));
    const bool is_linear = model_.scene.conventions.spot_falloff == SpotFalloff::linear;
    if (is(TracerMistake::spot_linear) && trial_.variant == 0) return by_cosine;
    if (is_linear != is(TracerMistake::spot_linear)) {
        const double below = acos(std::clamp(cosine.v - cosine.e, -1.0, 1.0)),
                     above = acos(std::clamp(cosine.v + cosine.e, -1.0, 1.0));
        const Approx angle((below + above) / 2, (below - above) / 2);
        return inside((Approx(outer) - angle) / Approx(outer - inner));
    }
    const Approx smooth = by_cosine * by_cosine * (Approx(3) - Approx(2) * by_cosine);
    return light.tightness > 0 ? smooth * pow(max(cosine, Approx(0)), light.tightness) : smooth;
}

std::optional<Approx> RayModel::highlight_cosine(std::uint32_t light) const {
    bool is_phong = model_.scene.settings.shading == Shading::phong;
    if (is(TracerMistake::blinn_for_phong)) is_phong = false;
    if (is(TracerMistake::phong_for_blinn)) is_phong = true;
    const Maybe s = value(is_phong ? Quantity::r_v : Quantity::n_h, light);
    return s ? std::optional(s->x) : std::nullopt;
}

std::optional<Approx> RayModel::power(std::uint32_t light) const {
    const Shading shading = model_.scene.settings.shading;
    const std::optional<Material> surface = material();
    if (!surface || (shading != Shading::phong && shading != Shading::blinn_phong)) return std::nullopt;
    if (is(TracerMistake::blinn_for_phong) && shading != Shading::phong) return std::nullopt;
    if (is(TracerMistake::phong_for_blinn) && shading != Shading::blinn_phong) return std::nullopt;
    std::optional<Approx> s = highlight_cosine(light);
    if (!s) return std::nullopt;
    if (is(TracerMistake::highlight_absolute)) s = abs(*s);
    if (s->v <= 0) return Approx(0, s->v + s->e > 0 ? pow(Approx(s->v + s->e), surface->shininess).v : 0);
    if (is(TracerMistake::power_exchanged)) {
        if (!(surface->shininess > 0)) return std::nullopt;
        const double log_n = glint::log(surface->shininess), v = glint::exp(s->v * log_n);
        return Approx(v, v * (std::fabs(log_n) * s->e + 8 * k_single_rounding));
    }
    if (is(TracerMistake::exponent_missing)) return *s;
    if (is(TracerMistake::exponent_as_factor)) return *s * Approx(surface->shininess);
    if (is(TracerMistake::exponent_other)) return pow(*s, trial_.number);
    const double factor = is(TracerMistake::exponent_times_4)     ? 4
                          : is(TracerMistake::exponent_divided_4) ? 0.25
                                                                  : 1;
    return pow(*s, factor * surface->shininess);
}

}  // namespace glint
