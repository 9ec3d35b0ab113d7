// SPDX-License-Identifier: Apache-2.0
#pragma once
// Limits on what a short text can ask for.
#include <cstddef>
#include <cstdint>

namespace glint::povray {

inline constexpr std::uint64_t k_max_steps = 30'000'000;  // tokens read again by loops and macros
inline constexpr std::uint64_t k_steps_per_shape = 1000;  // more of them for each shape that came of it
inline constexpr std::uint64_t k_most_steps = 1'000'000'000;
inline constexpr std::uint64_t k_list_bytes_a_step = 8;     // of the lists of meshes
inline constexpr std::size_t k_max_frames = 500;            // macros and includes within each other
inline constexpr int k_max_depth = 100;                     // brackets and blocks within each other
inline constexpr std::uint64_t k_max_elements = 4'000'000;  // of all arrays
inline constexpr std::uint64_t k_max_shapes = 4'000'000;    // more than the text has tokens
inline constexpr std::uint32_t k_max_includes = 10000;      // and tests of files
inline constexpr std::size_t k_max_string = 65536;

}  // namespace glint::povray
