// SPDX-License-Identifier: Apache-2.0
// The disc: packing, bounds, hit, normal.
#if defined(GLINT_GEOMETRY_DISC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_DISC_INL_H_
#undef GLINT_GEOMETRY_DISC_INL_H_
#else
#define GLINT_GEOMETRY_DISC_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"
#include "math/extent.h"
#include "math/transform.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct DiscGeometry : GeometryTraits {
    static constexpr int k_values = 8;  // center, unit normal, radius, radius of the hole

    static void pack(const Disc& disc, double* p) {
        const Vec3 n = glint::normalize(disc.normal);
        p[0] = disc.center.x, p[1] = disc.center.y, p[2] = disc.center.z;
        p[3] = n.x, p[4] = n.y, p[5] = n.z;
        p[6] = disc.radius, p[7] = disc.hole;
    }
    static bool is_open(const Disc&) { return true; }
    static void bounds(const Disc& disc, Vec3& lo, Vec3& hi) {
        Extent extent;
        extent.add_disc(disc.center, glint::normalize(disc.normal), disc.radius);
        lo = extent.lo, hi = extent.hi;
    }

    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const Vector3<T> q = ray.origin - vector3(p), n = vector3(p + 3);
        // A ray in the disc's plane gives NaN or infinity: no hit.
        const T t = -dot(q, n) / dot(ray.direction, n);
        const Vector3<T> across = q + ray.direction * t;
        const T from_center = dot(across, across);
        return {t > t_min && (from_center <= p[6] * p[6]) && (from_center >= p[7] * p[7]), t};
    }

    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T>) { return vector3(p + 3); }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
