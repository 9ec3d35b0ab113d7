// log, exp, pow, sin, cos and tan as templates over the kind of number T: double, or the lanes of
// simd/lanes-inl.h.
//
// No include guard and no fixed namespace: lanes compile only inside the namespace of their instruction set,
// so a file that wants these functions opens them there:
//     #define GLINT_NUMBER_NAMESPACE plain                 (or HWY_NAMESPACE: simd/elementary-inl.h)
//     #include "math/elementary_templates-inl.h"
// and the namespace must already know the names of math/number.h. The macro is undefined again at the end.
//
// Only IEEE + - * /, comparisons and the names of math/number.h, no branches, no tables: the same bits from
// every kind of number. Polynomials are minimax approximations; tests/math holds the errors in ulp.
#ifndef GLINT_NUMBER_NAMESPACE
#error "define GLINT_NUMBER_NAMESPACE to the namespace that the functions are wanted in"
#endif

#include "math/number.h"

namespace glint {
namespace GLINT_NUMBER_NAMESPACE {

/// The unevaluated sum of two numbers: hi + lo with |lo| far below |hi|.
template <class T>
struct HighLow {
    T hi, lo;
};

/// The first 26 bits of x, |x| < 2^996 (Veltkamp): products of two heads are exact.
template <class T>
GLINT_INLINE T head(T x) {
    const T scaled = x * 134217729.0;  // 2^27 + 1
    return scaled - (scaled - x);
}

/// log2(x) for finite x > 0, with a relative error below 2^-65; hi has 26 bits.
/// x = 2^e m; s = (m - c) / (m + c) for the nearer c of 1 and about sqrt(2), so |s| < 0.0865;
/// log2(x) = e + log2(c) + 2/(3 ln 2) s (3 + s^2 + s^4 R(s^2)). The arrangement of the leading terms is that
/// of FDLIBM's pow.
template <class T>
GLINT_INLINE HighLow<T> log2_high_low(T x) {
    const auto subnormal = x < 0x1p-1022;
    T m;
    T e = split_exponent(select(subnormal, x * 0x1p54, x), m);
    e = select(subnormal, e - 54.0, e);
    const auto upper = m > 1.681703;  // sqrt(2 c)
    m = select(upper, m * 0.5, m);
    e = select(upper, e + 1.0, e);
    const auto middle = m > 1.189143;  // sqrt(c)
    const T c = select(middle, T(1.4140625), T(1));
    const T log2_c_hi = select(middle, T(0x1.ffd79ap-2), T(0));
    const T log2_c_lo = select(middle, T(-0x1.5f0019518ce03p-28), T(0));

    const T f = m - c;  // exact
    const T d = m + c;
    const T reciprocal = 1.0 / d;
    const T s = f * reciprocal;
    const T s_hi = head(s);
    const T d_hi = (d + 0x1.8p28) - 0x1.8p28;   // to multiples of 2^-24
    const T d_lo = (d - d_hi) + (m - (d - c));  // d_hi + d_lo = m + c without rounding
    const T s_lo = ((f - s_hi * d_hi) - s_hi * d_lo) * reciprocal;

    const T z = s * s;
    const T z2 = z * z;
    const T r = (0x1.3333333333dddp-1 + z * 0x1.b6db6dafc9ab2p-2) +
                z2 * ((0x1.555562e4e27d2p-2 + z * 0x1.1739c235242fep-2) + z2 * 0x1.e2b69d5eae9a0p-3);
    const T z_hi = s_hi * s_hi;  // exact
    const T rest = z2 * r + s_lo * (s_hi + s);
    const T sum_hi = ((3.0 + z_hi + rest) + 0x1.8p28) - 0x1.8p28;
    const T sum_lo = rest - ((sum_hi - 3.0) - z_hi);
    const T u = s_hi * sum_hi;  // exact
    const T v = s_lo * sum_hi + sum_lo * s;
    const T p_hi = head(u + v);
    const T p_lo = v - (p_hi - u);
    const T log2_hi = p_hi * 0x1.ec709d8p-1;  // exact; 2 / (3 ln 2) = 0x1.ec709d8p-1 + 0x1.0e80ff5d27f05p-27
    const T log2_lo = (p_hi * 0x1.0e80ff5d27f05p-27 + p_lo * 0x1.ec709dc3a03fdp-1) + log2_c_lo;
    const T hi = head(((log2_hi + log2_lo) + log2_c_hi) + e);
    return {hi, log2_lo - (((hi - e) - log2_c_hi) - log2_hi)};
}

/// 2^n e^(hi + lo) for |hi + lo| < 0.3467 and a whole n, -1022 <= n <= 1024; hi has at most 52 bits.
template <class T>
GLINT_INLINE T exp_scaled(T n, T hi, T lo) {
    const T z = hi + lo;
    const T z2 = z * z;
    const T z4 = z2 * z2;
    const T low = (0x1.5555555555501p-3 + z * 0x1.5555555553206p-5) +
                  z2 * (0x1.1111111128866p-7 + z * 0x1.6c16c17cc35b1p-10);
    const T high = (0x1.a01a011c2889cp-13 + z * 0x1.a019ab2cae0e3p-16) +
                   z2 * (0x1.71df553686d25p-19 + z * 0x1.289f8b634110fp-22);
    const T cubic = (z2 * z) * (low + z4 * (high + z4 * 0x1.ad20275be59bep-26));
    const T rest = 0.5 * z2 + (cubic + lo);
    const T one = 1.0 + hi;
    const T power = one + ((hi - (one - 1.0)) + rest);
    // 2^1024 is not a number: the last doubling goes to the other factor.
    const auto last = n > 1023.0;
    return select(last, power + power, power) * exp2_whole(select(last, T(1023), n));
}

/// 2^(hi + lo): infinity from 2^1024 on, 0 below 2^-1022 (no subnormal results). hi has at most 52 bits.
template <class T>
GLINT_INLINE T exp2_high_low(T hi, T lo) {
    const T w = hi + lo;
    const T n = round_whole(max(min(w, T(1024)), T(-1022)));
    const T r = hi - n;  // exact
    const T r_hi = head(r);
    const T u = r_hi * 0x1.62e42f8p-1;  // exact; ln 2 = 0x1.62e42f8p-1 + 0x1.be8e7bcd5e4f2p-27
    const T v = ((r - r_hi) + lo) * 0x1.62e42fefa39efp-1 + r_hi * 0x1.be8e7bcd5e4f2p-27;
    const T power = exp_scaled(n, u, v);
    return select(w < -1022.0, T(0), select(w < 1024.0, power, T(k_infinity)));
}

/// Natural logarithm of a finite x > 0 (subnormal too).
template <class T>
GLINT_INLINE T log_positive(T x) {
    const auto log2 = log2_high_low(x);
    return log2.hi * 0x1.62e42f8p-1 + (log2.hi * 0x1.be8e7bcd5e4f2p-27 + log2.lo * 0x1.62e42fefa39efp-1);
}

/// e^x for finite x; infinity where that exceeds the largest double, 0 where it is below 2^-1022.
template <class T>
GLINT_INLINE T exp(T x) {
    const T bounded = max(min(x, T(710)), T(-708.4));
    const T n = round_whole(bounded * 0x1.71547652b82fep+0);
    const T hi = bounded - n * 0x1.62e42fefa38p-1;  // exact; ln 2 = 0x1.62e42fefa38p-1 + 0x1.ef35793c7673p-45
    const T lo = n * -0x1.ef35793c76730p-45;
    const T power = exp_scaled(n, hi, lo);
    const T least = -0x1.6232bdd7abcd2p+9;    // the least x with e^x >= 2^-1022
    const T greatest = 0x1.62e42fefa39efp+9;  // the greatest x with a finite e^x
    return select(x < least, T(0), select(x <= greatest, power, T(k_infinity)));
}

/// x^y for finite y and finite x >= 0: x^0 = 1, 0^y = 0 for y > 0 and infinity for y < 0; infinity where the
/// result exceeds the largest double; 0 where it is below 2^-1022. 0 for x < 0 whatever y (a cosine that
/// faces away).
template <class T>
GLINT_INLINE T pow(T x, T y) {
    const auto log2 = log2_high_low(x);
    // Beyond 2^70 nothing changes: the log2 of a double other than 1 is at least 2^-53 in size.
    const T exponent = max(min(y, T(0x1p70)), T(-0x1p70));
    const T y_hi = head(exponent);
    const T power = exp2_high_low(y_hi * log2.hi, (exponent - y_hi) * log2.hi + exponent * log2.lo);
    const T at_zero = select(y > 0.0, T(0), select(y < 0.0, T(k_infinity), T(1)));
    return select(x > 0.0, power, select(x < 0.0, T(0), at_zero));
}

/// An angle as quadrant * 90 degrees + (hi + lo) radians, |hi| below 45.001 degrees, quadrant one of -2, -1,
/// 0, 1, 2.
template <class T>
struct ReducedAngle {
    T quadrant, hi, lo;
};

template <class T>
GLINT_INLINE T quadrant_of(T n) {
    return n - 4.0 * round_whole(n * 0.25);
}

/// |x| <= 1e5 radians; other angles are taken as 0. Cody and Waite's reduction: the first two of the three
/// parts of pi/2 have 37 bits, so that their products with n < 2^16 are exact.
template <class T>
GLINT_INLINE ReducedAngle<T> reduce_radians(T angle) {
    const T x = select(abs(angle) <= 1e5, angle, T(0));
    const T n = round_whole(x * 0x1.45f306dc9c883p-1);
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

/// |x| <= 2^45 degrees; other angles are taken as 0. The reduction is exact, so multiples of 90 degrees leave
/// 0.
template <class T>
GLINT_INLINE ReducedAngle<T> reduce_degrees(T angle) {
    const T x = select(abs(angle) <= 0x1p45, angle, T(0));
    const T n = round_whole(x * (1.0 / 90.0));
    const T degrees = x - n * 90.0;  // exact
    const T d_hi = head(degrees);
    const T u = d_hi * 0x1.1df46ap-6;  // exact; pi / 180 = 0x1.1df46ap-6 + 0x1.294e9c8ae0ec6p-33
    const T v = (degrees - d_hi) * 0x1.1df46a2529d39p-6 + d_hi * 0x1.294e9c8ae0ec6p-33;
    const T hi = u + v;
    return {quadrant_of(n), hi, v - (hi - u)};
}

/// sin(hi + lo) within a quadrant.
template <class T>
GLINT_INLINE HighLow<T> sin_in_quadrant(T hi, T lo) {
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
template <class T>
GLINT_INLINE HighLow<T> cos_in_quadrant(T hi, T lo) {
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

template <class T>
GLINT_INLINE T sin_of(ReducedAngle<T> a) {
    const T s = sin_in_quadrant(a.hi, a.lo).hi;
    const T c = cos_in_quadrant(a.hi, a.lo).hi;
    const T size = select(abs(a.quadrant) == 1.0, c, s);
    return select((a.quadrant < 0.0) || (a.quadrant == 2.0), -size, size);
}

template <class T>
GLINT_INLINE T cos_of(ReducedAngle<T> a) {
    const T s = sin_in_quadrant(a.hi, a.lo).hi;
    const T c = cos_in_quadrant(a.hi, a.lo).hi;
    const T size = select(abs(a.quadrant) == 1.0, s, c);
    return select((a.quadrant > 0.0) || (a.quadrant == -2.0), -size, size);
}

template <class T>
GLINT_INLINE T tan_of(ReducedAngle<T> a) {
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

/// Sine, cosine and tangent of |x| <= 1e5 radians; of other angles, those of 0. Infinity where the tangent
/// has a pole.
template <class T>
GLINT_INLINE T sin(T x) {
    return sin_of(reduce_radians(x));
}
template <class T>
GLINT_INLINE T cos(T x) {
    return cos_of(reduce_radians(x));
}
template <class T>
GLINT_INLINE T tan(T x) {
    return tan_of(reduce_radians(x));
}

/// The same of |x| <= 2^45 degrees, exact where the value is 0, 1/2 or 1 in size.
template <class T>
GLINT_INLINE T sin_degrees(T x) {
    return sin_of(reduce_degrees(x));
}
template <class T>
GLINT_INLINE T cos_degrees(T x) {
    return cos_of(reduce_degrees(x));
}
template <class T>
GLINT_INLINE T tan_degrees(T x) {
    return tan_of(reduce_degrees(x));
}

}  // namespace GLINT_NUMBER_NAMESPACE
}  // namespace glint

#undef GLINT_NUMBER_NAMESPACE
