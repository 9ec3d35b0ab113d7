// SPDX-License-Identifier: Apache-2.0
// Scenes written as glTF, and read again.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "export/gltf/reflection.h"
#include "formats/gltf/materials.h"
#include "formats/load_text.h"
#include "formats/random_scene.h"
#include "glint/glint.h"
#include "scene/material_color.h"

namespace glint::test {
namespace {

std::string written(const Scene& scene, std::string_view format = "glb") {
    Result<std::string> result = write_scene(scene, format);
    EXPECT_TRUE(result) << result.message;
    return std::move(result).value_or({});
}

std::string gltf_warnings(const Scene& scene) {
    std::string all;
    for (const Diagnostic& d : write_scene(scene, "glb").diagnostics) all += d.message + '\n';
    return all;
}

Result<Scene> written_and_read(const Scene& scene, std::string_view format = "glb") {
    return load_text(written(scene, format), "a." + std::string(format));
}

std::vector<std::uint8_t> picture_bytes(Scene scene, std::int32_t width = 96, std::int32_t height = 72) {
    scene.settings.width = width;
    scene.settings.height = height;
    scene.settings.samples = 1;
    const Result<World> prepared = prepare(scene);
    EXPECT_TRUE(prepared) << prepared.message;
    Result<Rendering> result = render(*prepared);
    EncodeOptions options;
    options.format = FileFormat::ppm;
    options.set_rule(scene.conventions.byte_rule());
    return encode(result->image, options).value();
}

// The mean difference of two pictures, in steps of 255.
double mean_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    EXPECT_EQ(a.size(), b.size());
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

// A scene whose conventions are those of glTF.
Scene gltf_like(const std::string& shapes) {
    return quiet_scene(R"(glint = 1
conventions { transfer = srgb  clamp_attenuation = false }
camera { position = (1, 2, 6)  look_at = (0, 0.2, 0)  fov_y = 40 }
light { type = directional  to_light = (1, 2, 3)  intensity = 0.7 }
light { type = point  position = (-3, 4, 3)  color = (9, 8, 7)  attenuation = (0, 0, 1) }
light { type = spot  position = (0, 5, 1)  axis = (0, -1, -0.2)  outer_angle = 40  inner_angle = 10
        color = (5, 6, 5)  attenuation = (0, 0, 1) }
)" + shapes,
                       "a.glint");
}

TEST(WriteGltf, GivesTheStudioBackByteForByte) {
    const std::string path = GLINT_SOURCE_DIR "/scenes/gltf/studio.gltf";
    const Scene studio = quiet_scene(read_whole_file(path), path);
    const std::vector<std::uint8_t> picture = picture_bytes(studio);
    for (const std::string_view format : {"glb", "gltf"}) {
        const Result<Scene> again = written_and_read(studio, format);
        ASSERT_TRUE(again) << messages(again);
        EXPECT_EQ(messages(again), "");
        EXPECT_EQ(picture_bytes(*again), picture) << format;
        EXPECT_EQ(again->meshes.size(), studio.meshes.size()) << "instances share their mesh";
        ASSERT_EQ(again->materials.size(), studio.materials.size());
    }
    EXPECT_EQ(gltf_warnings(studio), "");
    EXPECT_EQ(written(studio), written(studio));
}

TEST(WriteGltf, KeepsTheSidesOfSurfaces) {
    const std::string keys = "one_sided = true }\n";
    Scene scene = gltf_like("sphere { center = (-1, 0, 0)  radius = 0.5  " + keys +
                            "box { min = (0, -0.5, 0)  max = (1, 0.5, 1)  scale = (1, 1, -1)  " + keys +
                            "disc { center = (0, 1, 0)  normal = (0, 0, -1)  radius = 0.6  " + keys);
    const auto pictures_agree = [&] {
        const Result<Scene> again = written_and_read(scene);
        ASSERT_TRUE(again) << messages(again);
        EXPECT_TRUE(again->materials.at(0).one_sided);
        EXPECT_LT(mean_difference(picture_bytes(*again), picture_bytes(scene)), 0.5);
    };
    pictures_agree();
    const std::vector<std::uint8_t> one_sided = picture_bytes(scene);
    for (Material& material : scene.materials) material.one_sided = false;
    EXPECT_GT(mean_difference(one_sided, picture_bytes(scene)), 2) << "the disc is seen";
    // A left-handed camera, for which the writer reflects the scene.
    for (Material& material : scene.materials) material.one_sided = true;
    scene.camera.frame = CameraFrame{{-0.6, 0, 0}, {0, 0.45, 0}, {0, 0, -1}};
    pictures_agree();
}

TEST(WriteGltf, KeepsTheMaterialsThatWereRead) {
    for (const double metallic : {0.0, 0.25, 1.0}) {
        for (const double roughness : {0.0, 0.1, 0.35, 0.5, 0.9, 1.0}) {
            for (const Color base : {Color{0.8, 0.4, 0.2}, Color{1, 1, 1}, Color{0.03, 0, 0.5}}) {
                Material m;
                gltf::set_reflection(m,
                                     {base * (1 - metallic), base * metallic,
                                      Color{0.04, 0.04, 0.04} * (1 - metallic) + base * metallic, roughness});
                const gltf_export::MetalRoughness found = gltf_export::metal_roughness(m, 0.04);
                EXPECT_TRUE(found.is_exact);
                EXPECT_FALSE(found.specular) << metallic << ' ' << roughness;
                // Below, all have the same exponent.
                EXPECT_NEAR(found.roughness, roughness, roughness < 0.12 ? 0.12 : 1e-12);
                if (roughness > 0.12 && roughness < 1) {
                    EXPECT_NEAR(found.metallic, metallic, 1e-9);
                }
                Scene scene = gltf_like("sphere { center = (0, 0, 0)  radius = 1 }");
                scene.materials = {m};
                scene.shapes[0].material = 0;
                const Result<Scene> again = written_and_read(scene);
                ASSERT_TRUE(again) << messages(again);
                const Material& read = again->materials.at(0);
                EXPECT_NEAR(read.shininess, m.shininess, 1e-9 * (1 + m.shininess));
                for (const auto member :
                     {&Material::color, &Material::ambient, &Material::diffuse, &Material::specular}) {
                    EXPECT_NEAR((read.*member).r, (m.*member).r, 1e-9);
                    EXPECT_NEAR((read.*member).g, (m.*member).g, 1e-9);
                    EXPECT_NEAR((read.*member).b, (m.*member).b, 1e-9);
                }
            }
        }
    }
}

TEST(WriteGltf, KeepsPhongsCoefficients) {
    Scene scene = gltf_like(R"(
material a { color = (0.8, 0.4, 0.2)  diffuse_color = (0.5, 0.3, 0.1)  specular_color = (0.2, 0.3, 0.4)  shininess = 60 }
material b { color = (1, 1, 1)  diffuse_color = (0.1, 0.2, 0.3)  emission_color = (3, 1.5, 0) }
material c { color = (0.5, 0.6, 0.7)  diffuse_color = (0.5, 0.6, 0.7)  transmit = 0.25  filter = 0.5 }
sphere { center = (0, 0, 0)  radius = 1  material = a }
sphere { center = (1, 0, 0)  radius = 1  material = b }
sphere { center = (2, 0, 0)  radius = 1  material = c }
)");
    const Result<Scene> again = written_and_read(scene);
    ASSERT_TRUE(again) << messages(again);
    EXPECT_EQ(gltf_warnings(scene), "");
    ASSERT_EQ(again->materials.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        const Material &m = scene.materials[i], &read = again->materials[i];
        for (const auto member : {&Material::diffuse, &Material::specular, &Material::emission}) {
            EXPECT_NEAR((read.*member).r, (m.*member).r, 1e-9) << i;
            EXPECT_NEAR((read.*member).g, (m.*member).g, 1e-9) << i;
            EXPECT_NEAR((read.*member).b, (m.*member).b, 1e-9) << i;
        }
        EXPECT_NEAR(read.transmit, m.transmit, 1e-12);
        EXPECT_NEAR(read.filter, m.filter, 1e-12);
    }
    EXPECT_NEAR(again->materials[0].shininess, 60, 1e-9);
    EXPECT_EQ(again->material_texts.name(1), "b");
}

TEST(WriteGltf, EveryKindOfShape) {
    const Scene scene = gltf_like(R"(
material m { color = (0.8, 0.6, 0.3)  specular_color = (0.3, 0.3, 0.3)  shininess = 40 }
sphere { center = (-1.5, 0.5, 0)  radius = 0.6  material = m }
cylinder { from = (0, 0, 0)  to = (0.3, 1.2, 0.2)  radius = 0.3  caps = true  material = m }
cone { from = (1.2, 0, 0)  to = (1.2, 1.3, 0)  radius = 0.5  material = m }
cone { from = (1.2, 0, 1.5)  to = (1.2, 1, 1.5)  radius = (0.2, 0.4)  caps = true  material = m }
disc { center = (-0.5, 0.5, 1)  normal = (0, 1, 1)  radius = 0.4  material = m }
disc { center = (0.3, 0.3, 1.6)  normal = (0, 1, 1)  radius = 0.3  hole = 0.15  material = m }
torus { center = (-0.8, 1.6, 0.4)  axis = (0, 1, 1)  radius = 0.4  tube = 0.15  material = m }
box { min = (-1.6, 0, 1)  max = (-1, 0.5, 1.6)  material = m }
triangle { vertices = ((2, 0, 0), (2.5, 0, 0.5), (2.2, 1, 0.2))  material = m }
polygon { vertices = ((-2.5, 0, 0), (-2, 0, 0.5), (-2.2, 1, 0.2), (-2.4, 0.3, 0))  material = m }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.4, 0.5, 0.6) }
group { matrix = ((1, 0.4, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0))  sphere { center = (0, 1.8, 0)  radius = 0.4  material = m } }
)");
    const Result<Scene> again = written_and_read(scene);
    ASSERT_TRUE(again) << messages(again);
    EXPECT_EQ(messages(again), "");
    EXPECT_EQ(gltf_warnings(scene), "glTF has no infinite planes: each is a large square\n");
    const double difference = mean_difference(picture_bytes(scene), picture_bytes(*again));
    EXPECT_LT(difference, 1.8) << "most of it at the horizon";
}

