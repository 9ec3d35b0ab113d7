// SPDX-License-Identifier: Apache-2.0
// Tachyon's patterns of colors, as its pictures show them (measured). The stage `peers` compares whole
// pictures.
#include <gtest/gtest.h>

#include <algorithm>

#include "formats/load_text.h"
#include "glint/glint.h"

namespace glint::test {
namespace {

std::string body(int function, const std::string& before = {}, const std::string& rest = "Center 0 0 0") {
    return "Texture Ambient 1 Diffuse 0 Specular 0 Opacity 1 " + before + " Color 0.8 0.4 0.2 TexFunc " +
           std::to_string(function) + " " + rest + " Rotate 10 20 30 Scale 2 0 5\n";
}

Result<Scene> read(const std::string& objects, const std::string& mode = {}) {
    return load_text("Begin_Scene\nResolution 64 64\n" + mode +
                         " Camera Projection Orthographic Zoom 0.05 Aspectratio 1 Antialiasing 0 Raydepth 2 "
                         "Center 0 0 -90 Viewdir 0 0 1 Updir 0 1 0 End_Camera\n" +
                         objects + "End_Scene\n",
                     "a.dat");
}

// Least, average and greatest value of each channel, of 255.
struct Channel {
    double least = 255, average = 0, most = 0;
};
std::array<Channel, 3> channels_of(const std::string& objects) {
    const Result<Scene> scene = read(objects);
    EXPECT_TRUE(scene) << scene.message;
    if (!scene) return {};
    const Result<World> world = prepare(*scene);
    const Result<Rendering> result = render(*world);
    std::array<Channel, 3> channels;
    const auto& rgb = result->image.rgb;
    for (std::size_t i = 0; i < rgb.size(); ++i) {
        const double value = 255.0 * rgb[i];
        Channel& c = channels[i % 3];
        c.least = std::min(c.least, value);
        c.most = std::max(c.most, value);
        c.average += 3 * value / static_cast<double>(rgb.size());
    }
    return channels;
}
std::string wall(int function) { return "Plane Center 0 0 0.05 Normal 0 0 -1 " + body(function); }

std::string messages_of(const Result<Scene>& scene) {
    std::string text;
    for (const Diagnostic& d : scene.diagnostics)
        text += to_string(d).substr(0, to_string(d).find('\n')) + "\n";
    return text;
}

TEST(TachyonTextures, CheckerHasItsOwnColorsAndNoWarning) {
    const Result<Scene> scene = read("Sphere Center 0 0 0 Rad 1 " + body(1, "", "Center 3 4 5"));
    ASSERT_TRUE(scene) << scene.message;
    EXPECT_EQ(messages_of(scene), "");
    ASSERT_EQ(scene->textures.size(), 1u);
    const Texture& t = scene->textures[0];
    EXPECT_EQ(t.mapping, TextureMapping::checker);
    EXPECT_EQ(t.color_map, (std::vector<TextureColor>{{0, {0, 0.2, 1}}, {0.5, {1, 0.2, 0}}}));
    EXPECT_EQ(t.mix, TextureMix::multiply);
    // The color of the text has no effect.
    EXPECT_EQ(scene->materials[0].ambient, (Color{1, 1, 1}));
    // A cube around the center, 1/3 wide, whatever Rotate and Scale are.
    const auto& m = t.world_from_texture.m;
    EXPECT_NEAR(m[0][0], 1. / 3, 1e-8);
    EXPECT_EQ(m[0][1], 0);
    EXPECT_NEAR(m[1][3], 4 - 1. / 6, 1e-8);
}

TEST(TachyonTextures, HighlightsOfMetalHaveThePatternsColor) {
    const auto mix_of = [](const std::string& phong, int function = 1) {
        const Result<Scene> scene = read("Sphere Center 0 0 0 Rad 1 " + body(function, phong));
        return scene && scene->textures.size() == 1 ? std::optional(scene->textures[0].mix) : std::nullopt;
    };
    EXPECT_EQ(mix_of("Phong Plastic 0.5 Phong_size 9"), TextureMix::multiply);
    EXPECT_EQ(mix_of("Phong Metal 0.5 Phong_size 9"), TextureMix::replace);
    EXPECT_EQ(mix_of("Phong Metal 0.5 Phong_size 9", 2), TextureMix::replace);
    EXPECT_EQ(mix_of("Phong Metal 1.5 Phong_size 9"), TextureMix::multiply);  // not a part of the color
}

TEST(TachyonTextures, ABrightHighlightOfMetalIsWarnedOf) {
    const auto warns = [](const std::string& phong, int function) {
        return messages_of(read("Sphere Center 0 0 0 Rad 1 " + body(function, phong)))
                   .find("highlights of metals whose Phong") != std::string::npos;
    };
    EXPECT_TRUE(warns("Phong Metal 1.5 Phong_size 9", 1));
    EXPECT_FALSE(warns("Phong Metal 0.5 Phong_size 9", 1));
    EXPECT_FALSE(warns("Phong Plastic 1.5 Phong_size 9", 1));
    EXPECT_FALSE(warns("Phong Metal 1.5 Phong_size 9", 0));
}

TEST(TachyonTextures, AreSharedAndKeepTheirPlaces) {
    const std::string ball = "Sphere Center 0 0 0 Rad 1 ";
    const Result<Scene> scene = read(ball + body(3, "", "Center 0 0 0") + ball + body(3, "", "Center 1 0 0") +
                                     ball + body(1, "", "Center 1 0 0") + ball + body(1, "", "Center 2 0 0"));
    ASSERT_TRUE(scene) << scene.message;
    EXPECT_EQ(scene->textures.size(), 3u);  // Center does not move marble
    EXPECT_EQ(scene->materials.size(), 3u);
    EXPECT_EQ(scene->texture_texts.place(1).line, 6u);
}

TEST(TachyonTextures, GritDarkensTheColorByAFifthAtMost) {
    const auto c = channels_of(wall(2));
    const double whole[] = {204, 102, 51};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(c[i].least, 0.8 * whole[i], 2);
        EXPECT_NEAR(c[i].average, 0.9 * whole[i], 1);
        EXPECT_NEAR(c[i].most, whole[i], 1);
    }
}

TEST(TachyonTextures, MarbleHasTheRangeAndTheAverageOfTachyons) {
    const auto c = channels_of(wall(3));
    const double least[] = {52, 58, 0}, average[] = {89, 151, 57}, most[] = {127.5, 238, 181};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(c[i].least, least[i], 3) << i;
        EXPECT_NEAR(c[i].average, average[i], 5) << i;
        EXPECT_NEAR(c[i].most, most[i], 3) << i;
    }
}

