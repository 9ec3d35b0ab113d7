// SPDX-License-Identifier: Apache-2.0
// The terms of a light at the hit of a logged ray (docs/lighting.md).
#include <limits>

#include "diagnose/ray_model.h"
#include "math/elementary.h"

namespace glint {
namespace {

// Whether the terms below are all that the material does with a light.
bool is_plain(const Material& m) {
    return m.brilliance == 1 && m.metallic == 0 && m.phong == Color{} && m.outline == 0 &&
           !m.is_transparent();
}

}  // namespace

const LoggedLight* RayModel::logged_light(std::uint32_t light) const {
    for (const LoggedLight& one : ray_.lights)
        if (model_.rules.light_of[one.label] == light) return &one;
    return nullptr;
}

double RayModel::light_factor(Quantity quantity) const {
    if (quantity == Quantity::to_light) return model_.rules.light_sign;
    if (quantity == Quantity::reflected) return model_.rules.reflected_sign;
    return 1 / model_.rules.white[static_cast<std::size_t>(quantity)];
}

Maybe RayModel::logged(Quantity quantity, std::uint32_t light) const {
    const LoggedLight* of = logged_light(light);
    const LoggedValue* value = of != nullptr ? of->find(quantity) : nullptr;
    if (value == nullptr) return std::nullopt;
    const Vec3 v = value->value.value();
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return std::nullopt;
    return value->value * Approx(light_factor(quantity));
}

Maybe RayModel::value(Quantity quantity, std::uint32_t light) const {
    const Maybe own = logged(quantity, light);
    return own ? own : expected(quantity, light);
}

Maybe RayModel::used_light(std::uint32_t light) const {
    const Maybe l = value(Quantity::to_light, light);
    return l && !is(TracerMistake::light_not_unit) ? Maybe(about_unit(*l)) : l;
}

Maybe RayModel::expected(Quantity quantity, std::uint32_t index) const {
    if (index >= model_.scene.lights.size()) return std::nullopt;
    const Light& light = model_.scene.lights[index];
    const std::optional<std::uint32_t> of = shape();
    if (light.is_ambient() || !of || *of == k_none) return std::nullopt;
    const auto number = [](std::optional<Approx> a) {
        return a ? Maybe(ApproxVec(*a, {}, {})) : std::nullopt;
    };
    switch (quantity) {
        case Quantity::to_light: {
            const Maybe p = value(Quantity::point);
            if (!p || light.is_area()) return std::nullopt;
            if (!light.has_position()) {
                const ApproxVec l(light.to_light);
                return is(TracerMistake::light_reversed)         ? -l
                       : is(TracerMistake::directional_as_point) ? l - *p
                                                                 : l;
            }
            const ApproxVec position(light.position);
            if (is(TracerMistake::light_is_position)) return position;
            if (is(TracerMistake::light_from_origin)) {
                const Maybe o = value(Quantity::origin);
                return o ? Maybe(position - *o) : std::nullopt;
            }
            return is(TracerMistake::light_reversed) ? *p - position : position - *p;
        }
        case Quantity::distance: {
            const Maybe p = value(Quantity::point);
            if (!light.has_position() || light.is_area() || !p) return std::nullopt;
            ApproxVec from = *p;
            if (is(TracerMistake::distance_is_t)) return value(Quantity::t);
            if (is(TracerMistake::distance_of_origin) || is(TracerMistake::light_from_origin)) {
                const Maybe o = value(Quantity::origin);
                if (!o) return std::nullopt;
                from = *o;
            }
            const Approx d = length(ApproxVec(light.position) - from);
            if (is(TracerMistake::distance_of_unit)) return number(Approx(1));
            return number(is(TracerMistake::distance_squared) ? d * d : d);
        }
        case Quantity::attenuation:
            return number(attenuation(index));
        case Quantity::spot:
            return number(spot(index));
        case Quantity::n_l: {
            const Maybe n = used_normal(), l = used_light(index);
            if (!n || !l) return std::nullopt;
            if (is(TracerMistake::cosine_of_view)) {
                const Maybe v = used_view();
                return v ? number(dot(*n, *v)) : std::nullopt;
            }
            if (is(TracerMistake::cosine_light_not_unit))
                return number(dot(*n, *value(Quantity::to_light, index)));
            const Approx cosine = dot(*n, *l);
            return number(is(TracerMistake::cosine_absolute) ? abs(cosine) : cosine);
        }
        case Quantity::reflected: {
            const Maybe n = used_normal(), l = used_light(index);
            if (!n || !l) return std::nullopt;
            if (is(TracerMistake::reflected_reversed))
                return trial_.variant == 0 ? -mirrored(*l, *n) : *n * (Approx(2) * dot(*l, *n)) + *l;
            if (is(TracerMistake::reflected_not_doubled)) return *n * dot(*l, *n) - *l;
            return mirrored(*l, *n);
        }
        case Quantity::half: {
            const Maybe l = used_light(index), v = used_view();
            if (!l || !v) return std::nullopt;
            if (is(TracerMistake::half_difference)) return trial_.variant == 0 ? *l - *v : *v - *l;
            return *l + *v;
        }
        case Quantity::r_v: {
            const Maybe r = value(Quantity::reflected, index), v = used_view(), l = used_light(index),
                        n = used_normal();
            if (!r || !v || !l || !n) return std::nullopt;
            // R has the length of L, which matters only where L is used as it is.
            const ApproxVec used = is(TracerMistake::light_not_unit) ||
                                           is(TracerMistake::reflected_not_doubled) ||
                                           is(TracerMistake::normal_not_unit)
                                       ? *r
                                       : about_unit(*r);
            if (is(TracerMistake::highlight_of_light))
                return number(trial_.variant == 0   ? dot(used, *l)
                              : trial_.variant == 1 ? dot(used, *n)
                                                    : dot(*n, *v));
            const Approx cosine = dot(used, *v);
            return number(is(TracerMistake::highlight_reversed) ? -cosine : cosine);
        }
        case Quantity::n_h: {
            const Maybe h = value(Quantity::half, index), n = used_normal(), l = used_light(index),
                        v = used_view();
            if (!h || !n || !l || !v) return std::nullopt;
            if (is(TracerMistake::highlight_of_light))
                return trial_.variant == 0   ? number(dot(*n, *v))
                       : trial_.variant == 1 ? number(dot(*h, *v))
                                             : number(dot(*h, *l));
            const Approx cosine = dot(*n, is(TracerMistake::half_not_unit)
                                              ? (logged(Quantity::half, index) ? *h : (*l + *v) * Approx(0.5))
                                              : about_unit(*h));
            return number(is(TracerMistake::highlight_reversed) ? -cosine : cosine);
        }
        case Quantity::power:
            return number(power(index));
        case Quantity::blocked: {
            const std::optional<bool> blocked = is_blocked(index);
            return blocked ? Maybe(ApproxVec(*blocked ? 1.0 : 0.0, 0, 0)) : std::nullopt;
        }
        case Quantity::diffuse:
        case Quantity::specular:
            return term(quantity, index);
        default:
            return std::nullopt;
    }
}

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

bool RayModel::is_blocked_from(std::uint32_t index, Vec3 point, Vec3 to_light, bool ends_at_light) const {
    const Light& light = model_.scene.lights[index];
    const double size = length(ApproxVec(to_light)).v;
    // A little above the surface, on the side of the light.
    const Maybe n = own_normal();
    const double lift = 1e-4 * std::max(1.0, length(ApproxVec(point)).v);
    Vec3 from = point;
    if (n) from = point + n->value() * (dot(n->value(), to_light) < 0 ? -lift : lift);
    const bool ends = ends_at_light && light.has_position() && model_.scene.conventions.shadow_stops_at_light;
    return model_.is_occluded(
        from, to_light, 0,
        ends ? 1 - lift / std::max(size, 1e-300) : std::numeric_limits<double>::infinity());
}

std::optional<bool> RayModel::is_blocked(std::uint32_t index) const {
    const Light& light = model_.scene.lights[index];
    if (!model_.scene.settings.shadows || !light.casts_shadows || is(TracerMistake::never_blocked))
        return false;
    if (light.is_area()) return std::nullopt;
    const Maybe p = value(Quantity::point);
    if (!p) return std::nullopt;
    const Vec3 to_light = light.way_from(p->value());
    if (is(TracerMistake::shadow_acne)) {
        // From P as it is, with the rounding that it has.
        if (model_.is_occluded(p->value(), to_light, 0,
                               light.has_position() ? 1 : std::numeric_limits<double>::infinity()))
            return true;
        return is_blocked_from(index, p->value(), to_light);
    }
    const double far = length(ApproxVec(to_light)).v;
    if (is(TracerMistake::shadow_inverted)) return !is_blocked_from(index, p->value(), to_light);
    if (is(TracerMistake::shadow_behind_start)) {
        const double end = light.has_position() ? 1 : std::numeric_limits<double>::infinity(),
                     lift = 1e-3 / std::max(far, 1e-300);
        return is_blocked_from(index, p->value(), to_light) ||
               model_.is_occluded(p->value(), to_light, -1e9, std::min(-lift, end));
    }
    if (is(TracerMistake::shadow_ray_from_origin)) {
        const Maybe o = value(Quantity::origin);
        if (!o) return std::nullopt;
        return model_.is_occluded(o->value(), to_light, least_distance(o->value()) / std::max(far, 1e-300),
                                  light.has_position() ? 1 : std::numeric_limits<double>::infinity());
    }
    if (is(TracerMistake::shadow_ray_late)) {
        const double late = model_.scene.conventions.camera_t_min;
        if (!(late > 0)) return std::nullopt;
        const double end = light.has_position() ? 1 : std::numeric_limits<double>::infinity();
        return late < end && model_.is_occluded(p->value(), to_light, late, end);
    }
    if (is(TracerMistake::shadow_ray_reversed)) return is_blocked_from(index, p->value(), -to_light, false);
    if (is(TracerMistake::blocked_to_squared_distance) && light.has_position())
        return is_blocked_from(index, p->value(), to_light * length(ApproxVec(to_light)).v) ||
               is_blocked_from(index, p->value(), to_light);
    if (is(TracerMistake::blocked_beyond_light)) return is_blocked_from(index, p->value(), to_light, false);
    if (is_reference() && reference_->hit) {
        for (const LightTerms& terms : reference_->hit->lights)
            if (terms.light == index && terms.has_ray && agree(*p, ApproxVec(reference_->hit->point), 1e-9))
                return terms.blocked;
    }
    return is_blocked_from(index, p->value(), to_light);
}

// The diffuse or the specular term.
Maybe RayModel::term(Quantity quantity, std::uint32_t index) const {
    const Light& light = model_.scene.lights[index];
    const Conventions& rules = model_.scene.conventions;
    const std::optional<Material> surface = material();
    if (!surface || !model_.is_simple) return std::nullopt;
    if (light.is_area() || !is_plain(*surface)) {
        // As glint has it, where the log agrees so far.
        if (trial_.mistake != TracerMistake::none || !is_reference() || !reference_->hit ||
            shape() != reference_->hit->shape)
            return std::nullopt;
        const Maybe n = value(Quantity::normal);
        if (!n || !agree(unit(*n), ApproxVec(reference_->hit->normal), 1e-4)) return std::nullopt;
        Color sum;
        for (const LightTerms& terms : reference_->hit->lights)
            if (terms.light == index)
                sum = sum + (quantity == Quantity::diffuse ? terms.diffuse : terms.specular);
        ApproxVec result(sum);
        result.x.e = result.y.e = result.z.e = 2e-3;
        return result;
    }
    Maybe n_l = value(Quantity::n_l, index);
    const Maybe blocked = value(Quantity::blocked, index);
    // N.L may be logged after it was clamped.
    if (is(TracerMistake::diffuse_not_clamped) && n_l && n_l->x.v == 0) n_l = expected(Quantity::n_l, index);
    const Maybe att = value(Quantity::attenuation, index), cone = value(Quantity::spot, index);
    if (!n_l || !blocked || !att || !cone) return std::nullopt;
    const ApproxVec black;
    const Approx cosine = n_l->x;
    const bool is_faint =
        rules.light_threshold > 0 && !(cosine.v * att->x.v * cone->x.v > rules.light_threshold);
    if (is_faint) return black;
    const Approx faded = att->x * cone->x;
    if (quantity == Quantity::diffuse) {
        if (blocked->x.v != 0 && !is(TracerMistake::diffuse_shadow_ignored)) return black;
        Approx factor =
            is(TracerMistake::diffuse_not_clamped) || !rules.clamp_cosines ? cosine : max(cosine, Approx(0));
        if (is(TracerMistake::diffuse_cosine_missing)) factor = cosine.v > 0 ? 1 : 0;
        if (is(TracerMistake::diffuse_cosine_squared)) factor = factor * factor;
        if (!is(TracerMistake::diffuse_attenuation_missing)) factor = factor * faded;
        ApproxVec result = ApproxVec(Color{1, 1, 1}) * factor;
        if (!is(TracerMistake::diffuse_color_missing)) {
            result = result * ApproxVec(surface->diffuse);
        } else if (trial_.variant == 1) {
            // The coefficient alone, without the color that it multiplies.
            const double color = std::max({surface->color.r, surface->color.g, surface->color.b});
            const double most = std::max({surface->diffuse.r, surface->diffuse.g, surface->diffuse.b});
            result = result * Approx(color > 0 ? most / color : 1);
        }
        if (is(TracerMistake::diffuse_color_squared)) result = result * ApproxVec(surface->diffuse);
        if (!is(TracerMistake::diffuse_light_missing)) result = result * ApproxVec(light.color);
        if (is(TracerMistake::diffuse_divided_by_pi)) result = result / Approx(k_pi);
        if (is(TracerMistake::diffuse_divided_by_lights)) result = result / Approx(lights_with_direction());
        return result;
    }
    if (blocked->x.v != 0 && !is(TracerMistake::specular_shadow_ignored)) return black;
    const Shading shading = model_.scene.settings.shading;
    if (shading != Shading::phong && shading != Shading::blinn_phong) return black;
    const ApproxVec strength = ApproxVec(surface->specular);
    const bool gates = is(TracerMistake::specular_gate_missing) ? false
                       : is(TracerMistake::specular_gate_added) ? true
                                                                : rules.specular_gate;
    if (gates && cosine.v <= 0) {
        // At the edge rounding decides.
        if (std::fabs(cosine.v) > cosine.e) return black;
        return std::nullopt;
    }
    const Maybe power = value(Quantity::power, index);
    if (!power) return std::nullopt;
    Approx factor = power->x;
    if (is(TracerMistake::specular_times_cosine)) factor = factor * max(cosine, Approx(0));
    if (rules.attenuate_highlights && !is(TracerMistake::specular_attenuation_missing))
        factor = factor * faded;
    ApproxVec result = ApproxVec(Color{1, 1, 1}) * factor;
    if (is(TracerMistake::specular_surface_color)) {
        result = result * ApproxVec(surface->diffuse);
    } else if (!is(TracerMistake::specular_color_missing)) {
        result = result * strength;
    } else if (surface->specular == Color{}) {
        return black;
    } else if (trial_.variant == 1) {
        result = result * Approx(std::max({surface->specular.r, surface->specular.g, surface->specular.b}));
    }
    if (surface->tinted_highlight && !is(TracerMistake::specular_light_missing))
        result = result * ApproxVec(light.specular_color);
    return result;
}

int RayModel::lights_with_direction() const {
    int count = 0;
    for (const Light& light : model_.scene.lights)
        if (!light.is_ambient()) ++count;
    return std::max(count, 1);
}

}  // namespace glint
