// SPDX-License-Identifier: Apache-2.0
#pragma once
// The results of one submission for the programs that show them to the student.
#include <string>
#include <vector>

#include "cli/part_pictures.h"
#include "grade/grade_by_rubric.h"

namespace glint::cli {

struct StudentResultOptions {
    std::string visibility = "visible";  ///< Gradescope's: visible, hidden, after_due_date, after_published
    bool with_causes = true;             ///< false: points and shares, without what explains them
    std::string log = {};                ///< what the submission's log shows; empty: no log is asked for
    const PartPictures* pictures = nullptr;  ///< by row; null: none
};

/// Gradescope's results.json: a test for each part. Its specification:
/// https://gradescope-autograders.readthedocs.io/en/latest/specs/, "Output format".
std::string gradescope_results(const Rubric& rubric, const GradedSubmission& submission,
                               const StudentResultOptions& options = {});

/// PrairieLearn's results.json of external grading: a test for each part, below 1 MB. Its specification:
/// https://prairielearn.readthedocs.io/en/latest/externalGrading/, "Grading results".
std::string prairielearn_results(const Rubric& rubric, const GradedSubmission& submission,
                                 const StudentResultOptions& options = {});

}  // namespace glint::cli
