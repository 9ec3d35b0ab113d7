// SPDX-License-Identifier: Apache-2.0
#pragma once
// Causes with numbers that are fitted by drawing: what stands elsewhere or has another colour.
#include <vector>

#include "compare/parameter_fit.h"

namespace glint {

/// Which shape of the scene each pixel of the grid shows, or k_none, in rows from the top.
std::vector<std::uint32_t> shapes_of_pixels(const SceneRenderer& renderer, const PixelGrid& grid);

/// A shape, and its part of the differences of two pictures.
struct ShapeShare {
    std::uint32_t shape = k_none;  ///< k_none: the background
    double share = 0;
};
/// The most different first. The pictures are of the grid's size.
std::vector<ShapeShare> shares_of_shapes(const std::vector<std::uint32_t>& shapes, const BytePicture& a,
                                         const BytePicture& b);

/// "sphere 2 (\"ball\", line 7)", of a shape of the scene.
std::string shape_text(const Scene& scene, std::uint32_t shape);

/// Lights, the camera, spheres and materials elsewhere, or of another size or colour; spheres and materials
/// only of shapes that `shares` begins with.
std::vector<FittedCause> geometry_causes(const SceneRenderer& renderer,
                                         const std::vector<ShapeShare>& shares);

}  // namespace glint
