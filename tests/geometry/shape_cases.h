// SPDX-License-Identifier: Apache-2.0
#pragma once
// The shapes under test: packed values, and properties that do not use the tested formulas.
#include <algorithm>
#include <array>
#include <string>

#include "geometry/kinds-inl.h"
#include "geometry/random_values.h"

namespace glint::test {

namespace plain = HWY_NAMESPACE;
using Long = long double;
using LongVec = plain::Vector3<Long>;
inline constexpr double k_epsilon = 0x1p-53;

inline LongVec to_long(Vec3 v) { return {v.x, v.y, v.z}; }
template <class T> plain::Vector3<T> triple_of(Vec3 v) { return {T(v.x), T(v.y), T(v.z)}; }
inline Vec3 to_vec(plain::Vector3<double> v) { return {v.x, v.y, v.z}; }

/// A geometry's packed values in another number type.
template <class Geometry, class T> struct Packed {
    std::array<T, Geometry::k_values> values;
    explicit Packed(const double* p) {
        for (int k = 0; k < Geometry::k_values; ++k) values[static_cast<std::size_t>(k)] = T(p[k]);
    }
    const T* data() const { return values.data(); }
};

template <class Geometry, class T> plain::Hit<T> formula_hit(const double* p, Vec3 o, Vec3 d, double t_min) {
    const Packed<Geometry, T> packed(p);
    return Geometry::hit(packed.data(), plain::Ray<T>{triple_of<T>(o), triple_of<T>(d)}, T(t_min));
}

/// A lower bound of a point's distance from the surface, and the outward direction there. By
/// definition, not by the tested formulas.
struct Nearness {
    Long distance;  // 0 on the surface, negative inside where there is an inside
    LongVec outward;
    Long bend = 1e30L;  // the radius of the surface's bend there
};

/// The largest coordinate of a shape's box.
template <class Geometry, class Shape> double reach_of(const Shape& shape) {
    Vec3 lo, hi;
    Geometry::bounds(shape, lo, hi);
    return std::max({-lo.x, -lo.y, -lo.z, hi.x, hi.y, hi.z});
}

struct SphereCase {
    using Geometry = plain::SphereGeometry;
    static constexpr bool k_solid = true, k_convex = true;
    Sphere shape;
    static SphereCase make(Random&, Vec3 at, double size) { return {{at, size}}; }
    void pack(double* p) const { Geometry::pack(shape, p); }
    double max_coordinate() const { return reach_of<Geometry>(shape); }
    double magnitude() const { return length(shape.center) + shape.radius; }
    Nearness nearness(LongVec point) const {
        const LongVec q = point - to_long(shape.center);
        const Long size = plain::length(q);
        return {size - Long(shape.radius), q / size, size};
    }
};

struct PlaneCase {
    using Geometry = plain::PlaneGeometry;
    static constexpr bool k_solid = true, k_convex = true;
    Plane shape;
    static PlaneCase make(Random& random, Vec3 at, double) {
        return {{at, (chance(random, 0.3) ? axis_direction(random) : unit_direction(random)) *
                         log_uniform(random, 1e-3, 1e3)}};
    }
    void pack(double* p) const { Geometry::pack(shape, p); }
    double max_coordinate() const { return 0; }
    double magnitude() const { return length(shape.point); }
    Nearness nearness(LongVec point) const {
        const LongVec n = plain::normalize(to_long(shape.normal));
        return {plain::dot(point - to_long(shape.point), n), n};
    }
};

template <bool caps> struct CylinderCase {
    using Geometry = plain::CylinderGeometry;
    static constexpr bool k_solid = caps, k_convex = true;
    Cylinder shape;
    static CylinderCase make(Random& random, Vec3 at, double size) {
        const Vec3 along = chance(random, 0.3) ? axis_direction(random) : unit_direction(random);
        return {{at, at + along * (size * log_uniform(random, 0.3, 3)), size, caps}};
    }
    void pack(double* p) const { Geometry::pack(shape, p); }
    double max_coordinate() const { return reach_of<Geometry>(shape); }
    double magnitude() const { return length(shape.from) + length(shape.to) + shape.radius; }
    Nearness nearness(LongVec point) const {
        const LongVec axis = to_long(shape.to) - to_long(shape.from), q = point - to_long(shape.from);
        const Long height = plain::length(axis), along = plain::dot(q, axis) / height;
        const LongVec a = axis / height, across = q - a * along;
        const Long from_axis = plain::length(across), side = from_axis - Long(shape.radius);
        const Long below = -along, above = along - height;
        const LongVec outward = across / from_axis;
        if (!caps) {
            // Beyond the ends it is the distance of the end; its sign is meaningless there.
            const Long off = below > 0 ? below : above > 0 ? above : 0;
            return {off > 0 ? plain::sqrt(off * off + side * side) : side, outward, from_axis};
        }
        if (side >= below && side >= above) return {side, outward, from_axis};
        return below > above ? Nearness{below, -a} : Nearness{above, a};
    }
};

template <bool caps> struct ConeCase {
    using Geometry = plain::ConeGeometry;
    static constexpr bool k_solid = caps, k_convex = true;
    Cone shape;
    static ConeCase make(Random& random, Vec3 at, double size) {
        const Vec3 along = chance(random, 0.3) ? axis_direction(random) : unit_direction(random);
        const double from = chance(random, 0.3) ? 0 : size * random.uniform(0.1, 1);
        const double to = from > 0 && chance(random, 0.4) ? 0 : size * random.uniform(0.1, 1);
        return {{at, at + along * (size * log_uniform(random, 0.3, 3)), from, to, caps}};
    }
    void pack(double* p) const { Geometry::pack(shape, p); }
    double max_coordinate() const { return reach_of<Geometry>(shape); }
    double magnitude() const {
        return length(shape.from) + length(shape.to) + shape.from_radius + shape.to_radius;
    }
    Nearness nearness(LongVec point) const {
        const LongVec axis = to_long(shape.to) - to_long(shape.from), q = point - to_long(shape.from);
        const Long height = plain::length(axis), along = plain::dot(q, axis) / height;
        const LongVec a = axis / height, across = q - a * along;
        const Long growth = (Long(shape.to_radius) - Long(shape.from_radius)) / height;
        const Long slant = plain::sqrt(1 + growth * growth), from_axis = plain::length(across);
        const Long side = (from_axis - (Long(shape.from_radius) + growth * along)) / slant;
        const Long below = -along, above = along - height;
        const LongVec outward = (across / from_axis - a * growth) / slant;
        if (!caps) {
            const Long off = below > 0 ? below : above > 0 ? above : 0;
            return {off > 0 ? plain::sqrt(off * off + side * side) : side, outward, from_axis};
        }
        if (side >= below && side >= above) return {side, outward, from_axis};
        return below > above ? Nearness{below, -a} : Nearness{above, a};
    }
};

struct DiscCase {
    using Geometry = plain::DiscGeometry;
    static constexpr bool k_solid = false, k_convex = true;
    Disc shape;
    static DiscCase make(Random& random, Vec3 at, double size) {
        return {{at,
                 (chance(random, 0.3) ? axis_direction(random) : unit_direction(random)) *
                     log_uniform(random, 1e-3, 1e3),
                 size}};
    }
    void pack(double* p) const { Geometry::pack(shape, p); }
    double max_coordinate() const { return reach_of<Geometry>(shape); }
    double magnitude() const { return length(shape.center) + shape.radius; }
    Nearness nearness(LongVec point) const {
        const LongVec n = plain::normalize(to_long(shape.normal)), q = point - to_long(shape.center);
        const Long along = plain::dot(q, n), off = plain::length(q - n * along) - Long(shape.radius);
        return {off > 0 ? plain::sqrt(off * off + along * along) : along, n};
    }
};

struct BoxCase {
    using Geometry = plain::BoxGeometry;
    static constexpr bool k_solid = true, k_convex = true;
    Box shape;
    static BoxCase make(Random& random, Vec3 at, double size) {
        const Vec3 half{random.uniform(0.1, 1) * size, random.uniform(0.1, 1) * size,
                        random.uniform(0.1, 1) * size};
        return {{at - half, at + half}};
    }
    void pack(double* p) const { Geometry::pack(shape, p); }
    double max_coordinate() const { return reach_of<Geometry>(shape); }
    double magnitude() const { return length(shape.min) + length(shape.max); }
    Nearness nearness(LongVec point) const {
        const LongVec lo = to_long(shape.min) - point, hi = point - to_long(shape.max);
        Nearness best{lo.x, {-1, 0, 0}};
        const auto consider = [&](Long distance, LongVec outward) {
            if (distance > best.distance) best = {distance, outward};
        };
        consider(hi.x, {1, 0, 0});
        consider(lo.y, {0, -1, 0});
        consider(hi.y, {0, 1, 0});
        consider(lo.z, {0, 0, -1});
        consider(hi.z, {0, 0, 1});
        return best;
    }
};

struct TriangleCase {
    using Geometry = plain::TriangleGeometry;
    static constexpr bool k_solid = false, k_convex = true;
    Triangle shape;
    static TriangleCase make(Random& random, Vec3 at, double size) {
        const Vec3 n = unit_direction(random), x = perpendicular(random, n), y = cross(n, x);
        // Random shapes, except slivers.
        return {{{at - x * size, at + x * size + y * (size * random.uniform(-0.5, 0.5)),
                  at + y * (size * random.uniform(0.6, 1)) + x * (size * random.uniform(-1, 1))}}};
    }
    void pack(double* p) const { Geometry::pack(shape, p); }
    double max_coordinate() const { return reach_of<Geometry>(shape); }
    double magnitude() const {
        return length(shape.vertices[0]) + length(shape.vertices[1]) + length(shape.vertices[2]);
    }
    Nearness nearness(LongVec point) const {
        LongVec v[3];
        for (int i = 0; i < 3; ++i) v[i] = to_long(shape.vertices[i]);
        const LongVec n = plain::normalize(plain::cross(v[1] - v[0], v[2] - v[0]));
        const Long along = plain::dot(point - v[0], n);
        Long off = 0;
        for (int i = 0; i < 3; ++i) {
            const LongVec edge = v[(i + 1) % 3] - v[i], aside = plain::normalize(plain::cross(edge, n));
            off = std::max(off, plain::dot(point - v[i], aside));
        }
        // The error of a grazing ray's t moves the point along the plane: that tolerance applies beyond an
        // edge.
        const Long allowed = 1e-6L * plain::length(v[1] - v[0]);
        return {off > allowed ? plain::sqrt(off * off + along * along) : along, n};
    }
};

struct TorusCase {
    using Geometry = plain::TorusGeometry;
    static constexpr bool k_solid = true, k_convex = false;
    Torus shape;
    static TorusCase make(Random& random, Vec3 at, double size) {
        const Vec3 axis = chance(random, 0.3) ? axis_direction(random) : unit_direction(random);
        const double tube = size * log_uniform(random, 0.02, 0.49);
        return {{at, axis * log_uniform(random, 1e-3, 1e3), size - tube, tube}};
    }
    void pack(double* p) const { Geometry::pack(shape, p); }
    double max_coordinate() const { return reach_of<Geometry>(shape); }
    double magnitude() const { return length(shape.center) + shape.radius + shape.tube; }
    Nearness nearness(LongVec point) const {
        const LongVec axis = plain::normalize(to_long(shape.axis)), q = point - to_long(shape.center);
        const LongVec across = q - axis * plain::dot(q, axis);
        const LongVec from_circle = q - across * (Long(shape.radius) / plain::length(across));
        const Long distance = plain::length(from_circle);
        return {distance - Long(shape.tube), from_circle / distance, distance};
    }
};

/// The unit sphere, transformed to an ellipsoid.
struct EllipsoidCase {
    using Geometry = plain::Transformed<plain::SphereGeometry>;
    static constexpr bool k_solid = true, k_convex = true;
    Affine world_from_object;
    static EllipsoidCase make(Random& random, Vec3 at, double size) {
        const Affine turn = compose(rotation_x(random.uniform(0, 360)), rotation_y(random.uniform(0, 360)));
        const auto scale = [&] { return size * random.uniform(0.5, 1) * (chance(random, 0.2) ? -1 : 1); };
        return {compose(translation(at), compose(turn, scaling({scale(), scale(), scale()})))};
    }
    void pack(double* p) const {
        plain::SphereGeometry::pack(Sphere{}, p);
        const Affine inverted = inverse(world_from_object).value_or(Affine{});
        int n = plain::SphereGeometry::k_values;
        for (const auto& row : inverted.m) {
            for (const double value : row) p[n++] = value;
        }
    }
    double max_coordinate() const {
        double reach = 0;
        for (const auto& row : world_from_object.m) {
            reach = std::max(reach,
                             std::fabs(row[0]) + std::fabs(row[1]) + std::fabs(row[2]) + std::fabs(row[3]));
        }
        return reach;
    }
    double magnitude() const {
        const auto& m = world_from_object.m;
        Vec3 offset{m[0][3], m[1][3], m[2][3]};
        return length(offset) + length({m[0][0], m[0][1], m[0][2]}) + length({m[1][0], m[1][1], m[1][2]}) +
               length({m[2][0], m[2][1], m[2][2]});
    }
    /// To first order: |object point| - 1 over the length of its gradient.
    Nearness nearness(LongVec point) const {
        double p[Geometry::k_values];
        pack(p);
        const Packed<Geometry, Long> packed(p);
        const Long* m = packed.data() + plain::SphereGeometry::k_values;
        const LongVec q{m[0] * point.x + m[1] * point.y + m[2] * point.z + m[3],
                        m[4] * point.x + m[5] * point.y + m[6] * point.z + m[7],
                        m[8] * point.x + m[9] * point.y + m[10] * point.z + m[11]};
        const Long size = plain::length(q);
        const LongVec g{(m[0] * q.x + m[4] * q.y + m[8] * q.z) / size,
                        (m[1] * q.x + m[5] * q.y + m[9] * q.z) / size,
                        (m[2] * q.x + m[6] * q.y + m[10] * q.z) / size};
        const Long steep = plain::length(g);
        return {(size - 1) / steep, g / steep, 0.5L / steep};
    }
};

}  // namespace glint::test
