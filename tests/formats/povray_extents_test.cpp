// SPDX-License-Identifier: Apache-2.0
// min_extent() and max_extent(): the boxes that POV-Ray 3.7 says (measured).
#include "formats/povray_text.h"
#include "math/transform.h"

namespace glint::test {
namespace {

struct MeasuredExtent {
    const char* object;
    Vec3 low, high;
};

constexpr Vec3 k_below{-1e10, -1e10, -1e10}, k_above{1e10, 1e10, 1e10};  // of all space

const MeasuredExtent k_measured[] = {
    {"sphere { <1, 2, 3>, 2 }", {-1, 0, 1}, {3, 4, 5}},
    {"sphere { <1, 2, 3>, 2 scale <1, 2, .5> rotate 30*z }",
     {-4.866025, -0.5, 0.5},
     {2.598076, 8.428204, 2.5}},
    {"box { <1, 2, 3>, -1 }", {-1, -1, -1}, {1, 2, 3}},
    {"box { <-1, -1, -1>, 1 rotate 45*y }", {-1.414214, -1, -1.414214}, {1.414214, 1, 1.414214}},
    {"cylinder { <0, 0, 0>, <1, 1, 0>, .5 }", {-0.5, -0.5, -0.707107}, {1.5, 1.5, 0.707107}},
    {"cylinder { <0, 0, 0>, <1, 1, 0>, .5 open rotate 20*x }",
     {-0.5, -0.469846, -0.664463},
     {1.5, 1.409539, 1.006483}},
    {"cylinder { <0, 0, 0>, <0, 2, 0>, .5 }", {-0.5, 0, -0.5}, {0.5, 2, 0.5}},
    {"cone { <0, 0, 0>, 1, <1, 2, 0>, .5 }", {-1.2, -0.6, -1.341641}, {2.2, 2.6, 1.341641}},
    {"cone { <0, 0, 0>, 1, <0, 2, 0>, 0 }", {-1, 0, -1}, {1, 2, 1}},
    {"torus { 1, .25 }", {-1.25, -0.25, -1.25}, {1.25, 0.25, 1.25}},
    {"torus { 1, .25 rotate 45*x }", {-1.25, -1.06066, -1.06066}, {1.25, 1.06066, 1.06066}},
    {"disc { <0, 1, 0>, <1, 1, 0>, 1, .5 }",
     {-1.000707, -0.000707, -1.414214},
     {1.000707, 2.000707, 1.414214}},
    {"disc { <0, 1, 0>, y, 1 }", {-1, 0.999, -1}, {1, 1.001, 1}},
    {"plane { y, 1 }", k_below, k_above},
    {"plane { <1, 1, 0>, 1 }", k_below, k_above},
    {"triangle { 0, x, <0, 1, 2> }", {0, 0, 0}, {1, 1, 2}},
    {"mesh { triangle { 0, x, <0, 1, 2> } }", {0, 0, 0}, {1, 1, 2}},
    {"union { sphere { 0, 1 } box { 2, 3 } }", {-1, -1, -1}, {3, 3, 3}},
    {"union { sphere { 0, 1 } box { 2, 3 } rotate 45*z }",
     {-2.828427, -1.414214, -1},
     {2.828427, 4.24264, 3}},
    {"union { sphere { 0, 1 rotate 45*z } plane { y, -3 } }", k_below, k_above},
    {"intersection { sphere { 0, 1 } box { 0, 3 } }", {0, 0, 0}, {1, 1, 1}},
    {"intersection { sphere { 0, 1 } plane { y, 0 } }", {-1, -1, -1}, {1, 0, 1}},
    {"intersection { box { -1, 1 } plane { y, 0 } plane { -x, .5 } plane { <1, 1, 0>, 0 } }",
     {-0.5, -1, -1},
     {1, 0, 1}},
    {"difference { sphere { 0, 1 } box { 0, 3 } }", {-1, -1, -1}, {1, 1, 1}},
    {"difference { box { 0, 1 } box { <-.5, .5, -.5>, 3 } }", {0, 0, 0}, {1, 1, 1}},
    {"difference { box { 0, 1 } plane { y, .5 } }", {0, 0.5, 0}, {1, 1, 1}},
    {"merge { sphere { 0, 1 } box { 2, 3 } }", {-1, -1, -1}, {3, 3, 3}},
    {"intersection { sphere { 0, 1 } box { 2, 3 } }", k_below, k_above},
    {"intersection { sphere { 0, 1 } box { 0, 3 inverse } }", {-1, -1, -1}, {1, 1, 1}},
    {"intersection { plane { y, 0 } plane { x, 0 } }", k_below, k_above},
    {"sphere { 0, 1 clipped_by { plane { y, 0 } } }", {-1, -1, -1}, {1, 1, 1}},
    {"object { sphere { 0, 1 } translate x }", {0, -1, -1}, {2, 1, 1}},
    {"sphere_sweep { linear_spline 2, 0, 1, 2*x, .5 rotate 45*z }", {-1, -1, -1}, {1.914214, 1.914214, 1}},
    {"lathe { linear_spline 2, <1, 0>, <2, 1> rotate 45*z }",
     {-2.12132, -1.414214, -2},
     {1.414214, 2.12132, 2}},
    {"prism { 0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> rotate 45*z }",
     {-0.707107, 0, 0},
     {0.707107, 1.414214, 1}},
    {"light_source { <1, 2, 3>, 1 }", k_below, k_above},
    {"union { sphere { 0, 1 } light_source { <1, 2, 3>, 1 } }", k_below, k_above},
    {"union { sphere { 0, 1 scale 2 rotate 30*z } sphere { 0, 1 } scale 2 rotate 30*z }",
     {-5.464102, -5.464102, -4},
     {5.464102, 5.464102, 4}},
    {"intersection { box { -1, 1 } box { -1, 1 rotate 45*y } rotate 45*y }",
     {-1.414214, -1, -1.414214},
     {1.414214, 1, 1.414214}},
    {"intersection { sphere { 0, 1 } plane { y, 0 } inverse }", {-1, -1, -1}, {1, 0, 1}},
    {"sphere { 0, 1 inverse }", {-1, -1, -1}, {1, 1, 1}},
    {"union { sphere { 0, 1 } sphere { 0, 1 } rotate 45*z rotate 45*z }", {-2, -2, -1}, {2, 2, 1}},
    {"union { sphere { 0, 1 } sphere { 0, 1 } transform { rotate 45*z rotate 45*z } }",
     {-1, -1, -1},
     {1, 1, 1}},
    {"sphere { 0, 1 rotate 45*z scale <1, 2, 1> }", {-1, -2, -1}, {1, 2, 1}},
    {"sphere { 0, 1 scale <1, 2, 1> rotate 45*z rotate 45*z }", {-2, -1, -1}, {2, 1, 1}},
    {"sphere { 0, 1 scale <1, 1, 1> rotate 45*z }", {-1, -1, -1}, {1, 1, 1}},
    {"sphere { 0, 1 scale 2 rotate 45*z }", {-2, -2, -2}, {2, 2, 2}},
    {"sphere { 0, 1 transform { rotate 45*z } rotate 45*z }", {-1, -1, -1}, {1, 1, 1}},
    {"difference { box { -1, 1 } plane { y, .5 } rotate 45*z rotate 45*z }", {-2, -1.25, -1}, {0.5, 1.25, 1}},
    {"union { box { -1, 1 rotate 45*z } rotate 45*z }", {-2, -2, -1}, {2, 2, 1}},
    {"union { box { -1, 1 } box { -1, 1 rotate 45*z } rotate 45*z }", {-2, -2, -1}, {2, 2, 1}},
    {"triangle { 0, x, <0, 1, 2> rotate 45*z }", {-0.707107, 0, 0}, {0.707107, 0.707107, 2}},
    {"mesh { triangle { -x, x, <0, 1, 2> } rotate 45*z rotate 45*z }", {-2, -1.5, 0}, {1, 1.5, 2}},
    {"plane { y, 1 rotate 45*z }", k_below, k_above},
    {"intersection { box { -1, 1 } plane { y, .5 rotate 90*z } }", {-0.5, -1, -1}, {1, 1, 1}},
    {"intersection { box { -1, 1 } plane { 2*y, .5 } }", {-1, -1, -1}, {1, 0.5, 1}},
    {"intersection { box { -1, 1 } plane { y, .5 scale .5 translate .1*y } }", {-1, -1, -1}, {1, 0.35, 1}},
    {"difference { box { -1, 1 } plane { y, -.5 inverse } }", {-1, -1, -1}, {1, -0.5, 1}},
    {"prism { 0, 1, 4, <0, 0>, <1, 0>, <0, 1>, <0, 0> rotate 45*z rotate 45*z }", {-1, 0, 0}, {0, 1, 1}},
    {"lathe { linear_spline 2, <1, 0>, <2, 1> rotate 45*z rotate 45*z }", {-1, -2, -2}, {0, 2, 2}},
    {"torus { 1, .25 rotate 45*z rotate 45*z }", {-0.25, -1.25, -1.25}, {0.25, 1.25, 1.25}},
    {"cylinder { <0, 0, 0>, <1, -2, .5>, .5 }",
     {-0.621822, -2.256356, -0.654654},
     {1.621822, 0.256356, 1.154654}},
    {"cylinder { <0, 0, 0>, <0, 0, -2>, .5 }", {-0.5, -0.5, -2}, {0.5, 0.5, 0}},
    {"cylinder { <0, 0, 0>, <0, -2, 0>, .5 }", {-0.5, -2, -0.5}, {0.5, 0, 0.5}},
    {"cone { <1, -2, .5>, .5, <0, 0, 0>, 1 }",
     {-1.243644, -2.512713, -1.309307},
     {2.243644, 0.512713, 1.809307}},
    {"cone { <0, 0, 0>, 0, <1, -2, .5>, .5 }",
     {-0.578178, -2.343644, -0.654654},
     {1.578178, 0.343643, 1.154654}},
    {"disc { 0, <1, -2, .5>, 1, .5 }", {-1.156793, -0.68816, -1.309526}, {1.156793, 0.68816, 1.309526}},
    {"sphere_sweep { linear_spline 2, 0, 1, 2*x, .5 scale <1, 2, 1> }", {-1, -2, -1}, {2.5, 2, 1}},
    {"sphere_sweep { linear_spline 2, 0, 1, 2*x, .5 scale 2 rotate 20*z rotate 25*z }",
     {-2, -2, -2},
     {3.828427, 3.828427, 2}},
    {"union { plane { y, 0 } sphere { 0, 1 } rotate 45*z }", k_below, k_above},
    {"union { plane { y, 0 } sphere { 0, 1 } translate 5 }", k_below, k_above},
    {"intersection { sphere { 0, 1 } union { plane { y, 0 } plane { x, 0 } } }", {-1, -1, -1}, {1, 1, 1}},
    {"intersection { sphere { 0, 1 } intersection { plane { y, 0 } plane { x, 0 } } }",
     {-1, -1, -1},
     {1, 1, 1}},
    {"difference { box { 0, 1 } union { plane { y, .5 } plane { x, .5 } } }", {0, 0, 0}, {1, 1, 1}},
    {"union { box { 0, 1 } rotate 45*z }", {-0.707107, 0, 0}, {0.707107, 1.414214, 1}},
    {"union { sphere { 0, 1 } light_source { <1, 2, 3>, 1 } }", k_below, k_above},
    {"smooth_triangle { 0, y, x, y, <0, 1, 2>, y rotate 45*z }", {-0.707107, 0, 0}, {0.707107, 0.707107, 2}},
};

std::string extents_of(const std::string& object) {
    return "#declare A = " + object + "\nsphere { min_extent(A), 1 } sphere { max_extent(A), 1 }";
}

TEST(PovRayExtents, AreThoseOfPovRay) {
    for (const MeasuredExtent& measured : k_measured) {
        const Scene scene = povray_scene(extents_of(measured.object));
        ASSERT_EQ(scene.get<Sphere>().size(), 2u) << measured.object;
        const Vec3 low = scene.get<Sphere>()[0].center, high = scene.get<Sphere>()[1].center;
        EXPECT_LE(length(low - measured.low), 2e-6)
            << measured.object << " from " << low.x << ' ' << low.y << ' ' << low.z;
        EXPECT_LE(length(high - measured.high), 2e-6)
            << measured.object << " to " << high.x << ' ' << high.y << ' ' << high.z;
    }
}

TEST(PovRayExtents, OfDeclaredCopiesAndElementsAreRead) {
    const Scene scene = povray_scene(
        "#declare B = union { box { -1, 1 } box { 1, 2 } rotate 90*y }\n#declare A = array[1] { object { B "
        "translate 5*x } };\n"
        "sphere { (min_extent(A[0]) + max_extent(A[0]))/2, max_extent(B).x }");
    ASSERT_EQ(scene.get<Sphere>().size(), 1u);
    expect_vec(scene.get<Sphere>()[0].center, {5.5, 0.5, -0.5});
    EXPECT_NEAR(scene.get<Sphere>()[0].radius, 2, 1e-12);
}

TEST(PovRayExtents, WhatIsNotKnownIsNamed) {
    const std::pair<std::string, std::string> unknown[] = {
        {"quadric { <1, 1, 1>, 0, 0, -1 }", "quadric"},
        {"poly { 2, <1, 0, 0, 0, 1, 0, 0, 1, 0, -1> }", "quartic"},
        {"polygon { 4, 0, x, y, 0 }", "polygon"},
        {"sphere { 0, 1 bounded_by { box { -1, 1 } } }", "with bounded_by"},
        {"sphere { 0, 1 clipped_by { box { 0, 1 } } }", "with clipped_by"},
        {"sphere { x, 1 scale <-1, 1, 1> rotate 20*z }", "a sphere that is turned and mirrored"},
        {"union { sphere { 0, 1 } blob { threshold 1 sphere { 0, 1, 1 } } }",
         "a shape that glint does not render"},
        {"sphere { 0, 1 rotate 20*z scale <1, 2, 3> rotate 20*x }",
         "a sphere that is turned, stretched and turned again"},
        {"mesh { }", "it has no points"}};
    for (const auto& [object, why] : unknown) {
        const auto result = read_povray(extents_of(object));
        EXPECT_NE(
            messages(result).find("2:10: error: glint does not know min_extent() of this object: " + why),
            std::string::npos)
            << messages(result);
    }
    EXPECT_NE(messages(read_povray("sphere { min_extent(B), 1 }"))
                  .find("1:21: error: expected the name of an object, found"),
              std::string::npos);
    EXPECT_NE(messages(read_povray("#declare B = 1; sphere { max_extent(B), 1 }"))
                  .find("expected the name of an object"),
              std::string::npos);
}

}  // namespace
}  // namespace glint::test
