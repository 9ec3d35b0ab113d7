// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether what a cause leaves of a difference has a structure that the cause does not explain.
#include <cstddef>

#include "compare/byte_picture.h"

namespace glint {

/// At most this fraction of a picture's pixels may be off in what a cause explains.
inline constexpr double k_structure_of_picture = 0.0001;
/// Bytes are roundings of numbers that are at most this far from those of a right cause, in 255ths: of
/// another program, and where numbers are fitted to bytes.
inline constexpr double k_other_program = 0.02, k_near_numbers = 0.06;
/// A picture whose mean difference is at most this, in 255ths, is not searched for other causes.
inline constexpr double k_rounding_mean = 0.15;

/// The numbers that became the bytes of a picture, as far as they are known, and by which rule they did.
struct NumbersOfBytes {
    const PictureView& numbers;
    const ByteRule& rule;
    double tolerance = k_other_program;
};

/// The pixels in which the pictures differ by more than k_noise, away from edges of either, and most of their
/// neighbours, too.
std::size_t structured_pixels(const BytePicture& made, const BytePicture& target, const Area& area);

/// Whether the difference, at edges or not, has the form of blobs.
bool has_blobs(const BytePicture& made, const BytePicture& target, const Area& area);

/// The pixels whose bytes in `target` are no roundings of `numbers`.
std::size_t wrong_pixels(const BytePicture& made, const NumbersOfBytes& numbers, const BytePicture& target,
                         const Area& area);

/// Whether `made` is `target` nearly wherever it is not `original`: a wrong cause can be near everywhere and
/// right nowhere. `target` has other bytes than roundings of `numbers` no more often there than where the
/// cause changes nothing. `but_at_edges`: much of the difference is left, at edges.
bool agrees_where_changed(const BytePicture& made, const NumbersOfBytes& numbers, const BytePicture& target,
                          const BytePicture& original, const Area& area, bool but_at_edges);

}  // namespace glint
