// SPDX-License-Identifier: Apache-2.0
#pragma once
// glint grade --rubric: the points of every submission, part by part.
#include <functional>
#include <string>
#include <vector>

#include "cli/grade_report.h"
#include "cli/grade_sheet.h"
#include "cli/submissions.h"

namespace glint::cli {

struct RubricGrading {
    const Scene& scene;
    const std::vector<RubricRow>& rows;
    const std::string& rubric;  ///< its name, for messages
    const std::vector<Submission>& submissions;
    int threads = 0;
    std::function<void(double)> progress;  ///< with the fraction done
};

/// Grades all parts of all submissions and puts their pictures on the sheet, a row of cells for the wanted
/// pictures and one for each submission. Throws Failure if a part cannot be rendered or shows nothing.
std::vector<GradedSubmission> grade_by_rubric(const RubricGrading& grading, GradeSheet& sheet);

}  // namespace glint::cli
