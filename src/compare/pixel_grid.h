// SPDX-License-Identifier: Apache-2.0
#pragma once
// Some pixels of a picture, on which causes are tried first.
#include "compare/byte_picture.h"
#include "glint/scene.h"

namespace glint {

/// The middle pixel of every block of step x step pixels. With step 1 all pixels.
struct PixelGrid {
    std::int32_t width = 0, height = 0;  ///< of the picture
    std::int32_t step = 1;               ///< odd

    std::int32_t columns() const { return width / step; }
    std::int32_t rows() const { return height / step; }
};

/// A grid of about k_grid_pixels for renderings of the scene at this size.
inline constexpr std::int64_t k_grid_pixels = 24000;
PixelGrid grid_of(const Scene& scene, std::int32_t width, std::int32_t height);
/// A grid of at least k_coarse_pixels, for searches with many renderings.
inline constexpr std::int64_t k_coarse_pixels = 2000;
PixelGrid coarse_grid_of(const Scene& scene, std::int32_t width, std::int32_t height);

/// The picture's rows that have pixels of the grid.
Rows rows_of(const PixelGrid& grid);

/// Those pixels of a picture, or of a list with one number per pixel.
BytePicture on_grid(const BytePicture& picture, const PixelGrid& grid);
std::vector<std::uint8_t> on_grid(const std::vector<std::uint8_t>& marks, const PixelGrid& grid);

/// Changes a scene of the picture's size so that its rendering is those pixels: the rays are the same. A
/// pixel with several samples gets one instead, in its middle.
void set_grid(Scene& scene, const PixelGrid& grid);

}  // namespace glint
