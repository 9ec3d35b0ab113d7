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

TEST(PovrayPatterns, WithoutAMapHaveTheirOwnColors) {
    const std::vector<TextureColor> grays{{0, {0, 0, 0}}, {1, {1, 1, 1}}};
    for (const char* gray : {"onion", "gradient x", "leopard", "planar", "spiral1 3"})
        EXPECT_EQ(pattern_texture(gray).color_map, grays) << gray;
    const std::vector<TextureColor> wood = pattern_texture("wood triangle_wave").color_map;
    ASSERT_EQ(wood.size(), 2u);
    EXPECT_NEAR(wood[0].at, 0.6, 1e-6);
    EXPECT_NEAR(wood[0].color.r, 0.666, 1e-6);
    EXPECT_NEAR(wood[1].color.g, 0.1333, 1e-6);
    EXPECT_EQ(pattern_texture("marble").color_map.back().color, (Color{0, 0, 0}));
    EXPECT_EQ(pattern_texture("radial").color_map.size(), 4u);
    const Result<Scene> bozo = read_pattern_ball("bozo");
    ASSERT_TRUE(bozo);
    EXPECT_EQ(bozo->textures.at(0).color_map.back().color, (Color{1, 0, 0}));
    EXPECT_NE(messages(bozo).find("glint has its own, with another grain"), std::string::npos);
}

// POV-Ray keeps the colors of the pattern before, also those of #default.
TEST(PovrayPatterns, WithoutAMapHaveTheOneBeforeThem) {
    const auto read = [](const std::string& before, const std::string& pigment) {
        return read_povray(before + "\nsphere { 0, 1 pigment { " + pigment + " } }");
    };
    const std::string two = "pigment { onion color_map { [0 rgb x] [1 rgb y] } }";
    const std::vector<TextureColor> colors{{0, {1, 0, 0}}, {1, {0, 1, 0}}};
    for (const auto& [before, pigment] :
         {std::pair("#declare P = " + two, "P wood"), std::pair("#default { " + two + " }", "marble")}) {
        const Result<Scene> scene = read(before, pigment);
        ASSERT_TRUE(scene);
        EXPECT_EQ(scene->textures.at(0).color_map, colors) << pigment;
        EXPECT_EQ(messages(scene), "");
    }
    for (const char* before : {"checker rgb x rgb y", "crackle color_map { [0 rgb x] [1 rgb y] }"}) {
        EXPECT_NE(messages(read("#declare P = pigment { " + std::string(before) + " }", "P wood"))
                      .find("does not render `wood` (a pattern)"),
                  std::string::npos)
            << before;
    }
    EXPECT_EQ(messages(read("#declare P = pigment { rgb x }", "P wood")), "");
}

