// SPDX-License-Identifier: Apache-2.0
// log, exp, pow, sin, cos, tan, acos and atan2 as templates over the number type T: double, or the lanes of
// simd/lanes-inl.h.
//
// No include guard and no fixed namespace: functions of lanes must be in the namespace of their instruction
// set. A file that needs these functions defines them in its own namespace:
//     #define GLINT_NUMBER_NAMESPACE plain                 (or HWY_NAMESPACE: simd/elementary-inl.h)
//     #include "math/elementary_templates-inl.h"
// The names of math/number.h must be visible in that namespace. The macro is undefined at the end.
//
// Only IEEE + - * /, comparisons and the names of math/number.h; no branches, no tables: the same bits with
// every number type. The polynomials are minimax approximations; tests/math checks the errors in ulp.
#ifndef GLINT_NUMBER_NAMESPACE
#error "define GLINT_NUMBER_NAMESPACE to the namespace that the functions are wanted in"
#endif

#include "math/number.h"

namespace glint {
namespace GLINT_NUMBER_NAMESPACE {

/// The unevaluated sum of two numbers: hi + lo with |lo| far below |hi|.
template <class T> struct HighLow { T hi, lo; };

/// log2(x) for finite x >= 2^-1022, with a relative error below 2^-65; hi is a head (see head()).
/// x = 2^e m, 1 <= m < 2; s = (m - c) / (m + c) for the nearest c of 1, about sqrt(2) and 2, so |s| < 0.0866;
/// log2(x) = e + log2(c) + s (A + A/3 s^2 + s^4 R(s^2)), A = 2 / ln 2. The c in the middle is the double near
/// sqrt(2) whose log2 is nearest to one of 24 bits: 2^-73 away. Split into exact products as in FDLIBM's pow.
template <class T> GLINT_INLINE HighLow<T> log2_high_low(T x) {
    T m;
    const T e = split_exponent(x, m);
    const auto above_first = m > 1.1894549;   // sqrt(c)
    const auto above_second = m > 1.6821432;  // sqrt(2 c)
    const T c = select(above_second, T(2), select(above_first, T(0x1.6a3087d71aeb6p+0), T(1)));
    const T base = e + select(above_second, T(1), select(above_first, T(0x1.004ecdp-1), T(0)));

    const T f = m - c;  // exact
    const T d = m + c;
    const T reciprocal = 1.0 / d;
    const T s = f * reciprocal;
    const T s_hi = head(s);
    const T d_hi = head(d);
    const T d_lo = (d - d_hi) + (m - (d - c));  // d_hi + d_lo = m + c without rounding
    const T s_lo = ((f - s_hi * d_hi) - s_hi * d_lo) * reciprocal;

    const T z = s * s;
    const T z2 = z * z;
    const T r = (0x1.2776c50efa657p-1 + z * 0x1.a61762a0d4d05p-2) +
                z2 * ((0x1.484b20f4a8928p-2 + z * 0x1.0c8ee09ebf0d5p-2) + z2 * 0x1.d04a2417c0801p-3);
    // (s_hi + s_lo)^2 = z_hi + z_lo; A = 0x1.715476p+1 + 0x1.4ae0bf85ddf44p-25; A/3 = 0x1.ec709d8p-1 +
    // 0x1.0e80ff5d27f05p-27
    const T z_hi = head(z);
    const T z_lo = (s_hi * s_hi - z_hi) + s_lo * (s_hi + s);
    const T cubic = z_hi * 0x1.ec709d8p-1;  // exact
    const T rest =
        z2 * r + (z_lo * 0x1.ec709dc3a03fdp-1 + (z_hi * 0x1.0e80ff5d27f05p-27 + 0x1.4ae0bf85ddf44p-25));
    const T sum_hi = head((0x1.715476p+1 + cubic) + rest);
    const T sum_lo = rest - ((sum_hi - 0x1.715476p+1) - cubic);
    const T u = s_hi * sum_hi;  // exact
    const T v = s_lo * sum_hi + s * sum_lo;
    const T hi = head((u + v) + base);
    return {hi, v - ((hi - base) - u)};
}

/// 2^(hi + lo); infinity if that exceeds the largest double, 0 below 2^-1022 (so that no result is
/// subnormal). hi has at most 52 bits; if it is infinite, lo may be anything.
template <class T> GLINT_INLINE T exp2_high_low(T hi, T lo) {
    const T w = hi + lo;
    const T n = round_to_integer(w);
    const T difference = hi - n;  // exact
    const T r = difference + lo;  // 2^r = 1 + r ln 2 + r^2 P(r), |r| <= 1/2
    const T r_hi = head(difference);
    const T r_lo = (difference - r_hi) + lo;
    const T u = r_hi * 0x1.62e42f8p-1;  // exact; ln 2 = 0x1.62e42f8p-1 + 0x1.be8e7bcd5e4f2p-27
    const T v = r_lo * 0x1.62e42fefa39efp-1 + r_hi * 0x1.be8e7bcd5e4f2p-27;
    const T r2 = r * r;
    const T r4 = r2 * r2;
    const T low = (0x1.c6b08d704a046p-5 + r * 0x1.3b2ab6fba078ep-7) +
                  r2 * (0x1.5d87fe78c3755p-10 + r * 0x1.4309130dc61f4p-13);
    const T high = (0x1.ffcbfbc7c412ap-17 + r * 0x1.62bfc9f3a4bcep-20) +
                   r2 * (0x1.b52652e16b68cp-24 + r * 0x1.e617b7fbd1691p-28);
    const T cubic = (r2 * r) * (low + r4 * (high + r4 * 0x1.e7c6d50b3bd61p-32));
    const T rest = r2 * 0x1.ebfbdff82c5a1p-3 + (cubic + v);
    const T one = 1.0 + u;
    const T power = one + ((u - (one - 1.0)) + rest);
    // 2^1024 is not a double: the last doubling is a separate step.
    const T scaled = power * exp2_integer(min(n, T(1023))) * select(n > 1023.0, T(2), T(1));
    const T beyond = select(hi > 0.0, T(k_infinity), T(0));
    // Near the smallest normal number hi + 1022 is exact, so this tests the sum before it is rounded.
    const auto normal = (hi + 1022.0) + lo >= 0.0;
    return select(normal && (w <= 1024.0), scaled, beyond);
}

/// Natural logarithm of a finite x >= 2^-1022.
template <class T> GLINT_INLINE T log_positive(T x) {
    const auto log2 = log2_high_low(x);
    return log2.hi * 0x1.62e42f8p-1 + (log2.hi * 0x1.be8e7bcd5e4f2p-27 + log2.lo * 0x1.62e42fefa39efp-1);
}

/// e^x for finite x; infinity if that exceeds the largest double, 0 if it is below 2^-1022.
template <class T> GLINT_INLINE T exp(T x) {
    const T x_hi = head(x);  // log2 e = 0x1.715476p+0 + 0x1.4ae0bf85ddf44p-26
    return exp2_high_low(x_hi * 0x1.715476p+0,
                         (x - x_hi) * 0x1.71547652b82fep+0 + x_hi * 0x1.4ae0bf85ddf44p-26);
}

/// x^y for finite y and finite x >= 0: x^0 = 1, 0^y = 0 for y > 0 and infinity for y < 0; infinity if the
/// result exceeds the largest double. Numbers below 2^-1022, x or the result, count as 0. For x < 0 (a cosine
/// on the far side) the result is 0 for every y.
template <class T> GLINT_INLINE_IF_FAST T pow(T x, T y) noexcept {
    const auto log2 = log2_high_low(x);
    const T y_hi = head(y);
    const T power = exp2_high_low(y_hi * log2.hi, (y - y_hi) * log2.hi + y * log2.lo);
    const T at_zero = select(y > 0.0, T(0), select(y < 0.0, T(k_infinity), T(1)));
    return select(x >= 0x1p-1022, power, select(x < 0.0, T(0), at_zero));
}

/// An angle as quadrant * 90 degrees + (hi + lo) radians, with |hi| below 45.001 degrees; quadrant is -2, -1,
/// 0, 1 or 2.
template <class T> struct ReducedAngle { T quadrant, hi, lo; };

template <class T> GLINT_INLINE T quadrant_of(T n) { return n - 4.0 * round_to_integer(n * 0.25); }

/// |x| <= 1e5 radians; other angles count as 0. Cody and Waite's reduction: the first two of the three
/// parts of pi/2 have 37 bits, so that their products with n < 2^16 are exact.
template <class T> GLINT_INLINE ReducedAngle<T> reduce_radians(T angle) {
    const T x = select(abs(angle) <= 1e5, angle, T(0));
    const T n = round_to_integer(x * 0x1.45f306dc9c883p-1);
    const T a = x - n * 0x1.921fb5444p+0;  // exact
    const T b = n * 0x1.68c234c4cp-39;     // exact
    const T c = n * 0x1.98a2e03707345p-77;
    const T difference = a - b;
    const T part = difference - a;
    const T error = (a - (difference - part)) - (b + part);  // difference + error = a - b without rounding
    const T tail = error - c;
    const T hi = difference + tail;
    return {quadrant_of(n), hi, tail - (hi - difference)};
}

/// |x| <= 2^45 degrees; other angles count as 0. The reduction is exact, so that multiples of 90 degrees give
/// 0.
template <class T> GLINT_INLINE ReducedAngle<T> reduce_degrees(T angle) {
    const T x = select(abs(angle) <= 0x1p45, angle, T(0));
    const T n = round_to_integer(x * (1.0 / 90.0));
    const T degrees = x - n * 90.0;  // exact
    const T d_hi = head(degrees);
    const T u = d_hi * 0x1.1df46ap-6;  // exact; pi / 180 = 0x1.1df46ap-6 + 0x1.294e9c8ae0ec6p-33
    const T v = (degrees - d_hi) * 0x1.1df46a2529d39p-6 + d_hi * 0x1.294e9c8ae0ec6p-33;
    const T hi = u + v;
    return {quadrant_of(n), hi, v - (hi - u)};
}

/// sin(hi + lo) within a quadrant.
template <class T> GLINT_INLINE HighLow<T> sin_in_quadrant(T hi, T lo) {
    const T z = hi * hi;
    const T z2 = z * z;
    const T p = (-0x1.5555555555549p-3 + z * 0x1.111111110f87ap-7) +
                z2 * ((-0x1.a01a019c11978p-13 + z * 0x1.71de3577b56b1p-19) +
                      z2 * (-0x1.ae5e6639d4290p-26 + z * 0x1.5d9300cf18857p-33));
    const T rest = lo * (1.0 - 0.5 * z) + z * hi * p;
    const T sum = hi + rest;
    return {sum, rest - (sum - hi)};
}

/// cos(hi + lo) within a quadrant.
template <class T> GLINT_INLINE HighLow<T> cos_in_quadrant(T hi, T lo) {
    const T z = hi * hi;
    const T z2 = z * z;
    const T p = (0x1.555555555554cp-5 - z * 0x1.6c16c16c1517ep-10) +
                z2 * ((0x1.a01a019cb1bebp-16 - z * 0x1.27e4f809f15ecp-22) +
                      z2 * (0x1.1ee9ebe9aae84p-29 - z * 0x1.8fae9cb444c1cp-37));
    const T half = 0.5 * z;
    const T one = 1.0 - half;
    const T h = head(hi);
    const T z_error = (hi - h) * (hi + h) - (z - h * h);  // hi^2 - z
    const T rest = ((1.0 - one) - half) + (z2 * p - (hi * lo + 0.5 * z_error));
    const T sum = one + rest;
    return {sum, rest - (sum - one)};
}

template <class T> GLINT_INLINE T sin_of(ReducedAngle<T> a) {
    const T s = sin_in_quadrant(a.hi, a.lo).hi;
    const T c = cos_in_quadrant(a.hi, a.lo).hi;
    const T size = select(abs(a.quadrant) == 1.0, c, s);
    return select((a.quadrant < 0.0) || (a.quadrant == 2.0), -size, size);
}

template <class T> GLINT_INLINE T cos_of(ReducedAngle<T> a) {
    const T s = sin_in_quadrant(a.hi, a.lo).hi;
    const T c = cos_in_quadrant(a.hi, a.lo).hi;
    const T size = select(abs(a.quadrant) == 1.0, s, c);
    return select((a.quadrant > 0.0) || (a.quadrant == -2.0), -size, size);
}

template <class T> GLINT_INLINE T tan_of(ReducedAngle<T> a) {
    const auto s = sin_in_quadrant(a.hi, a.lo);
    const auto c = cos_in_quadrant(a.hi, a.lo);
    const auto odd = abs(a.quadrant) == 1.0;
    const T over = select(odd, -c.hi, s.hi), over_lo = select(odd, -c.lo, s.lo);
    const T under = select(odd, s.hi, c.hi), under_lo = select(odd, s.lo, c.lo);
    const T q = over / under;
    const T q_hi = head(q), under_hi = head(under);
    const T product = q * under;
    const T product_lo = ((q_hi * under_hi - product) + q_hi * (under - under_hi) + (q - q_hi) * under_hi) +
                         (q - q_hi) * (under - under_hi);
    const T correction = (((over - product) - product_lo) + (over_lo - q * under_lo)) / under;
    return select(under == 0.0, T(k_infinity), q + correction);
}

/// Sine, cosine and tangent for |x| <= 1e5 radians; other angles count as 0. The tangent is infinite at its
/// poles.
template <class T> GLINT_INLINE T sin(T x) { return sin_of(reduce_radians(x)); }
template <class T> GLINT_INLINE T cos(T x) { return cos_of(reduce_radians(x)); }
template <class T> GLINT_INLINE T tan(T x) { return tan_of(reduce_radians(x)); }

/// The same for |x| <= 2^45 degrees; exact if the value is 0, +-1/2 or +-1.
template <class T> GLINT_INLINE T sin_degrees(T x) { return sin_of(reduce_degrees(x)); }
template <class T> GLINT_INLINE T cos_degrees(T x) { return cos_of(reduce_degrees(x)); }
template <class T> GLINT_INLINE T tan_degrees(T x) { return tan_of(reduce_degrees(x)); }

/// k * pi / 4 + u + v for whole k from 0 to 4, where k = 0 or |u| <= k * pi / 4, and |v| is far below |u|.
template <class T> GLINT_INLINE T add_to_eighths(T k, T u, T v) {
    const T base = k * 0x1.921fb54442d18p-1;  // exact: the last three bits of the constant are 0
    const T sum = base + u;
    return sum + (((base - sum) + u) + (v + k * 0x1.1a62633145c07p-55));
}

/// The angle from 0 to pi, in radians, whose cosine is x. Numbers beyond -1 and 1 count as -1 and 1.
/// |x| <= 1/2: pi/2 - asin(x); else 2 asin(s) or pi - 2 asin(s), s = sqrt((1 - |x|) / 2) = s + s_lo.
template <class T> GLINT_INLINE T acos(T x) {
    const T a = min(abs(x), T(1));
    const auto steep = a > 0.5;
    const T z = select(steep, (1.0 - a) * 0.5, a * a);  // 1 - a is exact
    const T s = select(steep, sqrt(z), a);
    const T s_hi = head(s);
    const T remainder = (z - s_hi * s_hi) - (s - s_hi) * (s + s_hi);
    const T s_lo = select(steep && (s > 0.0), remainder / select(s > 0.0, 2.0 * s, T(1)), T(0));

    const T z2 = z * z;
    const T z4 = z2 * z2;
    const T p0 = (0x1.5555555555556p-3 + z * 0x1.3333333332ec4p-4) +
                 z2 * (0x1.6db6db6e3292ep-5 + z * 0x1.f1c71c1d4aa0dp-6);
    const T p1 = (0x1.6e8bb1d89492bp-6 + z * 0x1.1c4d343fa57f6p-6) +
                 z2 * (0x1.c9cf3759fd8ffp-7 + z * 0x1.78246f32d075cp-7);
    const T p2 = (0x1.524ea8b3aad31p-7 + z * 0x1.653a8f8cfd43dp-8) +
                 z2 * (0x1.1d661531b222ep-6 - z * 0x1.e7a24f548c99dp-7);
    const T p = p0 + z4 * (p1 + z4 * (p2 + z4 * 0x1.d78189767524ep-6));
    const T rest = s * (z * p) + s_lo;  // asin(s + s_lo) - s

    const T side = select(x < 0.0, T(-1), T(1));
    const T factor = select(steep, 2.0 * side, -side);
    const T k = select(steep, 2.0 - 2.0 * side, T(2));
    return add_to_eighths(k, factor * s, factor * rest);
}

/// The angle of the point (x, y), in radians from -pi to pi: 0 on the positive x axis, pi on the negative
/// one, positive for y > 0. 0 for (0, 0). -0 counts as 0. |x| and |y| at most 1e300; if both are below
/// 1e-270, the error is larger. q = min / max of |x| and |y|; atan(q) = pi/4 + atan((q - 1) / (q + 1)) for q
/// above tan(pi/8).
template <class T> GLINT_INLINE T atan2(T y, T x) {
    const T ax = abs(x), ay = abs(y);
    const auto swapped = ay > ax;
    const T large = max(ax, ay), small = min(ax, ay);
    const auto folded = small > 0.4142135623730951 * large;
    const T difference = small - large, sum = large + small;
    const T over = select(folded, difference, small);
    const T over_lo = select(folded, small - (difference + large), T(0));
    const T under = select(folded, sum, select(large > 0.0, large, T(1)));
    const T under_lo = select(folded, small - (sum - large), T(0));
    const T t = over / under;
    const T t_hi = head(t), under_hi = head(under);
    const T product = t * under;
    const T product_lo = ((t_hi * under_hi - product) + t_hi * (under - under_hi) + (t - t_hi) * under_hi) +
                         (t - t_hi) * (under - under_hi);
    const T t_lo = (((over - product) - product_lo) + (over_lo - t * under_lo)) / under;

    const T z = t * t;
    const T z2 = z * z;
    const T z4 = z2 * z2;
    const T p0 = (-0x1.5555555555555p-2 + z * 0x1.9999999999953p-3) +
                 z2 * (-0x1.249249248d768p-3 + z * 0x1.c71c71c2fe5d9p-4);
    const T p1 = (-0x1.745d165cb83aap-4 + z * 0x1.3b1392b641b06p-4) +
                 z2 * (-0x1.110e858a72e28p-4 + z * 0x1.e199da4156fd9p-5);
    const T p2 = (-0x1.ac78ec6b8cb98p-5 + z * 0x1.74d64aa665b0ap-5) +
                 z2 * (-0x1.1b2058fb5da30p-5 + z * 0x1.0aa87c56e3eb5p-6);
    const T p = p0 + z4 * (p1 + z4 * p2);
    const T rest = t * (z * p) + t_lo * (1.0 - z);  // atan(t + t_lo) - t

    const auto left = x < 0.0;
    const T first = select(folded, T(1), select(swapped, T(2), T(0)));
    const T turn = select(swapped, T(-1), T(1));
    const T k = select(left, 4.0 - first, first);
    const T sign = select(left, -turn, turn);
    const T angle = add_to_eighths(k, sign * t, sign * rest);
    return select(y < 0.0, -angle, angle);
}

}  // namespace GLINT_NUMBER_NAMESPACE
}  // namespace glint

#undef GLINT_NUMBER_NAMESPACE
