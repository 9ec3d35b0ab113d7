// SPDX-License-Identifier: Apache-2.0
// Polynomials of degree 4 at most, and their roots in an interval.
#if defined(GLINT_SIMD_POLYNOMIAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SIMD_POLYNOMIAL_INL_H_
#undef GLINT_SIMD_POLYNOMIAL_INL_H_
#else
#define GLINT_SIMD_POLYNOMIAL_INL_H_
#endif

#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// c[0] + c[1] s + ... + c[4] s^4.
template <class T> struct Polynomial {
    T c[5];

    HWY_INLINE explicit Polynomial(T constant = T(0)) : c{constant, T(0), T(0), T(0), T(0)} {}

    HWY_INLINE T value(T s) const { return (((c[4] * s + c[3]) * s + c[2]) * s + c[1]) * s + c[0]; }

    /// It times (a + b s); terms beyond s^4 are left out.
    HWY_INLINE void multiply(T a, T b) {
        for (int i = 4; i > 0; --i) c[i] = c[i] * a + c[i - 1] * b;
        c[0] = c[0] * a;
    }
    HWY_INLINE Polynomial derivative() const {
        Polynomial of;
        for (int i = 1; i <= 4; ++i) of.c[i - 1] = c[i] * T(i);
        return of;
    }
};

/// Whether f may have a root from 0 to `end`, 1 or -1: its Bernstein coefficients there, between which its
/// values are, do not have one sign.
template <class T> HWY_INLINE auto may_have_root(const Polynomial<T>& f, int end) {
    const T c1 = f.c[1] * T(end), c3 = f.c[3] * T(end);
    const T b[] = {f.c[0] + c1 * T(0.25), f.c[0] + c1 * T(0.5) + f.c[2] * T(1.0 / 6),
                   f.c[0] + c1 * T(0.75) + f.c[2] * T(0.5) + c3 * T(0.25),
                   f.c[0] + c1 + f.c[2] + c3 + f.c[4]};
    T low = f.c[0], high = f.c[0];
    for (const T& x : b) low = min(low, x), high = max(high, x);
    return low <= T(0) && high > T(0);
}

/// Whether one value is above 0 and the other is not.
template <class T> HWY_INLINE auto are_opposite(T a, T b) {
    return (a <= T(0) && b > T(0)) || (a > T(0) && b <= T(0));
}

/// The root of f between `from` and `to`, where it is monotone and its values have opposite signs;
/// value_at_low is the first. By Newton's method, and bisection where that does not converge fast. A lane's
/// result does not depend on its neighbors.
template <class T>
GLINT_SMALL HWY_NOINLINE T monotone_root(const Polynomial<T>& f, const T& from, const T& to,
                                         const T& value_at_low) noexcept {
    T low = from, high = to;
    const Polynomial<T> slope = f.derivative();
    const auto rises = value_at_low <= T(0);
    T s = (low + high) * T(0.5), last = high - low;
    auto going = s < T(k_infinity);
    for (int i = 0; i < 100 && any(going); ++i) {
        const T value = f.value(s);
        const auto is_below = (rises && value <= T(0)) || (!rises && value > T(0));
        low = select(going && is_below, s, low);
        high = select(and_not(going, is_below), s, high);
        const T newton = min(max(s - value / slope.value(s), low), high);
        const auto fast = abs(newton - s) < last * T(0.5);
        const T next = select(fast, newton, (low + high) * T(0.5));
        last = abs(next - s);
        s = select(going, next, s);
        // After a step of 2^-40 of Newton's method, no error is left.
        going = going && last > select(fast, T(0x1p-40), T(0x1p-53)) * max(abs(s), T(0x1p-20));
    }
    return s;
}

/// at[0] and at[4] are given: sets the three between them so that f is monotone between neighbors.
template <class T> GLINT_SMALL HWY_NOINLINE void find_monotone_parts(const Polynomial<T>& f, T* at) noexcept {
    Polynomial<T> derivatives[3];
    derivatives[0] = f.derivative();
    derivatives[1] = derivatives[0].derivative();
    derivatives[2] = derivatives[1].derivative();
    // Between the roots of a derivative, the one before it is monotone.
    const T end = at[4];
    at[1] = end;
    for (int order = 2; order >= 0; --order) {
        const Polynomial<T>& of = derivatives[order];
        T low = at[0], value_at_low = of.value(low);
        for (int i = 1; i <= 3 - order; ++i) {
            const T high = at[i], value_at_high = of.value(high);
            const auto crosses = are_opposite(value_at_low, value_at_high);
            if (any(crosses)) at[i] = select(crosses, monotone_root(of, low, high, value_at_low), high);
            low = high, value_at_low = value_at_high;
        }
        at[4 - order] = end;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
