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
};

/// The causes that can make a difference to this scene, simple ones first.
std::vector<SceneCause> scene_causes(const Scene& scene);

/// Multiplies every light's intensity.
void scale_lights(Scene& scene, double factor);

}  // namespace glint
