// SPDX-License-Identifier: Apache-2.0
// The sphere: packing, bounds, hit, filter, normal.
#if defined(GLINT_GEOMETRY_SPHERE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_SPHERE_INL_H_
#undef GLINT_GEOMETRY_SPHERE_INL_H_
#else
#define GLINT_GEOMETRY_SPHERE_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "glint/shapes.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct SphereGeometry {
    static constexpr int k_values = 4;  // center, radius
    static constexpr bool k_bounded = true;
    static constexpr bool k_bakes_transform = false;
    static constexpr bool k_filtered = true;

    static void pack(const Sphere& s, double* p) {
        p[0] = s.center.x, p[1] = s.center.y, p[2] = s.center.z, p[3] = s.radius;
    }
    static bool is_open(const Sphere&) { return false; }
    static void bounds(const Sphere& s, Vec3& lo, Vec3& hi) {
        const Vec3 r{s.radius, s.radius, s.radius};
        lo = s.center - r, hi = s.center + r;
    }

    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const auto roots = closest_approach(ray.origin - vector3(p), ray.direction, p[3]);
        const T near = roots.b - roots.h, far = roots.b + roots.h;
        const T t = select(near > t_min, near, far);
        return {roots.real && (t > t_min), t};
    }

    /// False only if `hit` is false; needs neither a division nor a square root. False if the line passes
    /// beside the sphere, or if the ray is outside of it at t_min and moves away. The margins are more than a
    /// thousand times the rounding errors of both formulas, which are some 2^-53 |q|.
    template <class T> static HWY_INLINE auto may_hit(const T* p, const Ray<T>& ray, T t_min) {
        const Vector3<T>& d = ray.direction;
        const Vector3<T> q = ray.origin - vector3(p), at = q + d * t_min;
        const Vector3<T> moment = cross(q, d);
        const T radius_2 = p[3] * p[3], q_2 = dot(q, q), at_2 = dot(at, at);
        const auto beside = dot(moment, moment) > (radius_2 * T(1 + 1e-6) + q_2 * T(1e-20)) * dot(d, d);
        const auto leaves = dot(at, d) > T(0) && at_2 - radius_2 > (at_2 + q_2) * T(1e-12);
        return !(beside || leaves);
    }

    /// In single precision: false only if `hit` in double is false. With u = 2^-24, the error from converting
    /// the coordinates, q, b and f is below 16 u (|o| + |c|) in each coordinate; the test allows for twice
    /// that, and for squares so small that they lose precision.
    template <class F> struct Filter {
        static constexpr float k_tiny = 1e-37f;
        Vector3<F> q;
        F reach_squared;
        static HWY_INLINE Filter of(const F* p, const Vector3<F>& o) {
            const F magnitude = (abs(o.x) + abs(o.y) + abs(o.z)) + (abs(p[0]) + abs(p[1]) + abs(p[2]));
            const F reach = p[3] * F(1 + 0x1p-20f) + magnitude * F(0x1p-19f);
            return {o - vector3(p), reach * reach + F(k_tiny)};
        }
        HWY_INLINE auto may_hit(const Vector3<F>& d) const {
            const Vector3<F> c = cross(q, d);
            return !(dot(c, c) * F(1 - 0x1p-20f) > reach_squared * dot(d, d));  // a NaN may hit
        }
    };

    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T> point) {
        return normalize(point - vector3(p));
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
