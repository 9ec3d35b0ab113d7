// SPDX-License-Identifier: Apache-2.0
// image_map and uv_mapping. The stage `peers` compares their pictures with POV-Ray's.
#include "formats/povray/image_gamma.h"
#include "formats/povray_text.h"
#include "math/transform.h"

namespace glint::test {
namespace {

using namespace std::string_literals;

const std::string k_grey_picture = "P5 2 1 255\n\x33\xcc"s;
const std::string k_new = "#version 3.7; global_settings { assumed_gamma 1 }\n";
constexpr std::string_view k_image = "image_map { ppm \"a.ppm\" }";

Result<Scene> read_with_picture(const std::string& text) {
    TextSources sources({{"a.ppm", k_grey_picture}});
    return read_povray(k_new + "light_source { <0, 0, -9>, rgb 1 }\n" + text, &sources);
}

Scene scene_with_picture(const std::string& text) {
    const Result<Scene> result = read_with_picture(text);
    EXPECT_TRUE(result) << messages(result);
    return result.value_or(Scene{});
}

// The only texture.
Texture texture_of(const std::string& text) {
    const Scene scene = scene_with_picture(text);
    EXPECT_EQ(scene.textures.size(), 1u) << text;
    return scene.textures.empty() ? Texture{} : scene.textures[0];
}

std::string warnings_of(const std::string& text) { return messages(read_with_picture(text)); }

std::string ball(std::string_view pigment, std::string_view after = {}) {
    return "sphere { 0, 1 pigment { " + std::string(pigment) + " } " + std::string(after) + " }";
}

TEST(PovrayImages, ArePlanarNearestAndRepeatedByDefault) {
    const Scene scene = scene_with_picture(ball(k_image));
    ASSERT_EQ(scene.textures.size(), 1u);
    const Texture& texture = scene.textures[0];
    EXPECT_EQ(texture.mapping, TextureMapping::planar);
    EXPECT_EQ(texture.filter, TextureFilter::nearest);
    EXPECT_EQ(texture.wrap_u, TextureWrap::repeat);
    EXPECT_EQ(texture.mix, TextureMix::multiply);
    EXPECT_EQ(texture.encoding, TextureEncoding::srgb);
    EXPECT_EQ(texture.world_from_texture, Affine{});
    EXPECT_EQ(texture.file, "a.ppm");
    EXPECT_EQ(scene.materials[0].texture, 0u);
    EXPECT_EQ(scene.materials[0].diffuse, (Color{0.6, 0.6, 0.6}));
}

TEST(PovrayImages, AreInterpolated) {
    const auto filter = [](std::string_view items) {
        return texture_of(ball("image_map { ppm \"a.ppm\" " + std::string(items) + " }")).filter;
    };
    EXPECT_EQ(filter("interpolate 2"), TextureFilter::bilinear);
    EXPECT_EQ(filter("interpolate 4"), TextureFilter::distance);
}

TEST(PovrayImages, HaveTheTransformsAfterThem) {
    const auto place = [](const std::string& text) { return texture_of(text).world_from_texture; };
    EXPECT_EQ(place(ball(std::string(k_image) + " scale 2")), scaling({2, 2, 2}));
    EXPECT_EQ(place(ball(k_image, "scale 2")), scaling({2, 2, 2}));
    EXPECT_EQ(place("sphere { 0, 1 scale 3 pigment { " + std::string(k_image) + " } scale 2 }"),
              scaling({2, 2, 2}));
    EXPECT_EQ(place("union { " + ball(std::string(k_image) + " scale 2", "translate x") + " scale 3 }"),
              (Affine{{{6, 0, 0, 3}, {0, 6, 0, 0}, {0, 0, 6, 0}}}));
    EXPECT_EQ(
        place("union { sphere { 0, 1 scale 5 } scale 7 pigment { " + std::string(k_image) + " } scale 2 }"),
        scaling({2, 2, 2}));
    EXPECT_EQ(place("#default { pigment { " + std::string(k_image) + " } } sphere { 0, 1 scale 5 }"),
              Affine{});
}

TEST(PovrayImages, AreOneTextureForEachPlace) {
    const Scene scene = scene_with_picture("#declare T = texture { pigment { " + std::string(k_image) +
                                           " } }\n"
                                           "sphere { 0, 1 texture { T } } sphere { x, 1 texture { T } }\n"
                                           "sphere { y, 1 texture { T } scale 2 }");
    EXPECT_EQ(scene.textures.size(), 2u);
    EXPECT_EQ(scene.materials.size(), 2u);
    EXPECT_EQ(scene.textures[0].image, scene.textures[1].image);
}

TEST(PovrayImages, HaveUAndVOfMeshes) {
    const std::string mesh =
        "mesh2 { vertex_vectors { 3, <0, 0, 0>, <1, 0, 0>, <0, 1, 0> } "
        "uv_vectors { 4, <0, 0>, <0.5, 0>, <0, 0.25>, <1, 1> } face_indices { 1, <0, 1, 2> } ";
    const std::string uv = "pigment { uv_mapping " + std::string(k_image) + " scale <0.5, 1, 1> } scale 3 }";
    const Scene by_vertex = scene_with_picture(mesh + uv);
    ASSERT_EQ(by_vertex.textures.size(), 1u);
    EXPECT_EQ(by_vertex.textures[0].mapping, TextureMapping::uv);
    EXPECT_EQ(by_vertex.textures[0].uv_map, (UvMap{{{2, 0, 0}, {0, 1, 0}}}));
    const auto corners = [](const Scene& scene) {
        const MeshData& data = *scene.meshes[0];
        return data.corner_values(data.texture_coordinates, 0).value_or(std::array<Float3, 3>{});
    };
    EXPECT_EQ(corners(by_vertex)[1], (Float3{0.5f, 0, 0}));
    const Scene by_index = scene_with_picture(mesh + "uv_indices { 1, <3, 2, 1> } " + uv);
    EXPECT_EQ(corners(by_index)[0], (Float3{1, 1, 0}));
    const Scene of_triangle = scene_with_picture(
        "#declare T = texture { uv_mapping pigment { " + std::string(k_image) +
        " } }\nmesh { triangle { 0, x, y uv_vectors <0, 0>, <1, 0>, <0.5, 1> texture { T } } }");
    EXPECT_EQ(corners(of_triangle)[2], (Float3{0.5f, 1, 0}));
    EXPECT_NE(messages(read_with_picture(mesh + "uv_indices { 1, <3, 2, 9> } " + uv)).find("4 uv_vectors"),
              std::string::npos);
    // Wings3D writes an empty list, and the index 0 for each corner.
    const std::string none =
        "mesh2 { vertex_vectors { 3, 0, x, y } uv_vectors { 0 } face_indices { 1, <0, 1, 2> } ";
    EXPECT_EQ(corners(scene_with_picture(none + "uv_indices { 1, <0, 0, 0> } " + uv))[0], (Float3{}));
    EXPECT_NE(messages(read_with_picture(none + "uv_indices { 1, <0, 0, 5> } " + uv)).find("uv_vectors"),
              std::string::npos);
}

TEST(PovrayImages, PatternsHaveUAndVOfMeshes) {
    const std::string mesh =
        "mesh2 { vertex_vectors { 3, <0, 0, 0>, <1, 0, 0>, <0, 1, 0> } "
        "uv_vectors { 3, <0, 0>, <0.5, 0>, <0, 0.25> } face_indices { 1, <0, 1, 2> } ";
    const std::string uv = "pigment { uv_mapping checker rgb 0 rgb 1 scale <0.5, 1, 1> } scale 3 }";
    const Scene scene = scene_with_picture(mesh + uv);
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_TRUE(scene.textures[0].from_uv);
    EXPECT_EQ(scene.textures[0].mapping, TextureMapping::checker);
    EXPECT_EQ(scene.textures[0].world_from_texture, (Affine{{{0.5, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}));
    EXPECT_EQ(warnings_of(mesh + uv), "");
    // The same pigment, on u and v and in space.
    const std::string declared = "#declare P = pigment { checker rgb 0 rgb 1 }\n";
    const Scene both =
        scene_with_picture(declared + mesh + "uv_mapping pigment { P } }\n" + mesh + "pigment { P } }");
    ASSERT_EQ(both.textures.size(), 2u);
    EXPECT_TRUE(both.textures[0].from_uv);
    EXPECT_FALSE(both.textures[1].from_uv);
    for (const std::string& other : {"sphere { 0, 1 " + uv, "box { 0, 1 " + uv, "disc { 0, y, 1 " + uv})
        EXPECT_NE(warnings_of(other).find("`uv_mapping` (of a pattern"), std::string::npos) << other;
}

TEST(PovrayImages, SayWhatIsNotRendered) {
    for (const auto& [items, named] : {std::pair{"map_type 5", "map_type"},
                                       {"interpolate 3", "drawn as 2"},
                                       {"transmit 3 0.5", "palette"}}) {
        const std::string text = ball("image_map { ppm \"a.ppm\" " + std::string(items) + " }");
        EXPECT_NE(warnings_of(text).find(named), std::string::npos) << items;
    }
    EXPECT_NE(
        warnings_of("box { 0, 1 pigment { uv_mapping " + std::string(k_image) + " } }").find("of a box"),
        std::string::npos);
    EXPECT_NE(warnings_of(ball("image_map { ppm \"b.ppm\" }")).find("no such file"), std::string::npos);
    EXPECT_NE(warnings_of(ball("image_map { gif \"b.gif\" }")).find(".png"), std::string::npos);
    EXPECT_EQ(warnings_of(ball(k_image)), "");
}

TEST(PovrayImages, RefuseWhatIsNoPicture) {
    for (const auto& [items, named] : {std::pair{"", "the name of a picture's file"},
                                       {"ppm \"a.ppm\" gamma 0", "a gamma from 0.01 to 100"},
                                       {"ppm \"a.ppm\"", "`}`"}}) {
        const std::string close = named == std::string_view("`}`") ? "" : "}";
        EXPECT_NE(
            warnings_of("sphere { 0, 1 pigment { image_map { " + std::string(items) + close).find(named),
            std::string::npos)
            << items;
    }
}

TEST(PovrayImages, AreDecodedByTheScenesNumbers) {
    const auto texture = [](const std::string& head) {
        TextSources sources({{"a.ppm", k_grey_picture}});
        const Scene scene = povray_scene(head + ball(k_image), &sources);
        return scene.textures.empty() ? Texture{} : scene.textures[0];
    };
    EXPECT_EQ(texture("#version 3.6;\n").encoding, TextureEncoding::linear);
    EXPECT_EQ(texture("#version 3.6;\n").file, "a.ppm");
    const Texture graded = texture("#version 3.7; global_settings { assumed_gamma 2.2 }\n");
    EXPECT_EQ(graded.encoding, TextureEncoding::linear);
    EXPECT_EQ(graded.file, "");
    // 0.2 decoded is 0.03310477, whose power 1 / 2.2 is 0.21243.
    EXPECT_EQ(std::get<1>(graded.image->words)[0], 13922);
}

TEST(PovrayImages, ReadTheChunkGamma) {
    const std::string start = "\x89PNG\r\n\x1a\n\0\0\0\1tEXtxcrc!"s;
    const std::string chunk = "\0\0\0\4gAMA\0\0\xb1\x8f"s + "crc!";
    EXPECT_EQ(povray::png_curve(start + chunk).value_or(povray::ImageCurve{}).power, 1e5 / 45455);
    EXPECT_FALSE(povray::png_curve(start + "\0\0\0\0IDATcrc!"s + chunk));
    for (std::size_t n = 0; n < start.size() + chunk.size(); ++n)
        EXPECT_FALSE(povray::png_curve((start + chunk).substr(0, n)));
}

}  // namespace
}  // namespace glint::test
