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
            "shape 2 of solid 'cup', a sphere, seems to cut nothing off: without it, none of 20000 points"))
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

}  // namespace
}  // namespace glint::test
