// SPDX-License-Identifier: Apache-2.0
// fog { } of .glint: what it reads, and the messages for mistakes.
#include "formats/load_text.h"
#include "formats/mistakes.h"
#include "glint/write.h"

namespace glint::test {
namespace {

class FogMistakes : public testing::TestWithParam<BadText> {};
TEST_P(FogMistakes, AreReportedAtTheirPlace) { expect_messages(GetParam(), "a.glint"); }

#define SCENE                           \
    "camera { position = (0, 0, 5) }\n" \
    "light { position = (0, 9, 5) }\n"  \
    "sphere { center = (0, 0, 0)  radius = 1 }\n"

INSTANTIATE_TEST_SUITE_P(
    All, FogMistakes,
    testing::Values(
        BadText{"kind",
                SCENE "fog { type = $expo }",
                {"expected `linear`, `exp` or `exp2`, found 'expo'; did you mean `exp`?"}},
        BadText{"density", SCENE "fog { density = $-1 }", {"expected a number from 0 to 1e12, found '-1'"}},
        BadText{"transmit", SCENE "fog { transmit = $1.5 }", {"expected a number from 0 to 1, found '1.5'"}},
        BadText{"distance",
                SCENE "fog { $distance = 10 }",
                {"a fog has no 'distance': write `density`, which is 1 / distance"}},
        BadText{"unused", SCENE "fog { $end = 10 }", {"glint ignores the 'end' of an exp fog"}},
        BadText{"unused_height", SCENE "fog { $height = 10 }", {"glint ignores the 'height' of an exp fog"}},
        BadText{"unused_falloff",
                SCENE "fog { type = exp2  $falloff = 10 }",
                {"glint ignores the 'falloff' of an exp2 fog"}},
        BadText{"up",
                SCENE "fog { falloff = 1  up = $(0, 0, 0) }",
                {"expected a direction other than (0, 0, 0)"}},
        BadText{"unused_density",
                SCENE "fog { type = linear  $density = 10 }",
                {"glint ignores the 'density' of a linear fog"}},
        BadText{"end",
                SCENE "fog { type = linear  start = 5  $end = 5 }",
                {"expected an `end` above the start 5, found 5"}},
        BadText{"default_end",
                SCENE "$fog { type = linear  start = 500 }",
                {"expected an `end` above the start 500, found 100"}},
        BadText{"two", SCENE "fog { }\n$fog { density = 1 }", {"a second fog: the last one holds"}},
        BadText{"in_a_group",
                SCENE "group { $fog { } }",
                {"a group contains shapes, groups and includes; 'fog' must be outside"}}),
    [](const auto& tested) { return tested.param.name; });

TEST(GlintFog, OnTheGroundIsReadAndWritten) {
    const Result<Scene> scene =
        load_text("fog { density = 0.5  falloff = 2  height = 0.5  up = (0, 0, 1) }\n" SCENE, "a.glint");
    ASSERT_TRUE(scene);
    Fog expected;
    expected.density = 0.5;
    expected.falloff = 2;
    expected.height = 0.5;
    expected.up = {0, 0, 1};
    EXPECT_EQ(*scene->fog, expected);
    const Result<Scene> again = load_text(write_glint(*scene).value(), "a.glint");
    ASSERT_TRUE(again);
    EXPECT_EQ(*again->fog, expected);
}

TEST(GlintFog, IsReadAndWritten) {
    const Result<Scene> scene = load_text(
        "fog { type = linear  color = (0.1, 0.2, 0.3)  start = 2  end = 9  transmit = 0.25 }\n"
        "conventions { fog_distance = depth  fog_background = false }\n" SCENE,
        "a.glint");
    ASSERT_TRUE(scene);
    ASSERT_TRUE(scene->fog);
    EXPECT_EQ(*scene->fog, (Fog{FogKind::linear, {0.1, 0.2, 0.3}, Fog{}.density, 2, 9, 0.25}));
    EXPECT_EQ(scene->fog_place.line, 1u);
    EXPECT_EQ(scene->conventions.fog_distance, FogDistance::depth);
    EXPECT_FALSE(scene->conventions.fog_background);
    const std::string text = write_glint(*scene).value();
    EXPECT_NE(
        text.find("fog { type = linear  color = (0.1, 0.2, 0.3)  start = 2  end = 9  transmit = 0.25 }"),
        std::string::npos)
        << text;
    EXPECT_EQ(load_text(text, "b.glint")->fog, scene->fog);
    EXPECT_EQ(load_text("fog { }" SCENE, "a.glint")->fog, Fog{});
}

TEST(GlintFog, AdaptiveSamplingIsQuoted) {
    const Result<Scene> scene =
        load_text("render { aa = \"adaptive:4:0.05\"  alpha = true }\n" SCENE, "a.glint");
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->settings.samples, 4);
    EXPECT_EQ(scene->settings.aa_threshold, 0.05);
    EXPECT_TRUE(scene->settings.alpha);
    const Result<Scene> again = load_text(write_glint(*scene).value(), "b.glint");
    ASSERT_TRUE(again);
    EXPECT_EQ(again->settings, scene->settings);
}

}  // namespace
}  // namespace glint::test
