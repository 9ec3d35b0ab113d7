// SPDX-License-Identifier: Apache-2.0
// The bowl: packing, bounds, hit, normal. A shape added to glint (docs/adding_a_shape.md).
#if defined(GLINT_GEOMETRY_BOWL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_BOWL_INL_H_
#undef GLINT_GEOMETRY_BOWL_INL_H_
#else
#define GLINT_GEOMETRY_BOWL_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct BowlGeometry : GeometryTraits {
    static constexpr int k_values = 2;  // height / radius^2, height

    static void pack(const Bowl& bowl, double* p) {
        p[0] = bowl.height / (bowl.radius * bowl.radius), p[1] = bowl.height;
    }
    static bool is_open(const Bowl&) { return true; }
    static void bounds(const Bowl& bowl, Vec3& lo, Vec3& hi) {
        lo = {-bowl.radius, 0, -bowl.radius}, hi = {bowl.radius, bowl.height, bowl.radius};
    }

    /// Along the ray, k (x^2 + z^2) - y is a s^2 + 2 b s + c, with s from the ray's nearest point to the
    /// origin, so that distance does not reduce precision. The roots are q / a and c / q, of which the second
    /// also exists for a ray along the axis (a = 0).
    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const Vector3<T> d = ray.direction;
        const T start = -(dot(ray.origin, d) / dot(d, d)), k = p[0];
        const Vector3<T> o = ray.origin + d * start;
        const T a = k * (d.x * d.x + d.z * d.z);
        const T b = k * (o.x * d.x + o.z * d.z) - d.y * T(0.5);
        const T c = k * (o.x * o.x + o.z * o.z) - o.y;
        const T discriminant = b * b - a * c;
        const T root = sqrt(max(discriminant, T(0)));
        const T q = -(b + select(b < T(0), -root, root));
        T best = T(1e300);
        for (const T s : {q / a, c / q}) {
            const T t = start + s;
            const auto ok = discriminant >= T(0) && o.y + d.y * s <= p[1] && t > t_min && t < best;
            best = select(ok, t, best);
        }
        return {best < T(1e300), best};
    }

    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T> point) {
        const T slope = T(2) * p[0];
        return normalize(Vector3<T>{point.x * slope, T(-1), point.z * slope});
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
