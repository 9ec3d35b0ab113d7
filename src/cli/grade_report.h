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
    std::string error;             ///< the reason why there are no figures
    std::uint64_t not_finite = 0;  ///< its pixels that are NaN or infinite; then no causes are searched
    PictureDifference difference;
    CauseReport causes;
    std::string causes_error;  ///< the reason why there are none
};

std::string text_table(const std::vector<GradedPicture>& pictures);
std::string csv_table(const std::vector<GradedPicture>& pictures);
std::string json_table(const std::vector<GradedPicture>& pictures);

/// One part of a rubric, of one submission.
struct GradedPart {
    std::string path;   ///< of the picture; empty: none was handed in
    std::string error;  ///< the reason why there are no points: "no file *phong*.png"
    PartScore score;
    std::optional<Cause> cause;  ///< of the difference
    std::vector<Cause> then;     ///< further causes, together with the first
    /// The causes of earlier parts with which the picture was judged, because that gives more points; none if
    /// it was judged as it is.
    std::vector<std::string> followed;
    double points_alone = 0;  ///< the points without them
};

struct GradedSubmission {
    std::string name;
    std::vector<GradedPart> parts;  ///< as the rubric's rows
    double total() const;
};

std::string text_table(const std::vector<RubricRow>& rows, const std::vector<GradedSubmission>& submissions);
std::string csv_table(const std::vector<RubricRow>& rows, const std::vector<GradedSubmission>& submissions);
std::string json_table(const std::vector<RubricRow>& rows, const std::vector<GradedSubmission>& submissions);
/// The file that Gradescope reads: a test for each part.
std::string gradescope_results(const std::vector<RubricRow>& rows, const GradedSubmission& submission);

}  // namespace glint::cli
