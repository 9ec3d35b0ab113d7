// SPDX-License-Identifier: Apache-2.0
#pragma once
// The outputs of `glint grade`.
#include <optional>
#include <string>

#include "cli/output_file.h"

namespace glint::cli {

/// As the user named them; empty: not requested.
struct GradeOutputNames {
    std::string csv, json, gradescope, prairielearn, sheet, summary;
};

/// The destinations of the results other than standard output; checked before the work begins.
class GradeOutputs {
  public:
    /// Throws the errors of OutputFile, and a usage error if the next run would read an output as a picture
    /// of `folder`.
    GradeOutputs(const GradeOutputNames& names, const std::string& folder);
    GradeOutputs(const GradeOutputs&) = delete;
    GradeOutputs& operator=(const GradeOutputs&) = delete;

    /// Whether there are results for one student: the folder is one submission.
    bool is_of_one() const { return gradescope || prairielearn; }

    std::optional<OutputFile> csv, json, gradescope, prairielearn, sheet, summary;
    bool table;  ///< print the table on standard output, if no file goes there
};

}  // namespace glint::cli
