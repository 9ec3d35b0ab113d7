// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers in text: the fast path of all tokenizers.
#include <fast_float/fast_float.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <system_error>

namespace glint {

inline bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }

/// [-] digits [. digits] with at most 15 digits: the digits and the power of ten are exact, so that their
/// quotient is the nearest double. Most numbers of large scenes have this form. Returns the end of the
/// number; null for other numbers, for a sign or point alone, and if `continues` is true for the character
/// after it.
template <class Continues>
inline const char* read_short_number(const char* from, const char* end, double& value,
                                     const Continues& continues) {
    static constexpr double k_tens[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                        1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const bool negative = *from == '-';
    const char* at = from + (negative ? 1 : 0);
    std::uint64_t digits = 0;
    const char* first = at;
    while (at != end && is_decimal_digit(*at)) digits = digits * 10 + static_cast<std::uint64_t>(*at++ - '0');
    const std::ptrdiff_t count = at - first;
    std::ptrdiff_t decimals = 0;
    if (at != end && *at == '.') {
        first = ++at;
        while (at != end && is_decimal_digit(*at))
            digits = digits * 10 + static_cast<std::uint64_t>(*at++ - '0');
        decimals = at - first;
    }
    const std::ptrdiff_t all = count + decimals;
    if (all > 15 || all == 0 || (at != end && continues(*at))) return nullptr;
    value = static_cast<double>(digits) / k_tens[decimals];
    if (negative) value = -value;
    return at;
}

/// Any decimal number without a plus sign, rounded to the nearest double; infinite if it is outside the range
/// of double. Returns the end of the number, which is `from` if there is none.
inline const char* read_any_number(const char* from, const char* end, double& value) {
    const auto [at, error] = fast_float::from_chars(from, end, value);
    // Versions of fast_float differ in whether this is an error.
    if (error == std::errc::result_out_of_range && value != 0)
        value = std::numeric_limits<double>::infinity();
    return error == std::errc::invalid_argument ? from : at;
}

}  // namespace glint
