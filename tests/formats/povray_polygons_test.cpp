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

// The area of the mesh that a polygon becomes.
double area_of(const std::string& points) {
    const Scene scene = povray_scene("polygon { " + points + " }");
    EXPECT_EQ(scene.meshes.size(), 1u) << points;
    double area = 0;
    for (const auto& mesh : scene.meshes) {
        for (const TriangleCorners& t : mesh->triangles) {
            const Vec3 a = mesh->position(t[0]), b = mesh->position(t[1]), c = mesh->position(t[2]);
            area += length(cross(b - a, c - a)) / 2;
        }
    }
    return area;
}

TEST(PovRayPolygons, WhatAnEvenNumberOfEdgesSurroundsIsAHole) {
    EXPECT_NEAR(area_of("10, " + k_square + ", <0, 0>, <.5, .5>, <1, .5>, <1, 1>, <.5, 1>, <.5, .5>"), 3.75,
                1e-6);
    EXPECT_NEAR(area_of("5, <0, 0>, <2, 2>, <2, 0>, <0, 2>, <0, 0>"), 2, 1e-6) << "a bow tie";
    const Scene back = povray_scene("polygon { 4, <0, 0>, <3, 0>, <1, 0>, <1, 1> }");
    EXPECT_EQ(back.get<Triangle>().size(), 1u) << "back on its own edge";
    const std::string in_space = "<0, 0, 0>, <2, 0, 1>, <2, 2, 1>, <0, 2, 0>, <0, 0, 0>";
    EXPECT_NEAR(area_of("9, " + in_space + ", <.5, .5, .25>, <1, .5, .5>, <1, 1, .5>, <.5, .5, .25>"),
                (4 - 0.125) * 1.1180339887, 1e-6);
    EXPECT_NE(said_of_polygons("difference { box { -1, 1 } polygon { 10, " + k_square +
                               ", <0, 0>, <.5, .5>, <1, .5>, <1, 1>, <.5, 1>, <.5, .5> } }")
                  .find("`polygon` (that is open, in a solid)"),
              std::string::npos);
}

TEST(PovRayPolygons, NearlyTheFirstPointClosesAPart) {
    EXPECT_NEAR(area_of("9, " + k_square + ", <0, 1e-11>, <.5, .5>, <1, .5>, <1, 1>, <.5, .5>"), 3.875, 1e-6);
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
