// SPDX-License-Identifier: Apache-2.0
// What the C++ library of Debian's emscripten lacks of C++20. Included before every file of that build.
#pragma once
#if defined(__cplusplus) && __cplusplus > 201703L
#include <bit>
#include <compare>
#if !defined(__cpp_lib_bit_cast)
namespace std {
template <class To, class From> constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}
}  // namespace std
#endif
namespace std {
constexpr bool is_eq(partial_ordering order) noexcept { return order == 0; }
}  // namespace std
#endif
