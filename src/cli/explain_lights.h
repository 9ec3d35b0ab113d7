// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the lights add at a hit, as text.
#include "cli/explain_numbers.h"

namespace glint::cli {

/// The lights of a hit, each with its factors, what blocks it, and its highlights.
void add_lights(IndentedText& text, const Scene& scene, const ExplainStyle& style, const ExplainedHit& hit,
                int depth);

}  // namespace glint::cli