TEST(WriteGltf, TheColorsOfVertices) {
    const std::string mesh = R"(mesh { vertices = ((-1, 0, 0), (1, 0, 0), (0, 2, 0), (0, -1, 0))
       triangles = ((0, 1, 2), (0, 3, 1))  colors = ((1, 0, 0), (0, 1, 0), (0, 0, 1), (0.5, 0.5, 0.5)) })";
    const Scene scene = gltf_like(mesh);
    const Result<Scene> again = written_and_read(scene);
    ASSERT_TRUE(again) << messages(again);
    EXPECT_EQ(picture_bytes(*again), picture_bytes(scene));
}

TEST(WriteGltf, Textures) {
    const std::string mesh =
        R"(mesh { vertices = ((-2, -1, 0), (2, -1, 0), (2, 2, 0), (-2, 2, 0))  triangles = ((0, 1, 2), (0, 2, 3))
       texture_coordinates = ((0, 0), (3, 0), (3, 2), (0, 2))  material = t })";
    Scene scene = gltf_like("material t { color = (1, 1, 1)  diffuse_color = (0.9, 0.8, 0.7) }\n" + mesh);
    TextureImage image{3, 2, true,
                       std::vector<std::uint8_t>{255, 0,  0,   255, 0,   255, 0,   128, 0, 0, 255, 0,
                                                 9,   99, 199, 255, 200, 150, 100, 50,  1, 2, 3,   255}};
    Texture texture;
    texture.image = std::make_shared<const TextureImage>(image);
    texture.encoding = TextureEncoding::srgb;
    for (const TextureAlpha alpha : {TextureAlpha::blend, TextureAlpha::mask, TextureAlpha::ignore}) {
        for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::mirror, TextureWrap::clamp}) {
            for (const bool nearest : {false, true}) {
                texture.alpha = alpha;
                texture.wrap_u = wrap;
                texture.filter = nearest ? TextureFilter::nearest : TextureFilter::bilinear;
                scene.textures = {texture};
                scene.materials[0].texture = 0;
                const Result<Scene> again = written_and_read(scene);
                ASSERT_TRUE(again) << messages(again);
                ASSERT_EQ(again->textures.size(), 1u);
                const TextureImage& read = *again->textures[0].image;
                EXPECT_EQ(again->textures[0].wrap_u, wrap);
                if (alpha != TextureAlpha::ignore) {
                    EXPECT_EQ(read, image);
                }
                EXPECT_LT(mean_difference(picture_bytes(scene), picture_bytes(*again)), 1e-3);
                EXPECT_EQ(gltf_warnings(scene), "");
            }
        }
    }
    // A map that KHR_texture_transform can have, one that it cannot, and one that is not of glTF.
    for (const UvMap& map : {UvMap{{{0.6, 0.8, 0.1}, {0.8, -0.6, 0.3}}}, UvMap{{{1, 0.5, 0}, {0, 1, 0}}},
                             UvMap{{{2, 0, 0.25}, {0, 3, 0.5}}}}) {
        scene.textures[0].uv_map = map;
        const Result<Scene> again = written_and_read(scene);
        ASSERT_TRUE(again) << messages(again);
        EXPECT_LT(mean_difference(picture_bytes(scene), picture_bytes(*again)), 0.05);
    }
    scene.textures[0].wrap_u = TextureWrap::once;
    EXPECT_EQ(gltf_warnings(scene),
              "glTF has no textures with the wrap `once` or `clip`: they are written as `clamp`\n");
}

