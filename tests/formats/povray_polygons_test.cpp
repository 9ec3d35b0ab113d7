// SPDX-License-Identifier: Apache-2.0
// polygon, as POV-Ray draws it (measured).
#include "formats/mistakes.h"
#include "formats/povray_text.h"

namespace glint::test {
namespace {

const std::string k_square = "<0, 0, 0>, <2, 0, 0>, <2, 2, 0>, <0, 2, 0>";

std::string said_of_polygons(const std::string& text) {
    return messages(read_povray("light_source { <0, 0, -9>, rgb 1 }\n" + text));
}

TEST(PovRayPolygons, AreClosedPointLists) {
    for (const std::string& text : {"polygon { 5, " + k_square + ", <0, 0, 0> translate x }",
                                    "polygon { 4 " + k_square + " translate x }"}) {
        const Scene scene = povray_scene(text);
        ASSERT_EQ(scene.shapes.size(), 1u) << text;
        EXPECT_EQ(scene.shapes[0].kind, ShapeKind::polygon);
        ASSERT_EQ(scene.polygon_vertices.size(), 4u) << "the last point is the first";
        expect_vec(scene.polygon_vertices[2], {3, 2, 0});
    }
}

TEST(PovRayPolygons, TheFirstPointAgainBeginsAnotherPart) {
    const Scene scene = povray_scene(
        "#declare P = polygon { 8, <0, 0>, <1, 0>, <0, 1>, <0, 0>, <3, 3>, <4, 3>, <3, 4>, <3, 3> }\n"
        "polygon { P scale 2 }");
    ASSERT_EQ(scene.shapes.size(), 2u);
    ASSERT_EQ(scene.polygon_vertices.size(), 6u);
    expect_vec(scene.polygon_vertices[4], {8, 6, 0});
}

TEST(PovRayPolygons, HolesAndCrossingsAreRefusedByName) {
    EXPECT_NE(said_of_polygons("polygon { 10, " + k_square +
                               ", <0, 0>, <.5, .5>, <1, .5>, <1, 1>, <.5, 1>, <.5, .5> pigment { rgb 1 } }")
                  .find("2:1: error: glint does not render `polygon` (with a hole)"),
              std::string::npos);
    for (const std::string points :
         {"5, <0, 0>, <2, 2>, <2, 0>, <0, 2>, <0, 0>",          // a bow tie
          "5, <0, 2>, <1, -1>, <-1.5, 1>, <1.5, 1>, <-1, -1>",  // a star: all turns are left
          "4, <0, 0>, <3, 0>, <1, 0>, <1, 1>"}) {               // back on its own edge
        EXPECT_NE(
            said_of_polygons("polygon { " + points + " }").find("`polygon` (whose edges cross or touch)"),
            std::string::npos)
            << points;
    }
    EXPECT_EQ(said_of_polygons("#declare P = polygon { 4, <0, 0>, <2, 2>, <2, 0>, <0, 2> }\nsphere { 0, 1 }"),
              "")
        << "not used";
}

TEST(PovRayPolygons, PointsThatAreNotInOnePlaneAreLeftOut) {
    const std::string text = "sphere { 0, 1 }\npolygon { 4, <0, 0, 0>, <2, 0, 0>, <2, 2, 1e-8>, <0, 2, 0> }";
    EXPECT_NE(said_of_polygons(text).find("3:1: warning: the points of this polygon are not in one plane"),
              std::string::npos);
    EXPECT_EQ(povray_scene(text).shapes.size(), 1u);
    EXPECT_EQ(povray_scene("polygon { 4, <0, 0, 0>, <2, 0, 0>, <2, 2, 1e-11>, <0, 2, 0> }").shapes.size(),
              1u);
    EXPECT_EQ(povray_scene("sphere { 0, 1 } polygon { 3, 0, x, 2*x }").shapes.size(), 1u) << "on a line";
}

TEST(PovRayPolygons, BadInputIsNamed) {
    expect_messages(
        {"few", "polygon { $2, <0, 0>, <1, 0> }", {"expected at least three points of a polygon"}}, "a.pov",
        "povray");
    EXPECT_NE(said_of_polygons("polygon { 1e9, <0, 0>").find("error: "), std::string::npos);
    EXPECT_NE(said_of_polygons("polygon { 4, <0, 0>, <1, 0>, <1, 1> }").find("expected a number"),
              std::string::npos);
    std::string many = "polygon { 5000";
    for (int i = 0; i < 5000; ++i) many += ", <" + std::to_string(i) + ", " + std::to_string(i * i) + ">";
    EXPECT_NE(said_of_polygons(many + " }").find("`polygon` (with more than 4096 points)"),
              std::string::npos);
}

}  // namespace
}  // namespace glint::test
