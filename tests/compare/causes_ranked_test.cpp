// SPDX-License-Identifier: Apache-2.0
// Which of several causes that explain a picture is named.
#include "compare/cause_ranking.h"
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

// Of exact causes, pixels that are wrong count before the number of fitted ones, but for one or two.
TEST(CausesRanked, TheExactCauseThatGivesThePixels) {
    const auto first_of = [](std::size_t wrong_of_simple, std::size_t wrong_of_fitted) {
        Search search;
        search.whole = {1, 1};
        CauseCandidate simple, fitted;
        simple.cause.name = "simple";
        simple.left = {0.007, 0.007};
        simple.wrong = wrong_of_simple;
        fitted.cause.name = "fitted";
        fitted.left = {0.004, 0.004};
        fitted.wrong = wrong_of_fitted;
        fitted.parameters = 1;
        simple.is_exact = fitted.is_exact = true;
        search.found = {simple, fitted};
        bool away_from_edges = false;
        return ranked(search, away_from_edges).front().cause.name;
    };
    EXPECT_EQ(first_of(1, 0), "simple");
    EXPECT_EQ(first_of(12, 0), "fitted");
    EXPECT_EQ(first_of(0, 12), "simple");
    // Where many are wrong, as with another program's samples, a few more say nothing.
    EXPECT_EQ(first_of(205, 200), "simple");
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

const std::string k_floor = R"(
background = (0.2, 0.3, 0.5)
camera { position = (0, 2, 7)  look_at = (0, 1, 0)  fov_x = 50 }
light { type = ambient  intensity = 0.8 }
light { type = point  position = (3, 6, 5)  intensity = 0.8 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.6, 0.6, 0.5)  ambient = 0.2 }
sphere { center = (-0.6, 1, 0)  radius = 1  color = (0.6, 0.6, 0.5)  ambient = 0.2 }
render { size = 60 x 45  shading = phong }
)";

// All surfaces have one color. "The background was replaced, and there is no light" gives the same picture.
TEST(CausesRanked, ASurfaceIsNoBackground) {
    const Scene scene = read_scene(k_floor);
    const Image right = draw(scene);
    Scene flat = scene;
    for (Shape& shape : flat.shapes) shape.material = 0;
    Material white;
    white.color = {0.9, 0.9, 0.9};
    flat.materials.assign(flat.materials.size(), white);
    flat.settings.shading = Shading::color;
    const CauseReport report = *find_causes(as_file(draw(flat)), as_file(right), &scene);
    std::vector<Cause> named = report.causes;
    named.insert(named.end(), report.then.begin(), report.then.end());
    for (const Cause& cause : named)
        EXPECT_TRUE(cause.perhaps || cause.name != "background") << cause.explanation << all_causes(report);
}

// The background that is one is found, alone and after another fault.
TEST(CausesRanked, TheBackground) {
    const Scene scene = read_scene(k_floor);
    const Image right = draw_text(k_floor);
    const std::string other =
        replaced(k_floor, "background = \\(0.2, 0.3, 0.5\\)", "background = (0.3, 0.1, 0.5)");
    EXPECT_EQ(first_cause(*find_causes(draw_text(other), right, &scene)), "background");
    const CauseReport both =
        *find_causes(draw_text(replaced(other, "phong", "phong  shadows = false")), right, &scene);
    ASSERT_EQ(both.then.size(), 1u) << all_causes(both);
    EXPECT_EQ(first_cause(both), "background") << all_causes(both);
    EXPECT_EQ(both.then[0].name, "shadows-missing") << both.then[0].explanation;
}

// The specular term is multiplied by k_d. With grey surfaces that is a factor.
TEST(CausesRanked, HighlightsOfTheDiffuseColor) {
    const std::string text = replaced(k_floor, "  color = \\(0.6, 0.6, 0.5\\)  ambient = 0.2 \\}\nrender",
                                      "  diffuse_color = (0.8, 0.4, 0.2)  ambient_color = (0.1, 0.1, 0.1)  "
                                      "specular_color = (0.5, 0.5, 0.5)  shininess = 9 }\nrender");
    const std::string tinted =
        replaced(text, "specular_color = \\(0.5, 0.5, 0.5\\)", "specular_color = (0.4, 0.2, 0.1)");
    const CauseReport report = report_of(tinted, text);
    EXPECT_EQ(first_cause(report), "highlight-surface-color") << all_causes(report);
    EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps);
    const std::string grey = replaced(text, "0.8, 0.4, 0.2", "0.4, 0.4, 0.4");
    const std::string faint =
        replaced(grey, "specular_color = \\(0.5, 0.5, 0.5\\)", "specular_color = (0.2, 0.2, 0.2)");
    EXPECT_EQ(first_cause(report_of(faint, grey)), "specular-scaled");
}

// The program that shows normals draws the rest as it should.
TEST(CausesRanked, NormalsBeforeTheBackground) {
    const Scene scene = read_scene(k_floor);
    const Image right = draw_text(k_floor);
    Scene normals = scene, white = scene;
    normals.settings.shading = Shading::normals;
    white.settings.shading = Shading::color;
    white.background = {0, 0, 0};
    Image shown = draw(normals);
    const Image surfaces = draw(white);
    for (std::size_t i = 0; i < shown.rgb.size(); i += 3) {
        if (surfaces.rgb[i] == 0) std::copy_n(&right.rgb[i], 3, &shown.rgb[i]);
    }
    const CauseReport report = *find_causes(as_file(shown), right, &scene);
    EXPECT_EQ(first_cause(report), "normals-shown") << all_causes(report);
    EXPECT_TRUE(report.then.empty());
    EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps);
}

}  // namespace
}  // namespace glint::test