// The pigment that has a pattern is a layer below the pattern of the others.
TEST(PovrayPatterns, OneOfTheirPigmentsMayHaveAPattern) {
    const std::string rings = "onion color_map { [0 rgb x] [1 rgb y] } scale 2";
    const auto layers_of = [](const std::string& pigment) {
        const Result<Scene> scene = read_pattern_ball(pigment);
        EXPECT_TRUE(scene) << messages(scene);
        EXPECT_EQ(messages(scene), "") << pigment;
        return scene.value_or(Scene{}).textures;
    };
    std::vector<Texture> t =
        layers_of("checker pigment { " + rings + " } pigment { rgb z } translate <3, 0, 0>");
    ASSERT_EQ(t.size(), 2u);
    EXPECT_EQ(t[0].mapping, TextureMapping::onion);
    EXPECT_EQ(transform_point(t[0].world_from_texture, {1, 1, 1}), (Vec3{5, 2, 2}));
    EXPECT_EQ(t[1].over, 0u);
    EXPECT_EQ(t[1].color_map[0].alpha, 0);
    EXPECT_EQ(t[1].color_map[1], (TextureColor{0.5, {0, 0, 1}}));
    const std::string map = "[0 rgb z] [0.5 " + rings + "] [0.75 rgb 1]";
    t = layers_of("gradient x pigment_map { " + map + " }");
    ASSERT_EQ(t.size(), 2u);
    EXPECT_EQ(t[1].color_map,
              (std::vector<TextureColor>{
                  {0, {0, 0, 1}}, {0.5, {0, 0, 1}, 0}, {0.5, {1, 1, 1}, 0}, {0.75, {1, 1, 1}}}));
    for (const std::string& entries : {map + " [1 wood]", "[0 rgbt 1] [1 " + rings + "]",
                                       std::string("[0 rgb 1] [1 onion color_map { [0 rgbt 1] }]"),
                                       std::string("[0 rgb 1] [1 crackle]")}) {
        EXPECT_NE(messages(read_pattern_ball("gradient x pigment_map { " + entries + " }"))
                      .find("does not render `gradient` (a pattern)"),
                  std::string::npos)
            << entries;
    }
    EXPECT_NE(messages(read_pattern_ball("gradient x turbulence 1 pigment_map { " + map + " }")), "");
    const Result<Scene> named = read_povray("#declare P = pigment { gradient x pigment_map { " + map +
                                            " } }\nsphere { 0, 1 pigment { P wood } }");
    EXPECT_NE(messages(named).find("does not render `wood`"), std::string::npos) << messages(named);
}

TEST(PovrayPatterns, CheckersHaveTwoColors) {
    const std::vector<TextureColor> usual{{0, {0, 0, 1}}, {0.5, {0, 1, 0}}};
    EXPECT_EQ(pattern_texture("checker").color_map, usual);
    const std::vector<TextureColor> two{{0, {1, 0, 0}}, {0.5, {0.5, 0.5, 0.5}}};
    EXPECT_EQ(pattern_texture("checker rgb x rgb 0.5").color_map, two);
    EXPECT_EQ(pattern_texture("checker color rgb x, color rgb 0.5 scale 2").color_map, two);
    EXPECT_EQ(pattern_texture("checker rgb x").color_map[1], usual[1]);
    EXPECT_EQ(pattern_texture("checker").filter, TextureFilter::nearest);
    // Those that are missing after a pigment are the default one, not the pattern's own.
    EXPECT_EQ(pattern_texture("checker pigment { rgb x }").color_map[1].color, (Color{0, 0, 0}));
    EXPECT_EQ(pattern_texture("brick pigment { rgb x }").color_map[1].color, (Color{0, 0, 0}));
    EXPECT_EQ(pattern_texture("hexagon pigment { rgb x } pigment { rgb y }").color_map[2].color,
              (Color{0, 0, 0}));
}

TEST(PovrayPatterns, BricksAndHexagonsHaveSizesAndColors) {
    const Texture bricks = pattern_texture("brick rgb x rgb y brick_size <2, 4, 5> mortar 0.5 translate z");
    EXPECT_EQ(bricks.color_map, (std::vector<TextureColor>{{0, {1, 0, 0}}, {0.5, {0, 1, 0}}}));
    EXPECT_EQ(bricks.mortar, (Vec3{0.25, 0.125, 0.1}));
    EXPECT_EQ(transform_point(bricks.world_from_texture, {1, 1, 1}), (Vec3{2, 4, 6}));
    const Texture hexagons = pattern_texture("hexagon rgb x, rgb 0.5, rgb z");
    EXPECT_EQ(hexagons.mapping, TextureMapping::hexagons);
    EXPECT_EQ(hexagons.color_map,
              (std::vector<TextureColor>{{0, {1, 0, 0}}, {0.25, {0.5, 0.5, 0.5}}, {0.5, {0, 0, 1}}}));
}

