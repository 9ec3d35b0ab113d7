// SPDX-License-Identifier: Apache-2.0
#pragma once
// The operations that formulas use, for plain numbers, with the same names as in simd/lanes-inl.h. Formulas
// are templates over the number type and use only these and the operators, so that every type gives the same
// bits.
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

// Formulas over lanes must be inlined into code that is compiled for the lanes' instruction set.
#define GLINT_INLINE inline __attribute__((always_inline))
/// Of long functions: the page's files are smaller if they are called.
#ifdef __wasm__
#define GLINT_INLINE_IF_FAST inline __attribute__((noinline))
#else
#define GLINT_INLINE_IF_FAST GLINT_INLINE
#endif
/// Of functions in the kernels that only few scenes or explain() need: small in the page's files.
#ifdef __wasm__
#define GLINT_SMALL __attribute__((noinline, minsize)) inline
#else
#define GLINT_SMALL inline
#endif

namespace glint::number {

inline constexpr double k_infinity = std::numeric_limits<double>::infinity();

// In a formula, `auto m = a < b` is a bool for plain numbers and a mask for lanes.
template <class T> T select(bool m, T yes, T no) { return m ? yes : no; }
inline bool any(bool m) { return m; }
inline bool all(bool m) { return m; }
inline bool and_not(bool a, bool b) { return a && !b; }  // a and not b

// IEEE 754 requires sqrt to be correctly rounded, like + - * /.
inline float sqrt(float x) { return std::sqrt(x); }
inline double sqrt(double x) { return std::sqrt(x); }
inline long double sqrt(long double x) { return std::sqrt(x); }

template <class T> T abs(T x) { return x < T(0) ? -x : x == T(0) ? T(0) : x; }
template <class T> T min(T a, T b) { return a < b ? a : b; }
template <class T> T max(T a, T b) { return a < b ? b : a; }

/// The sign bit of `s` on the magnitude of x >= 0.
template <class T> T with_sign_of(T x, T s) { return s < T(0) ? -x : x; }

/// For finite, normal x > 0: x = mantissa * 2^e, 1 <= mantissa < 2. Returns e.
inline double split_exponent(double x, double& mantissa) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    mantissa = std::bit_cast<double>((bits & 0x000fffffffffffffu) | 0x3ff0000000000000u);
    return static_cast<double>(static_cast<std::int64_t>(bits >> 52) - 1023);
}

/// 2^k for a whole number k, -1022 <= k <= 1023. Other k give a meaningless number, the same for every type.
inline double exp2_integer(double k) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(k + (4503599627370496.0 + 1023.0)) << 52);
}

/// x with the last 27 bits of its mantissa cleared: the product of two heads is exact.
inline double head(double x) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0xfffffffff8000000u);
}

/// Whether the numbers from a come before those from b, of as many: an order of all bits, in which only 0 and
/// -0 are the same. It is for sorted maps, which no choice of numbers makes slow; it is not that of the
/// values.
template <std::size_t n> bool comes_before(const std::array<double, n>& a, const std::array<double, n>& b) {
    for (std::size_t i = 0; i < n; ++i) {
        const auto x = std::bit_cast<std::uint64_t>(a[i] == 0 ? 0.0 : a[i]);
        const auto y = std::bit_cast<std::uint64_t>(b[i] == 0 ? 0.0 : b[i]);
        if (x != y) return x < y;
    }
    return false;
}

/// The nearest whole number (ties to even), |x| < 2^51, by IEEE addition alone.
inline double round_to_integer(double x) {
    constexpr double shift = 6755399441055744.0;  // 1.5 * 2^52
    return (x + shift) - shift;
}

}  // namespace glint::number
