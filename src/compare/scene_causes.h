// SPDX-License-Identifier: Apache-2.0
#pragma once
// The causes that are tried by rendering the scene with a fault.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "compare/scene_renderer.h"
#include "glint/compare.h"

namespace glint {

/// Renders a changed scene, for a cause whose picture is a sum of several.
using RenderScene = std::function<std::optional<Image>(const Scene&)>;

struct SceneCause {
    std::string name, explanation;
    std::function<void(Scene&)> put;  ///< puts the fault into a copy of the scene
    /// If the fault takes away a part of the sum of light: that part's name, "the ambient term". Then a
    /// multiple of it is tried, too, as the cause `scaled`, which `scale_part` puts into a scene.
    std::string part = {}, scaled = {};
    std::function<void(Scene&, double)> scale_part = {};
    /// What the factor is among the scene's numbers, as a further sentence.
    std::function<std::string(double factor)> scale_hint = {};
    /// If a number of the scene is a multiple of what it should be (after `put`, which may be empty): makes
    /// it one, and says so, of a factor that is fitted. There is no other explanation then.
    std::function<void(Scene&, double)> scale = {};
    std::function<std::string(double factor, bool about)> scale_text = {};
    /// The cause whose picture an ever larger factor gives, and what is said if the pixels do not tell them
    /// apart from this factor on.
    std::string limit = {};
    std::function<std::string(double factor)> limit_text = {};
    /// If no setting of the scene makes the fault: its picture as a sum of others. `put` is empty then.
    std::function<std::optional<Image>(const Scene&, const RenderScene&)> compose = {};
    void (*reshape)(Scene&) = nullptr;      ///< changes the scene with its shapes
    TracerFault fault = TracerFault::none;  ///< of the kernels
    bool is_of_samples = false;             ///< visible only at edges: needs all pixels
    bool is_shift = false;                  ///< of the whole picture, by a pixel or less
    bool only_pairs = false;                ///< tried only together with another cause
    double least = k_min_explained;         ///< CauseCandidate::least
};

/// The causes that can make a difference to this scene, simple ones first.
std::vector<SceneCause> scene_causes(const Scene& scene);

}  // namespace glint