TEST(TachyonTextures, WoodHasBlackRings) {
    // The rings lie around the axis through the center along y.
    const auto ball = [](const std::string& center) {
        return channels_of("Sphere Center 0 0 0 Rad 30 " + body(4, "", "Center " + center));
    };
    EXPECT_NEAR(ball("0 0 0")[1].least, 255, 1e-3);
    EXPECT_NEAR(ball("0 77 0")[0].least, 204, 1e-3);
    EXPECT_NEAR(ball("0 0 0")[2].most, 51, 1e-3);
    EXPECT_EQ(ball("0 0 20")[1].most, 0);  // 41 to 50 from the axis
    EXPECT_NEAR(ball("0 0 33")[1].least, 255, 1e-3);
}

TEST(TachyonTextures, WarnOnceOfAnotherGrainAndOfRoundRings) {
    const std::string ball = "Sphere Center 0 0 0 Rad 1 ";
    const std::string objects =
        ball + body(2) + ball + body(3) + ball + body(4) + ball + body(4, "", "Center 1 0 0");
    EXPECT_EQ(
        messages_of(read(objects)),
        "a.dat:4:103: warning: glint has its own noise for grit and marble (`TexFunc` 2 and 3), with another "
        "grain: the picture will differ\n"
        "a.dat:6:103: warning: the rings of wood (`TexFunc` 4) are round here; in Tachyon they have waves of "
        "3 units\n");
    const Result<Scene> white = read(objects, "Shader_Mode Lowest End_Shader_Mode\n");
    EXPECT_EQ(messages_of(white), "");
    ASSERT_TRUE(white);
    EXPECT_TRUE(white->textures.empty());
}

TEST(TachyonTextures, HaveNoEffectOnColorsOfVertices) {
    const Result<Scene> scene = read(
        "VertexArray Numverts 3 Coords 0 0 0 1 0 0 0 1 0 Normals 0 0 -1 0 0 -1 0 0 -1 Colors 1 0 0 0 1 0 0 0 "
        "1\n" +
        body(3) + "TriMesh 1 0 1 2 End_VertexArray\n");
    ASSERT_TRUE(scene) << scene.message;
    EXPECT_TRUE(scene->textures.empty());
    EXPECT_EQ(messages_of(scene), "");
}

TEST(TachyonTextures, HaveNumbersWithinTheirRanges) {
    const std::string ball =
        "Sphere Center 0 0 0 Rad 1 Texture Ambient 1 Diffuse 0 Specular 0 Opacity 1 Color 1 1 1\nTexFunc 1 ";
    EXPECT_EQ(read(ball + "Center 0 1e13 0 Rotate 0 0 0 Scale 1 1 1\n").message,
              "a.dat:5:20: expected a number from -1e12 to 1e12, found '1e13'");
    EXPECT_EQ(read(ball + "Center 0 0 0 Rotate 0 nan 0 Scale 1 1 1\n").message,
              "a.dat:5:33: expected a number, found 'nan'");
    EXPECT_EQ(read(ball + "Center 0 0 0 Scale 1 1 1\n").message,
              "a.dat:5:24: expected `Rotate`, found 'Scale'");
    const Result<Scene> far = read(ball + "Center 1e12 -1e12 0 Rotate 0 0 0 Scale 0 0 0\n");
    ASSERT_TRUE(far) << far.message;
    EXPECT_TRUE(prepare(*far));
}

}  // namespace
}  // namespace glint::test
