// SPDX-License-Identifier: Apache-2.0
// Which of several causes that explain a picture is named.
#include "compare/small_scene.h"

namespace glint::test {
namespace {

CauseReport report_of(const std::string& faulty, const std::string& right) {
    const Scene scene = read_scene(right);
    return *find_causes(draw_text(faulty), draw_text(right), &scene);
}

// Highlights are so faint that the diffuse term alone explains nearly all of what is missing.
TEST(CausesRanked, TheExactCauseThatLeavesLess) {
    const std::string text =
        replaced(replaced(k_scene, "specular = 0.4", "specular = 0.06"), "specular = 0.6", "specular = 0.06");
    std::string half = replaced(text, "intensity = 0.6", "intensity = 0.3");
    half = replaced(half, "intensity = 0.4", "intensity = 0.2");
    const CauseReport report = report_of(half, text);
    EXPECT_EQ(first_cause(report), "light-intensity") << all_causes(report);
    EXPECT_FALSE(report.causes[0].perhaps);
}

// Without highlights both are the same: the first in the table is named.
TEST(CausesRanked, TheFirstOfExactCausesThatLeaveTheSame) {
    const std::string text =
        replaced(replaced(k_scene, "specular = 0.4", "specular = 0"), "specular = 0.6", "specular = 0");
    std::string half = replaced(text, "intensity = 0.6", "intensity = 0.3");
    half = replaced(half, "intensity = 0.4", "intensity = 0.2");
    const CauseReport report = report_of(half, text);
    EXPECT_EQ(first_cause(report), "diffuse-scaled") << all_causes(report);
}

}  // namespace
}  // namespace glint::test
