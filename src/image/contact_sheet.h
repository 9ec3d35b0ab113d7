// SPDX-License-Identifier: Apache-2.0
#pragma once
// Many small pictures on one.
#include <cstdint>
#include <optional>
#include <vector>

#include "glint/image.h"

namespace glint {

/// A picture and below it its difference from what it should be, both scaled down.
struct SheetCell {
    Image picture;     ///< without pixels: nothing was handed in, and the cell is an empty frame
    Image difference;  ///< without pixels: there is none
    int number = 0;    ///< drawn in the corner; negative: none
};

/// The picture at most `side` pixels wide and high, by averaging; never larger than it was.
Image scaled_down(const Image& picture, std::int32_t side);

/// How cells lie on a sheet.
struct SheetLayout {
    std::int32_t side = 160;  ///< pixels: pictures are at most so wide and high
    std::size_t columns = 1;  ///< cells of a row
    /// Rows below the first, the head; those that are more go on beside them, below a head of their own. 0:
    /// no row is a head, and nothing goes on beside.
    std::size_t rows = 0;
};

/// As many columns as make the sheet about square. Nothing if there are more cells than a sheet can show.
std::optional<SheetLayout> lay_out_list(std::size_t cells);

/// A table of a head and `rows` rows more. Nothing if there are more cells than a sheet can show.
std::optional<SheetLayout> lay_out_table(std::size_t rows, std::size_t columns);

/// The cells row by row, on a sheet of at most k_sheet_side pixels a side if the layout was made for them.
Image contact_sheet(const std::vector<SheetCell>& cells, const SheetLayout& layout);

inline constexpr std::int32_t k_sheet_side = 6000;

}  // namespace glint
