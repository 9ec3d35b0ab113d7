// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `glint grade` prints and writes.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "glint/compare.h"
#include "grade/grading.h"

namespace glint::cli {

/// A picture that was compared with the reference.
struct GradedPicture {
    std::string name, path;
    std::string error;             ///< why there are no figures
    std::uint64_t not_finite = 0;  ///< its pixels that are NaN or infinite; then no cause is looked for
    PictureDifference difference;
    CauseReport causes;
    std::string causes_error;  ///< why there are none
};

std::string text_table(const std::vector<GradedPicture>& pictures);
std::string csv_table(const std::vector<GradedPicture>& pictures);
std::string json_table(const std::vector<GradedPicture>& pictures);

/// One part of a rubric, of one submission.
struct GradedPart {
    std::string path;   ///< of the picture; empty: none was handed in
    std::string error;  ///< why there are no points: "no file *phong*.png"
    PartScore score;
    std::optional<Cause> cause;  ///< of what is wrong
};

struct GradedSubmission {
    std::string name;
    std::vector<GradedPart> parts;  ///< as the rubric's rows
    double total() const;
};

std::string text_table(const std::vector<RubricRow>& rows, const std::vector<GradedSubmission>& submissions);
std::string csv_table(const std::vector<RubricRow>& rows, const std::vector<GradedSubmission>& submissions);
std::string json_table(const std::vector<RubricRow>& rows, const std::vector<GradedSubmission>& submissions);

}  // namespace glint::cli
