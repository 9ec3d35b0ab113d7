// SPDX-License-Identifier: Apache-2.0
// .cgfs, field by field.
#include "formats/load_text.h"

namespace glint::test {
namespace {

Scene cgfs_scene(std::string_view text, std::size_t warnings = 0) {
    const Result<Scene> result = load_text(text, "a.cgfs");
    std::string messages;
    for (const Diagnostic& d : result.diagnostics) messages += to_string(d);
    EXPECT_EQ(result.diagnostics.size(), warnings) << messages;
    EXPECT_TRUE(result) << messages;
    return result.value_or(Scene{});
}

constexpr std::string_view k_light = "light { type = ambient intensity = 0.2 }\n";
constexpr std::string_view k_sphere = "sphere { center = (1, 2, 3) radius = 4 color = (255, 51, 0) }\n";

TEST(Cgfs, ReadsASphere) {
    const Scene s = cgfs_scene(std::string(k_light) +
                               "sphere {\n center = (0, -1, 3)\n radius = 1.5\n color = (255, 51, 0)  # Red\n"
                               " specular = 500 // shiny\n reflective = 0.2\n}\n");
    ASSERT_EQ(s.shapes.size(), 1u);
    EXPECT_EQ(s.shapes[0].kind, ShapeKind::sphere);
    EXPECT_EQ(s.get<Sphere>()[0].center, (Vec3{0, -1, 3}));
    EXPECT_EQ(s.get<Sphere>()[0].radius, 1.5);
    const Material& m = s.materials[s.shapes[0].material];
    const Color color{1, 0.2, 0};
    EXPECT_EQ(m.color, color);
    EXPECT_EQ(m.ambient, color);
    EXPECT_EQ(m.diffuse, color);
    EXPECT_EQ(m.specular, color);
    EXPECT_EQ(m.shininess, 500);
    EXPECT_EQ(m.mirror, 0.2);
    EXPECT_EQ(m.mirror_tint, (Color{1, 1, 1}));
    EXPECT_EQ(m.transmission, 0);
}

TEST(Cgfs, SpheresWithoutASpecularExponentAreMatte) {
    for (const char* specular : {"", "specular = -1", "specular = none"}) {
        const Scene s = cgfs_scene(std::string(k_light) +
                                   "sphere { center = (0,0,3) radius = 1 color = (9,9,9) " + specular + " }");
        EXPECT_EQ(s.materials[0].specular, (Color{0, 0, 0})) << specular;
        EXPECT_EQ(s.materials[0].mirror, 0);
    }
    const Scene s =
        cgfs_scene(std::string(k_light) + "sphere { center=(0,0,3) radius=1 color=(255,0,0) specular=0 }");
    EXPECT_EQ(s.materials[0].specular, (Color{1, 0, 0})) << "an exponent of 0 is a highlight everywhere";
    EXPECT_EQ(s.materials[0].shininess, 0);
}

TEST(Cgfs, ReadsLights) {
    const Scene s = cgfs_scene(std::string(k_sphere) +
                               "light {\n type = ambient\n intensity = 0.2\n}\n"
                               "light { type = point intensity = 0.6 position = (2, 1, 0) }\n"
                               "light { direction = (1, 4, 4) intensity = 0.25 type = directional }\n");
    ASSERT_EQ(s.lights.size(), 3u);
    EXPECT_EQ(s.lights[0].kind, LightKind::ambient);
    EXPECT_EQ(s.lights[0].color, (Color{0.2, 0.2, 0.2}));
    EXPECT_EQ(s.lights[1].kind, LightKind::point);
    EXPECT_EQ(s.lights[1].position, (Vec3{2, 1, 0}));
    EXPECT_EQ(s.lights[1].color, (Color{0.6, 0.6, 0.6}));
    EXPECT_EQ(s.lights[1].specular_color, s.lights[1].color);
    EXPECT_EQ(s.lights[1].attenuation, Attenuation{});
    EXPECT_EQ(s.lights[2].kind, LightKind::directional);
    EXPECT_EQ(s.lights[2].to_light, (Vec3{1, 4, 4}));
    EXPECT_EQ(s.lights[2].color, (Color{0.25, 0.25, 0.25}));
}

TEST(Cgfs, HasItsConventionsCameraAndBackground) {
    const Scene s = cgfs_scene(std::string(k_light) + std::string(k_sphere));
    EXPECT_EQ(s.profile, "cgfs");
    EXPECT_EQ(s.conventions.pixel_sample, PixelSample::corner);
    EXPECT_EQ(s.settings.width, 600);
    EXPECT_EQ(s.background, (Color{1, 1, 1}));
    EXPECT_EQ(s.camera.position, (Vec3{0, 0, 0}));
    ASSERT_TRUE(s.camera.frame);
    EXPECT_EQ(*s.camera.frame, (CameraFrame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
    EXPECT_FALSE(s.camera.lighting_eye);
}

TEST(Cgfs, ReadsTheCameraAndTheBackground) {
    const Scene s = cgfs_scene(
        std::string(k_light) + std::string(k_sphere) +
        "camera { position = (3, 0, 1)\n rotation = ((0.5, 0, -0.7), (0, 1, 0.25), (0.7, 0, 0.6)) }\n"
        "background = (0, 51, 255)\n");
    EXPECT_EQ(s.camera.position, (Vec3{3, 0, 1}));
    // direction = rotation * viewport point: the columns are the images of the viewport's x, y and z.
    EXPECT_EQ(*s.camera.frame, (CameraFrame{{0.5, 0, 0.7}, {0, 1, 0}, {-0.7, 0.25, 0.6}}));
    EXPECT_EQ(s.background, (Color{0, 0.2, 1}));
    EXPECT_EQ(s.camera_place.line, 3u);
    EXPECT_EQ(s.background_place.line, 5u);
}

TEST(Cgfs, ReadsTheViewportOfChapterTwo) {
    const std::string items = std::string(k_light) + std::string(k_sphere);
    const Scene plain = cgfs_scene("viewport_size = 1 x 1\nprojection_plane_d = 1\n" + items);
    EXPECT_EQ(*plain.camera.frame, CameraFrame{});
    const Scene wide =
        cgfs_scene("viewport_size = 2 x 1.5\n" + items +
                   "projection_plane_d = 3\ncamera { rotation = ((0,0,1),(0,1,0),(-1,0,0)) }\n");
    EXPECT_EQ(*wide.camera.frame, (CameraFrame{{0, 0, -2}, {0, 1.5, 0}, {3, 0, 0}}));
}

TEST(Cgfs, StoresThePlacesOfItems) {
    const Scene s = cgfs_scene(std::string(k_light) + "\n  " + std::string(k_sphere));
    EXPECT_EQ(s.files, std::vector<std::string>{"a.cgfs"});
    EXPECT_EQ(s.light_texts.place(0), (SourcePlace{1, 1, 0}));
    EXPECT_EQ(s.shape_texts.place(0), (SourcePlace{3, 3, 0}));
}

TEST(Cgfs, EqualSurfacesShareAMaterial) {
    std::string text(k_light);
    for (int i = 0; i < 10; ++i) text += k_sphere;
    text += "sphere { center = (1, 2, 3) radius = 4 color = (255, 51, 0) reflective = 0.5 }\n";
    const Scene s = cgfs_scene(text);
    EXPECT_EQ(s.shapes.size(), 11u);
    EXPECT_EQ(s.materials.size(), 2u);
}

TEST(Cgfs, LineEndsMarksAndSeparatorsDoNotMatter) {
    const std::string text = std::string(k_light) + std::string(k_sphere) + "# caf\xc3\xa9\n";
    std::string crlf = "\xef\xbb\xbf";
    for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    std::string one_line =
        "light{type=ambient,intensity=0.2;};sphere{center=(1,2,3)radius=4 color=(255,51,0,)},";
    const Scene a = cgfs_scene(text);
    for (const std::string& other : {crlf, one_line}) {
        const Scene b = cgfs_scene(other);
        EXPECT_EQ(a.get<Sphere>()[0].center, b.get<Sphere>()[0].center);
        EXPECT_EQ(a.materials[0].color, b.materials[0].color);
        EXPECT_EQ(a.lights[0].color, b.lights[0].color);
    }
}

TEST(Cgfs, SeveralTextsAreOneScene) {
    const std::string spheres(k_sphere), lights(k_light);
    const SceneText texts[] = {{"spheres.cgfs", spheres, {}}, {"lights", lights, "cgfs"}};
    const Result<Scene> result = load(texts);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result.diagnostics.empty());
    EXPECT_EQ(result->shapes.size(), 1u);
    EXPECT_EQ(result->lights.size(), 1u);
    EXPECT_EQ(result->files, (std::vector<std::string>{"spheres.cgfs", "lights"}));
    EXPECT_EQ(result->light_texts.place(0), (SourcePlace{1, 1, 1}));
}

TEST(Cgfs, AListingWithoutLightsIsASceneWithAWarning) {
    const Result<Scene> result = load_text(k_sphere, "a.cgfs");
    ASSERT_TRUE(result);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_NE(result.diagnostics[0].message.find("no lights"), std::string::npos);
}

}  // namespace
}  // namespace glint::test
