// SPDX-License-Identifier: Apache-2.0
// Refraction at the surface of glass: direction and coefficient of the ray (docs/lighting.md). Pure
// functions.
#if defined(GLINT_LIGHTING_GLASS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_LIGHTING_GLASS_INL_H_
#undef GLINT_LIGHTING_GLASS_INL_H_
#else
#define GLINT_LIGHTING_GLASS_INL_H_
#endif

#include "simd/elementary-inl.h"
#include "simd/vec3-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// A refracted ray. If `total` is set there is none: total internal reflection.
template <class T> struct Refraction {
    decltype(T() < T()) total;
    Vector3<T> direction;  // as long as the incoming direction
};

/// Snell's law, n1 sin(theta) = n2 sin(phi). incoming: any length except 0; normal: unit, on the side of the
/// incoming ray (N·D <= 0); eta = n1 / n2. T = eta (D + cos N) - N sqrt(1 - eta^2 (1 - cos^2)), cos = -N·D
/// (CSC 473, "Reflection and Refraction").
template <class T> HWY_INLINE Refraction<T> refracted(Vector3<T> incoming, Vector3<T> normal, T eta) {
    const T size = length(incoming);
    const Vector3<T> d = incoming / size;
    const T cosine = -dot(normal, d);
    const T square = T(1) - eta * eta * (T(1) - cosine * cosine);
    const Vector3<T> t = (d + normal * cosine) * eta - normal * sqrt(max(square, T(0)));
    return {square < T(0), t * size};
}

/// Schlick's approximation of the reflectance: F0 + (1 - F0) (1 - cos)^5, F0 = ((n - 1)/(n + 1))^2,
/// cos = |N·D| of the incoming ray on either side (CSC 473, "Fresnel and Beer's Law").
template <class T> HWY_INLINE T schlick(T cosine, T ior) {
    const T root = (ior - T(1)) / (ior + T(1)), f0 = root * root, m = max(T(1) - cosine, T(0));
    return f0 + (T(1) - f0) * (m * m * (m * m) * m);
}

/// Fresnel's equations for unpolarized light: the reflectance at a cosine of 0 to 1, eta = n1 / n2. 1 where
/// there is total internal reflection, 0 if eta is 1.
template <class T> HWY_NOINLINE T fresnel_reflectance(T cosine, T eta) noexcept {
    const T square = T(1) - eta * eta * (T(1) - cosine * cosine), other = sqrt(max(square, T(0)));
    const T across = (eta * cosine - other) / (eta * cosine + other),
            along = (eta * other - cosine) / (eta * other + cosine);
    const T part = (across * across + along * along) * T(0.5);
    return select(eta == T(1), T(0), select(square > T(0), min(part, T(1)), T(1)));
}

/// Beer's law: the fraction of a color channel that remains after a distance in glass of this tint.
/// absorption: of a black tint, per unit of length (CSC 473: 0.15).
template <class T> HWY_INLINE T beer(T tint, T absorption, T distance) {
    return exp(-((T(1) - tint) * absorption * distance));
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
