// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether what a cause leaves of a difference has a structure that the cause does not explain.
#include <cstddef>

#include "compare/byte_picture.h"

namespace glint {

/// At most this fraction of a picture's pixels may be off in what a cause explains.
inline constexpr double k_structure_of_picture = 0.0001;
/// Rounding alone, and that of fitted numbers, leave at most this mean, in 255ths.
inline constexpr double k_rounding_mean = 0.15;
/// So much where the programs round alike and no number is fitted by rendering: values between two bytes.
/// Measured: at most 0.007 of right causes, and 0.05 to 0.09 of light that fades by another formula.
inline constexpr double k_ties_mean = 0.02;

/// The pixels in which the pictures differ by more than k_noise, away from edges of either, and most of their
/// neighbours, too.
std::size_t structured_pixels(const BytePicture& made, const BytePicture& target, const Area& area);

/// Whether the difference, at edges or not, has the form of blobs.
bool has_blobs(const BytePicture& made, const BytePicture& target, const Area& area);

/// Whether `made` is `target` nearly wherever it is not `original`: a wrong cause can be near everywhere and
/// right nowhere. `but_at_edges`: much of the difference is left, at edges. `most`: the mean difference that
/// may be left of what is shaded, in 255ths.
bool agrees_where_changed(const BytePicture& made, const BytePicture& target, const BytePicture& original,
                          const Area& area, bool but_at_edges, double most = k_rounding_mean);

}  // namespace glint
