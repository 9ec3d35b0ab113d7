// SPDX-License-Identifier: Apache-2.0
// Solids that are empty, and operands that cut nothing.
#include "check/check_text.h"

namespace glint::test {
namespace {

std::string ids_with(std::string_view solid) { return ids_of(fmt::format("{}{}\n", k_clean, solid)); }

TEST(CheckSolids, Empty) {
    EXPECT_EQ(
        ids_with("intersection { sphere { center = (0, 2, 2)  radius = 0.3 } sphere { center = (1, 2, 2)  "
                 "radius = 0.3 } }"),
        "solid-empty@7");
    EXPECT_EQ(
        ids_with("difference { box { min = (0, 2, 2)  max = (0.5, 2.5, 2.5) } sphere { center = (0.2, 2.2, "
                 "2.2)  radius = 2 } }"),
        "solid-empty@7");
    // A thin shell, and a thin slice.
    EXPECT_EQ(
        ids_with("difference { sphere { center = (0, 2, 2)  radius = 0.3 } sphere { center = (0, 2, 2)  "
                 "radius = 0.29999 } }"),
        "");
    EXPECT_EQ(
        ids_with("intersection { box { min = (0, 1, 2)  max = (0.5, 1.5, 2.5) } plane { point = (0, 1.0001, "
                 "0)  normal = (0, 1, 0) } }"),
        "");
}

TEST(CheckSolids, OperandsThatCutNothing) {
    const auto cut = [](std::string_view what) {
        return ids_with(
            fmt::format("difference {{ box {{ min = (0, 1, 2)  max = (0.5, 1.5, 2.5) }} {} }}", what));
    };
    EXPECT_EQ(cut("sphere { center = (0.25, 2, 2.25)  radius = 0.4 }"), "operand-cuts-nothing@7");
    EXPECT_EQ(cut("sphere { center = (0.25, 1.8, 2.25)  radius = 0.4 }"), "");
    EXPECT_EQ(cut("cylinder { from = (0.25, 0.9, 2.25)  to = (0.25, 1.6, 2.25)  radius = 0.01 }"), "");
    // Inside: a bubble.
    EXPECT_EQ(cut("sphere { center = (0.25, 1.25, 2.25)  radius = 0.1 }"), "");
    const auto common = [](std::string_view what) {
        return ids_with(
            fmt::format("intersection {{ sphere {{ center = (0, 2, 2)  radius = 0.3 }} {} }}", what));
    };
    EXPECT_EQ(common("plane { point = (0, 2.31, 0)  normal = (0, 1, 0) }"), "operand-cuts-nothing@7");
    EXPECT_EQ(common("plane { point = (0, 2.29, 0)  normal = (0, 1, 0) }"), "");
    EXPECT_EQ(common("inverse { sphere { center = (0, 2, 2)  radius = 0.1 } }"), "");
    const std::string message =
        only_message(fmt::format("{}difference \"cup\" {{ box {{ min = (0, 1, 2)  max = (0.5, 1.5, 2.5) }} "
                                 "sphere {{ center = (0.25, 2, 2.25)  "
                                 "radius = 0.4 }} }}\n",
                                 k_clean));
    EXPECT_TRUE(
        has(message,
            "shape 2 of solid 'cup', a sphere, seems to cut nothing off: without it, each of 20000 points"))
        << message;
}

// One of two equal cuts is enough; and a bounded operand is needed.
TEST(CheckSolids, WhatIsNeeded) {
    EXPECT_EQ(
        ids_with(
            "difference { box { min = (0, 1, 2)  max = (0.5, 1.5, 2.5) } sphere { center = (0.25, 1, 2)  "
            "radius = 0.1 } sphere { center = (0.25, 1, 2)  radius = 0.1 } }"),
        "operand-cuts-nothing@7");
    EXPECT_EQ(
        ids_with(
            "intersection { sphere { center = (0, 2, 2)  radius = 0.3 } plane { point = (0, 2, 0)  normal "
            "= (0, 1, 0) } inverse { plane { point = (0, 1.9998, 0)  normal = (0, 1, 0) } } }"),
        "");
    // The corners of a cube, some of which the camera does not see.
    std::string planes;
    for (int i = 0; i < 8; ++i) {
        const int x = i & 1 ? 1 : -1, y = i & 2 ? 1 : -1, z = i & 4 ? 1 : -1;
        planes += fmt::format("plane {{ point = ({}, {}, {})  normal = ({}, {}, {}) }} ", x * 0.28,
                              2 + y * 0.28, 2 + z * 0.28, x, y, z);
    }
    EXPECT_EQ(
        ids_with("intersection { box { min = (-0.3, 1.7, 1.7)  max = (0.3, 2.3, 2.3) } " + planes + "}"), "");
}

// Parts of a union may lie in each other, and the first of a difference is what is cut.
TEST(CheckSolids, WhatNeedNotCut) {
    EXPECT_EQ(
        ids_with(
            "union { sphere { center = (0, 2, 2)  radius = 0.3 } sphere { center = (0, 2, 2)  radius = 0.1 "
            "} }"),
        "");
    EXPECT_EQ(
        ids_with(
            "merge { sphere { center = (0, 2, 2)  radius = 0.3 } sphere { center = (0, 2, 2)  radius = 0.1 "
            "} }"),
        "");
}

// A box of half a unit, whose front the camera sees, and what is cut out of it.
std::string cut_box(std::string_view what) {
    return fmt::format(
        "difference \"cup\" {{ color = (0.8, 0.2, 0.1)  ambient = 1  diffuse = 0.9  box {{ min = (0, 1, 2)  "
        "max = (0.5, 1.5, 2.5) }} {} }}",
        what);
}

TEST(CheckSolids, FlushCuts) {
    const char* const k_flush[] = {
        "cylinder { from = (0.25, 1.25, 2.2)  to = (0.25, 1.25, 2.5)  radius = 0.15 }",
        // through and through: the background is seen, or the floor
        "cylinder { from = (0.25, 1.25, 2)  to = (0.25, 1.25, 2.5)  radius = 0.15 }",
        "box { min = (0.2, 1.2, 2.3)  max = (0.4, 1.4, 2.5) }",
        // a step, of which one side is flush
        "box { min = (-0.1, 1.2, 2.3)  max = (0.3, 1.6, 2.5) }",
        "cone { from = (0.25, 1.25, 2.2)  to = (0.25, 1.25, 2.5)  radius = (0.02, 0.2) }",
        // but for rounding
        "cylinder { from = (0.25, 1.25, 2.2)  to = (0.25, 1.25, 2.5000000001)  radius = 0.15 }",
        // a countersink: two cuts that touch each other
        ("cylinder { from = (0.25, 1.25, 2.2)  to = (0.25, 1.25, 2.4)  radius = 0.1 } "
         "cylinder { from = (0.25, 1.25, 2.4)  to = (0.25, 1.25, 2.6)  radius = 0.2 }"),
    };
    for (const char* what : k_flush) EXPECT_EQ(ids_with(cut_box(what)), "faces-coincide@7") << what;
    const std::string message = only_message(fmt::format("{}{}\n", k_clean, cut_box(k_flush[0])));
    for (const char* part :
         {"shapes 1 and 2 of solid 'cup', a box and a cylinder, have faces that coincide, visible in 0.",
          "rounding decides whether a surface is there, and other programs may show spots",
          "make shape 2 reach further than shape 1 there, or less far, by more than a millionth of its "
          "coordinates"})
        EXPECT_TRUE(has(message, part)) << message;
    // Turned: the same plane but for rounding.
    EXPECT_EQ(ids_with(fmt::format("group {{ rotate = (0, 20, 5)  {} }}", cut_box(k_flush[0]))),
              "faces-coincide@7");
}

TEST(CheckSolids, FacesOfTwoMaterials) {
    const auto both = [](std::string_view operation, std::string_view color, double z) {
        return ids_with(fmt::format(
            "{} {{ box {{ min = (0, 1, 2)  max = (0.5, 1.5, 2.5)  color = (0.8, 0.2, 0.1)  ambient = 1  "
            "diffuse = 0.9 }} box {{ min = (0.2, 1.2, 2.1)  max = (0.8, 1.8, {})  color = {}  ambient = 1  "
            "diffuse = 0.9 }} }}",
            operation, z, color));
    };
    for (const char* operation : {"union", "merge", "intersection"}) {
        EXPECT_EQ(both(operation, "(0.2, 0.8, 0.1)", 2.5), "faces-coincide@7") << operation;
        EXPECT_EQ(both(operation, "(0.8, 0.2, 0.1)", 2.5), "") << operation;
        EXPECT_EQ(both(operation, "(0.2, 0.8, 0.1)", 2.49), "") << operation;
    }
    EXPECT_TRUE(has(
        only_message(k_clean + "union { box { min = (0, 1, 2)  max = (0.5, 1.5, 2.5)  color = (1, 0, 0) } "
                               "box { min = (0.2, 1.2, 2.1)  max = (0.8, 1.8, 2.5)  color = (0, 1, 0) } }\n"),
        "whose material is there"));
}

// Parts that touch have a wall between them, or none: in glass it is seen.
TEST(CheckSolids, PartsThatTouch) {
    const auto parts = [](std::string_view material, double z) {
        return fmt::format(
            "merge {{ color = (0.5, 0.6, 0.5)  {} box {{ min = (0, 1, 2.3)  max = (0.5, 1.5, 2.5) }} box {{ "
            "min = (0.1, 1.1, 2)  max = (0.4, 1.4, {}) }} }}",
            material, z);
    };
    const std::string glass = "transmission = 0.8  ior = 1.5";
    EXPECT_EQ(ids_with(parts(glass, 2.3)), "faces-coincide@7");
    EXPECT_EQ(ids_with(parts(glass, 2.4)), "");
    EXPECT_EQ(ids_with(parts("ambient = 1  diffuse = 0.9", 2.3)), "");
}

TEST(CheckSolids, FacesThatDoNotCoincide) {
    const std::string red = "color = (0.8, 0.2, 0.1)  ambient = 1  diffuse = 0.9",
                      green = "color = (0.1, 0.7, 0.1)  ambient = 1  diffuse = 0.9";
    for (const std::string& solid : {
             // It ends beyond the box, or within it.
             cut_box("cylinder { from = (0.25, 1.25, 2.2)  to = (0.25, 1.25, 2.6)  radius = 0.15 }"),
             cut_box("cylinder { from = (0.25, 1.25, 1.9)  to = (0.25, 1.25, 2.6)  radius = 0.15 }"),
             cut_box("cylinder { from = (0.25, 1.25, 2.2)  to = (0.25, 1.25, 2.500001)  radius = 0.15 }"),
             // Only the back is flush.
             cut_box("box { min = (0.2, 1.2, 2)  max = (0.4, 1.4, 2.1) }"),
             // Another cut is around the flush one.
             cut_box("cylinder { from = (0.25, 1.25, 2.05)  to = (0.25, 1.25, 2.5)  radius = 0.1 } "
                     "cylinder { from = (0.25, 1.25, 2.1)  to = (0.25, 1.25, 2.6)  radius = 0.15 }"),
             // Two boxes that have an edge in common.
             "union { box { min = (0, 1, 2)  max = (0.3, 1.3, 2.5) " + red +
                 " } box { min = (0.3, 1.3, 2)  max = (0.6, 1.6, 2.5) " + green + " } }",
             // ...and two that have a hidden side in common, next to each other in one plane.
             "union { box { min = (0, 1, 2)  max = (0.3, 1.3, 2.5) " + red +
                 " } box { min = (0.3, 1, 2)  max = (0.6, 1.3, 2.5) " + green + " } }",
             // A cylinder through a box, and spheres that touch from outside and from inside.
             "union { box { min = (0, 1, 2)  max = (0.3, 1.3, 2.5) " + red +
                 " } cylinder { from = (0.15, 1.15, 1.9)  to = (0.15, 1.15, 2.6)  radius = 0.1 " + green +
                 " } }",
             "union { sphere { center = (0, 1.5, 2)  radius = 0.2 " + red +
                 " } sphere { center = (0.4, 1.5, 2)  radius = 0.2 " + green + " } }",
             "union { sphere { center = (0, 1.5, 2)  radius = 0.3 " + red +
                 " } sphere { center = (0, 1.5, 2.1)  radius = 0.2 " + green + " } }",
             "difference { sphere { center = (0, 1.5, 2)  radius = 0.3 " + red +
                 " } sphere { center = (0, 1.5, 2.1)  radius = 0.2 " + green + " } }",
             // Spheres in one another at a small angle of their faces.
             "union { sphere { center = (0, 1.5, 2)  radius = 0.3 " + red +
                 " } sphere { center = (0.001, 1.5, 2)  radius = 0.3 " + green + " } }",
             // Faces in another shape.
             "union { box { min = (0, 1, 2)  max = (0.3, 1.3, 2.3) " + red +
                 " } box { min = (0.1, 1, 2)  max = (0.6, 1.6, 2.3) " + green +
                 " } box { min = (-0.1, 0.9, 2)  max = (0.7, 1.7, 2.5) " + red + " } }",
         })
        EXPECT_EQ(ids_with(solid), "") << solid;
}

// A coarse epsilon makes nothing else one face: it is how far rays start from a surface.
TEST(CheckSolids, FacesByACoarseEpsilon) {
    const std::string coarse = k_clean + "conventions { offset = normal  epsilon = 0.001 }\n";
    const auto common = [&](std::string_view other) {
        return ids_of(fmt::format(
            "{}union {{ sphere {{ center = (0, 1.5, 2)  radius = 0.5  color = (0.8, 0.2, 0.1)  ambient = 1  "
            "diffuse = 0.9 }} {} color = (0.1, 0.7, 0.1)  ambient = 1  diffuse = 0.9 }} }}\n",
            coarse, other));
    };
    EXPECT_EQ(common("sphere { center = (0, 1.5, 2.1)  radius = 0.4 "), "");
    EXPECT_EQ(common("sphere { center = (0.2, 1.5, 2.1)  radius = 0.45 "), "");
    EXPECT_EQ(common("box { min = (-0.1, 1.4, 2)  max = (0.1, 1.6, 2.5) "), "");
    EXPECT_EQ(common("sphere { center = (0, 1.5, 2)  radius = 0.5001 "), "");
    EXPECT_EQ(common("sphere { center = (0, 1.5, 2)  radius = 0.5 "), "faces-coincide@8");
}

// A lathe in a solid is made of cones that touch each other, or have the same ends: no one can change that.
TEST(CheckSolids, Lathes) {
    const auto with = [](std::string_view bored) {
        return ids_of(fmt::format("#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n"
                                  "camera {{ location <0, 4, -9> look_at <0, 0.5, 0> }}\n"
                                  "light_source {{ <3, 6, -8> rgb 0.8 }}\n"
                                  "plane {{ y, -2 pigment {{ rgb 0.5 }} }}\n"
                                  "difference {{ {} box {{ <0, -5, 0>, <5, 5, -5> rotate <0, 30, 0> }} "
                                  "pigment {{ rgb x }} }}\n",
                                  bored),
                      "scene.pov");
    };
    EXPECT_EQ(with("lathe { linear_spline 5, <1, -1>, <2, -1>, <2.5, 1>, <1.2, 1>, <1, -1> }"), "");
    EXPECT_EQ(with("lathe { linear_spline 6, <1, -1>, <2, -1>, <2.2, 0>, <2.5, 1>, <1.2, 1>, <1, -1> }"), "");
    EXPECT_EQ(with("lathe { linear_spline 5, <1, -1>, <2, -1>, <2, 1>, <1, 1>, <1, -1> }"), "");
    EXPECT_EQ(
        with("lathe { linear_spline 7, <0, -1>, <1, -1>, <1.5, 0>, <1, 0.5>, <1.4, 1>, <1, 1.5>, <0, 1.5> "
             "clipped_by { box { <-3, -0.5, -3>, <3, 3, 3> } } }"),
        "");
    // The same of two cylinders can be changed.
    EXPECT_EQ(with("difference { cylinder { -y, y, 2 } cylinder { -y, y, 1 } }"), "faces-coincide@6");
}

// So many pairs that they are not examined: it takes no more than some seconds.
TEST(CheckSolids, ManyFacesInOnePlane) {
    std::string solid = "union {";
    for (int i = 0; i < 200; ++i) {
        solid += fmt::format(" box {{ min = (-1, 0, {})  max = (1, 1, 1.5)  color = ({}, 0.5, 0.5) }}",
                             1.4 - 0.001 * i, 0.3 + 0.002 * i);
    }
    const std::string found =
        ids_with("merge { " + solid + " } sphere { center = (0, 2, 2)  radius = 0.3 } }");
    EXPECT_EQ(found.find("faces-coincide"), std::string::npos) << found;
}

}  // namespace
}  // namespace glint::test
