#pragma once
// Many small pictures on one.
#include <cstdint>
#include <vector>

#include "glint/image.h"

namespace glint {

/// A picture and below it its difference from what it should be, both scaled down.
struct SheetCell {
    Image picture;     ///< without pixels: nothing was handed in, the cell stays dark
    Image difference;  ///< without pixels: there is none
    int number = 0;    ///< drawn in the corner; negative: none
};

/// The picture at most `side` pixels wide and high, by averaging; never larger than it was.
Image scaled_down(const Image& picture, std::int32_t side);

/// The cells row by row, `columns` to a row.
Image contact_sheet(const std::vector<SheetCell>& cells, std::size_t columns);

}  // namespace glint