TEST(WriteGltf, MapsOfColorsBecomeTheirMean) {
    Scene scene = gltf_like(R"(
texture t { color_map = ((0, (1, 1, 1)), (0.5, (0, 0.5, 0)))  mapping = checker  filter = nearest }
material m { color = (0.5, 0.5, 0.5)  texture = t }
sphere { center = (0, 0, 0)  radius = 1  material = m })");
    const Result<Scene> again = written_and_read(scene);
    ASSERT_TRUE(again) << messages(again);
    EXPECT_EQ(gltf_warnings(scene),
              "glTF has no patterns and maps of colors (`color_map`): the surfaces have their mean color\n");
    scene.textures.clear();
    scene.materials[0].texture = k_none;
    scene.materials[0] = with_color(scene.materials[0], {0.25, 0.375, 0.25});
    const Result<Scene> mean = written_and_read(scene);
    ASSERT_EQ(again->materials.size(), 1u);
    EXPECT_TRUE(again->textures.empty());
    EXPECT_EQ(again->materials[0].color, mean->materials[0].color);
}

TEST(WriteGltf, UnlitTexturesHaveTheirColorsWhateverTheLights) {
    Scene scene = gltf_like(R"(
texture t { texels = ("3366cc 000000", "ff8001 fffefd")  filter = nearest  encoding = srgb  mix = multiply_all }
material m { color = (1, 1, 1)  ambient = 0  diffuse = 0  emission = 1  texture = t }
mesh { vertices = ((-2, -2, 0), (2, -2, 0), (2, 2, 0), (-2, 2, 0))  triangles = ((0, 1, 2), (0, 2, 3))
       texture_coordinates = ((0, 0), (1, 0), (1, 1), (0, 1))  material = m })");
    scene.camera.projection = Projection::orthographic;
    scene.camera.position = {0, 0, 5};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.width = 4;
    const Result<Scene> again = written_and_read(scene);
    ASSERT_TRUE(again) << messages(again);
    EXPECT_EQ(messages(again), "");
    EXPECT_NE(written(scene).find("KHR_materials_unlit"), std::string::npos);
    for (const Scene* const s : std::initializer_list<const Scene*>{&scene, &*again}) {
        const std::vector<std::uint8_t> bytes = picture_bytes(*s, 2, 2);
        const std::vector<std::uint8_t> texels(bytes.end() - 12, bytes.end());
        EXPECT_EQ(texels,
                  (std::vector<std::uint8_t>{0x33, 0x66, 0xcc, 0, 0, 0, 0xff, 0x80, 1, 0xff, 0xfe, 0xfd}));
        // The terms of an explanation are those of the pixel.
        Scene small = *s;
        small.settings.width = small.settings.height = 2;
        const Result<World> world = prepare(small);
        ASSERT_TRUE(world);
        const Result<Explanation> why = explain(small, *world, 0, 1);
        ASSERT_TRUE(why) << why.message;
        const Material m = material_of(*why->rays.at(0).hit, small);
        EXPECT_EQ(why->rays[0].hit->emission, m.emission);
        EXPECT_EQ(static_cast<float>(m.emission.g), render(*world)->image.rgb[7]);
    }
}

