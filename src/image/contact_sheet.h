// SPDX-License-Identifier: Apache-2.0
#pragma once
// A sheet of many small pictures.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glint/image.h"

namespace glint {

/// A picture, and below it its difference from the reference, both scaled down.
struct SheetCell {
    Image picture;      ///< without pixels: no picture was handed in; the cell is an empty frame
    Image difference;   ///< without pixels: there is no difference
    std::string label;  ///< shown in the top left corner, in capitals; cut off at the width of the picture
};

/// The picture scaled down by averaging to at most `side` pixels in width and height; never enlarged.
Image scaled_down(const Image& picture, std::int32_t side);

/// The layout of cells on a sheet.
struct SheetLayout {
    std::int32_t side = 160;  ///< pixels: the maximum width and height of a picture
    std::size_t columns = 1;  ///< cells per row
    /// Rows below the first row, which is the head. Further rows continue in a block to the right, with its
    /// own head. 0: no head, and only one block.
    std::size_t rows = 0;
};

/// A layout with a nearly square sheet. Nothing if there are more cells than a sheet can show.
std::optional<SheetLayout> lay_out_list(std::size_t cells);

/// A layout for a table of a head and `rows` more rows. Nothing if there are too many cells for a sheet.
std::optional<SheetLayout> lay_out_table(std::size_t rows, std::size_t columns);

/// The cells row by row. A sheet has at most k_sheet_side pixels on a side if the layout was made for it.
Image contact_sheet(const std::vector<SheetCell>& cells, const SheetLayout& layout);

inline constexpr std::int32_t k_sheet_side = 6000;

}  // namespace glint
