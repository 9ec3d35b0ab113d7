// SPDX-License-Identifier: Apache-2.0
// height_field. The stage `peers` compares its pictures with POV-Ray's.
#include "formats/povray_text.h"

namespace glint::test {
namespace {

using namespace std::string_literals;

// Rows from the top.
const std::string k_grey = "P5\n3 2\n255\n\x10\x20\x30\x40\x50\x60"s;
const std::string k_colors = "P6\n2 2\n255\n\x01\x02\x03\x11\x22\x33\x80\x01\xff\xff\xfe\xfd"s;
const std::string k_words = "P5\n2 2\n65535\n\x01\x02\x11\x22\x80\x01\xff\xfe"s;

Result<Scene> read_field(const std::string& text) {
    TextSources sources({{"grey.pgm", k_grey},
                         {"colors.ppm", k_colors},
                         {"words.pgm", k_words},
                         {"odd.pgm", "P5\n2 2\n99\n\x10\x20\x30\x40"s + std::string(32, ' ')},
                         {"small.pgm", "P5\n1 2\n255\n\x10\x20"s},
                         {"none.png", "none"}});
    return read_povray("light_source { <0, 0, -9>, rgb 1 }\n" + text, &sources);
}

Scene field_scene(const std::string& text) {
    const Result<Scene> result = read_field(text);
    EXPECT_TRUE(result) << messages(result);
    return result.value_or(Scene{});
}

MeshData mesh_of_field(const std::string& text) {
    const Scene scene = field_scene(text);
    EXPECT_EQ(scene.meshes.size(), 1u) << text;
    return scene.meshes.empty() ? MeshData{} : *scene.meshes[0];
}

TEST(PovRayHeightFields, TracedNormalsPointUp) {
    const Scene scene = field_scene(
        "#declare H = height_field { pgm \"grey.pgm\" } #declare N = 0*x;\n"
        "#declare P = trace(H, <0.4, 9, 0.4>, -y, N); sphere { N, 1 }");
    EXPECT_GT(scene.get<Sphere>().at(0).center.y, 0.5);
}

TEST(PovRayHeightFields, TexelsAreVerticesFromTheLowerLeft) {
    const Scene scene = field_scene("height_field { pgm \"grey.pgm\" }");
    ASSERT_EQ(scene.meshes.size(), 1u);
    const MeshData& mesh = *scene.meshes[0];
    ASSERT_EQ(mesh.vertex_count(), 6u);
    expect_vec(mesh.position(0), {0, 0x40 * 257, 0});
    expect_vec(mesh.position(2), {2, 0x60 * 257, 0});
    expect_vec(mesh.position(3), {0, 0x10 * 257, 1});
    EXPECT_TRUE(mesh.normals.empty());
    ASSERT_EQ(mesh.triangles.size(), 4u);
    EXPECT_EQ(mesh.triangles[0], (TriangleCorners{0, 3, 1})) << "the diagonal is from +x to +z";
    EXPECT_EQ(mesh.triangles[1], (TriangleCorners{4, 1, 3}));
    ASSERT_EQ(scene.transforms.size(), 1u);
    EXPECT_EQ(scene.transforms[0].m[0][0], 0.5);
    EXPECT_EQ(scene.transforms[0].m[1][1], 1 / 65536.0);
    EXPECT_EQ(scene.transforms[0].m[2][2], 1);
}

TEST(PovRayHeightFields, ColorsAreTwoBytesAndGreyWordsCount) {
    EXPECT_EQ(mesh_of_field("height_field { ppm \"colors.ppm\" }").position(0).y, 0x8001);
    EXPECT_EQ(mesh_of_field("height_field { \"colors.ppm\" }").position(3).y, 0x1122);
    EXPECT_EQ(mesh_of_field("height_field { pgm \"words.pgm\" }").position(1).y, 0xfffe);
}

TEST(PovRayHeightFields, WaterCutsOff) {
    // Of the heights 16, 32, 48 above 64, 80, 96: the lowest corner is cut off.
    const MeshData mesh = mesh_of_field("height_field { pgm \"grey.pgm\" water_level 24 * 257 / 65536 }");
    EXPECT_EQ(mesh.triangles.size(), 6u) << "two have two parts";
    const float water = 24 * 257;
    for (const TriangleCorners& t : mesh.triangles)
        for (const std::uint32_t i : t) EXPECT_GE(mesh.position(i).y, water);
    EXPECT_EQ(mesh.position(6).y, water) << "a vertex at the water";
    EXPECT_TRUE(
        field_scene("sphere { 0, 1 } height_field { pgm \"grey.pgm\" water_level 0.9 }").meshes.empty());
}

TEST(PovRayHeightFields, SmoothOnesHaveNormalsOfEachPlace) {
    const std::string field = "#declare F = height_field { pgm \"grey.pgm\" smooth }\n";
    const Scene scene =
        field_scene(field + "object { F } object { F translate x } object { F scale <1, 2, 1> }");
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(scene.meshes.size(), 2u) << "those that differ in scale";
    for (const auto& mesh : scene.meshes) {
        ASSERT_EQ(mesh->normals.values.size(), mesh->vertex_count());
        EXPECT_GT(mesh->normals.values[0].y, 0);
        EXPECT_LT(mesh->normals.values[0].x, 0) << "it rises to +x";
        EXPECT_GT(mesh->normals.values[0].z, 0) << "it falls to +z";
    }
    EXPECT_EQ(field_scene(
                  "#declare F = height_field { pgm \"grey.pgm\" } object { F } object { F scale <1, 2, 1> }")
                  .meshes.size(),
              1u);
}

// Noise: its normals would need many triangles in each square.
TEST(PovRayHeightFields, TooManyDividedSquaresAreWarnedOf) {
    const auto said = [](std::size_t size) {
        std::string rough = "P5\n" + std::to_string(size) + " " + std::to_string(size) + "\n255\n";
        for (std::size_t i = 0; i < size * size; ++i)
            rough += static_cast<char>((i * i * 7 + i / size) % 251);
        TextSources sources({{"rough.pgm", rough}});
        return messages(read_povray(
            "light_source { <0, 0, -9>, rgb 1 }\nheight_field { pgm \"rough.pgm\" smooth }", &sources));
    };
    EXPECT_EQ(said(20), "");
    EXPECT_NE(said(900).find("2:1: warning: the normals of this smooth height_field are linear"),
              std::string::npos);
}

TEST(PovRayHeightFields, WhatIsNotRenderedIsRefusedByName) {
    const std::pair<std::string, std::string> refused[] = {
        {"height_field { function 9, 9 { pigment { gradient x } } rotate x }",
         "`height_field` (of a function)"},
        {"height_field { pgm \"grey.pgm\" gamma 2 smooth }", "`height_field` (with a gamma)"},
        {"height_field { pgm \"odd.pgm\" }", "`height_field` (of a picture of this kind)"},
        {"difference { box { -1, 1 } height_field { pgm \"grey.pgm\" } }", "`height_field` (in a solid)"}};
    for (const auto& [text, message] : refused) {
        EXPECT_NE(messages(read_field(text)).find("error: glint does not render " + message),
                  std::string::npos)
            << messages(read_field(text));
        EXPECT_TRUE(read_field("#declare F = " + text + " sphere { 0, 1 }")) << "not used";
    }
    for (const std::string text :
         {"height_field { gif \"a.gif\" smooth }", "height_field { png \"none.png\" }"})
        EXPECT_NE(messages(read_field(text)).find("`height_field` (without its picture)"), std::string::npos);
    EXPECT_NE(messages(read_field("height_field { pgm \"small.pgm\" }"))
                  .find("2:20: error: expected a picture of at "
                        "least 2 x 2 texels"),
              std::string::npos);
}

}  // namespace
}  // namespace glint::test
