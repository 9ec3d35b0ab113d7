// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `glint grade` prints and writes.
#include <cstdint>
#include <string>
#include <vector>

#include "cli/log_feedback.h"
#include "glint/compare.h"
#include "grade/grade_by_rubric.h"

namespace glint::cli {

/// A picture that was compared with the reference.
struct GradedPicture {
    std::string name, path;
    std::string error;             ///< the reason why there are no figures
    std::string note;              ///< DecodedImage::note
    std::uint64_t not_finite = 0;  ///< its pixels that are NaN or infinite; then no causes are searched
    PictureDifference difference;
    CauseReport causes;
    std::string causes_error;  ///< the reason why there are none
};

std::string text_table(const std::vector<GradedPicture>& pictures);
std::string csv_table(const std::vector<GradedPicture>& pictures);
std::string json_table(const std::vector<GradedPicture>& pictures);

std::string text_table(const std::vector<RubricRow>& rows, const std::vector<GradedSubmission>& submissions);
std::string csv_table(const std::vector<RubricRow>& rows, const std::vector<GradedSubmission>& submissions);
/// logs: of each submission, or none at all.
std::string json_table(const std::vector<RubricRow>& rows, const std::vector<GradedSubmission>& submissions,
                       const std::vector<LogFeedback>& logs);

}  // namespace glint::cli
