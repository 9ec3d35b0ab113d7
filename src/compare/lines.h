// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whole rows or columns of a picture that are wrong.
#include <optional>
#include <string>

#include "compare/byte_picture.h"

namespace glint {

enum class Lines : std::uint8_t { rows, columns };

/// Rows or columns with one color throughout, the same in all of them, where the reference varies.
struct MissingLines {
    std::vector<std::uint8_t> marks;  ///< one per line
    std::string text;                 ///< "every second row, (0, 0, 0) throughout"
    /// One line, or every n-th. Others may be lines in which nothing is visible.
    bool is_regular = false;
};
/// Nothing if there are none, or if all lines are like this.
std::optional<MissingLines> missing_lines(const BytePicture& reference, const BytePicture& faulty,
                                          Lines lines);

/// One mark per line: whether nearly all pixels that are not dark in the reference differ.
std::vector<std::uint8_t> differing_lines(const BytePicture& reference, const BytePicture& faulty,
                                          Lines lines);

/// The only color of a picture, up to k_noise; nothing if it has more.
std::optional<std::string> one_color(const BytePicture& picture);

}  // namespace glint
