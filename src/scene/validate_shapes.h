// SPDX-License-Identifier: Apache-2.0
#pragma once
// Checks that a shape's parameters are valid for the formulas.
#include <set>
#include <string>
#include <vector>

#include "glint/scene.h"

namespace glint {

/// The format of messages: "(1, 2, 3)".
std::string text(Vec3 v);

class ShapeCheck {
  public:
    explicit ShapeCheck(const Scene& scene) : scene_(scene) {}

    /// The error in the shape's parameters, valid until the next call: "radius: expected a number > 0, found
    /// -1".
    const std::vector<std::string>& mistakes(const Shape& shape);

  private:
    const Scene& scene_;
    std::vector<std::string> mistakes_;
    std::set<const MeshData*> valid_meshes_, closed_meshes_;  // that shapes have, checked once each
};

}  // namespace glint
