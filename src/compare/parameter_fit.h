// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers of a scene with which it draws a picture: a light's place, the field of view.
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "compare/scene_renderer.h"

namespace glint {

struct FittedCause {
    std::string name;
    /// One for each number: a change of it that moves things by about a pixel.
    std::vector<double> units;
    std::function<void(FaultyScene&, std::span<const double>)> put;
    std::function<std::string(std::span<const double>)> text;
};

struct Fit {
    std::vector<double> values;
    double left = 0;  ///< mean difference of the bytes that stays
};

/// Fits numbers to one picture by the method of Levenberg and Marquardt, on blurred pictures first: then
/// edges that do not meet yet still say where to go.
class ParameterFit {
  public:
    /// `target` is of the grid's size. All must outlive it. Throws bad_alloc.
    ParameterFit(const SceneRenderer& renderer, const PixelGrid& grid, const FaultyScene& base,
                 const RenderedScene& drawn, const BytePicture& target);

    /// The share of the squared, blurred difference that goes away with the best small change.
    double promise(const FittedCause& cause) const;
    /// Nothing if it cannot be drawn.
    std::optional<Fit> fit(const FittedCause& cause) const;

  private:
    struct Step;

    std::optional<std::vector<float>> draw(const FittedCause& cause, std::span<const double> values) const;
    std::vector<float> blurred_difference(const std::vector<float>& to, const std::vector<float>& from,
                                          int radius) const;
    std::optional<Step> step_from(const FittedCause& cause, std::span<const double> values,
                                  const std::vector<float>& drawn, int radius) const;
    double left_of(const std::vector<float>& drawn) const;
    Fit rounded(const FittedCause& cause, Fit found) const;

    const SceneRenderer& renderer_;
    const PixelGrid grid_;
    const FaultyScene& base_;
    std::vector<float> drawn_, target_;  // 0 to 1
};

}  // namespace glint
