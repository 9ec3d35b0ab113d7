// SPDX-License-Identifier: Apache-2.0
// A ray beside a torus: the function that is 0 on the surface, its extrema along the ray, and its roots.
//
// A point at distance rho from the axis and y from the plane of the center circle is on the torus where
//   (rho - R)^2 + y^2 = r^2 or, if r > R, (rho + R)^2 + y^2 = r^2.
// The product of both is a polynomial of degree 4 in s. Its coefficients lose precision: of a thin tube, a
// rounding error of eps R^4 moves a root by eps R^2 / r. Therefore they are used only to find the extrema,
// where an error has no effect on the value. Signs and roots come from the two equations above: a hit is at
// most 2 eps off the surface, times the sum of |origin|, |center|, R and r, eps = 2^-53
// (tests/geometry/torus_test.cpp, beside roots to 400 bits: thin tubes, tangents, and rays from 1e6 radii
// away).
#if defined(GLINT_GEOMETRY_TORUS_RAY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_TORUS_RAY_INL_H_
#undef GLINT_GEOMETRY_TORUS_RAY_INL_H_
#else
#define GLINT_GEOMETRY_TORUS_RAY_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "simd/polynomial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Points q + s d, where q is the ray's nearest point to the torus' center, relative to it.
template <class T> struct TorusRay {
    T radius, tube, q_along, d_along;
    Vector3<T> q_across, d_across;
    T dd, dd_across, qd_across;  // products of d and q
    T curve;                     // p, see find_extrema()

    HWY_INLINE TorusRay(const Vector3<T>& axis, T big, T small, const Vector3<T>& q, const Vector3<T>& d)
        : radius(big),
          tube(small),
          q_along(dot(q, axis)),
          d_along(dot(d, axis)),
          q_across(q - axis * q_along),
          d_across(d - axis * d_along),
          dd(dot(d, d)),
          dd_across(dot(d_across, d_across)),
          qd_across(dot(q_across, d_across)),
          curve((dd * (dot(q, q) + (radius - tube) * (radius + tube)) - T(2) * radius * radius * dd_across) /
                (dd * dd)) {}

    /// Below 0 within the tube.
    HWY_INLINE T value(T s) const {
        const Vector3<T> across = q_across + d_across * s;
        const T rho = sqrt(dot(across, across)), y = q_along + d_along * s;
        const T rest = y * y - tube * tube, near = rho - radius, far = rho + radius;
        return (near * near + rest) * (far * far + rest);
    }

    /// Sets at[1], at[2], at[3] to the extrema in ascending order; one that does not exist has any value.
    /// q and d are perpendicular, so that the polynomial's derivative is, but for a factor,
    ///   s^3 + p s - e,  p = (|d|^2 c - 2 R^2 |d_across|^2) / |d|^4,
    ///   e = 2 R^2 (q_across d_across) / |d|^4,  c = |q|^2 + R^2 - r^2.
    /// Newton's method from above finds the root of greatest magnitude, and the others follow from it.
    HWY_INLINE void find_extrema(T* at) const {
        const T p = curve, signed_e = T(2) * radius * radius * qd_across / (dd * dd), e = abs(signed_e);
        // Not below the root: sqrt(-p) or 0, and the least of two bounds of the rest.
        const T cube_root = select(e > T(1), sqrt(e), (e + T(2)) / T(3));
        T u = sqrt(max(-p, T(0))) + min(e / abs(p), cube_root);
        auto going = u < T(k_infinity);
        for (int i = 0; i < 100 && any(going); ++i) {
            const T square = u * u;
            const T step = ((square + p) * u - e) / (T(3) * square + p);
            u = select(going, u - step, u);
            // An error of 2^-40 after the last step has no effect on the values.
            going = going && (step > T(0x1p-20) * (T(1) + u));
        }
        const T half = u * T(0.5), reach = sqrt(max(-(p + T(3) * half * half), T(0)));
        const auto mirrored = signed_e < T(0);
        at[1] = select(mirrored, -u, -half - reach);
        at[2] = select(mirrored, half - reach, -half + reach);
        at[3] = select(mirrored, half + reach, u);
    }

    /// The first i for which a root between at[i] and at[i + 1] may be after start; value: those at `at`. It
    /// leaves out only roots that are clearly before it.
    HWY_INLINE T first_bracket(const T* at, const T* value_at, T start) const {
        T first = T(0);
        if (!any(start > T(-1))) return first;
        const T out = radius + tube, here = value(start);
        const auto is_clear = abs(here) > T(0x1p-36) * (out * out) * (out * out);
        for (int i = 0; i < 4; ++i) {
            const auto is_past = start > at[i + 1] + T(0x1p-40);
            const auto is_beyond = start > at[i] && is_clear && !are_opposite(here, value_at[i + 1]);
            first = select(is_past || is_beyond, T(i + 1), first);
        }
        return first;
    }

    /// The root between `from` and `to`, at one of which, the inner end, the value is `inner` <= 0, and at
    /// the other above 0. By Newton's method, and bisection where that does not converge fast. A lane's
    /// result does not depend on its neighbors.
    HWY_INLINE T root(T from, T to, T inner) const {
        // Only one of the two equations changes its sign.
        T center = radius;
        if (any(tube > radius)) {
            const auto first = is_within(from, -radius), second = is_within(to, -radius);
            center = select((first && !second) || (second && !first), -radius, radius);
        }
        const auto forward = !is_within(from, center);
        T outside = select(forward, from, to), inside = select(forward, to, from);
        // The inner end is a minimum as a rule: a parabola there gives the first estimate.
        const T bend = T(2) * dd * dd * (T(3) * inside * inside + curve);
        const T step = sqrt(-inner / bend);
        T s = inside + select(outside < inside, -step, step);
        T last = abs(outside - inside);
        s = select(is_between(s, outside, inside), s, (outside + inside) * T(0.5));
        auto going = s < T(k_infinity);
        for (int i = 0; i < 100 && any(going); ++i) {
            const Vector3<T> across = q_across + d_across * s;
            const T rho = sqrt(dot(across, across)), y = q_along + d_along * s, off = rho - center;
            const T value = off * off + y * y - tube * tube;
            const T slope = T(2) * (off * (qd_across + dd_across * s) / rho + y * d_along);
            const auto within = value <= T(0);
            inside = select(going && within, s, inside);
            outside = select(going && !within, s, outside);
            const T newton = min(max(s - value / slope, min(inside, outside)), max(inside, outside));
            const auto fast = abs(newton - s) < last * T(0.5);
            const T next = select(fast, newton, (inside + outside) * T(0.5));
            last = abs(next - s);
            s = select(going, next, s);
            // After a step of 2^-40 of Newton's method, no error is left.
            going = going && last > select(fast, T(0x1p-40), T(0x1p-53));
        }
        return s;
    }

  private:
    HWY_INLINE auto is_within(T s, T center) const {
        const Vector3<T> across = q_across + d_across * s;
        const T off = sqrt(dot(across, across)) - center, y = q_along + d_along * s;
        return off * off + y * y - tube * tube <= T(0);
    }
    static HWY_INLINE auto is_between(T s, T a, T b) { return s >= min(a, b) && s <= max(a, b); }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
