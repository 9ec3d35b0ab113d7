// SPDX-License-Identifier: Apache-2.0
// Any shape with an affine transform: the ray is transformed to object space, where t is the same.
#if defined(GLINT_GEOMETRY_TRANSFORMED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_TRANSFORMED_INL_H_
#undef GLINT_GEOMETRY_TRANSFORMED_INL_H_
#else
#define GLINT_GEOMETRY_TRANSFORMED_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "geometry/traits.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Maps by a packed object_from_world, m: 12 values, row by row.
struct AffineMap {
    template <class T> static HWY_INLINE Vector3<T> linear(const T* m, Vector3<T> v) {
        return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[4] * v.x + m[5] * v.y + m[6] * v.z,
                m[8] * v.x + m[9] * v.y + m[10] * v.z};
    }
    template <class T> static HWY_INLINE Vector3<T> affine(const T* m, Vector3<T> v) {
        return linear(m, v) + Vector3<T>{m[3], m[7], m[11]};
    }
    /// Its direction is not normalised, so that t is the same.
    template <class T> static HWY_INLINE Ray<T> to_object(const T* m, const Ray<T>& ray) {
        return {affine(m, ray.origin), linear(m, ray.direction)};
    }
    /// Normals are transformed by the transpose of object_from_world; their length changes.
    template <class T> static HWY_INLINE Vector3<T> to_world_normal(const T* m, Vector3<T> n) {
        return {m[0] * n.x + m[4] * n.y + m[8] * n.z, m[1] * n.x + m[5] * n.y + m[9] * n.z,
                m[2] * n.x + m[6] * n.y + m[10] * n.z};
    }
};

/// Packed as the values of the shape, then object_from_world row by row (12 values).
template <class Geometry> struct Transformed : GeometryTraits {
    static constexpr int k_values = Geometry::k_values + 12;
    static constexpr bool k_bounded = Geometry::k_bounded;
    static constexpr int k_crossings = Geometry::k_crossings;
    static constexpr bool k_only_operand = Geometry::k_only_operand;

    static bool contains(const double* p, const Vector3<double>& point) {
        return Geometry::contains(p, AffineMap::affine(p + Geometry::k_values, point));
    }

    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        return Geometry::hit(p, AffineMap::to_object(p + Geometry::k_values, ray), t_min);
    }

    template <class T>
    static HWY_INLINE void crossings(const T* p, const Ray<T>& ray, Crossing<T>* to) requires requires {
        Geometry::crossings(p, ray, to);
    }
    { Geometry::crossings(p, AffineMap::to_object(p + Geometry::k_values, ray), to); }

    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T> point) {
        const T* m = p + Geometry::k_values;
        return normalize(AffineMap::to_world_normal(m, Geometry::normal(p, AffineMap::affine(m, point))));
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
