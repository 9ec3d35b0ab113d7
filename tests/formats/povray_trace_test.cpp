// SPDX-License-Identifier: Apache-2.0
// trace() and inside(). The stage `peers` compares pictures of them with POV-Ray's.
#include <string>

#include "formats/povray_text.h"
#include "math/transform.h"

namespace glint::test {
namespace {

// A hit and its normal, as the centers of two spheres.
struct Hit {
    Vec3 point, normal;
};
Hit traced(const std::string& object, const std::string& ray) {
    const Scene scene = povray_scene("#declare O = " + object + " #declare N = x; #declare P = trace(O, " +
                                     ray + ", N);\nsphere { P, 1 } sphere { N, 1 }");
    const auto& spheres = scene.get<Sphere>();
    EXPECT_EQ(spheres.size(), 2u) << object;
    if (spheres.size() != 2) return {};
    return {spheres[0].center, spheres[1].center};
}

void expect_hit(const std::string& object, const std::string& ray, Vec3 point, Vec3 normal) {
    const Hit hit = traced(object, ray);
    SCOPED_TRACE(object);
    expect_vec(hit.point, point);
    expect_vec(hit.normal, normal);
}

TEST(PovRayTrace, HitsHaveTheirOutwardNormal) {
    expect_hit("sphere { 5*z, 1 }", "0, 0.1*z", {0, 0, 4}, {0, 0, -1});
    expect_hit("sphere { 5*z, 1 }", "5*z, z", {0, 0, 6}, {0, 0, 1});
    expect_hit("sphere { 5*z, 1 inverse }", "0, z", {0, 0, 4}, {0, 0, 1});
    expect_hit("plane { y, -1 }", "-3*y, y", {0, -1, 0}, {0, 1, 0});
    expect_hit("difference { box { -1, 1 } sphere { -z, 0.5 } }", "-9*z, z", {0, 0, -0.5}, {0, 0, -1});
    expect_hit("union { sphere { 9*z, 1 } torus { 1, 0.25 translate 2*z } translate y }", "y, z",
               {0, 1, 0.75}, {0, 0, -1});
    expect_hit("sphere { 0, 1 no_shadow clipped_by { plane { z, 0 } } }", "<0, 0, -0.5>, z", {0, 0, 0},
               {0, 0, 0});
}

TEST(PovRayTrace, NormalsOfFlatTrianglesAreClockwise) {
    const std::string corners = "<-1, -1, 3>, <1, -1, 3>, <0, 1, 3>";
    expect_hit("triangle { " + corners + " }", "0, z", {0, 0, 3}, {0, 0, -1});
    expect_hit("mesh { triangle { " + corners + " } triangle { x, y, 9 } }", "9*z, -z", {0, 0, 3},
               {0, 0, -1});
    expect_hit("prism { 0, 1, 5, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0> }", "<0.5, 0.5, -3>, z",
               {0.5, 0.5, 0}, {0, 0, -1});
}

TEST(PovRayTrace, MissesAreTheOrigin) {
    expect_hit("sphere { 5*z, 1 }", "0, x", {0, 0, 0}, {0, 0, 0});
    expect_hit("sphere { 5*z, 1 }", "0, 0", {0, 0, 0}, {0, 0, 0});
    expect_hit("union { sphere { 5*z, 0 } sphere { 9, 0 } }", "0, z", {0, 0, 0}, {0, 0, 0});
    // A ray begins 0.0001 away.
    expect_hit("sphere { 0, 1 }", "<0, 0, -1.00009>, 10*z", {0, 0, 1}, {0, 0, 1});
    expect_hit("sphere { 0, 1 }", "<0, 0, -1.00011>, 0.1*z", {0, 0, -1}, {0, 0, -1});
}

TEST(PovRayTrace, TheTracedObjectIsNotInTheScene) {
    const Scene scene = povray_scene(
        "#declare O = union { sphere { 0, 1 pigment { granite } } box { 5, 6 } }\n"
        "sphere { trace(O, 9*x, -x), 0.5 }");
    EXPECT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(
        messages(read_povray("#declare O = sphere { 0, 1 normal { bumps 1 } }\nsphere { trace(O, 9*x, -x), "
                             "1 } light_source { 9, 1 }")),
        "");
}

TEST(PovRayTrace, ALoopOfManyRaysPreparesTheObjectOnce) {
    const Scene scene = povray_scene(
        "#declare O = union { #for (I, 0, 999) sphere { <I, 0, 0>, 0.4 } #end }\n"
        "#for (I, 0, 9999) #declare P = trace(O, <mod(I, 1000), 9, 0>, -y); #end sphere { P, 1 }");
    expect_vec(scene.get<Sphere>().back().center, {999, 0.4, 0});
}

TEST(PovRayTrace, InsideKnowsSolids) {
    const std::pair<std::string, std::string> inside[] = {
        {"sphere { 0, 1 scale 2 }", "<0, 1.9, 0>"},
        {"box { 1, -1 rotate 45*z }", "<0, 1.3, 0>"},
        {"plane { 2*y, 1 }", "0.9*y"},
        {"cylinder { 0, 2*y, 1 }", "<0.7, 1.9, 0.7>"},
        {"cone { -y, 1, y, 0.3 }", "<0.6, 0, 0>"},
        {"torus { 1, 0.3 rotate 90*x }", "1.2*y"},
        {"quadric { <1, 1, 1>, <0.9, 0.7, 0.2>, <0.1, 0.2, 0.3>, -1 }", "<-0.5, 0.3, 0.6>"},
        {"poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> }", "<0.5, 0.6, 0.6>"},
        {"union { box { 5, 6 } sphere { 0, 1 } }", "0"},
        {"difference { box { -1, 1 } sphere { -z, 0.5 } }", "0"},
        {"intersection { box { -1, 1 } plane { y, 0 } }", "-0.5*y"},
        {"box { -1, 1 clipped_by { plane { y, 0 } } translate 3*y }", "2.9*y"}};
    for (const auto& each : inside) {
        const std::string &object = each.first, &point = each.second;
        const auto is_inside = [&](const std::string& text) {
            return povray_scene("#declare O = " + object + text + "; sphere { 0, 1 + inside(O, " + point +
                                ") }")
                       .get<Sphere>()[0]
                       .radius == 2;
        };
        EXPECT_TRUE(is_inside("")) << object;
        EXPECT_FALSE(is_inside(" #declare O = object { O translate -40*(x + y + z) }")) << object;
    }
    const Scene outside = povray_scene(
        "#declare O = difference { box { -1, 1 } sphere { -z, 0.5 } }\n"
        "#declare V = box { 0, 1 inverse }\n"
        "sphere { 0, 1 + inside(O, -0.9*z) } sphere { 0, 1 + inside(V, 0.5) }");
    EXPECT_EQ(outside.get<Sphere>()[0].radius, 1);
    EXPECT_EQ(outside.get<Sphere>()[1].radius, 1);
}

TEST(PovRayTrace, FacesAreInside) {
    for (const std::string object : {"box { 0, 1 }", "plane { x, 1 }", "torus { 0.75, 0.25 rotate 90*x }"})
        EXPECT_EQ(povray_scene("#declare O = " + object + "; sphere { 0, 1 + inside(O, x) }")
                      .get<Sphere>()
                      .at(0)
                      .radius,
                  2)
            << object;
}

TEST(PovRayTrace, TheNormalMayBeAnElementOfAnArray) {
    const Scene scene = povray_scene(
        "#declare O = sphere { 0, 1 } #declare A = array[2] { x, x }\n"
        "#declare P = trace(O, -5*z, z, A[1]); sphere { A[1], 1 } sphere { A[0], 1 }");
    EXPECT_EQ(scene.get<Sphere>().at(0).center, (Vec3{0, 0, -1}));
    EXPECT_EQ(scene.get<Sphere>().at(1).center, (Vec3{1, 0, 0}));
}

TEST(PovRayTrace, WorldsOfManyObjectsCountAsSteps) {
    const Result<Scene> scene = read_povray(
        "#declare M = mesh { #for (I, 1, 2000) triangle { <I, 0, 0>, <I + 1, 0, 0>, <I, 1, 1> } #end }\n"
        "#while (1) #declare O = object { M } #declare P = trace(O, y, -y); #end");
    EXPECT_FALSE(scene);
}

TEST(PovRayTrace, MistakesAreNamed) {
    const std::pair<std::string, std::string> mistakes[] = {
        {"sphere { trace(x, 0, z), 1 }", "2:16: error: expected the name of an object, found 'x'"},
        {"#declare O = sphere { 0, 1 } sphere { trace(O, 0, z, Q), 1 }",
         "2:54: error: expected the name of a vector, found 'Q', which is not declared"},
        {"#declare N = 1; #declare O = sphere { 0, 1 } sphere { trace(O, 0, z, N), 1 }",
         "2:70: error: expected the name of a vector, found 'N'"},
        {"#declare O = blob { threshold 1 sphere { 0, 1, 1 } } sphere { trace(O, 0, z), 1 }",
         "2:14: error: glint does not render `blob`"},
        {"#declare O = blob { threshold 1 sphere { 0, 1, 1 } } sphere { trace(O, 0, z), 1 }",
         "2:63: error: glint does not render the object that is traced here"},
        {"#declare O = disc { 0, y, 1 } sphere { 0, inside(O, 0) }",
         "2:43: error: expected an object whose inside glint knows"}};
    for (const auto& [text, message] : mistakes) {
        const std::string said = messages(read_povray("light_source { <0, 0, -9>, rgb 1 }\n" + text));
        EXPECT_NE(said.find(message), std::string::npos) << said;
    }
}

}  // namespace
}  // namespace glint::test
