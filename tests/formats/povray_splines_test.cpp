// SPDX-License-Identifier: Apache-2.0
// Splines as values. The numbers are those of POV-Ray 3.7.
#include <string>

#include "formats/mistakes.h"
#include "formats/povray_text.h"

namespace glint::test {
namespace {

const std::string k_points = "0, <1,2,3>, 1, <2,5,-1>, 2.5, <4,0,1>, 4, <-3,2,6>, 5, <1,1,1> }";

Vec3 value_of(const std::string& spline, const std::string& call) {
    const Scene scene = povray_scene("#declare S = spline { " + spline + " sphere { " + call + ", 1 }");
    return scene.get<Sphere>().empty() ? Vec3{} : scene.get<Sphere>()[0].center;
}

void expect_value(const std::string& spline, const std::string& call, Vec3 wanted) {
    const Vec3 found = value_of(spline, call);
    EXPECT_NEAR(found.x, wanted.x, 1e-11) << spline << call;
    EXPECT_NEAR(found.y, wanted.y, 1e-11) << spline << call;
    EXPECT_NEAR(found.z, wanted.z, 1e-11) << spline << call;
}

TEST(PovRaySplines, HaveTheValuesOfPovRay) {
    expect_value(k_points, "S(0.15)", {1.15, 2.45, 2.4});
    expect_value("linear_spline " + k_points, "S(2.74)", {2.88, 0.32, 1.8});
    expect_value("quadratic_spline " + k_points, "S(0.52)", {1.48672, 4.19232, 0.38752});
    expect_value("quadratic_spline " + k_points, "S(3.85)", {-1.895, 1.485, 5.365});
    expect_value("cubic_spline " + k_points, "S(1.63)", {3.265082, 3.213026, -0.87862});
    expect_value("cubic_spline " + k_points, "S(3.85)", {-2.786, 1.91025, 5.99275});
    expect_value("natural_spline " + k_points, "S(0.15)", {1.0651875, 2.6984, 2.2686125});
    expect_value("natural_spline " + k_points, "S(2.0)",
                 {4.369281045751634, 1.60871459694989, -0.737908496732026});
}

TEST(PovRaySplines, AreConstantBeyondTheirEnds) {
    for (const std::string kind : {"linear", "quadratic", "natural"}) {
        expect_value(kind + "_spline " + k_points, "S(-3)", {1, 2, 3});
        expect_value(kind + "_spline " + k_points, "S(9)", {1, 1, 1});
    }
    expect_value("cubic_spline " + k_points, "S(0.5)", {2, 5, -1});
    expect_value("cubic_spline " + k_points, "S(4.5)", {-3, 2, 6});
}

TEST(PovRaySplines, FewPointsAreStraightOrTheirMean) {
    for (const std::string kind : {"linear", "quadratic", "cubic", "natural"}) {
        expect_value(kind + "_spline 0, <1,2,3>, 1, <2,5,-1> }", "S(0.3)",
                     kind == "cubic" ? Vec3{1.5, 3.5, 1} : Vec3{1.3, 2.9, 1.8});
        expect_value(kind + "_spline 0, <1,2,3> }", "S(0.3)", {1, 2, 3});
    }
    expect_value("cubic_spline 0, <1,2,3>, 1, <2,5,-1>, 2, <4,4,4> }", "S(0.3)", {2, 5, -1});
}

TEST(PovRaySplines, PointsAreSorted) {
    expect_value("4, <1,2,0> 0 <2,5,0>, 2, <7,8,0> }", "S(1)", {4.5, 6.5, 0});
    expect_value("4, <1,2,0> 0 <2,5,0>, 2, <7,8,0> }", "S(1, natural_spline)", {5.53125, 7.34375, 0});
    expect_value("4, <1,2,0> 0 <2,5,0>, 2, <7,8,0> }", "S(1, quadratic_spline) + S(1) - S(1)",
                 {5.875, 7.625, 0});
    expect_value("natural_spline 0, 1, 1, 2, 2, 5 }", "S(0.5)", {1.3125, 1.3125, 0});
}

TEST(PovRaySplines, TheLastOfSeveralValuesAtOneTCounts) {
    expect_value("0, <1,2,3>, 0, <5,6,7>, 1, <2,3,4> }", "S(0)", {5, 6, 7});
    expect_value("0, <1,2,3>, 1, <5,6,7>, 2, <2,3,4>, 1, <9,9,9> }", "S(1)", {9, 9, 9});
    // Where t was the greatest, the first does.
    expect_value("0, <1,2,3>, 1, <5,6,7>, 1, <9,9,9>, 2, <2,3,4> }", "S(1)", {5, 6, 7});
}

TEST(PovRaySplines, AreCopiedAndHeldInArrays) {
    expect_value(k_points + " #declare T = spline { S cubic_spline 3, <9,9,9> }", "T(2.7)",
                 {6.216, 3.432, 4.128});
    expect_value(k_points + " #declare A = array[1] { S } #declare B = A[0]; #declare C = spline { A[0] }",
                 "(A[0](0.15) + B(0.15) + C(0.15))/3", {1.15, 2.45, 2.4});
    expect_value("0, <1,2,3>, 1, <2,5,-1> } #declare V = -S(0.3).y; #macro M(S, T) S(T) #end",
                 "M(S, 0.3)*<1, V, 1>", {1.3, 2.9 * -2.9, 1.8});
}

TEST(PovRaySplines, MistakesAreNamed) {
    expect_messages(
        {"empty", "#declare S = spline { linear_spline $}", {"expected a number and a value, found '}'"}},
        "a.pov", "povray");
    expect_messages({"kind",
                     "#declare S = spline { 0, 1 } sphere { S(1, $bezier_spline), 1 }",
                     {"expected the kind of a spline, found 'bezier_spline', which is not declared"}},
                    "a.pov", "povray");
    expect_messages({"spline",
                     "#declare T = pigment { rgb 1 } #declare S = spline { $T 0, 1 }",
                     {"expected a spline or a number, found a pigment"}},
                    "a.pov", "povray");
    expect_messages({"far",
                     "#declare S = spline { 0, 1e300, 1e-300, -1e300 } sphere { $S(1e-301), 1 }",
                     {"the spline has no finite value here"}},
                    "a.pov", "povray");
}

}  // namespace
}  // namespace glint::test
