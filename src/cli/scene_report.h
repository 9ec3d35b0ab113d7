// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `glint info` prints.
#include <string>
#include <vector>

#include "glint/glint.h"

namespace glint::cli {

struct SceneReport {
    const Scene& scene;
    const World& world;
    const std::vector<Diagnostic>& warnings;
};

std::string text_report(const SceneReport& report);
std::string json_report(const SceneReport& report);

/// The sum of the lights' colours, intensities included.
Color sum_of_lights(const Scene& scene);

/// Where a setting came from: "profile cgfs", "castle.json:3:5", "command line", "code".
std::string origin_text(const Scene& scene, std::size_t key);

}  // namespace glint::cli
