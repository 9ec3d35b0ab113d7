// SPDX-License-Identifier: Apache-2.0
#pragma once
// A diagnosis of another ray tracer's log as text.
#include <string>

#include "glint/diagnose.h"

namespace glint::cli {

/// What the log's numbers mean, and each finding with its cause.
std::string diagnosis_text(const Diagnosis& diagnosis, const Scene& scene);

/// The first finding in one line, without a full stop. with_cause: also what gives its numbers.
std::string feedback_text(const Diagnosis& diagnosis, bool with_cause);

/// The program's picture beside its log: whether it has the log's bytes, and which of the pixels that were
/// proposed from it the log does not have. Empty: nothing is to be said.
std::string picture_text(const Diagnosis& diagnosis, const Image& picture,
                         const std::vector<ProposedPixel>& proposed);

/// All quantities of a pixel of the log in Diagnosis::rows, beside what they should be. Empty: it is not
/// there.
std::string diagnosis_tree_text(const Diagnosis& diagnosis, const Scene& scene, std::int32_t x,
                                std::int32_t y);

}  // namespace glint::cli
