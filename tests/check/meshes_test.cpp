// SPDX-License-Identifier: Apache-2.0
// Triangles of meshes that contradict each other or their normals, planted, and what is no mistake.
#include "check/check_text.h"

namespace glint::test {
namespace {

// A strip of squares, two triangles each. `change` replaces the text of triangle 1.
std::string strip(const std::string& change = {}, const std::string& more = {}) {
    std::string vertices, triangles;
    for (int i = 0; i < 5; ++i) {
        vertices += fmt::format("{}({}, 1, 2), ({}, 2, 2)", i > 0 ? ", " : "", 0.2 * i, 0.2 * i);
        if (i == 4) break;
        triangles += i > 0 ? ", " : "";
        triangles += fmt::format("({}, {}, {}), ", 2 * i, 2 * i + 2, 2 * i + 1);
        const std::string second = fmt::format("({}, {}, {})", 2 * i + 2, 2 * i + 3, 2 * i + 1);
        triangles += i == 0 && !change.empty() ? change : second;
    }
    return "mesh { vertices = (" + vertices + ")  triangles = (" + triangles + ") " + more + "}\n";
}
std::string normals(const std::string& one, const std::string& last) {
    std::string list = "normals = (";
    for (int i = 0; i < 9; ++i) list += one + ", ";
    return list + last + ") ";
}

TEST(CheckMeshes, SayNothingOfASoundMesh) {
    EXPECT_EQ(ids_of(k_clean + strip()), "");
    EXPECT_EQ(ids_of(k_clean + strip({}, normals("(0, 0, 1)", "(0, 0.1, 1)"))), "");
    // A mirrored one is turned around with all that it has.
    EXPECT_EQ(ids_of(k_clean + "group { scale = (-1, 1, 1)\n" + strip({}, normals("(0, 0, 1)", "(0, 0, 1)")) +
                     "}\n"),
              "");
}

TEST(CheckMeshes, TurnedTriangles) {
    const std::string turned = strip("(2, 1, 3)");
    EXPECT_TRUE(has(only_message(k_clean + turned),
                    "1 of the 8 triangles of its mesh face the other way than their neighbours; the first is "
                    "number 1, from 0"))
        << only_message(k_clean + turned);
    EXPECT_EQ(ids_of("conventions { facing = none }\n" + k_clean + turned), "mesh-winding@8");
}

// One of a cube's twelve has three neighbours, which are right.
TEST(CheckMeshes, TheTurnedTriangleAndNotItsNeighbours) {
    const auto cube = [](std::string_view eleventh, std::string_view glass) {
        return fmt::format(
            "{}mesh {{ vertices = ((-0.4, 0.2, 2), (0.4, 0.2, 2), (0.4, 1, 2), (-0.4, 1, 2), (-0.4, 0.2, "
            "2.8), "
            "(0.4, 0.2, 2.8), (0.4, 1, 2.8), (-0.4, 1, 2.8))\ntriangles = ((0, 2, 1), (0, 3, 2), (4, 5, 6), "
            "(4, 6, 7), (0, 1, 5), (0, 5, 4), (2, 3, 7), (2, 7, 6), (1, 2, 6), (1, 6, 5), (0, 4, 7), {}) {} "
            "}}\n",
            k_clean, eleventh, glass);
    };
    EXPECT_EQ(ids_of(cube("(0, 7, 3)", "")), "");
    for (const char* glass : {"", "transmission = 0.8  ior = 1.5"}) {
        std::vector<Finding> found = check_text(cube("(0, 3, 7)", glass));
        std::erase_if(found, [](const Finding& f) { return f.id != "mesh-winding"; });
        ASSERT_EQ(found.size(), 1u) << glass;
        EXPECT_TRUE(has(to_string(found[0]), "1 of the 12 triangles")) << to_string(found[0]);
        EXPECT_TRUE(has(to_string(found[0]), "the first is number 11")) << to_string(found[0]);
        EXPECT_EQ(found[0].diagnostic.severity, *glass == 0 ? Severity::note : Severity::warning);
    }
}

TEST(CheckMeshes, NoOrderOfVerticesAgreesOnAMoebiusStrip) {
    EXPECT_FALSE(has(
        ids_of("conventions { facing = none }\n" + k_clean +
               "mesh { vertices = ((0, 0.4, 2), (0.4, 0.4, 2.2), (0.1, 0.8, 2.4), (0.5, 1, 2), "
               "(-0.3, 1, 2.2))\ntriangles = ((0, 1, 2), (1, 2, 3), (2, 3, 4), (3, 4, 0), (4, 0, 1)) }\n"),
        "mesh-winding"));
}

TEST(CheckMeshes, DuplicatesAndTrianglesWithoutArea) {
    EXPECT_EQ(ids_of(k_clean + strip("(2, 1, 0)")), "mesh-duplicates@7");
    EXPECT_EQ(ids_of(k_clean + strip("(2, 2, 0)")), "mesh-without-area@7");
}

TEST(CheckMeshes, NormalsAgainstTheWinding) {
    EXPECT_EQ(ids_of(k_clean + strip({}, normals("(0, 0, -1)", "(0, 0, -1)"))), "normals-against-winding@7");
    EXPECT_EQ(ids_of(k_clean + strip({}, normals("(0, 0, 1)", "(0, 0, -1)"))), "normals-on-both-sides@7");
}

TEST(CheckMeshes, ShapesOfSolids) {
    const auto cut = [](std::string_view more) {
        return fmt::format(
            "{}difference \"cup\" {{ box {{ min = (-0.5, 0.7, 1.7)  max = (0.5, 1.5, 1.9) }} mesh {{ "
            "vertices = "
            "((-0.4, 0.8, 2), (0.4, 0.8, 2), (0, 0.8, 1.6), (0, 1.6, 1.8))  triangles = ((0, 2, 1), (0, 1, "
            "3), (1, 2, 3), (2, 0, 3){}  }} }}\n",
            k_clean, more);
    };
    EXPECT_EQ(ids_of(cut(")")), "");
    EXPECT_EQ(ids_of(cut(", (0, 0, 1))")), "mesh-without-area@7");
    const std::string message = only_message(cut(", (0, 0, 1))"));
    EXPECT_TRUE(has(message, "shape 2 of solid 'cup': 1 of the 5 triangles of its mesh have no area"))
        << message;
    const std::string turned = ")  normals = ((0, 0, -1), (0, 0, -1), (0, 0, -1), (0, 0, -1))";
    EXPECT_TRUE(has(ids_of(cut(turned)), "normals-against-winding@7")) << ids_of(cut(turned));
}

}  // namespace
}  // namespace glint::test
