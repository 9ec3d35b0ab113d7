// SPDX-License-Identifier: Apache-2.0
// Mistakes of cylinders and of glass.
#include "compare/planted_faults.h"

namespace glint::test {
namespace {

TEST(CausesOfShapes, CylindersOfAnotherLength) {
    const std::string head = R"(
background = (0.2, 0.3, 0.5)
camera { position = (1, 5, 8)  look_at = (0, 1, 0)  fov_y = 40 }
light { type = ambient }
light { type = point  position = (3, 6, 5)  intensity = 0.7 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.6, 0.6, 0.5)  ambient = 0.2 }
)";
    const auto text = [&](double lower, double upper, bool caps) {
        const auto cylinder = [&](double x, double z, double radius) {
            const auto end = [&](double y) {
                return "(" + std::to_string(x) + ", " + std::to_string(y) + ", " + std::to_string(z) + ")";
            };
            return "cylinder { from = " + end(lower) + "  to = " + end(upper) +
                   "  radius = " + std::to_string(radius) + (caps ? "  caps = true" : "  caps = false") +
                   "  color = (0.8, 0.3, 0.2)  ambient = 0.2 }\n";
        };
        return head + cylinder(-1.2, 0, 0.7) + cylinder(1.1, 0.5, 0.5) + "render { size = 72 x 54 }\n";
    };
    const Scene right = read_scene(text(0.6, 1.8, true));
    const Image picture = as_file(draw(right));
    const auto expect = [&](const std::string& wrong, const char* name) {
        const CauseReport report = find_causes(draw_text(wrong), picture, &right).value();
        EXPECT_EQ(first_cause(report), name) << all_causes(report);
        EXPECT_FALSE(!report.causes.empty() && report.causes[0].perhaps) << name;
    };
    expect(text(0, 2.4, true), "cylinder-height");
    expect(text(0.9, 1.5, true), "cylinder-height");
    for (const auto& [lower, upper] : {std::pair{0.6, 3.0}, {-0.6, 1.8}, {0.6, 1.2}, {1.2, 1.8}})
        expect(text(lower, upper, true), "cylinder-height");
    expect(text(-900, 900, false), "cylinder-unbounded");
    expect(text(0.6, 1.8, false), "caps-missing");
    const CauseReport other = find_causes(draw_text(text(0.6, 1.5, true)), picture, &right).value();
    for (const Cause& cause : other.causes) EXPECT_TRUE(cause.perhaps) << all_causes(other);
}

TEST(CausesOfShapes, AKindWithoutShadows) {
    const auto text = [](const char* wall, const char* cylinder) {
        const std::string shadow = "  casts_shadow = ";
        return R"(
background = (0.2, 0.3, 0.5)
camera { position = (1, 5, 8)  look_at = (0, 1, 0)  fov_y = 40 }
light { type = ambient }
light { type = point  position = (6, 6, 2)  intensity = 0.7 }
material clay { color = (0.8, 0.3, 0.2)  ambient = 0.2 }
material wall { color = (0.3, 0.7, 0.4)  ambient = 0.2)" +
               shadow + wall + " }\nmaterial post { color = (0.3, 0.3, 0.8)  ambient = 0.2" + shadow +
               cylinder +
               R"( }
sphere { center = (0, 1, 0)  radius = 1  material = clay }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.6, 0.6, 0.5)  ambient = 0.2 }
triangle { vertices = ((2, 0, -1), (2, 0, 1), (2, 2, 0))  material = wall }
cylinder { from = (-2, 0, 0)  to = (-2, 2, 0)  radius = 0.4  material = post }
triangle { vertices = ((0, 0, 3), (1, 0, 3), (0, 1.5, 3))  material = wall }
cylinder { from = (1, 0, 2)  to = (1, 1, 2)  radius = 0.3  material = post }
sphere { center = (-1, 0.5, 2.5)  radius = 0.5  material = clay }
render { size = 72 x 54 }
)";
    };
    const Scene right = read_scene(text("true", "true"));
    const Image picture = as_file(draw(right));
    for (const auto& [wrong, words] : {std::pair{text("false", "true"), "Triangles cast no shadow"},
                                       {text("true", "false"), "Cylinders cast"}}) {
        const CauseReport report = find_causes(draw_text(wrong), picture, &right).value();
        ASSERT_EQ(first_cause(report), "shadow-of-shape-missing") << all_causes(report);
        EXPECT_FALSE(report.causes[0].perhaps);
        EXPECT_TRUE(report.causes[0].explanation.starts_with(words)) << report.causes[0].explanation;
    }
}

