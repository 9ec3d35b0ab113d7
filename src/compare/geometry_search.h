// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fits positions, sizes and colors to a picture.
#include <functional>
#include <span>
#include <vector>

#include "compare/cause_ranking.h"
#include "compare/geometry_causes.h"

namespace glint {

/// Renders a scene, with whatever else makes its picture.
using RenderScenePicture = std::function<std::optional<RenderedScene>(const FaultyScene&)>;

/// Fits the most promising of `causes`, at most `most`, to the search's target, and judges them. `render`
/// gives pictures of the grid's size of `base`, which has no fault of `causes`. Ends early if one explains
/// nearly all.
void fit_geometry(const std::vector<FittedCause>& causes, const PixelGrid& grid, const FaultyScene& base,
                  const RenderScenePicture& render, std::size_t most, Search& search);

/// Fits the other forms of a cause whose numbers are fitted (FittedCause::refined), and judges them: always
/// the nearest form, from its first numbers.
void fit_forms(const FittedCause& cause, std::span<const double> values, const PixelGrid& grid,
               const FaultyScene& base, const RenderScenePicture& render, Search& search);

}  // namespace glint
