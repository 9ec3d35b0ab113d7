// SPDX-License-Identifier: Apache-2.0
// The formulas of POV-Ray's finishes (measured; docs/lighting.md): brilliance, metals, and mirrors that
// depend on the angle; and of Tachyon's outlines and Raster3D's opacity. Pure functions. Those with a power,
// a cosine or an arc cosine are not inline: the kernels call them from many places, and few scenes use them.
#if defined(GLINT_LIGHTING_FINISH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_LIGHTING_FINISH_INL_H_
#undef GLINT_LIGHTING_FINISH_INL_H_
#else
#define GLINT_LIGHTING_FINISH_INL_H_
#endif

#include "lighting/phong-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The factor of k_d I_l,d: (N·L)^brilliance. With a brilliance of 1, the bits of diffuse_term().
template <class T> HWY_NOINLINE T brilliant_term(T n_l, T brilliance, const LightingRules& rules) noexcept {
    const T cosine = diffuse_term(n_l, rules);
    return select(brilliance == T(1), cosine, highlight_power(cosine, brilliance, rules));
}

/// F, the reflectance of a metal, by the cosine of the angle to its normal: 0 up to about 5 degrees, 1 from
/// about 90 degrees on. 0.014567225 / (a - 1.12)^2 - 0.011612903 within 0 and 1, a = acos(cosine) / (pi/2).
template <class T> HWY_NOINLINE T metal_reflectance(T cosine) noexcept {
    constexpr double k_per_radian = 0x1.45f306dc9c883p-1;  // 2 / pi
    const T x = acos(cosine) * T(k_per_radian) - T(1.12);
    return min(max(T(0.014567225) / (x * x) - T(0.011612903), T(0)), T(1));
}

/// The color of what a metal reflects: 1 + metallic (1 - F) (color - 1). 1 if metallic is 0.
template <class T> HWY_INLINE Vector3<T> metal_tint(Vector3<T> color, T metallic, T cosine) {
    const T part = metallic * (T(1) - metal_reflectance(cosine));
    return {T(1) + part * (color.x - T(1)), T(1) + part * (color.y - T(1)), T(1) + part * (color.z - T(1))};
}

/// a of a mirror whose normal has this cosine with the ray: least + (most - least) (1 - cosine)^falloff; with
/// a falloff of 0, `most`.
template <class T> HWY_NOINLINE T angled_mirror(T least, T most, T falloff, T cosine) noexcept {
    const T power = pow(max(T(1) - cosine, T(0)), falloff);
    return select(falloff == T(0), most, least + (most - least) * power);
}

/// Raster3D's transparency of a surface whose normal has this cosine, 0 to 1, with the ray: 1 - s^2 / 4, s =
/// 1 + cos(pi transmit cosine) (Tachyon, measured).
template <class T> HWY_NOINLINE T angled_transmit(T transmit, T cosine) noexcept {
    constexpr double k_pi = 0x1.921fb54442d18p+1;
    const T s = T(1) + cos(T(k_pi) * transmit * cosine);
    return T(1) - s * s * T(0.25);
}

/// The factor of diffuse light on a surface with an outline, whose normal has this cosine, 0 to 1, with the
/// ray: 1 - outline + outline (1 - (1 - cosine^2)^(32 (1 - width))) (Tachyon, measured). Exactly 1 if outline
/// is 0.
template <class T> HWY_NOINLINE T outline_factor(T outline, T width, T cosine) noexcept {
    const T edge = T(1) - pow(max(T(1) - cosine * cosine, T(0)), (T(1) - width) * T(32));
    return (T(1) - outline) + outline * edge;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
