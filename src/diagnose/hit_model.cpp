// SPDX-License-Identifier: Apache-2.0
// What a ray hits.
#include "diagnose/ray_model.h"
#include "world/world.h"

namespace glint {

double radius_of(const Scene& scene, const Shape& shape) {
    switch (shape.kind) {
        case ShapeKind::sphere:
            return scene.get<Sphere>()[shape.index].radius;
        case ShapeKind::cylinder:
            return scene.get<Cylinder>()[shape.index].radius;
        case ShapeKind::cone:
            return std::max(scene.get<Cone>()[shape.index].from_radius,
                            scene.get<Cone>()[shape.index].to_radius) /
                   4;
        case ShapeKind::torus:
            return scene.get<Torus>()[shape.index].tube;
        default:
            return 0;  // flat, or not known
    }
}

const HitModel& RayModel::expected_hit() const {
    if (!hit_) hit_ = find_hit();
    return *hit_;
}

HitModel RayModel::find_hit() const {
    HitModel hit;
    const Maybe o = value(Quantity::origin), d = value(Quantity::direction);
    if (!o || !d) return hit;
    const Vec3 origin = o->value(), along = unit(*d).value();
    if (!(dot(along, along) > 0.5)) return hit;
    const bool at_hit = trial_.mistake != TracerMistake::none && info_of(trial_.mistake).at == Quantity::hit;
    if (!at_hit && is_reference()) {
        hit.known = true;
        if (!reference_->hit) return hit;
        hit.shape = reference_->hit->shape;
        const Vec3 used = reference_->hit->normal;
        hit.normal = reference_->hit->turned ? -used : used;
        hit.t = reference_->t * length(ApproxVec(reference_->direction)).v;
        hit.t.e = hit_error(hit, origin, along);
        const Vec3 moved = origin - reference_->origin,
                   turned = along - unit(ApproxVec(reference_->direction)).value();
        const double cosine = std::max(1e-3, std::fabs(dot(used, along)));
        hit.t.e += (length(ApproxVec(moved)).v + o->error() +
                    hit.t.v * (length(ApproxVec(turned)).v + unit(*d).error())) /
                   cosine;
        if (parent_ && !logged(Quantity::origin)) hit.t.e += leaving_distance(origin) / cosine;
        return hit;
    }
    double t_min = parent_ ? least_distance(origin) : model_.scene.conventions.camera_t_min;
    if (at_hit) {
        hit = mistaken_hit(origin, along, t_min);
    } else {
        hit.known = true;
        const std::optional<std::uint32_t> left = parent_ ? parent_->shape() : std::nullopt;
        for (int i = 0; i < 4; ++i) {
            const RayHit found = model_.nearest(origin, along, t_min);
            hit.shape = found.shape;
            if (found.shape == k_none) return hit;
            hit.t = found.t;
            hit.normal = found.normal;
            // The surface that the ray leaves, beside which its origin is not exactly.
            if (!left || found.shape != *left || found.t > leaving_distance(origin)) break;
            t_min = found.t + least_distance(origin);
        }
    }
    if (hit.known && hit.shape != k_none) {
        hit.t.e += hit_error(hit, origin, along);
        if (hit.normal)
            hit.t.e += (o->error() + hit.t.v * unit(*d).error()) /
                       std::max(1e-3, std::fabs(dot(*hit.normal, along)));
    }
    return hit;
}

HitModel RayModel::mistaken_hit(Vec3 origin, Vec3 along, double t_min) const {
    HitModel hit;
    if (is(TracerMistake::self_hit)) {
        // From the origin as it is, with the rounding that it has.
        if (!parent_) return hit;
        const RayHit found = model_.nearest(origin, along, 0);
        hit.known = true;
        hit.shape = found.shape;
        hit.t = {found.t, found.shape == parent_->shape() && found.t < leaving_distance(origin)
                              ? leaving_distance(origin)
                              : 0};
        hit.normal = found.normal;
        return hit;
    }
    const ShapeWorlds& worlds = model_.shape_worlds();
    if (!worlds.exists()) return hit;
    const Maybe logged_d = value(Quantity::direction);
    const double size = length(*logged_d).v;
    if (is(TracerMistake::quadratic_of_unit) && std::fabs(size - 1) < 1e-3) return hit;
    hit.known = true;
    const std::optional<std::uint32_t> left = parent_ ? parent_->shape() : std::nullopt;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        const double begin = is(TracerMistake::behind_origin) || is(TracerMistake::near_root_only) ? -1e9
                             : left == i ? leaving_distance(origin)
                                         : t_min;
        std::vector<double> all = worlds.hits(i, origin, along, begin);
        const Shape& shape = model_.scene.shapes[i];
        if (is(TracerMistake::quadratic_of_unit) && shape.kind == ShapeKind::sphere &&
            shape.transform == k_none) {
            const Sphere& sphere = model_.scene.get<Sphere>()[shape.index];
            const Vec3 oc = origin - sphere.center, d = along * size;
            const double a = trial_.variant == 0 ? 1 : size * size, b = dot(oc, d),
                         c = dot(oc, oc) - sphere.radius * sphere.radius;
            all.clear();
            if (b * b - a * c < 0) continue;
            const double root = std::sqrt(b * b - a * c);
            for (const double t : {-b - root, -b + root})
                if (t * size > begin) all.push_back((trial_.variant == 0 ? t : t * size * size) * size);
        }
        if (all.empty() || (is(TracerMistake::near_root_only) && all[0] < t_min)) continue;
        const double t = is(TracerMistake::far_root) && all.size() > 1 ? all[1] : all[0];
        const bool is_first = hit.shape == k_none;
        const bool replaces = is(TracerMistake::first_shape)      ? is_first
                              : is(TracerMistake::last_shape)     ? true
                              : is(TracerMistake::farthest_shape) ? is_first || t > hit.t.v
                                                                  : is_first || t < hit.t.v;
        if (!replaces) continue;
        hit.shape = static_cast<std::uint32_t>(i);
        hit.t = t;
    }
    return hit;
}

// The rounding of single precision in the usual formulas: that of a sphere takes the root of a difference of
// squares, of which little may be left.
double RayModel::hit_error(const HitModel& hit, Vec3 origin, Vec3 along) const {
    const Shape& shape = model_.scene.shapes[hit.shape];
    const double cosine = hit.normal ? std::max(1e-3, std::fabs(dot(*hit.normal, along))) : 0.1;
    const double far = std::max({1.0, length(ApproxVec(origin)).v, std::fabs(hit.t.v),
                                 length(ApproxVec(origin + along * hit.t.v)).v});
    const double radius = radius_of(model_.scene, shape);
    double squares = 16 * far;
    if (radius > 0) {
        const double away = shape.kind == ShapeKind::sphere
                                ? length(ApproxVec(origin - model_.scene.get<Sphere>()[shape.index].center)).v
                                : far;
        squares += 4 * (away * away + radius * radius) / radius;
    }
    // Programs that take D as a unit vector do not divide by D.D, which rounding moves off 1.
    const Maybe d = logged(Quantity::direction);
    const double off = d ? std::fabs(length(*d).v - 1) : 0;
    return (k_single_rounding * squares + (off < 1e-3 ? 2 * off * std::fabs(hit.t.v) : 0)) / cosine;
}

}  // namespace glint
