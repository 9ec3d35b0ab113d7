// SPDX-License-Identifier: Apache-2.0
// The sphere: packing, bounds, hit, filter, normal.
#if defined(GLINT_GEOMETRY_SPHERE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_SPHERE_INL_H_
#undef GLINT_GEOMETRY_SPHERE_INL_H_
#else
#define GLINT_GEOMETRY_SPHERE_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct SphereGeometry : GeometryTraits {
    static constexpr int k_values = 4;  // center, radius
    static constexpr int k_crossings = 2;
    static constexpr bool k_filtered = true;
    static constexpr bool k_cheap = true;
    static constexpr bool k_quick = true;

    static void pack(const Sphere& s, double* p) {
        p[0] = s.center.x, p[1] = s.center.y, p[2] = s.center.z, p[3] = s.radius;
    }
    static bool is_open(const Sphere&) { return false; }
    static void bounds(const Sphere& s, Vec3& lo, Vec3& hi) {
        const Vec3 r{s.radius, s.radius, s.radius};
        lo = s.center - r, hi = s.center + r;
    }

    static bool contains(const double* p, const Vector3<double>& point) {
        const Vector3<double> q = point - vector3(p);
        return dot(q, q) < p[3] * p[3];
    }

    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const auto roots = closest_approach(ray.origin - vector3(p), ray.direction, p[3]);
        const T near = roots.b - roots.h, far = roots.b + roots.h;
        const T t = select(near > t_min, near, far);
        return {roots.real && (t > t_min), t};
    }

    template <class T> static HWY_INLINE void crossings(const T* p, const Ray<T>& ray, Crossing<T>* to) {
        const auto roots = closest_approach(ray.origin - vector3(p), ray.direction, p[3]);
        *to = Crossing<T>(roots.real, roots.b - roots.h, roots.b + roots.h);
    }

    /// What is known of a ray without its intersections, which need a division and a square root.
    template <class T> struct QuickResult {
        decltype(T() < T()) may_hit;  // false only if `hit` is false
        decltype(T() < T()) is_hit;   // true only if `hit` is true; for rays without a limit
    };

    /// may_hit is false if the line passes beside the sphere, or if the ray is outside of it at t = 0 and
    /// moves away; away: 0, or infinite if t_min may be negative. is_hit is true if the line intersects the
    /// sphere, and the center is ahead of the point at t_min. d_2: d·d. start: at least t_min d·d; infinite
    /// for rays with a limit. The margins are hundreds of times the rounding errors of both formulas, which
    /// are some 2^-53 |q|. The ray then also intersects the bounds: they are padded, and sizes and distances
    /// of a scene are at most 1e12, so that t does not overflow.
    template <class T>
    static HWY_INLINE QuickResult<T> quick_test(const T* p, const Ray<T>& ray, T d_2, T start, T away) {
        const Vector3<T>& d = ray.direction;
        const Vector3<T> q = ray.origin - vector3(p), moment = cross(q, d);
        const T radius_2 = p[3] * p[3], q_2 = dot(q, q), b = dot(q, d);
        const T moment_2 = dot(moment, moment), margin = q_2 * T(1e-20) + T(1e-200);
        const auto beside = moment_2 > (radius_2 * T(1 + 1e-6) + margin) * d_2;
        const auto leaves = b > away && q_2 * T(1 - 1e-12) > radius_2 + T(1e-200);
        const auto crosses = moment_2 < (radius_2 * T(1 - 1e-6) - margin) * d_2;
        return {!(beside || leaves), crosses && b < -start};
    }

    /// The same for parallel rays with t_min >= 0. slack: the rounding errors of the formulas and of the
    /// coordinates, relative to the numbers: some 2^-50, or 2^-22 in single precision.
    template <class T> struct ParallelTest {
        static constexpr double k_double_slack = 1e-12, k_single_slack = 0x1p-20, k_tiny = 1e-37;
        Vector3<T> center;
        T reach_2, inner_2, ahead;
        /// start: at least the distance t_min |d|.
        static HWY_INLINE ParallelTest of(const T* p, const ParallelFrame& frame, double slack, T start) {
            const T magnitude = abs(p[0]) + abs(p[1]) + abs(p[2]) + T(frame.magnitude);
            const T margin = (p[3] + magnitude) * T(slack);
            const T reach = p[3] + margin, inner = max(p[3] - margin, T(0));
            return {frame.coordinates(vector3(p)), reach * reach + T(k_tiny), inner * inner - T(k_tiny),
                    -(start * T(1 + slack) + margin)};
        }
        HWY_INLINE QuickResult<T> test(const Vector3<T>& origin) const {
            const Vector3<T> q = origin - center;
            const T beyond = max(q.z, T(0)), across_2 = q.x * q.x + q.y * q.y;
            return {!(across_2 + beyond * beyond > reach_2),  // a NaN may hit
                    across_2 < inner_2 && q.z < ahead};
        }
    };

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
