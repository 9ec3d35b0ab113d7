// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether a shape's parameters are what the formulas need.
#include <string>
#include <vector>

#include "glint/scene.h"

namespace glint {

/// As messages write it: "(1, 2, 3)".
std::string text(Vec3 v);

class ShapeCheck {
  public:
    explicit ShapeCheck(const Scene& scene) : scene_(scene) {}

    /// What is wrong with the shape's parameters, until the next call: "radius: expected a number > 0, found
    /// -1".
    const std::vector<std::string>& mistakes(const Shape& shape);

  private:
    const Scene& scene_;
    std::vector<std::string> mistakes_;
};

}  // namespace glint
