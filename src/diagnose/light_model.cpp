// SPDX-License-Identifier: Apache-2.0
// The values of a light at the hit of a logged ray, and what they should be.
#include "diagnose/ray_model.h"

namespace glint {

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
    const auto [known, is_new] = light_values_.try_emplace({quantity, light});
    if (!is_new) return known->second;
    const Maybe own = logged(quantity, light);
    const Maybe found = own ? own : expected(quantity, light);
    light_values_[{quantity, light}] = found;
    return found;
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

}  // namespace glint
