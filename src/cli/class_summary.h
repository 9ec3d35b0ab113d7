// SPDX-License-Identifier: Apache-2.0
#pragma once
// A web page for the teacher: the mistakes of a class, each with its submissions and some of their pictures.
#include <string>
#include <vector>

#include "cli/grade_report.h"
#include "cli/part_pictures.h"

namespace glint::cli {

/// By a rubric. `pictures` has a cell for each part of each submission, submission by submission.
std::string class_summary(const Rubric& rubric, const std::vector<GradedSubmission>& submissions,
                          const PartPictures& pictures);
/// Without a rubric: one picture for each submission.
std::string class_summary(const std::vector<GradedPicture>& graded, const PartPictures& pictures);

}  // namespace glint::cli
