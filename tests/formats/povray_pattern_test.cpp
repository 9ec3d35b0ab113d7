// SPDX-License-Identifier: Apache-2.0
// Patterns of colors. The stage `peers` compares their pictures with POV-Ray's.
#include "formats/povray_text.h"
#include "math/transform.h"

namespace glint::test {
namespace {

constexpr std::string_view k_pattern_map = "color_map { [0 rgb <1, 0, 0>] [0.6 rgbt <0, 0, 1, 0.25>] }";

Result<Scene> read_pattern_ball(const std::string& pigment) {
    return read_povray("light_source { <0, 0, -9>, rgb 1 }\nsphere { 0, 1 pigment { " + pigment + " } }");
}
std::string mapped(std::string_view pattern, std::string_view after = {}) {
    return std::string(pattern) + " " + std::string(k_pattern_map) + " " + std::string(after);
}

// The only texture, read without a warning.
Texture pattern_texture(const std::string& pigment) {
    const Result<Scene> result = read_pattern_ball(pigment);
    EXPECT_TRUE(result) << messages(result);
    EXPECT_EQ(messages(result), "") << pigment;
    const Scene scene = result.value_or(Scene{});
    EXPECT_EQ(scene.textures.size(), 1u) << pigment;
    return scene.textures.empty() ? Texture{} : scene.textures[0];
}

TEST(PovrayPatterns, HaveTheColorsOfTheirMap) {
    const Texture t = pattern_texture(mapped("onion"));
    EXPECT_EQ(t.color_map, (std::vector<TextureColor>{{0, {1, 0, 0}}, {0.6, {0, 0, 1}, 0.75}}));
    EXPECT_EQ(t.mapping, TextureMapping::onion);
    EXPECT_EQ(t.wrap_u, TextureWrap::repeat);
    EXPECT_EQ(t.filter, TextureFilter::bilinear);
}

TEST(PovrayPatterns, CheckersHaveTwoColors) {
    const std::vector<TextureColor> usual{{0, {0, 0, 1}}, {0.5, {0, 1, 0}}};
    EXPECT_EQ(pattern_texture("checker").color_map, usual);
    const std::vector<TextureColor> two{{0, {1, 0, 0}}, {0.5, {0.5, 0.5, 0.5}}};
    EXPECT_EQ(pattern_texture("checker rgb x rgb 0.5").color_map, two);
    EXPECT_EQ(pattern_texture("checker color rgb x, color rgb 0.5 scale 2").color_map, two);
    EXPECT_EQ(pattern_texture("checker rgb x").color_map[1], usual[1]);
    EXPECT_EQ(pattern_texture("checker").filter, TextureFilter::nearest);
}

TEST(PovrayPatterns, FrequencyPhaseAndWaveChangeU) {
    const auto change = [](const std::string& pigment) {
        const Texture t = pattern_texture(pigment);
        return std::tuple(t.uv_map.m[0][0], t.uv_map.m[0][2], t.wrap_u);
    };
    EXPECT_EQ(change(mapped("gradient x", "frequency 3 phase 0.5")), std::tuple(3, 0.5, TextureWrap::repeat));
    EXPECT_EQ(change(mapped("gradient x", "triangle_wave phase 0.25")),
              std::tuple(2, 0.5, TextureWrap::mirror));
    EXPECT_EQ(change(mapped("wood")), std::tuple(2, 0, TextureWrap::mirror));
    EXPECT_EQ(change(mapped("marble", "ramp_wave")), std::tuple(1, 0, TextureWrap::repeat));
    EXPECT_EQ(change(mapped("radial", "frequency 2")), std::tuple(2, 0.5, TextureWrap::repeat));
    EXPECT_EQ(change(mapped("spherical")), std::tuple(-1, 1, TextureWrap::clamp));
}

TEST(PovrayPatterns, ATransformMovesThem) {
    const Texture t = pattern_texture(mapped("onion", "scale 2 translate <1, 2, 3>"));
    EXPECT_EQ(transform_point(t.world_from_texture, {1, 0, 0}), (Vec3{3, 2, 3}));
    const Affine map = pattern_texture(mapped("gradient 5*y")).world_from_texture;
    EXPECT_EQ(transform_vector(map, {1, 0, 0}), (Vec3{0, 1, 0}));
}

TEST(PovrayPatterns, WhatIsNotDrawnIsSaid) {
    for (const std::string& pigment :
         {mapped("bozo"), mapped("onion", "turbulence 0.3"), mapped("onion", "frequency 1.5"),
          mapped("spherical", "frequency 2"), mapped("gradient x", "sine_wave"), std::string("onion"),
          std::string("onion color_map { [0.5 rgb 1] [0.2 rgb 0] }"),
          std::string("onion color_map { [0 rgb 1] [1.5 rgb 0] }"),
          std::string("hexagon rgb x rgb y rgb z")}) {
        const Result<Scene> result = read_pattern_ball(pigment);
        EXPECT_TRUE(result);
        EXPECT_NE(messages(result).find("a pattern"), std::string::npos) << pigment << "\n"
                                                                         << messages(result);
        EXPECT_TRUE(result.value_or(Scene{}).textures.empty()) << pigment;
    }
    const Result<Scene> filtered = read_pattern_ball("onion color_map { [0 rgb 1] [1 rgbf 0.5] }");
    EXPECT_NE(messages(filtered).find("it is drawn as transmit"), std::string::npos) << messages(filtered);
    EXPECT_EQ(filtered.value_or(Scene{}).textures.size(), 1u);
    EXPECT_NE(messages(read_pattern_ball("checker rgb 1 rgbf 0.5")).find("it is drawn as transmit"),
              std::string::npos);
}

TEST(PovrayPatterns, ANewPatternReplacesThatOfANamedPigment) {
    const std::string map = " color_map { [0 rgb x] [1 rgb z] } ";
    const std::string sky = "light_source { 9, 1 }\n#declare P = pigment { gradient y" + map +
                            "}\nsphere { 0, 1 }\nsky_sphere { pigment { P ";
    EXPECT_TRUE(read_povray(sky + "} }").value_or(Scene{}).gradient);
    for (const std::string pattern : {"bozo", "onion"}) {
        const Result<Scene> other = read_povray(sky + pattern + map + "} }");
        EXPECT_FALSE(other.value_or(Scene{}).gradient) << pattern;
        EXPECT_NE(messages(other).find("sky_sphere"), std::string::npos) << messages(other);
    }
}

}  // namespace
}  // namespace glint::test
