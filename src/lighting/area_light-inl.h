// SPDX-License-Identifier: Apache-2.0
// The points of an area light (docs/lighting.md). Pure functions.
#if defined(GLINT_LIGHTING_AREA_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_LIGHTING_AREA_LIGHT_INL_H_
#undef GLINT_LIGHTING_AREA_LIGHT_INL_H_
#else
#define GLINT_LIGHTING_AREA_LIGHT_INL_H_
#endif

#include "glint/conventions.h"
#include "lighting/light.h"
#include "simd/elementary-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The coordinate from 0 to 1 of sample i of n. moved: its place in its cell, from 0 to 1; 1/2 if it is not
/// moved. center: the first and the last sample are at 0 and 1 (POV-Ray, measured).
template <class T> HWY_INLINE T sample_coordinate(int i, int n, T moved, AreaShading rule) {
    if (rule == AreaShading::samples) return (T(i) + moved) / T(n);
    if (n == 1) return T(0.5);
    return (T(i) + (moved - T(0.5))) / T(n - 1);
}

/// The sides of an oriented light as a surface point sees it: at right angles to the way to its centre, the
/// first one also to the z axis (POV-Ray, measured). On the z axis, the first one is x.
template <class T>
HWY_INLINE void face_point(const AreaGrid& light, const Vector3<T>& point, Vector3<T>& x, Vector3<T>& y) {
    const Vector3<T> way{point.x - T(light.center.x), point.y - T(light.center.y),
                         point.z - T(light.center.z)};
    const T beside = sqrt(way.x * way.x + way.y * way.y), all = length(way), size(length(light.x));
    const auto is_beside = beside > T(0);
    const T safe = select(is_beside, beside, T(1));
    x = {select(is_beside, way.y / safe, T(1)) * size, select(is_beside, -way.x / safe, T(0)) * size, T(0)};
    const Vector3<T> across = cross(way, x);
    const T factor = T(1) / select(all > T(0), all, T(1));
    y = {across.x * factor, across.y * factor, across.z * factor};
}

/// The place from -1/2 to 1/2 of a sample along both sides of a parallelogram. circular: squares around the
/// middle become circles, along the lines through it (POV-Ray, measured).
template <class T> HWY_INLINE void bend_grid(bool circular, T& p, T& q) {
    if (!circular) return;
    const T far = max(abs(p), abs(q)), length = sqrt(p * p + q * q);
    const T factor = far / select(length > T(0), length, T(1));
    p = p * factor;
    q = q * factor;
}

/// The point of the light with coordinates u and v, as this surface point sees it. Of equal ranges of u and
/// v, the areas on a parallelogram that is not circular, a disc and a sphere are equal.
template <class T>
HWY_INLINE Vector3<T> area_point(const AreaGrid& light, T u, T v, const Vector3<T>& point) {
    const auto of = [](Vec3 a) { return Vector3<T>{T(a.x), T(a.y), T(a.z)}; };
    const Vector3<T> center = of(light.center);
    Vector3<T> x = of(light.x), y = of(light.y);
    if (light.oriented) face_point(light, point, x, y);
    if (light.is_parallelogram) {
        T p = u - T(0.5), q = v - T(0.5);
        bend_grid(light.circular, p, q);
        return center + (x * p + y * q);
    }
    const T degrees = T(360) * v;
    if (light.is_disc) {
        const T r = sqrt(max(u, T(0)));
        return center + (x * (r * cos_degrees(degrees)) + y * (r * sin_degrees(degrees)));
    }
    const T height = T(1) - T(2) * u;
    const T r = sqrt(max(T(1) - height * height, T(0)));
    return center + (x * (r * cos_degrees(degrees)) + y * (r * sin_degrees(degrees)) + of(light.z) * height);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
