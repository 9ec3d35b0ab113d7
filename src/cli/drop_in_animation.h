// SPDX-License-Identifier: Apache-2.0
#pragma once
// POV-Ray's animations and parts of pictures: what their options mean (POV-Ray 3.7, measured).
#include <optional>
#include <string>
#include <vector>

#include "cli/drop_in.h"

namespace glint::cli {

/// +KFI, +KFF, +KI, +KF, +KC, +SF, +EF and Frame_Step.
struct Animation {
    std::optional<double> first_frame, last_frame;
    double first_clock = 0, last_clock = 1;
    bool is_cyclic = false;  ///< the frame after the last one is the first
    /// The frames to render, as numbers, or below 1 as fractions of all. The end may be beyond last_frame.
    std::optional<double> subset_first, subset_last;
    double step = 1;
};

/// The pictures of an animation; none if it has no frames. output: the name without the frame's number.
std::vector<DropInFrame> frames_of(const Animation& animation, const std::string& output);

/// +SC, +EC, +SR and +ER: columns or rows from 1, or fractions of the picture.
struct PartOfSide {
    std::optional<double> first, last;
};

/// The first pixel from 0, and the number of pixels.
struct PixelRange {
    int first = 0, count = 0;
};

/// Of a picture with `pixels` on this side. Nothing if POV-Ray refuses these numbers or nothing is left.
std::optional<PixelRange> pixels_of(const PartOfSide& part, int pixels);

}  // namespace glint::cli
