// SPDX-License-Identifier: Apache-2.0
#pragma once
// `glint compare SCENE --vary KEY=VALUES`: finds the values of a setting that change the picture.
#include <string>
#include <vector>

#include "cli/scene_option.h"

namespace glint::cli {

struct Variation {
    std::size_t key = 0;
    std::vector<std::string> values;
};

/// Parses "reflections=0..5" or "epsilon=0,1e-6,1e-3". Throws a usage error.
Variation parse_variation(const std::string& text);

/// Renders the scene with each value and prints how many pixels each step changes. Returns the exit code.
/// Throws Failure.
int vary_command(SceneOption& scene, const Variation& variation, int threads, bool json, bool quiet);

}  // namespace glint::cli
