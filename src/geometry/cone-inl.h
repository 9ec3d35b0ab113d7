// SPDX-License-Identifier: Apache-2.0
// The finite cone, complete or truncated, open or capped: packing, bounds, hit, normal.
#if defined(GLINT_GEOMETRY_CONE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_CONE_INL_H_
#undef GLINT_GEOMETRY_CONE_INL_H_
#else
#define GLINT_GEOMETRY_CONE_INL_H_
#endif

#include "geometry/axial-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct ConeGeometry : GeometryTraits {
    static constexpr int k_values =
        10;  // from, unit axis, height, radius at from, growth of the radius per unit, caps (0 or 1)
    static constexpr int k_crossings = 2;
    static constexpr bool k_filtered = true;

    static void pack(const Cone& c, double* p) {
        const double height = pack_axis(c.from, c.to, p);
        p[7] = c.from_radius, p[8] = (c.to_radius - c.from_radius) / height, p[9] = c.caps ? 1 : 0;
    }
    static bool is_open(const Cone& c) { return !c.caps; }
    static void bounds(const Cone& c, Vec3& lo, Vec3& hi) {
        axial_bounds(c.from, c.to, c.from_radius, c.to_radius, lo, hi);
    }

    static bool contains(const double* p, const Vector3<double>& point) {
        return is_within_axial(p, point, p[7], p[8]);
    }

    /// Solves |across(t)|^2 = r(t)^2 with r(t) = r_0 + k along(t), relative to the ray's closest approach to
    /// the middle of the axis, so that distance does not reduce precision. The roots are q / a and c / q:
    /// a may be 0 (a ray parallel to the side).
    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const Vector3<T> axis = vector3(p + 3), d = ray.direction;
        const T height = p[6], base = p[7], growth = p[8];
        const Vector3<T> to_origin = ray.origin - vector3(p);
        const T start = -(dot(to_origin - axis * (height * T(0.5)), d) / dot(d, d));
        AxialRay<T> r(axis, height, to_origin + d * start, d, start, t_min);
        const T q_radius = base + growth * r.q_along, d_radius = growth * r.d_along;

        const T a = dot(r.d_across, r.d_across) - d_radius * d_radius;
        const T b = dot(r.q_across, r.d_across) - q_radius * d_radius;
        const T c = dot(r.q_across, r.q_across) - q_radius * q_radius;
        const T discriminant = b * b - a * c;
        const T root = sqrt(max(discriminant, T(0)));
        const T sum = -(b + select(b < T(0), -root, root));
        const auto real = discriminant >= T(0);
        r.consider_side(sum / a, real);
        r.consider_side(c / sum, real);
        r.consider_caps(p[9], base, base + growth * height);
        return r.hit();
    }

    template <class F> struct Filter : AxialFilter<F> {
        static HWY_INLINE Filter of(const F* p, const Vector3<F>& o) {
            // The other end's radius, minus its rounding error.
            const F end = p[7] + p[8] * p[6];
            return {AxialFilter<F>::around(p, o, max(p[7], end) + (abs(p[7]) + abs(end)) * F(0x1p-20f))};
        }
    };

    /// A point nearer to a cap's plane than to the lateral surface belongs to the cap.
    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T> point) {
        const Vector3<T> q = point - vector3(p), axis = vector3(p + 3);
        const T along = dot(q, axis);
        const Vector3<T> across = q - axis * along;
        const T distance = length(across);
        const Vector3<T> outward = across / distance - axis * p[8];
        // The apex has no normal: the axis is used.
        const Vector3<T> tip = axis * select(p[8] < T(0), T(1), T(-1));
        const Vector3<T> lateral = select_vector3(distance > T(0), normalize(outward), tip);
        return side_or_cap(lateral, axis, p[6], along, distance - (p[7] + p[8] * along), p[9]);
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
