// SPDX-License-Identifier: Apache-2.0
#pragma once
// The causes that are tried by drawing the scene with a fault.
#include <functional>
#include <string>
#include <vector>

#include "glint/scene.h"

namespace glint {

struct SceneCause {
    std::string name, explanation;
    std::function<void(Scene&)> put;  ///< puts the fault into a copy of the scene
    /// If the fault takes away a part of the sum of light: that part's name, "the ambient term". Then a
    /// multiple of it is tried, too, as the cause `scaled`.
    std::string part = {}, scaled = {};
    /// If a number of the scene is a multiple of what it should be (after `put`, which may be empty): makes
    /// it one, and says so, of a factor that is fitted. There is no other explanation then.
    std::function<void(Scene&, double)> scale = {};
    std::function<std::string(double factor, bool about)> scale_text = {};
};

/// The causes that can make a difference to this scene, simple ones first.
std::vector<SceneCause> scene_causes(const Scene& scene);

}  // namespace glint
