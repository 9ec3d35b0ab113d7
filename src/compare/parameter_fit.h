// SPDX-License-Identifier: Apache-2.0
#pragma once
// The numbers with which a scene's rendering is nearest to a picture.
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "compare/pixel_grid.h"

namespace glint {

/// The scalar product of two lists of the same length.
double product(const std::vector<float>& a, const std::vector<float>& b);

/// Numbers to fit, and how a picture is rendered with them.
struct FitProblem {
    std::vector<double> start, units;  ///< FittedCause::units
    /// The picture as Image::rgb; nothing if it cannot be rendered.
    std::function<std::optional<std::vector<float>>(std::span<const double>)> render;
};

struct Fit {
    std::vector<double> values;
    double left = 0;  ///< remaining mean difference of the bytes, in 255ths
};

/// How far from the start the numbers may be.
enum class FitStart : std::uint8_t {
    far,  ///< edges may not meet yet: pictures are blurred first, so that they still say where to go
    near
};

/// Fits numbers to one picture by the method of Levenberg and Marquardt.
class ParameterFit {
  public:
    /// `target` has the grid's size. Throws bad_alloc.
    ParameterFit(const PixelGrid& grid, const BytePicture& target);

    /// The fraction of the squared, blurred difference that the best small change removes. `at_start` is what
    /// the problem renders at its start.
    double promise(const FitProblem& problem, const std::vector<float>& at_start) const;
    /// The squared, blurred difference of a rendered picture.
    double blurred_square(std::vector<float> rendered) const;
    /// Nothing if it cannot be rendered, or has too many numbers.
    std::optional<Fit> fit(const FitProblem& problem, FitStart start) const;

  private:
    struct Step;

    std::vector<float> blurred_difference(const std::vector<float>& to, const std::vector<float>& from,
                                          int radius) const;
    std::optional<Step> step_from(const FitProblem& problem, std::span<const double> values,
                                  const std::vector<float>& rendered, int radius, double by) const;
    static Step step_of(const std::vector<std::vector<float>>& slopes, const std::vector<float>& error);
    double left_of(const std::vector<float>& rendered) const;
    void polish(const FitProblem& problem, Fit& fit) const;
    Fit rounded(const FitProblem& problem, Fit found) const;

    const PixelGrid grid_;
    std::vector<float> target_;  // 0 to 1
};

}  // namespace glint
