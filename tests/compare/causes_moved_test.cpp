// SPDX-License-Identifier: Apache-2.0
// Causes whose numbers are fitted by rendering, and what is not sure.
#include <cmath>
#include <set>

#include "compare/small_scene.h"

namespace glint::test {
namespace {

struct Moved {
    const char *pattern, *with;  // in the scene's text
    const char *cause, *text;    // what is named first, and a part of what it says
};

const Moved k_moved[] = {
    {"position = \\(3, 5, 4\\)", "position = (3.4, 5, 4)", "light-moved",
     "Light 2 (\"lamp\", line 5) stands at (3.4, 5, 4)"},
    {"position = \\(-4, 4, 5\\)", "position = (-4, 5, 5)", "light-moved",
     "Light 3 (line 6) stands at (-4, 5, 5)"},
    {"fov_x = 48", "fov_x = 53", "field-of-view-scaled",
     "The field of view is 53 degrees, and in the reference 48."},
    {"position = \\(0.5, 2, 7\\)", "position = (0.7, 2, 7)", "camera-moved",
     "stands at (0.7, 2, 7), and in the reference at (0.5, 2, 7)"},
    {"center = \\(-1.1, 1, 0\\)", "center = (-1.1, 1.3, 0)", "shape-moved",
     "Sphere 2 (\"ball\", line 10) has its centre at (-1.1, 1.3, 0)"},
    {"color = \\(0.9, 0.2, 0.2\\)", "color = (0.3, 0.5, 0.2)", "material-color",
     "has the color (0.3, 0.5, 0.2), and in the reference (0.9, 0.2, 0.2)"},
    {"mirror = 0.4", "mirror = 0.5", "mirror-scaled", "1.25 times"},
    {"intensity = 0.4", "intensity = 0.2", "light-scaled", "Light 3 (line 6) is 0.5 times"},
};

TEST(CausesMoved, ColorsAreNotBelow0) {
    const std::string dark = replaced(k_scene, "background = [^\n]*", "background = (0, 0, 0)");
    const Scene scene = read_scene(dark);
    const std::string blue = replaced(dark, "background = [^\n]*", "background = (0.228, 0.2, 0)");
    const CauseReport report =
        *find_causes(draw_text(replaced(blue, "fov_x = 48", "fov_x = 53")), draw_text(dark), &scene);
    ASSERT_EQ(first_cause(report), "background") << all_causes(report);
    EXPECT_EQ(report.causes[0].explanation.find("-"), std::string::npos) << report.causes[0].explanation;
}

TEST(CausesMoved, AreFittedAndReportedWithObjectAndLine) {
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    for (const Moved& m : k_moved) {
        const CauseReport report =
            *find_causes(draw_text(replaced(k_scene, m.pattern, m.with)), right, &scene);
        EXPECT_EQ(first_cause(report), m.cause) << all_causes(report);
        if (report.causes.empty()) continue;
        const Cause& cause = report.causes.front();
        EXPECT_NE(cause.explanation.find(m.text), std::string::npos) << cause.explanation;
        EXPECT_FALSE(cause.perhaps) << cause.explanation << cause.explained;
    }
}

TEST(CausesMoved, AShapeThatIsNotDrawn) {
    const std::string text = replaced(
        k_scene, "plane \\{", "sphere { center = (0.3, 0.4, 2)  radius = 0.4  material = red }\nplane {");
    const Scene scene = read_scene(text);
    const Image right = draw_text(text);
    const std::string ball = "sphere \"ball\" [^\n]*\n", small = "sphere \\{ center = \\(0.3[^\n]*\n";
    for (const std::string& shape : {ball, small}) {
        const std::string without = replaced(text, shape, "");
        const CauseReport report = *find_causes(draw_text(without), right, &scene);
        EXPECT_EQ(first_cause(report), "shape-missing") << all_causes(report);
        EXPECT_FALSE(report.causes[0].perhaps);
        EXPECT_TRUE(report.then.empty());
        const bool is_ball = shape == ball;
        EXPECT_NE(report.causes[0].explanation.find(is_ball ? "Sphere 3 (\"ball\"" : "Sphere 1 (line"),
                  std::string::npos)
            << report.causes[0].explanation;
        const CauseReport dark =
            *find_causes(draw_text(replaced(without, "ambient  intensity = 0.9", "ambient  intensity = 0")),
                         right, &scene);
        ASSERT_EQ(dark.then.size(), 1u) << all_causes(dark);
        EXPECT_EQ((std::set<std::string>{first_cause(dark), dark.then[0].name}),
                  (std::set<std::string>{"ambient-missing", "shape-missing"}))
            << all_causes(dark);
    }
    const CauseReport floor = *find_causes(
        draw_text(replaced(replaced(replaced(text, ball, ""), small, ""), "sphere \\{[^\n]*\n", "")), right,
        &scene);
    EXPECT_EQ(first_cause(floor), "shape-missing") << all_causes(floor);
    EXPECT_NE(floor.causes[0].explanation.find("All shapes of the kind"), std::string::npos)
        << all_causes(floor);
}

// A shape that is small is drawn.
TEST(CausesMoved, ASmallShapeIsNotMissing) {
    const Scene scene = read_scene(k_scene);
    const CauseReport report = *find_causes(draw_text(replaced(k_scene, "radius = 0.8", "radius = 0.5")),
                                            draw_text(k_scene), &scene);
    EXPECT_EQ(first_cause(report), "shape-scaled") << all_causes(report);
}

// A lid under the lamp that is nearly as black as the background. Leaving it out explains 88% of the
// difference, by its shadow; but it is drawn, and only its shadow is missing.
TEST(CausesMoved, AShapeThatIsNotSeenIsNotMissing) {
    const std::string
        lid = "plane { point = (0, 4.5, 0)  normal = (0, 1, 0)  color = (0.01, 0.01, 0.01)  diffuse = 0 ",
        balls =
            "sphere { center = (-0.2, 1.6, 1.7)  radius = 0.35  material = red }\n"
            "sphere { center = (-1.2, 2.8, 1.9)  radius = 0.55  material = red }\n",
        dark = replaced(k_scene, "background = [^\n]*\n", ""),
        text = replaced(dark, "plane \\{[^\n]*\n", lid + "ambient = 0 }\n" + balls),
        faulty = replaced(dark, "plane \\{[^\n]*\n", lid + "ambient = 0.9  casts_shadow = false }\n" + balls);
    const Scene scene = read_scene(text);
    const CauseReport report = *find_causes(draw_text(faulty), draw_text(text), &scene);
    ASSERT_FALSE(report.causes.empty());
    for (const Cause& cause : report.causes) EXPECT_NE(cause.name, "shape-missing") << all_causes(report);
}

TEST(CausesMoved, MirrorsWhereTheReferenceHasNone) {
    const std::string plain = replaced(k_scene, "reflections = 2", "reflections = 0");
    const Scene scene = read_scene(plain);
    const CauseReport report = *find_causes(draw_text(k_scene), draw_text(plain), &scene);
    EXPECT_EQ(first_cause(report), "reflections-added") << all_causes(report);
}

TEST(CausesMoved, GammaTwice) {
    const Image right = draw_text(k_scene);
    Image faulty = right;
    for (float& v : faulty.rgb) v = std::pow(v, static_cast<float>(1 / (2.2 * 2.2)));
    EXPECT_EQ(first_cause(*find_causes(as_file(faulty), right)), "gamma-twice");
}

// A gradient is no fault of the tables: no cause is sure, and the report says where the difference is.
TEST(CausesMoved, WhatIsNotSureIsPerhapsAndSaysWhere) {
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    Image faulty = draw_text(replaced(k_scene, "shading = phong", "shading = phong  shadows = false"));
    for (int y = 25; y < 45; ++y)  // a gradient over the lower half, too
        for (int i = 0; i < 180; ++i) faulty.rgb[180 * y + i] *= 1 - 0.02f * static_cast<float>(y - 24);
    const CauseReport report = *find_causes(as_file(faulty), right, &scene);
    for (const Cause& cause : report.causes) EXPECT_TRUE(cause.perhaps) << all_causes(report);
    EXPECT_NE(report.where.find("plane 1 (line 9)"), std::string::npos) << report.where;
}

}  // namespace
}  // namespace glint::test
