// SPDX-License-Identifier: Apache-2.0
#pragma once
// The sum of a pixel, and its samples, as text.
#include <string>

#include "cli/explain_text.h"

namespace glint::cli {

/// The layers that are not black, their sum, and the numbers of the file.
std::string sum_text(const Explanation& e, const Scene& scene, const ExplainStyle& style);

/// Why adaptive sampling gives the pixel several samples, or one.
std::string adaptive_text(const Explanation& e, const Scene& scene, const ExplainStyle& style);

}  // namespace glint::cli
