// SPDX-License-Identifier: Apache-2.0
// N, as a shape has it, turned to the ray, and as it is used in products; and V as it is used.
#include "diagnose/ray_model.h"

namespace glint {

Maybe RayModel::own_normal() const {
    const std::optional<std::uint32_t> of = shape();
    if (!of || *of == k_none) return std::nullopt;
    const Shape& shape = model_.scene.shapes[*of];
    const Maybe p = value(Quantity::point);
    if (!p) return std::nullopt;
    if (shape.kind == ShapeKind::sphere && shape.transform == k_none) {
        const Sphere& sphere = model_.scene.get<Sphere>()[shape.index];
        return unit(is(TracerMistake::normal_of_origin) ? *p : *p - ApproxVec(sphere.center));
    }
    const HitModel& hit = expected_hit();
    if (hit.known && hit.shape == *of && hit.normal) {
        const double radius = radius_of(model_.scene, shape);
        const bool is_flat = shape.kind == ShapeKind::plane || shape.kind == ShapeKind::disc ||
                             shape.kind == ShapeKind::triangle || shape.kind == ShapeKind::polygon ||
                             shape.kind == ShapeKind::box;
        const double moved = p->error() + hit.t.e;
        const double error = is_flat ? 2e-6 : radius > 0 ? 1e-5 + 2 * moved / radius : 1e-3;
        ApproxVec normal(*hit.normal);
        normal.x.e = normal.y.e = normal.z.e = error;
        return normal;
    }
    if (shape.transform != k_none) return std::nullopt;
    if (shape.kind == ShapeKind::plane) return unit(ApproxVec(model_.scene.get<Plane>()[shape.index].normal));
    if (shape.kind == ShapeKind::disc) return unit(ApproxVec(model_.scene.get<Disc>()[shape.index].normal));
    if (shape.kind == ShapeKind::triangle) {
        const Triangle& triangle = model_.scene.get<Triangle>()[shape.index];
        return unit(ApproxVec(
            cross(triangle.vertices[1] - triangle.vertices[0], triangle.vertices[2] - triangle.vertices[0])));
    }
    return std::nullopt;
}

Maybe RayModel::turned_normal() const {
    const Maybe own = own_normal(), d = value(Quantity::direction);
    if (!own || !d) return std::nullopt;
    const Shape& shape = model_.scene.shapes[*this->shape()];
    const auto is_open = [&] {
        switch (shape.kind) {
            case ShapeKind::sphere:
            case ShapeKind::box:
            case ShapeKind::torus:
            case ShapeKind::quadric:
            case ShapeKind::quartic:
                return false;
            case ShapeKind::cylinder:
                return !model_.scene.get<Cylinder>()[shape.index].caps;
            case ShapeKind::cone:
                return !model_.scene.get<Cone>()[shape.index].caps;
            default:
                return true;
        }
    };
    const Facing facing = model_.scene.conventions.facing;
    const bool turns = facing != Facing::none && (facing != Facing::open || is_open()) && dot(*own, *d).v > 0;
    const ApproxVec normal = turns && !is(TracerMistake::normal_not_turned) ? -*own : *own;
    if (is(TracerMistake::normal_from_center) && shape.kind == ShapeKind::cylinder &&
        shape.transform == k_none) {
        const Cylinder& cylinder = model_.scene.get<Cylinder>()[shape.index];
        const Maybe p = value(Quantity::point);
        const ApproxVec away =
            unit(*p - ApproxVec(trial_.variant == 0 ? (cylinder.from + cylinder.to) * 0.5 : cylinder.from));
        return dot(away, normal).v < 0 ? -away : away;
    }
    if ((is(TracerMistake::normal_transform) || is(TracerMistake::normal_untransformed)) &&
        shape.transform != k_none) {
        // M n in place of M^-T n: the shape's own n is M^T times the world's.
        const auto& m = model_.scene.transforms[shape.transform].m;
        const Vec3 n = normal.value();
        const Vec3 own_n{m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
                         m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                         m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z};
        const Vec3 turned{m[0][0] * own_n.x + m[0][1] * own_n.y + m[0][2] * own_n.z,
                          m[1][0] * own_n.x + m[1][1] * own_n.y + m[1][2] * own_n.z,
                          m[2][0] * own_n.x + m[2][1] * own_n.y + m[2][2] * own_n.z};
        ApproxVec result = unit(ApproxVec(is(TracerMistake::normal_untransformed) ? own_n : turned));
        for (Approx* c : {&result.x, &result.y, &result.z}) c->e += 3 * normal.error();
        return result;
    }
    return is(TracerMistake::normal_reversed) ? -normal : normal;
}

Maybe RayModel::used_normal() const {
    const Maybe n = value(Quantity::normal);
    if (!n || !is(TracerMistake::normal_not_unit)) return n ? Maybe(about_unit(*n)) : n;
    if (logged(Quantity::normal)) return n;
    const std::optional<std::uint32_t> of = shape();
    if (!of || *of == k_none) return n;
    const Shape& shape = model_.scene.shapes[*of];
    if (shape.kind == ShapeKind::sphere) return *n * Approx(model_.scene.get<Sphere>()[shape.index].radius);
    if (shape.kind == ShapeKind::plane)
        return *n * length(ApproxVec(model_.scene.get<Plane>()[shape.index].normal));
    return n;
}

Maybe RayModel::used_view() const {
    const Maybe v = value(Quantity::view);
    if (!v || !is(TracerMistake::view_not_unit)) return v ? Maybe(about_unit(*v)) : v;
    if (logged(Quantity::view)) return v;
    const Maybe d = value(Quantity::direction);
    return d ? Maybe(-*d) : v;
}

}  // namespace glint
