// SPDX-License-Identifier: Apache-2.0
#pragma once
// The causes that can be seen in the pictures alone.
#include <vector>

#include "compare/picture_faults.h"

namespace glint {

struct PictureCause {
    const char* name;
    const char* explanation;
    double least;  ///< explained share from which it is named
    PictureFault make;
    int freedom =
        0;  ///< how much it can be bent to fit anything: named only if nothing of less explains well
    bool is_turn = false;  ///< the whole picture, flipped or turned
    /// Applied to a picture that has the fault, it gives the picture without: flips and swaps.
    bool is_own_inverse = false;
    bool is_rendered = false;  ///< the causes of a scene have it exactly: not tried if there is a scene
    int parameters = 0;        ///< CauseCandidate::parameters
};

/// Numbers that a fault of pictures with a detail fits.
inline constexpr int k_detail_parameters = 2;
/// Bytes that are truncated: all that it changes is within rounding.
inline constexpr const char* k_rounded_down = "rounded-down";
/// Explanations with a direction, which are also those of shifts that are rendered.
inline constexpr const char* k_shift_text =
    "Everything is shifted by one pixel {}: an index begins at 1, or a coordinate is rounded up.";
inline constexpr const char* k_half_shift_text =
    "Everything is shifted by half a pixel {}: in one picture rays pass through a pixel's middle (x + 0.5), "
    "in the other through its corner.";

/// The table, simple causes first: of two that explain the same, the earlier is named.
const std::vector<PictureCause>& picture_causes();

}  // namespace glint
