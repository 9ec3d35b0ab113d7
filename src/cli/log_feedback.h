// SPDX-License-Identifier: Apache-2.0
#pragma once
// Logs that are handed in beside pictures (glint diagnose): feedback, never points, since a log can be made
// by glint itself.
#include <optional>
#include <string>
#include <vector>

#include "cli/submissions.h"
#include "glint/diagnose.h"

namespace glint::cli {

struct LogFeedback {
    std::string file;   ///< its path; empty: there is none
    std::string error;  ///< why it cannot be diagnosed
    std::optional<Diagnosis> diagnosis;
};

/// The diagnosis of each submission's first file that matches the pattern.
std::vector<LogFeedback> diagnose_logs(const Scene& scene, const std::vector<Submission>& submissions,
                                       const std::string& pattern, int threads);

/// "mine.log: N is wrong in 3 of 4 pixels ...": for the table and for students.
std::string log_text(const LogFeedback& log, bool with_cause);

}  // namespace glint::cli