// And near misses: parallelograms and spheres of another size.
TEST(CausesOfShapes, TrianglesAndSpheresOfAnotherSize) {
    for (const char* const rest :
         {"background = (0.2, 0.3, 0.5)\ncamera { position = (0, 2, 8)  look_at = (0, 1, 0)  fov_y = 40 }\n",
          "background = (0.6, 0.6, 0.5)\ncamera { position = (1, 3, 9)  look_at = (0, 1, 0)  fov_y = 36 "
          "}\n"}) {
        const auto text = [&](double radius, double small, double v) {
            const std::string up = std::to_string(v), end = "  color = (0.8, 0.3, 0.2)  ambient = 0.2 }\n";
            std::string all =
                std::string(rest) +
                "light { type = ambient }\nlight { type = point  position = (3, 6, 5)  intensity "
                "= 0.7 }\nsphere { center = (1.5, 1, 0)  radius = " +
                std::to_string(radius) + end +
                "sphere { center = (0.2, 0.3, 2)  radius = " + std::to_string(small) + end +
                "triangle { vertices = ((-2, 0, 0), (0, 0, 0.5), (-2, 1.5, 0))" + end;
            if (v > 0)
                all += "triangle { vertices = ((0, 0, 0.5), (0, " + up + ", 0.5), (-2, " + up + ", 0))" + end;
            return all + "plane { point = (0, -1, 0)  normal = (0, 1, 0)" + end +
                   "render { size = 72 x 54 }\n";
        };
        const Scene right = read_scene(text(0.8, 0.5, 0));
        const Image picture = as_file(draw(right));
        const auto report_of = [&](double radius, double small, double v) {
            return find_causes(draw_text(text(radius, small, v)), picture, &right).value();
        };
        const std::pair<CauseReport, const char*> cases[] = {
            {report_of(std::sqrt(0.8), std::sqrt(0.5), 0), "radius-squared"},
            {report_of(0.64, 0.25, 0), "radius-squared"},
            {report_of(0.8, 0.5, 1.5), "triangle-as-parallelogram"}};
        for (const auto& [report, name] : cases) {
            EXPECT_EQ(first_cause(report), name) << all_causes(report);
            EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps) << all_causes(report);
        }
        EXPECT_NE(first_cause(report_of(0.75, 0.47, 0)), "radius-squared");
        for (const Cause& cause : report_of(0.8, 0.5, 1.2).causes)
            EXPECT_TRUE(cause.perhaps || cause.name != "triangle-as-parallelogram");
    }
}

TEST(CausesOfShapes, GlassThatBendsTheWrongWay) {
    const std::string head =
        "background = (0.4, 0.5, 0.7)\ncamera { position = (0, 1, 7)  look_at = (0, 1, 0)  fov_y = 40 }\n"
        "light { type = ambient }\nlight { type = point  position = (3, 6, 5)  intensity = 0.7 }\n"
        "plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.6, 0.6, 0.5)  ambient = 0.2 }\n"
        "sphere { center = (-1, 1, -1)  radius = 1  color = (0.8, 0.3, 0.2)  ambient = 0.2 }\n";
    const std::string tail = "render { size = 72 x 54  reflections = 4 }\n";
    for (const char* const glass : {"sphere { center = (0.4, 1.1, 1.5)  radius = 0.9  transmission = 0.8",
                                    "box { min = (-0.3, 0.2, 0.8)  max = (1, 1.6, 1.8)  rotate = (0, 30, 0)  "
                                    "transmission = 0.9"}) {
        const auto text = [&](const char* ior) { return head + glass + "  ior = " + ior + " }\n" + tail; };
        const Scene right = read_scene(text("1.5"));
        const Image picture = as_file(draw(right));
        const CauseReport report = find_causes(draw_text(text("0.6666666667")), picture, &right).value();
        EXPECT_EQ(first_cause(report), "refraction-inverted") << all_causes(report);
        EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps) << all_causes(report);
        const CauseReport denser = find_causes(draw_text(text("1.7")), picture, &right).value();
        for (const Cause& cause : denser.causes) EXPECT_TRUE(cause.perhaps) << all_causes(denser);
    }
}

// A program that turns no normals draws the inner side of a cylinder without caps dark.
TEST(CausesOfShapes, CapsThatAreMissingFromAClosedSurface) {
    const std::string text =
        "background = (0.2, 0.3, 0.5)\ncamera { position = (1, 5, 8)  look_at = (0, 1, 0)  fov_y = 40 }\n"
        "light { type = ambient }\nlight { type = point  position = (3, 6, 5)  intensity = 0.7 }\n"
        "plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.6, 0.6, 0.5)  ambient = 0.2 }\n"
        "cylinder { from = (0, 0.3, 0)  to = (0, 1.8, 0)  radius = 1  caps = true  color = (0.8, 0.3, 0.2)  "
        "ambient = 0.2 }\nconventions { facing = open }\nrender { size = 72 x 54 }\n";
    const Scene right = read_scene(text);
    const Image picture = as_file(draw(right));
    const std::string no_caps = replaced(text, "caps = true", "caps = false");
    for (const std::string& wrong : {no_caps, replaced(no_caps, "facing = open", "facing = none")}) {
        const CauseReport report = find_causes(draw_text(wrong), picture, &right).value();
        EXPECT_EQ(first_cause(report), "caps-missing") << all_causes(report);
        EXPECT_GT(report.causes.at(0).explained, 0.99);
        EXPECT_FALSE(report.causes[0].perhaps);
    }
}

}  // namespace
}  // namespace glint::test