TEST(PovrayPatterns, SpiralsHaveArms) {
    const auto map = [](std::string_view arms, std::string_view after = {}) {
        const Texture t = pattern_texture("spiral1 " + mapped(arms, after));
        EXPECT_EQ(t.mapping, TextureMapping::spiral);
        return std::tuple(t.uv_map.m[0][0], t.uv_map.m[0][1], t.uv_map.m[0][2], t.wrap_u);
    };
    EXPECT_EQ(map("3"), std::tuple(2, 6, 3, TextureWrap::mirror));
    EXPECT_EQ(map("-2.9", "ramp_wave"), std::tuple(1, -2, -1, TextureWrap::repeat)) << "whole arms";
    EXPECT_EQ(map("1", "ramp_wave frequency 4 phase 0.5"), std::tuple(4, 4, 2.5, TextureWrap::repeat));
}

TEST(PovrayPatterns, MandelbrotsSetIsClamped) {
    const Texture t =
        pattern_texture("mandel 20.5 color_map { [0 rgb x] [0.5 rgb y] [0.7 rgb y] [1 rgb z] }");
    EXPECT_EQ(t.mapping, TextureMapping::mandelbrot);
    EXPECT_EQ(t.iterations, 20);
    EXPECT_EQ(t.wrap_u, TextureWrap::clamp);
    const std::vector<TextureColor>& colors = t.color_map;
    EXPECT_EQ(colors[0].at, 0);
    EXPECT_GT(colors[1].at, 0.5) << "0.5 has the color before";
    EXPECT_LT(colors[2].at, 0.7) << "a float, so 0.7 is behind it";
    EXPECT_EQ(colors[3].at, 1);
    EXPECT_EQ(pattern_texture("mandel 5 " + mapped("triangle_wave")).uv_map.m[0][0], 2);
}

TEST(PovrayPatterns, MapsAreUsedFrom0To1) {
    const auto map_of = [](const std::string& entries) {
        return pattern_texture("onion color_map { " + entries + " }").color_map;
    };
    const std::vector<TextureColor> cut{{0, {0.5, 0.5, 0.5}}, {0.5, {1, 1, 1}}, {1, {0.5, 0.5, 0.5}}};
    EXPECT_EQ(map_of("[-0.5 rgb 0] [0.5 rgb 1] [1.5 rgb 0]"), cut);
    EXPECT_EQ(map_of("[-2 rgb 1] [-0.5 rgb 0] [0.5 rgb 1] [1.5 rgb 0] [2 rgb 1]"), cut);
    EXPECT_EQ(map_of("[-1 rgb 0] [3 rgb 1]"),
              (std::vector<TextureColor>{{0, {0.25, 0.25, 0.25}}, {1, {0.5, 0.5, 0.5}}}));
    EXPECT_EQ(map_of("[1.5 rgb x] [2 rgb y]"), (std::vector<TextureColor>{{1, {1, 0, 0}}}));
    EXPECT_EQ(map_of("[-2 rgb x] [-1 rgb y]"), (std::vector<TextureColor>{{0, {0, 1, 0}}}));
    EXPECT_EQ(map_of("[0 rgb x] [1 rgb y] [1.5 rgb 0]"),
              (std::vector<TextureColor>{{0, {1, 0, 0}}, {1, {0, 1, 0}}}));
}

// The warnings of a ball with this texture; the colors of its only pattern.
std::string texture_messages(const std::string& texture, std::vector<TextureColor>& colors,
                             Material& material) {
    const Result<Scene> result =
        read_povray("light_source { <0, 0, -9>, rgb 1 }\nsphere { 0, 1 texture { " + texture + " } }");
    EXPECT_TRUE(result) << messages(result);
    const Scene scene = result.value_or(Scene{});
    EXPECT_EQ(scene.textures.size(), 1u) << texture;
    if (!scene.textures.empty()) colors = scene.textures[0].color_map;
    if (!scene.materials.empty()) material = scene.materials[0];
    return messages(result);
}

