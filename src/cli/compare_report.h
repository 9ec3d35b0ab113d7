// SPDX-License-Identifier: Apache-2.0
#pragma once
// What `glint compare` prints about two pictures.
#include <optional>
#include <string>
#include <vector>

#include "glint/compare.h"

namespace glint::cli {

struct CompareReport {
    std::string a, b;  ///< the files' names
    std::int32_t width = 0, height = 0;
    double within = 0;  ///< CompareOptions::within
    bool as_floats = false;
    PictureDifference difference;
    std::optional<Result<CauseReport>>
        causes;  ///< absent for pictures that do not differ, or if not asked for
    bool with_scene = false;
    bool passes = false;
    std::string reference = "the reference";  ///< what the text calls B
    /// Of the pixel that is explained, as JSON, in A and in B; or none.
    std::vector<std::string> explanations;
    LargestDifference explained;  ///< that pixel: the one inside an object that differs most
};

std::string text_report(const CompareReport& report);
std::string json_report(const CompareReport& report);

/// 0.99951 -> "99.95%"; only all is "100%", and only nothing "0%".
std::string percent_text(std::uint64_t part, std::uint64_t whole);

/// What stands before the explanation of the first cause if it is not certain; else empty.
std::string likelihood_text(const CauseReport& report);

/// An explained share: "99.8%".
std::string share_text(double share);

}  // namespace glint::cli
