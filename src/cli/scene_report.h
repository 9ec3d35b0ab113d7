// SPDX-License-Identifier: Apache-2.0
#pragma once
// The output of `glint info`.
#include <string>
#include <vector>

#include "glint/glint.h"

namespace glint::cli {

struct SceneReport {
    const Scene& scene;
    const World& world;
    const std::vector<Diagnostic>& warnings;
    const std::vector<SceneText>& texts;
};

std::string text_report(const SceneReport& report);
std::string json_report(const SceneReport& report);

/// The sum of the lights' colors times their intensities.
Color sum_of_lights(const Scene& scene);

/// The origin of a setting's value: "profile cgfs", "castle.json:3:5", "command line", "code".
std::string origin_text(const Scene& scene, std::size_t key);

}  // namespace glint::cli