TEST(WriteGltf, ATextureOnAShapeByItsMapping) {
    Scene scene = gltf_like(
        "material t { color = (1, 1, 1) }\nsphere { center = (0, 0, 0)  radius = 1.5  material = t }");
    Texture texture;
    texture.image = std::make_shared<const TextureImage>(
        TextureImage{2, 2, false, std::vector<std::uint8_t>{250, 0, 0, 0, 250, 0, 0, 0, 250, 250, 250, 250}});
    texture.encoding = TextureEncoding::srgb;
    texture.mapping = TextureMapping::spherical;
    scene.textures = {texture};
    scene.materials[0].texture = 0;
    const Result<Scene> again = written_and_read(scene);
    ASSERT_TRUE(again) << messages(again);
    EXPECT_LT(mean_difference(picture_bytes(scene), picture_bytes(*again)), 0.7);
}

TEST(WriteGltf, SaysOnceWhatIsLeftOut) {
    const Scene scene = quiet_scene(R"(glint = 1
camera { position = (0, 0, 6)  look_at = (0, 0, 0)  fov_y = 40 }
light { type = ambient  intensity = 0.2 }
light { type = ambient  intensity = 0.1 }
light { type = point  position = (0, 4, 3) }
light { type = sphere  position = (0, 4, 3)  radius = 1 }
fog { type = exp  density = 0.1 }
sphere { center = (0, 0, 0)  radius = 1  mirror = 0.5 }
)",
                                    "a.glint");
    EXPECT_EQ(
        gltf_warnings(scene),
        "glTF has no mirrors: they are metal or reflect at a right angle, which glint reads without what "
        "they show\n"
        "glTF has no ambient light: it is left out (2)\n"
        "glTF has no fall-offs of lights other than 1 / d^2: they are as bright as they were, at the "
        "distance of most shapes (2)\n"
        "glTF has no area lights: each is a point light at its middle\n"
        "glTF has no fog: it is left out\n");
}

