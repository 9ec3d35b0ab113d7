// SPDX-License-Identifier: Apache-2.0
// Whether a light is blocked.
#include <algorithm>
#include <limits>

#include "diagnose/ray_model.h"

namespace glint {

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
    if (is(TracerMistake::blocked_within_one) && light.has_position())
        return far > 1 ? is_blocked_from(index, p->value(), to_light * (1 / far))
                       : is_blocked_from(index, p->value(), to_light);
    if (is(TracerMistake::blocked_beyond_light)) return is_blocked_from(index, p->value(), to_light, false);
    if (is_reference() && reference_->hit) {
        for (const LightTerms& terms : reference_->hit->lights)
            if (terms.light == index && terms.has_ray && agree(*p, ApproxVec(reference_->hit->point), 1e-9))
                return terms.blocked;
    }
    return is_blocked_from(index, p->value(), to_light);
}

}  // namespace glint
