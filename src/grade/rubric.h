// SPDX-License-Identifier: Apache-2.0
#pragma once
// A rubric: which parts of a picture give how many points, and which renderings show them (docs/teaching.md).
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glint/diagnostic.h"
#include "glint/scene.h"

namespace glint {

/// KEY=VALUE pairs: settings and conventions, and lights=all, lights=ambient or lights=N (the ambient light
/// and the first N others).
using RubricSettings = std::vector<std::pair<std::string, std::string>>;

/// A line of a rubric: PART POINTS FILE [KEY=VALUE...] [without KEY=VALUE...]
struct RubricRow {
    std::string part;
    double points = 0;
    std::string file;         ///< of a submission, with * and ?
    RubricSettings settings;  ///< what the scene is drawn with
    RubricSettings without;   ///< what takes the part away again, on top of `settings`; may be empty
};

struct RubricResult {
    std::vector<RubricRow> rows;          ///< of lines without faults
    std::vector<Diagnostic> diagnostics;  ///< with line and column; reading ends after 20
};

/// Reads a rubric. `name` is for messages.
RubricResult read_rubric(std::string_view name, std::string_view text);

/// The scene as a row draws it. The settings must be those of a read rubric.
Scene with_settings(const Scene& scene, const RubricSettings& settings);

}  // namespace glint
