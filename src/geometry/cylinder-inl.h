// The finite cylinder, open or capped: packing, bounds, hit, normal.
#if defined(GLINT_GEOMETRY_CYLINDER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_CYLINDER_INL_H_
#undef GLINT_GEOMETRY_CYLINDER_INL_H_
#else
#define GLINT_GEOMETRY_CYLINDER_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "glint/shapes.h"
#include "math/extent.h"
#include "math/transform.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct CylinderGeometry {
    static constexpr int k_values = 9;  // from, unit axis, height, radius, caps (0 or 1)
    static constexpr bool k_bounded = true;
    static constexpr bool k_takes_maps = false;
    static constexpr bool k_filtered = false;

    static void pack(const Cylinder& c, double* p) {
        const Vec3 axis = c.to - c.from;
        const double height = glint::length(axis);
        const Vec3 a = glint::normalize(axis);
        p[0] = c.from.x, p[1] = c.from.y, p[2] = c.from.z;
        p[3] = a.x, p[4] = a.y, p[5] = a.z;
        p[6] = height, p[7] = c.radius, p[8] = c.caps ? 1 : 0;
    }
    static bool open(const Cylinder& c) { return !c.caps; }

    static void bounds(const Cylinder& c, Vec3& lo, Vec3& hi) {
        const Vec3 axis = glint::normalize(c.to - c.from);
        Extent extent;
        extent.add_disc(c.from, axis, c.radius);
        extent.add_disc(c.to, axis, c.radius);
        lo = extent.lo, hi = extent.hi;
    }

    template <class T> static HWY_INLINE Candidate<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const Triple<T> q = ray.origin - triple(p), axis = triple(p + 3), d = ray.direction;
        const T height = p[6], radius = p[7];
        const T q_along = dot(q, axis), d_along = dot(d, axis);
        const Triple<T> q_across = q - axis * q_along, d_across = d - axis * d_along;

        // Parallel to the axis, the division below gives NaN or infinity, and no lateral hit.
        const auto roots = closest_approach(q_across, d_across, radius);
        const T none = T(1e300);
        T best = none;
        const auto consider = [&](T t, decltype(t < t) ok)
                                  HWY_ATTR { best = select(ok && (t > t_min) && (t < best), t, best); };
        const auto within = [&](T t) HWY_ATTR {
            const T along = q_along + d_along * t;
            return (along >= T(0)) && (along <= height);
        };
        const T near = roots.b - roots.h, far = roots.b + roots.h;
        consider(near, roots.real && within(near));
        consider(far, roots.real && within(far));

        const auto capped = p[8] > T(0);
        if (any(capped)) {
            const auto on_disc = [&](T t) HWY_ATTR {
                const Triple<T> across = q_across + d_across * t;
                return dot(across, across) <= radius * radius;
            };
            const T bottom = -q_along / d_along, top = (height - q_along) / d_along;
            consider(bottom, capped && on_disc(bottom));
            consider(top, capped && on_disc(top));
        }
        return {best < none, best};
    }

    /// A point nearer to a cap than to the lateral surface belongs to the cap.
    template <class T> static HWY_INLINE Triple<T> normal(const T* p, Triple<T> point) {
        const Triple<T> q = point - triple(p), axis = triple(p + 3);
        const T along = dot(q, axis);
        const Triple<T> across = q - axis * along;
        const T distance = length(across);
        const Triple<T> lateral = across / distance;
        const T to_bottom = abs(along), to_top = abs(p[6] - along);
        const auto on_cap = (p[8] > T(0)) && (min(to_bottom, to_top) < abs(distance - p[7]));
        return select_triple(on_cap, select_triple(to_bottom < to_top, -axis, axis), lateral);
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
