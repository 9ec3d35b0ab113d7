// SPDX-License-Identifier: Apache-2.0
// occlusion { } and background_gradient { } of .glint: what they read, and the messages for mistakes.
#include <limits>

#include "formats/load_text.h"
#include "formats/mistakes.h"
#include "glint/write.h"

namespace glint::test {
namespace {

class SkyMistakes : public testing::TestWithParam<BadText> {};
TEST_P(SkyMistakes, AreReportedAtTheirPlace) { expect_messages(GetParam(), "a.glint"); }

#define SKY_SCENE                       \
    "camera { position = (0, 0, 5) }\n" \
    "light { position = (0, 9, 5) }\n"  \
    "sphere { center = (0, 0, 0)  radius = 1 }\n"

INSTANTIATE_TEST_SUITE_P(
    All, SkyMistakes,
    testing::Values(
        BadText{"method",
                SKY_SCENE "occlusion { method = $hash }",
                {"expected `hashed` or `fixed`, found 'hash'; did you mean `hashed`?"}},
        BadText{"samples",
                SKY_SCENE "occlusion { samples = $0 }",
                {"expected a whole number from 1 to 4096, found '0'"}},
        BadText{"half_a_sample",
                SKY_SCENE "occlusion { samples = $2.5 }",
                {"expected a whole number from 1 to 4096, found '2.5'"}},
        BadText{"reach", SKY_SCENE "occlusion { reach = $0 }", {"expected a number > 0, found '0'"}},
        BadText{"distance",
                SKY_SCENE "occlusion { $distance = 10 }",
                {"an occlusion has no 'distance': write `reach`"}},
        BadText{"two", SKY_SCENE "occlusion { }\n$occlusion { }", {"a second occlusion: the last one holds"}},
        BadText{"in_a_group",
                SKY_SCENE "group { $occlusion { } }",
                {"a group contains shapes, groups and includes; 'occlusion' must be outside"}},
        BadText{"kind",
                SKY_SCENE "background_gradient { type = $sky }",
                {"expected `sphere` or `plane`, found 'sky'"}},
        BadText{"up",
                SKY_SCENE "background_gradient { up = $(0, 0, 0) }",
                {"expected a direction other than (0, 0, 0)"}},
        BadText{"top",
                SKY_SCENE "background_gradient { bottom = 2  $top = 2 }",
                {"expected a `top` above the bottom 2, found 2"}},
        BadText{"bottom",
                SKY_SCENE "background_gradient { $bottom = 1 }",
                {"expected a `top` above the bottom 1, found 1"}}),
    [](const auto& tested) { return tested.param.name; });

TEST(GlintSky, IsReadAndWritten) {
    const Result<Scene> scene = load_text(
        "occlusion { method = fixed  samples = 12  color = (0.1, 0.2, 0.3)  reach = 5  direct = 0.5 }\n"
        "background_gradient { type = plane  up = (0, 0, 2)  bottom = -1  top = 3  bottom_color = (0.1, 0.2, "
        "0.3)  "
        "top_color = (1, 0, 0)  repeats = true }\n" SKY_SCENE,
        "a.glint");
    ASSERT_TRUE(scene);
    const Occlusion occlusion{OcclusionMethod::fixed, 12, {0.1, 0.2, 0.3}, 5, 0.5};
    const BackgroundGradient gradient{GradientKind::plane, {0, 0, 2}, -1,  3,
                                      {0.1, 0.2, 0.3},     {1, 0, 0}, true};
    EXPECT_EQ(scene->occlusion, occlusion);
    EXPECT_EQ(scene->gradient, gradient);
    EXPECT_EQ(scene->occlusion_place.line, 1u);
    EXPECT_EQ(scene->gradient_place.line, 2u);
    const std::string text = write_glint(*scene).value();
    EXPECT_NE(
        text.find(
            "occlusion { method = fixed  samples = 12  color = (0.1, 0.2, 0.3)  reach = 5  direct = 0.5 }"),
        std::string::npos)
        << text;
    const Result<Scene> again = load_text(text, "b.glint");
    ASSERT_TRUE(again) << text;
    EXPECT_EQ(again->occlusion, occlusion);
    EXPECT_EQ(again->gradient, gradient);
    EXPECT_EQ(load_text("occlusion { }" SKY_SCENE, "a.glint")->occlusion, Occlusion{});
    EXPECT_EQ(load_text("background_gradient { }" SKY_SCENE, "a.glint")->gradient, BackgroundGradient{});
    EXPECT_EQ(Occlusion{}.reach, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace glint::test
