// SPDX-License-Identifier: Apache-2.0
// The finite cylinder, open or capped: packing, bounds, hit, normal.
#if defined(GLINT_GEOMETRY_CYLINDER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_CYLINDER_INL_H_
#undef GLINT_GEOMETRY_CYLINDER_INL_H_
#else
#define GLINT_GEOMETRY_CYLINDER_INL_H_
#endif

#include "geometry/axial-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct CylinderGeometry : GeometryTraits {
    static constexpr int k_values = 9;  // from, unit axis, height, radius, caps (0 or 1)
    static constexpr int k_crossings = 2;
    static constexpr bool k_filtered = true;

    static void pack(const Cylinder& c, double* p) {
        pack_axis(c.from, c.to, p);
        p[7] = c.radius, p[8] = c.caps ? 1 : 0;
    }
    static bool is_open(const Cylinder& c) { return !c.caps; }
    static void bounds(const Cylinder& c, Vec3& lo, Vec3& hi) {
        axial_bounds(c.from, c.to, c.radius, c.radius, lo, hi);
    }

    static bool contains(const double* p, const Vector3<double>& point) {
        return is_within_axial(p, point, p[7], 0);
    }

    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        AxialRay<T> r(vector3(p + 3), p[6], ray.origin - vector3(p), ray.direction, T(0), t_min);
        // For a ray parallel to the axis, the division gives NaN or infinity, and no lateral hit.
        const auto roots = closest_approach(r.q_across, r.d_across, p[7]);
        if (any(roots.real)) {
            r.consider_side(roots.b - roots.h, roots.real);
            r.consider_side(roots.b + roots.h, roots.real);
        }
        r.consider_caps(p[8], p[7], p[7]);
        return r.hit();
    }

    /// Of a cylinder with caps: the interval within the side, and that between the caps.
    template <class T> static HWY_INLINE void crossings(const T* p, const Ray<T>& ray, Crossing<T>* to) {
        const Vector3<T> axis = vector3(p + 3), q = ray.origin - vector3(p);
        const T q_along = dot(q, axis), d_along = dot(ray.direction, axis), height = p[6], radius = p[7];
        const Vector3<T> q_across = q - axis * q_along, d_across = ray.direction - axis * d_along;
        const auto roots = closest_approach(q_across, d_across, radius);
        const T infinity(k_infinity);
        const auto is_parallel = !(dot(d_across, d_across) > T(0));
        const auto within = dot(q_across, q_across) <= radius * radius;
        const T side_enter = select(is_parallel, -infinity, roots.b - roots.h),
                side_exit = select(is_parallel, infinity, roots.b + roots.h);
        const T bottom = -q_along / d_along, top = (height - q_along) / d_along;
        const auto is_flat = d_along == T(0);
        const auto between = q_along >= T(0) && q_along <= height;
        const T enter = max(side_enter, select(is_flat, -infinity, min(bottom, top))),
                exit = min(side_exit, select(is_flat, infinity, max(bottom, top)));
        const auto meets_side = (is_parallel && within) || and_not(roots.real, is_parallel);
        const auto valid = meets_side && (between || !is_flat) && enter <= exit;
        *to = Crossing<T>(valid, enter, exit);
    }

    template <class F> struct Filter : AxialFilter<F> {
        static HWY_INLINE Filter of(const F* p, const Vector3<F>& o) {
            return {AxialFilter<F>::around(p, o, p[7])};
        }
    };

    /// A point nearer to a cap than to the lateral surface belongs to the cap.
    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T> point) {
        const Vector3<T> q = point - vector3(p), axis = vector3(p + 3);
        const T along = dot(q, axis);
        const Vector3<T> across = q - axis * along;
        const T distance = length(across);
        return side_or_cap(across / distance, axis, p[6], along, distance - p[7], p[8]);
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
