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
    static constexpr bool k_filtered = true;

    static void pack(const Cylinder& c, double* p) {
        pack_axis(c.from, c.to, p);
        p[7] = c.radius, p[8] = c.caps ? 1 : 0;
    }
    static bool is_open(const Cylinder& c) { return !c.caps; }
    static void bounds(const Cylinder& c, Vec3& lo, Vec3& hi) {
        axial_bounds(c.from, c.to, c.radius, c.radius, lo, hi);
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
