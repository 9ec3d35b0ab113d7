// SPDX-License-Identifier: Apache-2.0
// The lighting equation (docs/lighting.md): the diffuse and specular terms of one light at a surface point.
// Pure functions.
#if defined(GLINT_LIGHTING_PHONG_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_LIGHTING_PHONG_INL_H_
#undef GLINT_LIGHTING_PHONG_INL_H_
#else
#define GLINT_LIGHTING_PHONG_INL_H_
#endif

#include "glint/conventions.h"
#include "lighting/light.h"
#include "simd/elementary-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The conventions that the lighting equation depends on.
struct LightingRules {
    Shading shading = Shading::blinn_phong;
    bool specular_gate = true;  // the highlight needs N·L > 0
    bool clamp_cosines = true;  // N·L and S below 0 add nothing
    bool normalize = true;      // L, V, R and H are normalised before use
    bool clamp_attenuation = true;
    SpotFalloff spot_falloff = SpotFalloff::cubic;
    bool attenuate_highlights = true;  // f_att and the spot's factor apply to highlights, too
    double light_threshold = 0;  // a light adds something only if N·L f_att spot is above this; 0: always
    bool has_highlights() const { return shading == Shading::phong || shading == Shading::blinn_phong; }
};

/// The two cosines of the model: N·L, and S = R·V (Phong) or N·H (Blinn-Phong).
template <class T> struct Cosines { T n_l, s; };

/// R = 2 N (N·L) - L (LIGHT-6; CGFS "ReflectRay"; RT2).
template <class T> HWY_INLINE Vector3<T> mirrored(Vector3<T> l, Vector3<T> n) {
    return n * (T(2) * dot(n, l)) - l;
}

/// N is unit; l and v, from the surface point to the light and to the eye, are unit if the rules normalise.
template <class T>
HWY_INLINE Cosines<T> cosines(Vector3<T> normal, Vector3<T> l, Vector3<T> v, const LightingRules& rules) {
    const T n_l = dot(normal, l);
    if (rules.shading == Shading::phong) return {n_l, dot(mirrored(l, normal), v)};
    if (rules.shading == Shading::blinn_phong) {
        const Vector3<T> h = l + v;
        const T size = length(h);
        // Light from exactly behind: H does not exist, and there is no highlight.
        const T s = dot(normal, h);
        return {n_l, rules.normalize ? select(size > T(0), s / select(size > T(0), size, T(1)), T(0)) : s};
    }
    return {n_l, T(0)};
}

/// The mask of points whose specular term may be nonzero.
template <class T> HWY_INLINE auto has_highlight(const Cosines<T>& c, const LightingRules& rules) {
    const auto positive = rules.clamp_cosines ? c.s > T(0) : c.s > T(0) || c.s < T(0);
    return rules.specular_gate ? positive && (c.n_l > T(0)) : positive;
}

/// The factor of k_d I_l,d for a visible light, without the attenuation.
template <class T> HWY_INLINE T diffuse_term(T n_l, const LightingRules& rules) {
    return rules.clamp_cosines ? max(n_l, T(0)) : n_l;
}

/// S^n, the factor of k_s I_l,s for a visible light where there is a highlight.
template <class T> HWY_INLINE T highlight_power(T s, T shininess, const LightingRules& rules) {
    // Without normalisation S may be large: this keeps the film finite.
    const T power = min(pow(abs(s), shininess), T(1e30));
    if (rules.clamp_cosines) return power;
    // (-x)^n is negative for odd n, positive for even n, and undefined for n that are not whole.
    const T half = shininess * T(0.5);
    const auto whole = round_to_integer(shininess) == shininess, even = round_to_integer(half) == half;
    return select(s < T(0), select(whole, select(even, power, -power), T(0)), power);
}

/// f_att = min(1 / (c0 + c1 d + c2 d^2), 1) (LIGHT-12).
/// most: 1, or with clamp_attenuation = false a number that keeps the film finite.
template <class T> HWY_INLINE T attenuation(T c0, T c1, T c2, T distance, T most = T(1)) {
    return min(T(1) / (c0 + c1 * distance + c2 * (distance * distance)), most);
}

/// 2 / (1 + (d / fade_distance)^fade_power) (POV-Ray, measured).
template <class T> HWY_NOINLINE T fading(T fade_distance, T fade_power, T distance) noexcept {
    return T(2) / (T(1) + pow(distance / fade_distance, fade_power));
}

/// The factor of a spot's light in a direction whose cosine with the axis is given: 1 within the inner angle,
/// 0 from the outer angle on. cubic: POV-Ray, measured; linear: Tachyon, measured.
template <class T> HWY_NOINLINE T spot_factor(T cosine, const SpotCone& cone, SpotFalloff falloff) noexcept {
    const auto inside = cosine >= T(cone.inner_cosine), outside = cosine <= T(cone.outer_cosine);
    if (falloff == SpotFalloff::linear) {
        const double width = cone.outer_radians - cone.inner_radians;
        const T s = (T(cone.outer_radians) - acos(cosine)) / T(width > 0 ? width : 1);
        return select(inside, T(1), select(outside, T(0), min(max(s, T(0)), T(1))));  // rounding
    }
    const double width = cone.inner_cosine - cone.outer_cosine;
    const T x = (cosine - T(cone.outer_cosine)) / T(width > 0 ? width : 1);
    const T s = select(inside, T(1), select(outside, T(0), x * x * (T(3) - T(2) * x)));
    return cone.tightness > 0 ? s * pow(cosine, T(cone.tightness)) : s;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
