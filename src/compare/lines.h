// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whole rows or columns of a picture that are wrong.
#include <optional>
#include <string>

#include "compare/byte_picture.h"

namespace glint {

enum class Lines : std::uint8_t { rows, columns };

/// Lines that are one colour from end to end, the same in all of them, where the reference's are not.
struct MissingLines {
    std::vector<std::uint8_t> marks;  ///< one a line
    std::string text;                 ///< "every second row, (0, 0, 0) throughout"
};
/// Nothing if there are none, or if all are so.
std::optional<MissingLines> missing_lines(const BytePicture& reference, const BytePicture& faulty,
                                          Lines lines);

/// One mark a line: do nearly all of its pixels differ that are not dark in the reference?
std::vector<std::uint8_t> differing_lines(const BytePicture& reference, const BytePicture& faulty,
                                          Lines lines);

/// The one colour of a picture, give or take k_noise; nothing if it has more.
std::optional<std::string> one_color(const BytePicture& picture);

}  // namespace glint