// Along the normal, a Fresnel mirror reflects a little more than its least.
TEST(WriteGltf, FresnelMirrorsReflectAtARightAngle) {
    const Scene scene = gltf_like(
        "sphere { center = (0, 0, 0)  radius = 1  ior = 1.5  mirror = 0.8  mirror_min = 0.1  mirror_fresnel "
        "= true "
        "conserve_energy = true }");
    const nlohmann::json json = nlohmann::json::parse(written(scene, "gltf"));
    const double factor =
        json["materials"][0]["extensions"]["KHR_materials_specular"]["specularColorFactor"][0];
    EXPECT_NEAR(factor, (0.1 + 0.7 * 0.04) / 0.04, 1e-12);
    EXPECT_NE(gltf_warnings(scene).find("and the like of finishes"), std::string::npos);
}

TEST(WriteGltf, LeftHandedScenesAreNotMirrored) {
    const std::string path = GLINT_SOURCE_DIR "/scenes/cgfs/three_spheres.cgfs";
    const Scene scene = quiet_scene(read_whole_file(path), path);
    const Result<Scene> again = written_and_read(scene);
    ASSERT_TRUE(again) << messages(again);
    Scene a = scene, b = *again;
    a.settings.shading = b.settings.shading = Shading::color;
    a.background = b.background = {};
    a.conventions.transfer = Transfer::none;
    b.settings.width = a.settings.width, b.settings.height = a.settings.height;
    EXPECT_LT(mean_difference(picture_bytes(a, 90, 90), picture_bytes(b, 90, 90)), 3);
}

TEST(WriteGltf, AnyScene) {
    int valid = 0, read = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        const Scene scene = test::RandomScene(seed).make();
        const Result<std::string> text = write_scene(scene, "glb");
        if (has_errors(validate(scene))) {
            EXPECT_EQ(text.code, ErrorCode::invalid_scene);
            continue;
        }
        ++valid;
        ASSERT_TRUE(text) << seed << text.message;
        // Not all are read: their coordinates may go beyond the limit where shapes are placed by nodes.
        const Result<Scene> again = load_text(*text, "a.glb");
        EXPECT_EQ(what_is_wrong(again, *text), "") << seed;
        read += again ? 1 : 0;
    }
    EXPECT_GE(valid, 100);
    EXPECT_GE(read, valid / 2);
}

TEST(WriteGltf, TheFormatsThatAreWritten) {
    std::string names;
    for (const WrittenFormat& format : written_formats()) names += std::string(format.name) + ' ';
    EXPECT_EQ(names, "glint glb gltf ");
    EXPECT_EQ(write_scene(Scene{}, "obj").message,
              "expected one of the formats glint, glb, gltf, found 'obj'");
    EXPECT_EQ(write_scene(Scene{}, "glint").value(), write_glint(Scene{}).value());
    EXPECT_TRUE(write_scene(Scene{}, "glb")) << "without shapes";
}

}  // namespace
}  // namespace glint::test
