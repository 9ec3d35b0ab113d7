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

/// The point of the light with coordinates u and v. Of equal ranges of u and v, the areas on a parallelogram,
/// a disc and a sphere are equal.
template <class T> HWY_INLINE Vector3<T> area_point(const AreaGrid& light, T u, T v) {
    const auto of = [](Vec3 a) { return Vector3<T>{T(a.x), T(a.y), T(a.z)}; };
    const Vector3<T> center = of(light.center), x = of(light.x), y = of(light.y);
    if (light.is_parallelogram) return center + (x * (u - T(0.5)) + y * (v - T(0.5)));
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
