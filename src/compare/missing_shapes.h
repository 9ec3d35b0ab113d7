// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shapes that are not drawn.
#include <vector>

#include "compare/cause_ranking.h"
#include "compare/shape_shares.h"

namespace glint {

inline constexpr const char* k_shape_missing = "shape-missing";

/// A rendered picture, the shape that each of its pixels shows, and the shapes' parts of the difference.
struct SeenShapes {
    const std::vector<std::uint32_t>& of_pixels;
    const std::vector<ShapeShare>& shares;
    const BytePicture& rendered;
};

/// Tries the causes that leave out a shape that shows much of the difference, or all shapes of its kind, on
/// a scene that may have a fault already. A shape that cannot be seen, for example a black one before a
/// black background, is not said to be missing, although its shadow may be.
void try_missing_shapes(const SceneRenderer& renderer, const SeenShapes& seen,
                        const std::function<std::optional<RenderedScene>(const FaultyScene&)>& render,
                        Search& search);

}  // namespace glint
