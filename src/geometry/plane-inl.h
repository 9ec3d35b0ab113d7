// SPDX-License-Identifier: Apache-2.0
// The infinite plane: packing, hit, normal.
#if defined(GLINT_GEOMETRY_PLANE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_PLANE_INL_H_
#undef GLINT_GEOMETRY_PLANE_INL_H_
#else
#define GLINT_GEOMETRY_PLANE_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"
#include "math/aabb.h"
#include "math/transform.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct PlaneGeometry : GeometryTraits {
    static constexpr int k_values = 6;  // point nearest to the origin, unit normal
    static constexpr int k_crossings = 2;
    static constexpr bool k_bounded = false;
    static constexpr bool k_bakes_transform = true;

    static void pack(const Plane& plane, double* p) {
        const Vec3 n = glint::normalize(plane.normal);
        // The point nearest to the origin: a distant one would reduce precision.
        const Vec3 foot = n * glint::dot(plane.point, n);
        p[0] = foot.x, p[1] = foot.y, p[2] = foot.z;
        p[3] = n.x, p[4] = n.y, p[5] = n.z;
    }
    static Plane apply_transform(const Plane& plane, const Affine& world_from_object,
                                 const Affine& object_from_world) {
        return {transform_point(world_from_object, plane.point),
                transform_normal(object_from_world, plane.normal)};
    }
    static bool is_open(const Plane&) { return true; }
    static void bounds(const Plane&, Vec3& lo, Vec3& hi) {
        hi = {k_endless, k_endless, k_endless};
        lo = -hi;
    }

    static bool contains(const double* p, const Vector3<double>& point) {
        return dot(point - vector3(p), vector3(p + 3)) < 0;
    }

    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const Vector3<T> n = vector3(p + 3);
        const T t = dot(vector3(p) - ray.origin, n) / dot(ray.direction, n);
        // A ray in the plane gives NaN or infinity: no hit.
        return {(t > t_min) && (t < T(1e300)), t};
    }

    /// Of the half-space opposite to the normal: the whole line, a half of it, or nothing.
    template <class T> static HWY_INLINE void crossings(const T* p, const Ray<T>& ray, Crossing<T>* to) {
        const Vector3<T> n = vector3(p + 3);
        const T above = dot(ray.origin - vector3(p), n), slope = dot(ray.direction, n), t = -above / slope;
        const T infinity(k_infinity);
        const auto falls = slope<T(0), rises = slope> T(0), inside = above <= T(0);
        to->enter = select(falls, t, select(rises || inside, -infinity, infinity));
        to->exit = select(rises, t, select(falls || inside, infinity, -infinity));
    }

    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T>) { return vector3(p + 3); }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
