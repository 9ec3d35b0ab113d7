// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shapes that are not drawn.
#include <vector>

#include "compare/cause_ranking.h"
#include "compare/shape_shares.h"

namespace glint {

inline constexpr const char* k_shape_missing = "shape-missing";

/// The causes that leave out a shape that shows much of the difference, or all shapes of its kind.
std::vector<CauseCandidate> missing_shapes(const SceneRenderer& renderer,
                                           const std::vector<ShapeShare>& shares);

/// Tries them, on a scene that may have a fault already.
void try_missing_shapes(const SceneRenderer& renderer, const std::vector<ShapeShare>& shares,
                        const std::function<std::optional<RenderedScene>(const FaultyScene&)>& render,
                        Search& search);

}  // namespace glint
