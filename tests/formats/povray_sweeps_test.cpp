// SPDX-License-Identifier: Apache-2.0
// prism, lathe and sphere_sweep. The stage `peers` compares their pictures with POV-Ray's.
#include <fmt/format.h>

#include "formats/mistakes.h"
#include "formats/povray_text.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::test {
namespace {

const std::string k_prism_square = "<0, 0>, <2, 0>, <2, 2>, <0, 2>, <0, 0>";
const std::string k_hole = "<0.5, 0.5>, <1.5, 0.5>, <1.5, 1.5>, <0.5, 1.5>, <0.5, 0.5>";

std::string said_of(const std::string& text) {
    return messages(read_povray("light_source { <0, 0, -9>, rgb 1 }\n" + text));
}

const MeshData& prism_mesh(const Scene& scene) {
    EXPECT_EQ(scene.meshes.size(), 1u);
    static const MeshData none;
    return scene.meshes.empty() ? none : *scene.meshes[0];
}

// Of the triangles with this normal's direction, on either side.
double area_across(const MeshData& mesh, Vec3 direction) {
    double area = 0;
    for (const TriangleCorners& t : mesh.triangles) {
        const Vec3 a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
        area += number::abs(dot(cross(b - a, c - a), direction)) / 2;
    }
    return area;
}

TEST(PovRayPrisms, HaveSidesAndCapsWithoutHoles) {
    const Scene scene =
        povray_scene("prism { linear_sweep linear_spline 1, 3, 10, " + k_prism_square + ", " + k_hole + " }");
    const MeshData& mesh = prism_mesh(scene);
    EXPECT_DOUBLE_EQ(area_across(mesh, {0, 1, 0}), 2 * (4 - 1));
    EXPECT_DOUBLE_EQ(area_across(mesh, {1, 0, 0}), 2 * (2 * 2 + 2 * 1));
    EXPECT_DOUBLE_EQ(area_across(mesh, {0, 0, 1}), 2 * (2 * 2 + 2 * 1));
    for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i)
        EXPECT_TRUE(mesh.position(i).y == 1 || mesh.position(i).y == 3);
}

TEST(PovRayPrisms, AnIslandInAHoleIsFilled) {
    const std::string island = ", <0.8, 0.8>, <1.2, 0.8>, <1, 1.2>, <0.8, 0.8>";
    const Scene scene = povray_scene("prism { 1, 0, 14, " + k_prism_square + ", " + k_hole + island + " }");
    EXPECT_NEAR(area_across(prism_mesh(scene), {0, 1, 0}), 2 * (3 + 0.08), 1e-6);
}

TEST(PovRayPrisms, WhatAnEvenNumberOfEdgesSurroundsIsOutside) {
    // A bow tie, and a square twice.
    const Scene tie = povray_scene("prism { 0, 1, 5, <0, 0>, <2, 2>, <2, 0>, <0, 2>, <0, 0> }");
    EXPECT_DOUBLE_EQ(area_across(prism_mesh(tie), {0, 1, 0}), 2 * 2);
    const Scene twice = povray_scene("prism { 0, 1, 10, " + k_prism_square + ", " + k_prism_square + " }");
    EXPECT_DOUBLE_EQ(area_across(prism_mesh(twice), {0, 1, 0}), 0);
}

TEST(PovRayPrisms, OpenOnesHaveNoCaps) {
    const Scene scene = povray_scene("prism { 0, 1, 5, " + k_prism_square + " open pigment { rgb 1 } }");
    EXPECT_DOUBLE_EQ(area_across(prism_mesh(scene), {0, 1, 0}), 0);
    EXPECT_EQ(prism_mesh(scene).triangles.size(), 8u);
}

TEST(PovRayPrisms, LinesThatAreNotClosedAreClosed) {
    const Scene scene = povray_scene("prism { 0, 1, 4, <0, 0>, <2, 0>, <2, 2>, <0, 2> }");
    EXPECT_DOUBLE_EQ(area_across(prism_mesh(scene), {0, 1, 0}), 2 * 4);
    const Scene near =
        povray_scene("prism { 0, 1, 10, <0, 0>, <2, 0>, <2, 2>, <0, 2>, <1e-11, 0>, " + k_hole + " }");
    EXPECT_DOUBLE_EQ(area_across(prism_mesh(near), {0, 1, 0}), 2 * 3) << "nearly the first point";
}