TEST(PovrayPatterns, TexturesThatDifferInColorAreOfColors) {
    const std::string finish = "finish { ambient 0.5 diffuse 0.25 }", a = "pigment { rgb x } " + finish,
                      b = "pigment { rgb z } " + finish;
    const std::vector<TextureColor> two{{0, {1, 0, 0}}, {0.5, {0, 0, 1}}};
    std::vector<TextureColor> colors;
    Material material;
    EXPECT_EQ(
        texture_messages("checker texture { " + a + " } texture { " + b + " } scale 2", colors, material),
        "");
    EXPECT_EQ(colors, two);
    EXPECT_EQ(material.ambient, (Color{0.5, 0.5, 0.5}));
    EXPECT_EQ(material.diffuse, (Color{0.25, 0.25, 0.25}));
    EXPECT_EQ(texture_messages("onion texture_map { [0 " + a + "] [0.5, " + b + "] }", colors, material), "");
    EXPECT_EQ(colors, two);
    const std::string several =
        texture_messages("checker texture { " + a + " } texture { pigment { rgb z } }", colors, material);
    EXPECT_NE(several.find("several finishes"), std::string::npos) << several;
    EXPECT_EQ(colors, two);
    EXPECT_EQ(material.ambient, (Color{0.5, 0.5, 0.5}));
    const std::string bumpy = texture_messages(
        "checker texture { " + a + " } texture { " + b + " normal { bumps } }", colors, material);
    EXPECT_NE(bumpy.find("`normal`"), std::string::npos) << bumpy;
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
         {mapped("crackle"), mapped("onion", "warp { turbulence 0.3 }"), mapped("onion", "frequency 1.5"),
          mapped("spherical", "frequency 2"), mapped("gradient x", "sine_wave"),
          std::string("onion color_map { [0.5 rgb 1] [0.2 rgb 0] }"), std::string("brick brick_size 0"),
          mapped("mandel 0"), mapped("mandel 2e6"), mapped("mandel 9 exponent 3"),
          mapped("mandel 9", "phase 0.5"), mapped("spiral1 2", "frequency 1.5"), mapped("spiral2 2"),
          std::string("tiles"), std::string("checker pigment { onion } pigment { wood }"),
          std::string("onion pigment_map { [0 wood] [1 checker] }")}) {
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

// Of the same kind as POV-Ray's, whose tables are not used.
TEST(PovrayPatterns, NoiseIsGlintsOwnWhichIsSaidOnce) {
    const Result<Scene> result =
        read_povray("light_source { 9, 1 }\nsphere { 0, 1 pigment { " + mapped("bozo") +
                    " } }\nsphere { 3, 1 pigment { " +
                    mapped("wood", "turbulence <0.1, 0.2, 0.3> octaves 3 omega 0.4 lambda 2.5") + " } }\n");
    const std::string said = messages(result);
    const std::size_t first = said.find("glint has its own, with another grain");
    ASSERT_NE(first, std::string::npos) << said;
    EXPECT_EQ(said.find("its own", first + 50), std::string::npos) << said;
    ASSERT_EQ(result->textures.size(), 2u);
    EXPECT_EQ(result->textures[0].mapping, TextureMapping::noise);
    EXPECT_EQ(result->textures[0].turbulence, Vec3{});
    const Texture& wood = result->textures[1];
    EXPECT_EQ(wood.mapping, TextureMapping::rings);
    EXPECT_EQ(wood.turbulence, (Vec3{0.1, 0.3, 0.2})) << "along the mapping's axes";
    EXPECT_EQ(std::tuple(wood.octaves, wood.gain, wood.lacunarity), std::tuple(3, 0.4, 2.5));
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

TEST(PovrayPatterns, AMapWithoutItsBracketIsAnError) {
    for (const char* const map : {"color_map { rgb 1][1 rgb 0] }", "pigment_map { rgb 1][1 rgb 0] }"}) {
        const Result<Scene> result = read_pattern_ball("onion " + std::string(map));
        EXPECT_FALSE(result) << map;
        EXPECT_NE(messages(result).find("expected `}`"), std::string::npos) << messages(result);
    }
}

}  // namespace
}  // namespace glint::test
