// SPDX-License-Identifier: Apache-2.0
// The axis-aligned box: packing, bounds, hit, normal.
#if defined(GLINT_GEOMETRY_BOX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_BOX_INL_H_
#undef GLINT_GEOMETRY_BOX_INL_H_
#else
#define GLINT_GEOMETRY_BOX_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"
#include "math/transform.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct BoxGeometry : GeometryTraits {
    static constexpr int k_values = 6;  // min, max
    static constexpr int k_crossings = 2;

    static void pack(const Box& c, double* p) {
        p[0] = c.min.x, p[1] = c.min.y, p[2] = c.min.z;
        p[3] = c.max.x, p[4] = c.max.y, p[5] = c.max.z;
    }
    static bool is_open(const Box&) { return false; }
    static void bounds(const Box& c, Vec3& lo, Vec3& hi) { lo = c.min, hi = c.max; }

    static bool contains(const double* p, const Vector3<double>& point) {
        return p[0] < point.x && point.x < p[3] && p[1] < point.y && point.y < p[4] && p[2] < point.z &&
               point.z < p[5];
    }

    template <class T> static HWY_INLINE void crossings(const T* p, const Ray<T>& ray, Crossing<T>* to) {
        const auto [enter, exit] = interval(p, ray);
        *to = Crossing<T>(enter <= exit, enter, exit);
    }

    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const auto [enter, exit] = interval(p, ray);
        const T t = select(enter > t_min, enter, exit);
        // A NaN or infinity in the ray leaves t at its bounds, or outside them: no hit.
        return {(enter <= exit) && (t > t_min) && (t < T(1e300)), t};
    }

    /// Where the line is between the planes of all sides.
    template <class T> struct Interval { T enter, exit; };
    template <class T> static HWY_INLINE Interval<T> interval(const T* p, const Ray<T>& ray) {
        T enter = T(-1e300), exit = T(1e300);
        const auto slab = [&](T lo, T hi, T o, T d) HWY_ATTR {
            const auto parallel = d == T(0);
            const auto inside = (o >= lo) && (o <= hi);
            const T a = (lo - o) / d, b = (hi - o) / d;
            enter = select(parallel, select(inside, enter, T(1e300)), max(enter, min(a, b)));
            exit = select(parallel, select(inside, exit, T(-1e300)), min(exit, max(a, b)));
        };
        slab(p[0], p[3], ray.origin.x, ray.direction.x);
        slab(p[1], p[4], ray.origin.y, ray.direction.y);
        slab(p[2], p[5], ray.origin.z, ray.direction.z);
        return {enter, exit};
    }

    /// The normal of the face whose plane is nearest to the point.
    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T> point) {
        const auto depth = [](T lo, T hi, T x) HWY_ATTR { return min(abs(x - lo), abs(hi - x)); };
        const auto side = [](T lo, T hi, T x)
                              HWY_ATTR { return select(abs(x - lo) < abs(hi - x), T(-1), T(1)); };
        const T x = depth(p[0], p[3], point.x), y = depth(p[1], p[4], point.y),
                z = depth(p[2], p[5], point.z);
        const T zero(0);
        const auto is_x = (x <= y) && (x <= z), is_y = y <= z;
        return select_vector3(is_x, Vector3<T>{side(p[0], p[3], point.x), zero, zero},
                              select_vector3(is_y, Vector3<T>{zero, side(p[1], p[4], point.y), zero},
                                             Vector3<T>{zero, zero, side(p[2], p[5], point.z)}));
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
