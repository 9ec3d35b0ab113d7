// SPDX-License-Identifier: Apache-2.0
// Layered textures of POV-Ray, and `over` of .glint. The stage `peers` compares their pictures with
// POV-Ray's.
#include "formats/povray_text.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

constexpr std::string_view k_rings = "texture { pigment { onion color_map { [0 rgb x] [1 rgb y] } } }";
constexpr std::string_view k_lines = "texture { pigment { gradient x color_map { [0 rgb z] [1 rgbt 1] } } }";

Result<Scene> read_layers(const std::string& textures) {
    return read_povray("light_source { <0, 0, -9>, rgb 1 }\nsphere { 0, 1 " + textures + " }");
}
std::string both() { return std::string(k_rings) + std::string(k_lines); }

TEST(PovrayLayers, AreTexturesOverOthers) {
    const Result<Scene> scene = read_layers(both());
    ASSERT_TRUE(scene) << messages(scene);
    EXPECT_EQ(messages(scene), "");
    ASSERT_EQ(scene->textures.size(), 2u);
    EXPECT_EQ(scene->textures[0].mapping, TextureMapping::onion);
    EXPECT_EQ(scene->textures[0].over, k_none);
    EXPECT_EQ(scene->textures[1].over, 0u);
    EXPECT_EQ(scene->materials[scene->shapes[0].material].texture, 1u);
}

TEST(PovrayLayers, OfOneColorAreOneColor) {
    const Result<Scene> scene = read_layers(
        "texture { pigment { rgb <0.8, 0.4, 0.2> } } texture { pigment { rgbf <0.2, 0.6, 0.8, 0.5> } }");
    ASSERT_TRUE(scene) << messages(scene);
    EXPECT_EQ(messages(scene), "");
    EXPECT_TRUE(scene->textures.empty());
    const Color color = scene->materials[scene->shapes[0].material].color;
    EXPECT_NEAR(color.r, 0.5 * 0.2 + 0.5 * 0.2 * 0.8, 1e-12);
    EXPECT_NEAR(color.g, 0.5 * 0.6 + 0.5 * 0.6 * 0.4, 1e-12);
}

TEST(PovrayLayers, OpaqueOnesHideThoseBelow) {
    const Result<Scene> scene = read_layers(both() + "texture { pigment { rgb 0.5 } }");
    ASSERT_TRUE(scene) << messages(scene);
    EXPECT_EQ(messages(scene), "");
    EXPECT_TRUE(scene->textures.empty());
}

TEST(PovrayLayers, WithSeveralFinishesHaveShares) {
    const Result<Scene> scene = read_layers(
        "texture { pigment { rgb x } finish { ambient 0.4 diffuse 0.3 } } texture { pigment { "
        "rgbt <0, 1, 0, 0.5> } finish { ambient 0.1 diffuse 0.6 phong 0.2 } }");
    ASSERT_TRUE(scene) << messages(scene);
    EXPECT_EQ(messages(scene), "");
    const Material& material = scene->materials[scene->shapes[0].material];
    EXPECT_EQ(material.ambient, (Color{0.4, 0.4, 0.4}));
    EXPECT_EQ(material.diffuse, (Color{0.6, 0.6, 0.6}));
    const Texture &top = scene->textures[material.texture], &lower = scene->textures[top.over];
    EXPECT_EQ(top.ambient, 0.25);
    EXPECT_EQ(top.diffuse, 1);
    EXPECT_EQ(lower.ambient, 1);
    EXPECT_EQ(lower.diffuse, 0.5);
}

TEST(PovrayLayers, WithSeveralHighlightsAreWarnedOf) {
    for (const std::string_view finish :
         {"phong 0.5", "reflection 0.2", "ambient <0.3, 0.1, 0>", "emission 0.3", "brilliance 2"}) {
        const std::string lower = "texture { pigment { rgb x } finish { " + std::string(finish) + " } }";
        EXPECT_NE(messages(read_layers(lower + std::string(k_lines))).find("layered textures"),
                  std::string::npos)
            << finish;
    }
    const std::string shiny =
        "texture { pigment { rgbt <1, 0, 0, 0.5> } finish { phong 0.5 reflection 0.2 } }";
    EXPECT_EQ(messages(read_layers(std::string(k_rings) + shiny)), "");
}

