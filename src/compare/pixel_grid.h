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

/// A grid of about k_grid_pixels of the pictures that the scene draws at this size.
inline constexpr std::int64_t k_grid_pixels = 24000;
PixelGrid grid_of(const Scene& scene, std::int32_t width, std::int32_t height);

/// Those pixels of a picture, or of numbers of which there is one a pixel.
BytePicture on_grid(const BytePicture& picture, const PixelGrid& grid);
std::vector<std::uint8_t> on_grid(const std::vector<std::uint8_t>& marks, const PixelGrid& grid);

/// Changes a scene of the picture's size so that its picture is those pixels: rays pass the same places.
/// Where a pixel has several samples it has one instead, in its middle.
void draw_grid(Scene& scene, const PixelGrid& grid);

}  // namespace glint
