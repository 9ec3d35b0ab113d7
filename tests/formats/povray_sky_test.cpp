// SPDX-License-Identifier: Apache-2.0
// sky_sphere of POV-Ray: a gradient of two colors is the scene's background gradient.
#include "formats/povray_text.h"

namespace glint::test {
namespace {

constexpr std::string_view k_map = "color_map { [0 rgb <1, 0, 0>] [1 color rgb <0, 0, 1>] }";

BackgroundGradient sky_of(const std::string& items) {
    const Result<Scene> result =
        read_povray("light_source { 9, 1 }\nsphere { 0, 1 }\nsky_sphere { " + items + " }");
    EXPECT_TRUE(result) << messages(result);
    EXPECT_EQ(messages(result), "") << items;
    const std::optional<BackgroundGradient> gradient = result.value_or(Scene{}).gradient;
    EXPECT_TRUE(gradient) << items;
    return gradient.value_or(BackgroundGradient{});
}

TEST(PovRaySky, AGradientOfTwoColorsRepeats) {
    const BackgroundGradient sky = sky_of("pigment { gradient y " + std::string(k_map) + " }");
    EXPECT_EQ(sky.kind, GradientKind::sphere);
    EXPECT_EQ(sky.up, (Vec3{0, 1, 0}));
    EXPECT_EQ(sky.bottom, 0);
    EXPECT_EQ(sky.top, 1);
    EXPECT_EQ(sky.bottom_color, (Color{1, 0, 0}));
    EXPECT_EQ(sky.top_color, (Color{0, 0, 1}));
    EXPECT_TRUE(sky.repeats);
}

TEST(PovRaySky, ItsTransformsMoveTheColors) {
    const BackgroundGradient whole =
        sky_of("pigment { gradient y color_map { [.25 rgb 0] [.75 rgb 1] } scale 2 translate -1 }");
    EXPECT_FALSE(whole.repeats) << "one period is the whole sphere";
    EXPECT_NEAR(whole.bottom, -.5, k_pov_near);
    EXPECT_NEAR(whole.top, .5, k_pov_near);
    const BackgroundGradient turned = sky_of("pigment { gradient y " + std::string(k_map) + " } rotate 90*z");
    expect_vec(turned.up, {-1, 0, 0});
    const BackgroundGradient steep = sky_of("pigment { gradient 2*x " + std::string(k_map) + " scale .5 }");
    EXPECT_NEAR(steep.top, .5, k_pov_near) << "the length of the vector does not count";
}

TEST(PovRaySky, OneColorAndTwoNumbersOfAnEntry) {
    EXPECT_EQ(sky_of("pigment { rgb <.1, .2, .3> }").top_color, (Color{.1, .2, .3}));
    EXPECT_EQ(sky_of("pigment { gradient z color_map { [0, 1 color rgb 0 color rgb 1] } }").top_color,
              (Color{1, 1, 1}));
}

TEST(PovRaySky, AGradientOfOtherColorsHasAMap) {
    const BackgroundGradient sky =
        sky_of("pigment { gradient y color_map { [0 rgb 0] [.5 rgb 1] [.5 rgb x] [.75 rgb y] } }");
    EXPECT_EQ(sky.color_map, (std::vector<TextureColor>{
                                 {0, {0, 0, 0}}, {.5, {1, 1, 1}}, {.5, {1, 0, 0}}, {.75, {0, 1, 0}}}));
    EXPECT_EQ(sky.bottom, 0);
    EXPECT_EQ(sky.top, 1);
    EXPECT_TRUE(sky.repeats);
    EXPECT_EQ(sky_of("pigment { gradient y color_map { [0 rgb 0] [.5 rgb 1] } }").color_map.size(), 2u);
    EXPECT_FALSE(
        sky_of("pigment { gradient y color_map { [0 rgb 0] [.2 rgb 1] [1 rgb x] } scale 2 translate -1 }")
            .repeats);
}

TEST(PovRaySky, ANameStandsForASkyOrAMap) {
    const std::string colors = "{ [0 rgb 0] [.5 rgb x] [1 rgb 1] }";
    const BackgroundGradient sky =
        sky_of("pigment { gradient y color_map " + colors + " scale 2 } rotate 90*z");
    const auto of_text = [](const std::string& text) {
        const Result<Scene> result = read_povray("light_source { 9, 1 }\nsphere { 0, 1 }\n" + text);
        EXPECT_EQ(messages(result), "") << text;
        return result.value_or(Scene{}).gradient.value_or(BackgroundGradient{});
    };
    const std::string map = "#declare M = color_map " + colors + "\n";
    EXPECT_EQ(of_text(map + "#declare S = sky_sphere { pigment { gradient y color_map { M } scale 2 } "
                            "}\nsky_sphere { S rotate 90*z }"),
              sky);
    EXPECT_EQ(of_text(map + "sky_sphere { pigment { gradient y color_map { M } scale 2 } rotate 90*z }"),
              sky);
}

TEST(PovRaySky, PlanarIsTheSameAboveAndBelow) {
    const BackgroundGradient sky =
        sky_of("pigment { planar color_map { [0 rgb 0] [.5 rgb x] [1 rgb 1] } scale .5 }");
    EXPECT_EQ(sky.bottom, -.5);
    EXPECT_EQ(sky.top, .5);
    EXPECT_FALSE(sky.repeats);
    EXPECT_EQ(sky.color_map, (std::vector<TextureColor>{{0, {0, 0, 0}},
                                                        {.25, {1, 0, 0}},
                                                        {.5, {1, 1, 1}},
                                                        {.5, {1, 1, 1}},
                                                        {.75, {1, 0, 0}},
                                                        {1, {0, 0, 0}}}));
}

TEST(PovRaySky, OtherPatternsAreNamed) {
    for (const char* const items : {
             "pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } triangle_wave }",
             "pigment { onion color_map { [0 rgb 0] [1 rgb 1] } }",
             "pigment { gradient y color_map { [0 rgb 0] [1 rgb 1] } turbulence .2 }",
             "pigment { gradient y color_map { [0 rgbt 0] [1 rgbt 1] } }",
             "pigment { bozo color_map { [0 rgb 0] [1 rgb 1] } }",
             "pigment { rgbt .5 }",
         }) {
        const Result<Scene> result =
            read_povray(std::string("light_source { 9, 1 }\nsphere { 0, 1 }\nsky_sphere { ") + items + " }");
        ASSERT_TRUE(result) << messages(result);
        EXPECT_FALSE(result->gradient) << items;
        EXPECT_NE(messages(result).find("3:1: warning: glint does not render `sky_sphere`"),
                  std::string::npos)
            << items << messages(result);
    }
}

TEST(PovRaySky, AnotherBracketThanItsOwnIsAnError) {
    const std::string wrong = messages(read_povray("sphere { 0, 1 }\nsky_sphere { haze ] }"));
    EXPECT_TRUE(wrong.starts_with("a.pov:2:19: error: expected `}`, found ']'\n")) << wrong;
}

TEST(PovRaySky, TheLastOpaquePigmentIsDrawn) {
    const auto read = [](const std::string& items) {
        return read_povray("light_source { 9, 1 }\nsphere { 0, 1 }\nsky_sphere { " + items + " }");
    };
    const std::string blue = "pigment { rgb z }",
                      clouds = "pigment { bozo color_map { [0 rgb 1] [1 rgbt 1] } }";
    const Result<Scene> hidden = read(clouds + blue);
    ASSERT_TRUE(hidden && hidden->gradient) << messages(hidden);
    EXPECT_EQ(messages(hidden), "");
    EXPECT_EQ(hidden->gradient->top_color, (Color{0, 0, 1}));
    const Result<Scene> below = read(blue + clouds);
    ASSERT_TRUE(below && below->gradient) << messages(below);
    EXPECT_EQ(below->gradient->top_color, (Color{0, 0, 1}));
    EXPECT_NE(messages(below).find("without what is over it"), std::string::npos) << messages(below);
}

double alpha_of_background(const std::string& version, const std::string& text) {
    return povray_scene("#version " + version + ";\nsphere { 0, 1 }\n" + text).conventions.background_alpha;
}

// Measured by tests/peers/alpha.py.
TEST(PovRaySky, AnOpaqueBackgroundIsPartOfPicturesWithAlphaFromVersion37On) {
    EXPECT_EQ(alpha_of_background("3.6", "background { rgb 1 }"), 0);
    EXPECT_EQ(alpha_of_background("3.7", "background { rgb 1 }"), 1);
    EXPECT_EQ(alpha_of_background("3.7", "background { rgbt <1, 1, 1, .25> }"), .75);
    EXPECT_EQ(alpha_of_background("3.7", "background { rgbt 1 }"), 0);
    EXPECT_EQ(alpha_of_background("3.7", ""), 0);
    EXPECT_EQ(alpha_of_background("3.7", "sky_sphere { pigment { rgb 1 } }"), 1);
    EXPECT_EQ(alpha_of_background("3.6", "sky_sphere { pigment { rgb 1 } }"), 0);
}

TEST(PovRaySky, ATransparentBackgroundInMirrorsIsNamed) {
    const auto said = [](const std::string& finish, const std::string& color) {
        return messages(
            read_povray("#version 3.7;\nlight_source { 9, 1 }\nsphere { 0, 1 pigment { rgb 1 } finish { " +
                        finish + " } }\nbackground { " + color + " }"));
    };
    EXPECT_NE(
        said("reflection .5", "rgbt <1, 1, 1, .5>").find("4:1: warning: glint does not render `transmit`"),
        std::string::npos)
        << said("reflection .5", "rgbt <1, 1, 1, .5>");
    EXPECT_EQ(said("ambient 0", "rgbt <1, 1, 1, .5>"), "");
    EXPECT_EQ(said("reflection .5", "rgbt <0, 0, 0, 1>"), "") << "black without transmit, too";
    EXPECT_EQ(said("reflection .5", "rgb 1"), "");
}

}  // namespace
}  // namespace glint::test
