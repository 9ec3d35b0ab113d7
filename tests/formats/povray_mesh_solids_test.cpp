// SPDX-License-Identifier: Apache-2.0
// Meshes, prisms and lathes as parts of solids.
#include <algorithm>

#include "formats/povray_text.h"

namespace glint::test {
namespace {

// A tetrahedron whose second triangle faces inwards.
const std::string k_triangles =
    "triangle { <0, 0, 0>, <0, 2, 0>, <2, 0, 0> } triangle { <0, 0, 0>, <0, 0, 2>, <0, 2, 0> }\n"
    "triangle { <0, 0, 0>, <2, 0, 0>, <0, 0, 2> } triangle { <2, 0, 0>, <0, 2, 0>, <0, 0, 2> }\n";

std::string said_of(const std::string& text) { return messages(read_povray(text)); }

std::string cut(const std::string& object) { return "difference { box { -1, 1 } " + object + " }"; }

TEST(PovRayMeshSolids, AMeshWithAnInsideIsAnOperand) {
    const Scene scene = povray_scene(cut("mesh { " + k_triangles + " inside_vector y }"));
    ASSERT_EQ(scene.solids.size(), 1u);
    ASSERT_EQ(scene.solids[0].operands.size(), 2u);
    EXPECT_EQ(scene.solids[0].operands[1].kind, ShapeKind::mesh);
    ASSERT_EQ(scene.meshes.size(), 1u);
    // Turned so that all face outwards.
    for (const TriangleCorners& t : scene.meshes[0]->triangles) {
        const Vec3 a = scene.meshes[0]->position(t[0]), b = scene.meshes[0]->position(t[1]),
                   c = scene.meshes[0]->position(t[2]);
        EXPECT_GT(dot(cross(b - a, c - a), a - Vec3{0.4, 0.4, 0.4}), 0);
    }
}

TEST(PovRayMeshSolids, OthersAreRefusedByName) {
    const auto expect_said = [](const std::string& text, const std::string& wanted) {
        EXPECT_NE(said_of(text).find(wanted), std::string::npos) << text << "\n" << said_of(text);
    };
    expect_said(cut("mesh { " + k_triangles + " }"), "`mesh` (without `inside_vector` in a solid)");
    expect_said(cut("mesh { " + k_triangles + " inside_vector 0 }"), "`mesh` (without `inside_vector`");
    expect_said(cut("mesh { " + k_triangles.substr(0, k_triangles.find('\n')) + " inside_vector y }"),
                "`mesh` (that is open, in a solid)");
    expect_said("#declare T = texture { pigment { rgb x } }\n" +
                    cut("mesh { triangle { 0, x, y texture { T } } inside_vector y }"),
                "`mesh` (with textures of its faces in a solid)");
    expect_said(cut("mesh { triangle { 0, 0, 0 } inside_vector y }"), "`mesh` (that is open, in a solid)");
    expect_said("sphere { 0, 1 clipped_by { mesh { " + k_triangles + " } } }", "`clipped_by`");
}

// The caps of these prisms have vertices on the edges of others.
TEST(PovRayMeshSolids, CapsAndSidesOfPrismsMeet) {
    for (const std::string& spline :
         {std::string("linear_spline 0, 1, 12, <0, 0>, <3, 0>, <3, 3>, <1, 2>, <0, 3>, <0, 0>, "
                      "<1, 1>, <2, 1>, <2.2, 1.7>, <1.3, 1.9>, <0.7, 1.4>, <1, 1>"),
          std::string("quadratic_spline 0, 1, 6, <1, 0>, <0, 1>, <-1, 0>, <0, -1>, <1, 0>, <0, 1>"),
          std::string(
              "conic_sweep cubic_spline -1, 2, 7, <1, 0>, <0, 1>, <-1, 0>, <0, -1>, <1, 0>, <0, 1>, <-1, 0>"),
          std::string("linear_spline 0, 1, 6, <0, 0>, <2, 2>, <2, 0>, <0, 2>, <-1, 1>, <0, 0>")}) {
        const Scene scene = povray_scene(cut("prism { " + spline + " }"));
        EXPECT_EQ(scene.solids.size(), 1u) << spline;
        const Scene clipped = povray_scene("prism { " + spline + " clipped_by { sphere { 0, 1 } } }");
        EXPECT_EQ(clipped.solids.size(), 1u) << spline;
    }
}

// It is cut only if the camera sees what is cut off: it is placed whole, and cut in the end.
TEST(PovRayMeshSolids, APrismWithoutShadowIsCut) {
    const Scene scene = povray_scene(
        "camera { location <0, 0, -5> look_at 0 }\nprism { linear_spline 0, 1, 6, <0, 0>, <2, 2>, <2, 0>, "
        "<0, 2>, "
        "<-1, 1>, <0, 0> rotate -70*x no_shadow clipped_by { box { -0.5, 0.5 } } }");
    EXPECT_EQ(scene.solids.size(), 1u);
}

// Turned around the y axis, what two edges have between them is a cone, or a cone less another one.
TEST(PovRayMeshSolids, ALatheIsTheMergeOfWhatIsBetweenItsEdges) {
    const auto operands = [](const std::string& lathe) {
        const Scene scene = povray_scene(cut("lathe { " + lathe + " }"));
        return scene.solids.empty() ? std::size_t{0} : scene.solids[0].operands.size();
    };
    EXPECT_EQ(operands("linear_spline 4, <0, 0>, <1, 0>, <1, 2>, <0, 2>"), 2u) << "a cylinder";
    EXPECT_EQ(operands("linear_spline 5, <1, 0>, <2, 0>, <2, 1>, <1, 1>, <1, 0>"), 3u) << "a ring";
    EXPECT_EQ(operands("linear_spline 5, <0, 0>, <2, 1>, <1, 1>, <1, 2>, <0, 2>"), 3u);
    EXPECT_GT(operands("cubic_spline 6, <1, -1>, <0, 0>, <1, 1>, <1, 2>, <0, 3>, <1, 4>"), 10u);
    for (const char* const open :
         {"linear_spline 3, <1, 0>, <2, 1>, <1, 2>", "linear_spline 3, <0, 0>, <2, 1>, <1, 2>",
          "bezier_spline 8, <0, 0>, <1, 0>, <1, 0>, <1, 1>, <1, 2>, <1, 3>, <0, 3>, <0, 3>"}) {
        const std::string said = said_of(cut("lathe { " + std::string(open) + " }"));
        EXPECT_NE(said.find("`lathe` (that is open, in a solid)"), std::string::npos) << said;
    }
    const Scene turned = povray_scene(
        "intersection { box { -3, 3 } lathe { linear_spline 4, <0, 0>, <1, 0>, <1, 2>, <0, 2> inverse } }");
    ASSERT_EQ(turned.solids.size(), 1u);
    const auto& steps = turned.solids[0].steps;
    EXPECT_TRUE(std::any_of(steps.begin(), steps.end(),
                            [](const SolidStep& step) { return step.operation == SolidOperation::inverse; }));
    const Scene clipped = povray_scene(
        "lathe { linear_spline 4, <0, 0>, <1, 0>, <1, 2>, <0, 2> clipped_by { sphere { 0, 1 } } }");
    EXPECT_EQ(clipped.solids.size(), 1u);
}

TEST(PovRayMeshSolids, LathesSayWhyTheyAreNoParts) {
    const std::string nothing = said_of(cut("lathe { linear_spline 3, <0, 0>, <1, 0>, <0, 0> }"));
    EXPECT_NE(nothing.find("`lathe` (that encloses nothing, in a solid)"), std::string::npos) << nothing;
    std::string fine = "lathe { cubic_spline 40, <0, -1>";
    for (int i = 0; i < 38; ++i)
        fine += ", <" + std::to_string(i % 37 == 0 ? 0 : 1 + i % 2) + ", " + std::to_string(i) + ">";
    fine += ", <0, 38> }";
    const std::string many = said_of(cut(fine));
    EXPECT_NE(many.find("of more than 4096 shapes"), std::string::npos) << many;
    // Such a merge keeps its inner surfaces.
    const std::string merged = said_of("merge { " + fine + " sphere { 0, 1 } pigment { rgbt 0.5 } }");
    EXPECT_NE(merged.find("`merge` (of transparent surfaces)"), std::string::npos) << merged;
}

TEST(PovRayMeshSolids, InsideKnowsMeshes) {
    const auto radius = [](const std::string& point) {
        const Scene scene =
            povray_scene("#declare M = " + cut("mesh { " + k_triangles + " inside_vector y }") +
                         "\nsphere { 0, 1 + inside(M, " + point + ") }");
        return scene.get<Sphere>().at(0).radius;
    };
    EXPECT_EQ(radius("<-0.5, 0.5, 0.5>"), 2);
    EXPECT_EQ(radius("<0.2, 0.3, 0.4>"), 1) << "within the mesh";
    EXPECT_EQ(radius("<0.8, 0.8, 0.8>"), 2) << "beyond its last face";
    EXPECT_EQ(radius("<1.5, 0.2, 0.2>"), 1);
}

}  // namespace
}  // namespace glint::test