std::string average(const std::string& parts) {
    return "pigment { average pigment_map { " + parts + " } scale 2 }";
}

TEST(PovrayLayers, AveragesAreLayers) {
    const Result<Scene> scene =
        read_layers(average("[1 onion color_map { [0 rgb x] [1 rgb y] }] [2 checker rgb x rgb z] [1 rgb 3]"));
    ASSERT_TRUE(scene) << messages(scene);
    EXPECT_EQ(messages(scene), "");
    ASSERT_EQ(scene->textures.size(), 3u);
    EXPECT_EQ(scene->textures[1].over, 0u);
    EXPECT_EQ(scene->textures[2].over, 1u);
    EXPECT_EQ(scene->textures[0].color_map[0].alpha, 1);
    EXPECT_EQ(scene->textures[1].color_map[1].alpha, 2.0 / 3);
    EXPECT_EQ(scene->textures[2].color_map[0].alpha, 1.0 / 4);
    EXPECT_EQ(scene->textures[1].world_from_texture.m[0][0], 2);
}

TEST(PovrayLayers, AveragesOfColorsAreOneColor) {
    const Result<Scene> scene = read_layers(average("[1 rgb x] [3 rgb y] [0 rgb z]"));
    ASSERT_TRUE(scene) << messages(scene);
    EXPECT_EQ(messages(scene), "");
    EXPECT_TRUE(scene->textures.empty());
    EXPECT_EQ(scene->materials[scene->shapes[0].material].color, (Color{0.25, 0.75, 0}));
}

TEST(PovrayLayers, OtherAveragesAreWarnedOf) {
    for (const std::string parts :
         {"[1 rgbt <1, 0, 0, 0.5>] [1 rgb y]", "[-1 rgb x] [1 rgb y]", "[0 rgb x]", "M", "",
          "[1 crackle] [1 rgb x]", "[function { x } color_map { [0 rgb x] }]",
          "[1 gradient x color_map { [0 rgb x] [1 rgbt 1] }] [1 rgb x]"}) {
        const Result<Scene> scene = read_layers(average(parts));
        ASSERT_TRUE(scene) << messages(scene);
        EXPECT_NE(messages(scene).find("average"), std::string::npos) << parts;
    }
}

TEST(PovrayLayers, ManyAveragesHaveAtMostSixteenLayers) {
    std::string parts;
    for (int i = 0; i < 12; ++i) parts += "[1 onion color_map { [0 rgb x] [1 rgb y] }]";
    const Result<Scene> scene = read_layers("texture { " + average(parts) +
                                            " } texture { pigment { gradient x "
                                            "color_map { [0 rgb z] [1 rgbt 1] } } }" +
                                            std::string(k_lines));
    ASSERT_TRUE(scene) << messages(scene);
    for (int i = 0; i < 2; ++i) parts += parts;
    const Result<Scene> many = read_layers(average(parts));
    ASSERT_TRUE(many) << messages(many);
    EXPECT_NE(messages(many).find("layered textures"), std::string::npos);
}

TEST(PovrayLayers, BeyondSixteenAreLeftOut) {
    std::string many;
    for (int i = 0; i < 40; ++i) many += k_lines;
    const Result<Scene> scene = read_layers(many);
    ASSERT_TRUE(scene) << messages(scene);
    EXPECT_NE(messages(scene).find("more of them than 16"), std::string::npos) << messages(scene);
}

TEST(PovrayLayers, NamedPatternsCanBeChanged) {
    const Result<Scene> scene = read_layers(
        "pigment { wood scale 2 }}\n#declare P = pigment { wood scale 2 }\n"
        "sphere { 0, 1 pigment { P color_map { [0 rgb x] [1 rgb y] } phase 0.25 }");
    ASSERT_TRUE(scene) << messages(scene);
    ASSERT_EQ(scene->textures.size(), 2u);
    const Texture& t = scene->textures[1];
    EXPECT_EQ(t.mapping, TextureMapping::rings);
    EXPECT_EQ(t.color_map, (std::vector<TextureColor>{{0, {1, 0, 0}}, {1, {0, 1, 0}}}));
    EXPECT_EQ(t.world_from_texture.m[0][0], 2);
    EXPECT_EQ(t.uv_map.m[0][2], 0.5);  // of a triangle wave
}

