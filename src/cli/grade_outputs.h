// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where `glint grade` writes.
#include <optional>
#include <string>

#include "cli/output_file.h"

namespace glint::cli {

/// As the user named them; empty: not asked for.
struct GradeOutputNames {
    std::string csv, json, sheet;
};

/// Where the results go besides standard output, found out before the work begins.
class GradeOutputs {
  public:
    /// Throws Failure as OutputFile does, and of usage if the next run would take one for a picture of
    /// `folder`.
    GradeOutputs(const GradeOutputNames& names, const std::string& folder);
    GradeOutputs(const GradeOutputs&) = delete;
    GradeOutputs& operator=(const GradeOutputs&) = delete;

    std::optional<OutputFile> csv, json, sheet;
    bool table;  ///< for people, on standard output, where no file goes there
};

}  // namespace glint::cli
