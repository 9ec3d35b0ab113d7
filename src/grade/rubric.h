// SPDX-License-Identifier: Apache-2.0
#pragma once
// A rubric: the points for parts of a picture, and the renderings that show the parts (docs/teaching.md).
#include <cstdint>
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
    RubricSettings settings;  ///< for rendering the scene
    RubricSettings without;   ///< removes the part again, in addition to `settings`; may be empty
    std::uint32_t line = 0;   ///< in the rubric, from 1
};

/// A line of a rubric: penalty CAUSE POINTS
struct RubricPenalty {
    std::string cause;  ///< one of cause_names()
    double points = 0;  ///< taken off once, instead of those of a part
};

struct Rubric {
    std::string name;  ///< for messages
    std::vector<RubricRow> rows;
    std::vector<RubricPenalty> penalties;
};

struct RubricResult {
    Rubric rubric;                        ///< of valid lines
    std::vector<Diagnostic> diagnostics;  ///< with line and column; reading stops after 20
};

/// Reads a rubric. `name` is for messages.
RubricResult read_rubric(std::string_view name, std::string_view text);

/// The scene with the settings of a row. They must be those of a rubric from read_rubric().
Scene with_settings(const Scene& scene, const RubricSettings& settings);
/// The same in place, without the keys `lights`.
void set_all_but_lights(Scene& scene, const RubricSettings& settings);
/// By light of the scene: whether the settings keep it.
std::vector<bool> kept_lights(const Scene& scene, const RubricSettings& settings);

}  // namespace glint