TEST(PovrayLayers, WhatPovRayKeepsOfANamedPattern) {
    const auto said = [](std::string_view items) {
        return messages(
            read_layers("pigment { rgb 1 } }\n#declare Q = pigment { gradient x color_map { [0 rgb x] [1 rgb "
                        "z] } " +
                        std::string(items) +
                        " }\nsphere { 0, 1 pigment { Q gradient y color_map { [0 rgb y] [1 rgb 1] } }"));
    };
    EXPECT_EQ(said(""), "");
    for (const char* items : {"scale 0.37", "frequency 2", "triangle_wave"})
        EXPECT_NE(said(items).find("`gradient` (in place of another pattern"), std::string::npos)
            << said(items);
}

TEST(PovrayLayers, AFilterBelowIsWarnedOf) {
    const std::string text = messages(read_layers(
        "texture { pigment { rgbf <1, 0.5, 0.2, 0.9> } } texture { pigment { rgbt <0, 1, 0, 0.5> } }"));
    EXPECT_NE(text.find("`filter`"), std::string::npos) << text;
}

Result<Scene> read_over(const std::string& of_a, const std::string& of_b) {
    const std::string map = " mapping = planar color_map = ((0, (1, 0, 0), 0.5)) ";
    return load_text("camera { position = (0, 2, 8)  look_at = (0, 1, 0)  fov_x = 50 }\ntexture a {" + map +
                         of_a + "}\ntexture b {" + map + of_b +
                         "}\nsphere { center = (0, 0, 0)  radius = 1  texture = a }\n",
                     "a.glint");
}

// Each layer has its own part of the ambient and diffuse light.
TEST(Layers, MayReflectLightDifferently) {
    const auto drawn = [](const std::string& of_a, const std::string& of_b, const std::string& light) {
        const std::string map = "mapping = planar  color_map = ((0, (0.6, 0.8, 0.4), ";
        const Result<Scene> scene = load_text(
            "camera { position = (0, 2, 8)  look_at = (0, 1, 0)  fov_x = 20 }\n"
            "render { size = 8 x 6 }\n" +
                light + "texture a { " + map + "0.5))  over = b  " + of_a + " }\ntexture b { " + map +
                "1))  " + of_b +
                " }\nsphere { center = (0, 1, 0)  radius = 3  texture = a  color = (1, 1, 1)  "
                "ambient = 0.4  diffuse = 0.6 }\n",
            "a.glint");
        EXPECT_TRUE(scene) << messages(scene);
        return scene ? render_scene(*scene).rgb : std::vector<float>{};
    };
    const std::string lights[] = {"light { type = ambient }\n",
                                  "light { type = point  position = (1, 3, 9) }\n"};
    const std::string shares[] = {"ambient = ", "diffuse = "};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string &light = lights[i], own = shares[i], other = shares[1 - i];
        const std::vector<float> whole = drawn("", "", light);
        EXPECT_EQ(drawn(other + "0.5", other + "0", light), whole);
        const std::vector<float> front = drawn("", own + "0", light),
                                 half = drawn(own + "0.5", own + "0", light);
        for (std::size_t k = 0; k < whole.size(); ++k) {
            EXPECT_NEAR(front[k], whole[k] / 2, 1e-6);
            EXPECT_NEAR(half[k], whole[k] / 4, 1e-6);
        }
    }
}

TEST(Layers, HaveNoCirclesAndNoMasks) {
    const Result<Scene> good = read_over("over = b", "");
    ASSERT_TRUE(good) << messages(good);
    EXPECT_EQ(good->textures[good->materials[0].texture].over, 1u);
    EXPECT_NE(messages(read_over("over = b", "over = a")).find("over: the texture is over itself"),
              std::string::npos);
    EXPECT_NE(messages(read_over("over = b alpha = mask", "")).find("other than mask"), std::string::npos);
    EXPECT_NE(messages(read_over("over = c", "")).find("no texture is called"), std::string::npos);
}

}  // namespace
}  // namespace glint::test
