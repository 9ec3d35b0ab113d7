// SPDX-License-Identifier: Apache-2.0
#pragma once
// Why a submission does not have all points of a rubric, in words.
#include <string>
#include <vector>

#include "grade/grade_by_rubric.h"

namespace glint::cli {

/// For the teacher, in all outputs that people read.
inline constexpr const char* k_review_text =
    "The points are provisional: look at the pictures before you use them.";

/// With at most two decimals: "4.5".
std::string points_text(double points);
/// Of all rows.
double all_points(const std::vector<RubricRow>& rows);

/// The reason why a part does not have all its points, and whether it has pixels without a value; empty if
/// there is nothing to report.
std::string part_note(const RubricRow& row, const GradedPart& part, bool with_causes = true);
/// "2 points off for gamma-applied".
std::string penalty_text(const RubricPenalty& penalty, bool with_causes = true);

/// What a lost point is counted under: the id of a cause, "not handed in", "no classic cause".
std::string loss_name(const GradedPart& part);

struct Loss {
    std::string cause;
    double points = 0;
};

/// The cause that costs most points; of equal ones the first. None if the submission has all points.
Loss costliest(const std::vector<RubricRow>& rubric, const GradedSubmission& submission);

}  // namespace glint::cli
