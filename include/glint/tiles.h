// SPDX-License-Identifier: Apache-2.0
#pragma once
// The tiles in which pictures are rendered, for callers who render a picture in parts.
#include <cstddef>
#include <cstdint>

#include "glint/image.h"

namespace glint {

/// Pixels of a tile's side. Tiles at the right and bottom edges of a picture are smaller.
inline constexpr std::int32_t k_tile_side = 32;

/// How many tiles a picture, or a crop of one, of this size has: 0 if a side has no pixels.
inline std::size_t count_tiles(const Crop& picture) {
    const auto side = [](std::int32_t pixels) {
        return pixels < 1 ? std::size_t{0} : static_cast<std::size_t>((pixels - 1) / k_tile_side + 1);
    };
    return side(picture.width) * side(picture.height);
}

/// The pixels of a tile; empty if the picture has no tile of this number. Tiles are numbered row by row from
/// the top left of `picture`. The origin of x and y is that of `picture`'s.
inline Crop tile_area(const Crop& picture, std::size_t tile) {
    if (tile >= count_tiles(picture)) return {};
    const auto across = static_cast<std::size_t>((picture.width - 1) / k_tile_side + 1);
    const auto x = static_cast<std::int32_t>(tile % across) * k_tile_side;
    const auto y = static_cast<std::int32_t>(tile / across) * k_tile_side;
    const auto side = [](std::int32_t left) { return left < k_tile_side ? left : k_tile_side; };
    return {side(picture.width - x), side(picture.height - y), picture.x + x, picture.y + y};
}

}  // namespace glint
