// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which shapes show the difference of two pictures.
#include <cstdint>
#include <vector>

#include "compare/scene_renderer.h"

namespace glint {

/// The shape that each pixel of the grid shows, or k_none, in rows from the top.
std::vector<std::uint32_t> shapes_of_pixels(const SceneRenderer& renderer, const PixelGrid& grid);

/// Whether each of these pixels shows no shape.
std::vector<bool> background_pixels(const SceneRenderer& renderer, const PixelGrid& grid);

/// A shape, and its fraction of the difference of two pictures.
struct ShapeShare {
    std::uint32_t shape = k_none;  ///< k_none: the background
    double share = 0;
};
/// The most different first. The pictures have the grid's size.
std::vector<ShapeShare> shares_of_shapes(const std::vector<std::uint32_t>& shapes, const BytePicture& a,
                                         const BytePicture& b);

}  // namespace glint