TEST(PovRayPrisms, ConicOnesShrinkToTheOrigin) {
    const Scene scene = povray_scene("prism { conic_sweep -1, 2, 5, " + k_prism_square + " }");
    EXPECT_DOUBLE_EQ(area_across(prism_mesh(scene), {0, 1, 0}), 4 + 16 + 4 * (1.0 / 2 + 2) * 2)
        << "caps and sides";
    Vec3 low{9, 9, 9}, high{-9, -9, -9};
    for (std::uint32_t i = 0; i < prism_mesh(scene).vertex_count(); ++i) {
        const Vec3 p = prism_mesh(scene).position(i);
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    expect_vec(low, {-2, -1, -2});
    expect_vec(high, {4, 2, 4});
}

TEST(PovRayLathes, AreConesCylindersAndRings) {
    const Scene scene = povray_scene(
        "lathe { linear_spline 6, <0, 0>, <2, 0>, <2, 1>, <1, 1>, <0.5, 3>, <0, 4> translate x }");
    ASSERT_EQ(scene.shapes.size(), 5u);
    ASSERT_EQ(scene.get<Disc>().size(), 2u);
    EXPECT_EQ(scene.get<Disc>()[0].hole, 0);
    EXPECT_EQ(scene.get<Disc>()[1].hole, 1);
    EXPECT_EQ(scene.get<Disc>()[1].radius, 2);
    expect_vec(scene.get<Disc>()[1].center, {1, 1, 0});
    ASSERT_EQ(scene.get<Cylinder>().size(), 1u);
    EXPECT_FALSE(scene.get<Cylinder>()[0].caps);
    ASSERT_EQ(scene.get<Cone>().size(), 2u);
    EXPECT_FALSE(scene.get<Cone>()[0].caps);
    EXPECT_EQ(scene.get<Cone>()[1].from_radius, 0.5);
    EXPECT_EQ(scene.get<Cone>()[1].to_radius, 0);
}

TEST(PovRayLathes, WhatHasNoAreaIsLeftOut) {
    const Scene scene = povray_scene("sphere { 0, 1 } lathe { 4, <0, 0>, <0, 2>, <0, 2>, <-1e-17, 3> }");
    EXPECT_EQ(scene.shapes.size(), 1u);
}

TEST(PovRaySphereSweeps, ConesTouchBothSpheres) {
    const Scene scene =
        povray_scene("sphere_sweep { linear_spline 2, <0, 0, 0>, 2, <5, 0, 0>, 1 tolerance 0.1 }");
    ASSERT_EQ(scene.get<Sphere>().size(), 2u);
    ASSERT_EQ(scene.get<Cone>().size(), 1u);
    const Cone& cone = scene.get<Cone>()[0];
    expect_vec(cone.from, {2 * 0.2, 0, 0});
    expect_vec(cone.to, {5 + 0.2, 0, 0});
    // Its ends are circles on the spheres, and a radius there is perpendicular to the cone's line.
    EXPECT_NEAR(cone.from.x * cone.from.x + cone.from_radius * cone.from_radius, 4, 1e-12);
    EXPECT_NEAR((cone.to.x - 5) * (cone.to.x - 5) + cone.to_radius * cone.to_radius, 1, 1e-12);
    const double along = cone.to.x - cone.from.x, rise = cone.to_radius - cone.from_radius;
    EXPECT_NEAR(cone.from.x * along + cone.from_radius * rise, 0, 1e-12);
}

TEST(PovRaySphereSweeps, EqualRadiiMakeCylindersAndHeldSpheresNothing) {
    const Scene scene = povray_scene(
        "sphere_sweep { linear_spline 4, <0, 0, 0>, 1, <3, 0, 0>, 1, <3, 0.1, 0>, 0.5, <3, 0.1, 0>, 0.5 }");
    EXPECT_EQ(scene.get<Sphere>().size(), 4u);
    EXPECT_EQ(scene.get<Cylinder>().size(), 1u);
    EXPECT_TRUE(scene.get<Cone>().empty());
}

TEST(PovRaySphereSweeps, CurvesAreSweptInPieces) {
    const auto ends = [](const std::string& kind) {
        const Scene scene = povray_scene(
            "sphere_sweep { " + kind + " 5, 0, 1, <6, 0, 0>, 2, <6, 6, 0>, 1, <0, 6, 6>, 3, <0, 12, 6>, 1 }");
        const auto& spheres = scene.get<Sphere>();
        EXPECT_EQ(spheres.size(), 129u) << kind;
        EXPECT_EQ(scene.get<Cone>().size() + scene.get<Cylinder>().size(), 128u);
        return spheres.empty() ? std::tuple<Sphere, Sphere, Sphere>()
                               : std::tuple(spheres.front(), spheres[64], spheres.back());
    };
    // Through the given spheres.
    const auto [first, middle, last] = ends("cubic_spline");
    expect_vec(first.center, {6, 0, 0});
    expect_vec(middle.center, {6, 6, 0});
    expect_vec(last.center, {0, 6, 6});
    EXPECT_NEAR(last.radius, 3, 1e-12);
    // (a + 4 b + c) / 6
    const auto [b_first, b_middle, b_last] = ends("b_spline");
    expect_vec(b_first.center, {5, 1, 0});
    EXPECT_NEAR(b_first.radius, 10.0 / 6, 1e-12);
    expect_vec(b_middle.center, {5, 5, 1});
    expect_vec(b_last.center, {1, 7, 5});
}

TEST(PovRaySphereSweeps, TransparentOnesAndOperandsAreOneSolid) {
    for (const std::string text :
         {"sphere_sweep { linear_spline 2, 0, 1, 3*x, 0.5 pigment { rgbt 0.5 } }",
          "difference { box { -2, 2 } sphere_sweep { linear_spline 2, 0, 1, 3*x, 0.5 } }"}) {
        const Scene scene = povray_scene(text);
        ASSERT_EQ(scene.shapes.size(), 1u) << text;
        EXPECT_EQ(scene.shapes[0].kind, ShapeKind::solid) << text;
    }
}

TEST(PovRayPrisms, CurvesAreNearlyStraightPieces) {
    const std::pair<std::string, double> areas[] = {
        // y = (t - t^2) / 2 over x = (t^2 + 3 t) / 2, and back on the x axis.
        {"quadratic_spline 0, 1, 4, <-1, -1>, <0, 0>, <2, 0>, <0, 0>", 1.0 / 6},
        // A square with y = t - t^2 over x = t + 3 t^2 - 2 t^3 at each side.
        {"cubic_spline 0, 1, 7, <0, 2>, <0, 0>, <2, 0>, <2, 2>, <0, 2>, <0, 0>, <2, 0>",
         4 + 4 * (1.0 / 6 + 6.0 / 30)},
        {"bezier_spline 0, 1, 8, <0, 0>, <1, 2>, <2, 2>, <3, 0>, <3, 0>, <2, 0>, <1, 0>, <0, 0>", 3}};
    for (const auto& [text, area] : areas) {
        const Scene scene = povray_scene("prism { " + text + " }");
        EXPECT_NEAR(area_across(prism_mesh(scene), {0, 1, 0}), 2 * area, 1e-4) << text;
    }
}

TEST(PovRayLathes, CurvesAreConesThatTurnByLittle) {
    // A quarter of a circle, nearly.
    const Scene scene =
        povray_scene("lathe { bezier_spline 4, <1, 0>, <1, 0.5523>, <0.5523, 1>, <0, 1> sturm }");
    const auto& cones = scene.get<Cone>();
    EXPECT_GT(cones.size(), 200u);
    EXPECT_LT(cones.size(), 1000u);
    for (const Cone& cone : cones) {
        EXPECT_NEAR(length(Vec3{cone.from_radius, cone.from.y, 0}), 1, 3e-4);
        EXPECT_FALSE(cone.caps);
    }
    // The first point, and of cubic ones the last, are not on the curve.
    for (const std::string text :
         {"quadratic_spline 3, <9, 9>, <1, 0>, <1, 2>", "cubic_spline 4, <1, -2>, <1, 0>, <1, 2>, <1, 4>"}) {
        const Scene one = povray_scene("lathe { " + text + " }");
        EXPECT_EQ(one.get<Cone>().size() + one.get<Cylinder>().size(), one.shapes.size()) << text;
        EXPECT_FALSE(one.shapes.empty());
    }
}

TEST(PovRaySweeps, OtherSplinesAndPartsOfSolidsAreRefusedByName) {
    const std::pair<std::string, std::string> refused[] = {
        {"prism { cubic_spline 0, 1, 6, <0, 0>, <1, 0>, <1, 1>, <0, 1>, <0, 0>, <1, 0> pigment { rgb 1 } }",
         "2:1: error: glint does not render `prism` (whose curve is not closed)"},
        {"prism { conic_sweep bezier_spline 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0.1, 0> }",
         "2:1: error: glint does not render `prism` (whose curve is not closed)"},
        {"prism { linear_sweep natural_spline 0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0.1, 0> }",
         "2:22: error: glint does not render `natural_spline` (prism)"},
        {"sphere_sweep { natural_spline 4, 0, 1, x, 1, 2*x, 1, 3*x, 1 }",
         "2:16: error: glint does not render `natural_spline` (sphere_sweep)"},
        {"sphere_sweep { cubic_spline 4, 0, 1, x, .1, 2*x, .1, 3*x, 2 }",
         "2:1: error: glint does not render `sphere_sweep` (with a radius below 0)"},
        {"difference { box { -1, 1 } prism { 0, 1, 5, " + k_prism_square + " open } }",
         "2:28: error: glint does not render `prism` (that is open, in a solid)"},
        {"intersection { box { -1, 1 } lathe { 2, <1, 0>, <1, 1> } }",
         "2:30: error: glint does not render `lathe` (that is open, in a solid)"},
        {"lathe { 2, <-1, 0>, <1, 1> }", "2:1: error: glint does not render `lathe` (with a radius below 0)"},
        {"sphere_sweep { linear_spline 2, 0, -1, x, 1 }",
         "2:1: error: glint does not render `sphere_sweep` (with a radius below 0)"}};
    for (const auto& [text, message] : refused) {
        EXPECT_NE(said_of(text).find(message), std::string::npos) << said_of(text);
        EXPECT_EQ(said_of("#declare A = " + text + "\nsphere { 0, 1 }"), "") << "not used";
    }
    std::string many = "prism { 0, 1, 5000";
    for (int i = 0; i < 5000; ++i) many += ", <" + std::to_string(i) + ", " + std::to_string(i * i) + ">";
    EXPECT_NE(said_of(many + " }").find("`prism` (with too many points or crossings)"), std::string::npos);
}

TEST(PovRaySweeps, BadInputIsNamed) {
    expect_messages(
        {"few", "prism { 0, 1, $2, <0, 0>, <1, 0> }", {"expected at least 3 points of a linear spline"}},
        "a.pov", "povray");
    expect_messages(
        {"few", "lathe { linear_spline $1, <0, 0> }", {"expected at least 2 points of a linear spline"}},
        "a.pov", "povray");
    expect_messages({"few",
                     "sphere_sweep { linear_spline $1, 0, 1 }",
                     {"expected at least two spheres of a sphere_sweep"}},
                    "a.pov", "povray");
    expect_messages({"cubic",
                     "lathe { cubic_spline $3, <0, 0>, <1, 1>, <2, 1> }",
                     {"expected at least 4 points of a cubic spline"}},
                    "a.pov", "povray");
    expect_messages({"four",
                     "lathe { bezier_spline $5, <0, 0>, <1, 1>, <2, 1>, <2, 2>, <2, 2> }",
                     {"expected four points for each curve of a bezier spline"}},
                    "a.pov", "povray");
    expect_messages({"three", "lathe { 2, $<0, 0, 1>, <1, 0> }", {"expected a vector of two numbers"}},
                    "a.pov", "povray");
    EXPECT_NE(said_of("prism { 0, 1, 1e9, <0, 0>, <1, 0>").find("error: "), std::string::npos);
    EXPECT_NE(said_of("prism { cubic_spline 0").find("error: "), std::string::npos);
}

TEST(PovRaySweeps, DeclaredOnesAreCopied) {
    const Scene scene = povray_scene("#declare P = prism { 0, 1, 5, " + k_prism_square +
                                     " }\n"
                                     "prism { P translate x } object { P scale 2 }\n"
                                     "#declare L = lathe { 2, <1, 0>, <1, 1> } lathe { L translate x }");
    EXPECT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(scene.meshes.size(), 1u);
}

TEST(PovRaySweeps, ACameraInOneInFogIsWarnedOf) {
    const auto said = [](std::string_view camera, std::string_view more) {
        return messages(read_povray(fmt::format(
            "camera {{ location {} look_at <0, 0, 9> }}\nfog {{ distance 5 color rgb 1 }}\n"
            "prism {{ 0, 1, 5, <-1, -1>, <1, -1>, <1, 1>, <-1, 1>, <-1, -1> pigment {{ rgb 1 }} {} }}",
            camera, more)));
    };
    EXPECT_NE(said("<0, 0.5, 0>", "").find("3:1: warning: the camera may be inside of this object"),
              std::string::npos)
        << said("<0, 0.5, 0>", "");
    EXPECT_EQ(said("<0, 1.5, 0>", ""), "");
    EXPECT_EQ(said("<0, 0.5, 0>", "hollow"), "");
    EXPECT_NE(said("<0, 1.5, 0>", "translate y").find("the camera may be inside"), std::string::npos);
}

// The number of a shape that becomes an operand is then another shape's, or none's.
TEST(PovRaySweeps, AnOperandIsNotTakenForAnotherShapeAroundTheCamera) {
    const std::string text =
        "camera { location <0, 2, -7> look_at 0 }\nfog { distance 5 color rgb 1 }\n"
        "difference { sphere { 0, 1 } prism { -2, 2, 5, " +
        k_prism_square + " } pigment { rgb 1 } }\n";
    EXPECT_EQ(messages(read_povray(text + "sphere { <0, 2, -7>, 3 pigment { rgb 1 } hollow }")), "");
    EXPECT_EQ(messages(read_povray(text)), "");
}

}  // namespace
}  // namespace glint::test
