// SPDX-License-Identifier: Apache-2.0
// validate() checks every number of a scene made in code: one invalid scene per row, with its message.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "glint/scene.h"
#include "glint/world.h"
#include "math/transform.h"

namespace glint::test {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_inf = std::numeric_limits<double>::infinity();

Scene good_scene() {
    Scene scene;
    scene.lights.push_back({});
    scene.materials.push_back({});
    scene.transforms.push_back({});
    scene.add(Sphere{{0, 0, -5}, 1}, 0, 0);
    scene.add(Plane{{0, -1, 0}, {0, 1, 0}});
    scene.add(Cylinder{{0, 0, 0}, {0, 1, 0}, 1});
    return scene;
}

TEST(Validate, ValidScenesHaveNoDiagnostics) { EXPECT_TRUE(validate(good_scene()).empty()); }

TEST(Validate, ErrorsNameTheItemByItsIndex) {
    const struct {
        SceneItem item;
        std::uint32_t index;
        const char* path;
        std::function<void(Scene&)> breaks;
    } cases[] = {
        {SceneItem::camera, 0, "camera", [](Scene& s) { s.camera.fov_degrees = 0; }},
        {SceneItem::background, 0, "background", [](Scene& s) { s.background.g = k_nan; }},
        {SceneItem::setting, static_cast<std::uint32_t>(*find_setting("epsilon")), "settings",
         [](Scene& s) { s.conventions.epsilon = -1; }},
        {SceneItem::light, 1, "lights[1]",
         [](Scene& s) {
             s.lights.push_back({.position = {k_inf, 0, 0}});
         }},
        {SceneItem::material, 2, "materials[2]",
         [](Scene& s) {
             s.materials.resize(3);
             s.materials[2].ior = 0;
         }},
        {SceneItem::transform, 0, "transforms[0]", [](Scene& s) { s.transforms[0].m[0][0] = 0; }},
        {SceneItem::shape, 2, "shapes[2]", [](Scene& s) { s.get<Cylinder>()[0].radius = 0; }},
        {SceneItem::shape, 0, "shapes[0]", [](Scene& s) { s.shapes[0].material = 7; }},
        {SceneItem::fog, 0, "fog", [](Scene& s) { s.fog = Fog{.density = -1}; }},
    };
    for (const auto& [item, index, path, breaks] : cases) {
        Scene scene = good_scene();
        breaks(scene);
        const std::vector<Diagnostic> diagnostics = validate(scene);
        ASSERT_EQ(diagnostics.size(), 1u) << path;
        EXPECT_EQ(diagnostics[0].item, item) << path;
        EXPECT_EQ(diagnostics[0].index, index) << path;
        EXPECT_EQ(item_path(diagnostics[0]), path);
        // A scene has one camera and one fog, so the message has no index.
        const bool is_one = item < SceneItem::light || item == SceneItem::fog;
        const std::string place = is_one ? "" : std::string(path) + ": ";
        EXPECT_EQ(to_string(diagnostics[0]), place + "error: " + diagnostics[0].message + "\n");
        // The same through a function that returns a Result.
        const Result<World> prepared = prepare(scene);
        EXPECT_EQ(prepared.code, ErrorCode::invalid_scene);
        EXPECT_EQ(prepared.message, place + diagnostics[0].message);
    }
    Scene scene = good_scene();
    scene.lights.clear();
    const std::vector<Diagnostic> warnings = validate(scene);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_EQ(warnings[0].item, SceneItem::none);
    EXPECT_EQ(item_path(warnings[0]), "");
}

struct Broken {
    const char* message;
    std::function<void(Scene&)> make;
};

class BrokenScenes : public testing::TestWithParam<Broken> {};

TEST_P(BrokenScenes, AreErrors) {
    Scene scene = good_scene();
    GetParam().make(scene);
    const auto diagnostics = validate(scene);
    ASSERT_FALSE(diagnostics.empty());
    EXPECT_EQ(diagnostics[0].severity, Severity::error);
    EXPECT_NE(diagnostics[0].message.find(GetParam().message), std::string::npos) << diagnostics[0].message;
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, BrokenScenes,
    testing::Values(
        Broken{"sphere 1: radius: expected a number > 0", [](Scene& s) { s.get<Sphere>()[0].radius = 0; }},
        Broken{"found -1", [](Scene& s) { s.get<Sphere>()[0].radius = -1; }},
        Broken{"found nan", [](Scene& s) { s.get<Sphere>()[0].radius = k_nan; }},
        Broken{"found inf", [](Scene& s) { s.get<Sphere>()[0].radius = k_inf; }},
        Broken{"sphere 1: expected a center within 1e12",
               [](Scene& s) { s.get<Sphere>()[0].center.y = k_nan; }},
        Broken{"within 1e12", [](Scene& s) { s.get<Sphere>()[0].center.z = -1e13; }},
        Broken{"plane 2: expected a normal",
               [](Scene& s) {
                   s.get<Plane>()[0].normal = {0, 0, 0};
               }},
        Broken{"plane 2: expected a normal", [](Scene& s) { s.get<Plane>()[0].normal.x = k_inf; }},
        Broken{"plane 2: expected a point", [](Scene& s) { s.get<Plane>()[0].point.x = k_inf; }},
        Broken{"cylinder 3: expected an axis of some length",
               [](Scene& s) { s.get<Cylinder>()[0].to = s.get<Cylinder>()[0].from; }},
        Broken{"cylinder 3: expected an axis within", [](Scene& s) { s.get<Cylinder>()[0].to.x = k_nan; }},
        Broken{"cylinder 3: radius", [](Scene& s) { s.get<Cylinder>()[0].radius = 0; }},
        Broken{"sphere 1: no such material", [](Scene& s) { s.shapes[0].material = 1; }},
        Broken{"sphere 1: no such transform", [](Scene& s) { s.shapes[0].transform = 7; }},
        Broken{"sphere 1: no such parameters", [](Scene& s) { s.shapes[0].index = 1; }},
        Broken{"no such kind of shape", [](Scene& s) { s.shapes[0].kind = static_cast<ShapeKind>(200); }}));

INSTANTIATE_TEST_SUITE_P(
    Camera, BrokenScenes,
    testing::Values(
        Broken{"at the point that it looks at", [](Scene& s) { s.camera.look_at = s.camera.position; }},
        Broken{"along its view direction",
               [](Scene& s) {
                   s.camera.up = {0, 0, 2};
               }},
        Broken{"along its view direction",
               [](Scene& s) {
                   s.camera.up = {1e-200, 0, -1e-180};
               }},
        Broken{"up: expected a direction",
               [](Scene& s) {
                   s.camera.up = {0, 0, 0};
               }},
        Broken{"field of view: expected an angle", [](Scene& s) { s.camera.fov_degrees = 0; }},
        Broken{"field of view", [](Scene& s) { s.camera.fov_degrees = 180; }},
        Broken{"field of view", [](Scene& s) { s.camera.fov_degrees = k_nan; }},
        Broken{"position: expected coordinates", [](Scene& s) { s.camera.position.x = k_nan; }},
        Broken{"target: expected coordinates", [](Scene& s) { s.camera.look_at.x = 2e12; }},
        Broken{"lighting eye",
               [](Scene& s) {
                   s.camera.lighting_eye = Vec3{k_inf, 0, 0};
               }},
        Broken{"width: expected a number > 0",
               [](Scene& s) {
                   s.camera.projection = Projection::orthographic;
                   s.camera.width = 0;
               }},
        Broken{"lie in one plane",
               [](Scene& s) {
                   s.camera.frame = CameraFrame{{1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
               }},
        Broken{"forward: expected a direction",
               [](Scene& s) {
                   s.camera.frame = CameraFrame{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
               }},
        Broken{"no such projection", [](Scene& s) { s.camera.projection = static_cast<Projection>(9); }}));

INSTANTIATE_TEST_SUITE_P(
    Rest, BrokenScenes,
    testing::Values(
        Broken{"background: expected each channel", [](Scene& s) { s.background.g = k_nan; }},
        Broken{"light 1: color", [](Scene& s) { s.lights[0].color.b = k_inf; }},
        Broken{"light 1: specular color", [](Scene& s) { s.lights[0].specular_color.b = k_nan; }},
        Broken{"light 1: position", [](Scene& s) { s.lights[0].position.x = k_nan; }},
        Broken{"light 1: direction: expected a direction",
               [](Scene& s) {
                   s.lights[0].kind = LightKind::directional;
                   s.lights[0].to_light = {0, 0, 0};
               }},
        Broken{"light 1: attenuation: expected a number from 0",
               [](Scene& s) { s.lights[0].attenuation.c1 = -1; }},
        Broken{"light 1: attenuation: expected one of",
               [](Scene& s) {
                   s.lights[0].attenuation = {0, 0, 0};
               }},
        Broken{"light 1: fade distance", [](Scene& s) { s.lights[0].fade_distance = -1; }},
        Broken{"light 1: fade power", [](Scene& s) { s.lights[0].fade_power = k_nan; }},
        Broken{"light 1: axis: expected a direction",
               [](Scene& s) {
                   s.lights[0].kind = LightKind::spot;
                   s.lights[0].axis = {0, 0, 0};
               }},
        Broken{"light 1: outer angle: expected an angle > 0",
               [](Scene& s) {
                   s.lights[0].kind = LightKind::spot;
                   s.lights[0].outer_angle = s.lights[0].inner_angle = 0;
               }},
        Broken{"light 1: inner angle: expected at most the outer angle of 30 degrees, found 31",
               [](Scene& s) {
                   s.lights[0].kind = LightKind::spot;
                   s.lights[0].outer_angle = 30;
                   s.lights[0].inner_angle = 31;
               }},
        Broken{"light 1: tightness",
               [](Scene& s) {
                   s.lights[0].kind = LightKind::spot;
                   s.lights[0].tightness = -1;
               }},
        Broken{"light 1: expected sides that are not parallel, found (1, 0, 0) and (-2, 0, 0)",
               [](Scene& s) {
                   s.lights[0].kind = LightKind::parallelogram;
                   s.lights[0].side_v = {-2, 0, 0};
               }},
        Broken{"light 1: samples u: expected a whole number from 1 to 64, found 0",
               [](Scene& s) {
                   s.lights[0].kind = LightKind::parallelogram;
                   s.lights[0].samples_u = 0;
               }},
        Broken{"light 1: adaptive: expected a whole number from 0 to 16, found 17",
               [](Scene& s) {
                   s.lights[0].kind = LightKind::sphere;
                   s.lights[0].adaptive = 17;
               }},
        Broken{"torus 4: tube: expected a number > 0",
               [](Scene& s) {
                   s.add(Torus{{}, {0, 1, 0}, 1, 0});
               }},
        Broken{"torus 4: expected an axis other than (0, 0, 0)",
               [](Scene& s) {
                   s.add(Torus{{}, {0, 0, 0}});
               }},
        Broken{"disc 4: hole: expected a number from 0 to 1e12",
               [](Scene& s) {
                   s.add(Disc{{}, {0, 1, 0}, 1, -1});
               }},
        Broken{"disc 4: expected a hole smaller than the radius 1, found 1",
               [](Scene& s) {
                   s.add(Disc{{}, {0, 1, 0}, 1, 1});
               }},
        Broken{"light 1: radius: expected a number > 0",
               [](Scene& s) {
                   s.lights[0].kind = LightKind::disc;
                   s.lights[0].radius = 0;
               }},
        Broken{"no such kind of light", [](Scene& s) { s.lights[0].kind = static_cast<LightKind>(9); }},
        Broken{"material 1: color", [](Scene& s) { s.materials[0].color.r = k_nan; }},
        Broken{"material 1: ambient", [](Scene& s) { s.materials[0].ambient.r = k_nan; }},
        Broken{"material 1: diffuse", [](Scene& s) { s.materials[0].diffuse.r = k_nan; }},
        Broken{"material 1: specular", [](Scene& s) { s.materials[0].specular.r = 1e7; }},
        Broken{"material 1: shininess", [](Scene& s) { s.materials[0].shininess = -1; }},
        Broken{"material 1: mirror: expected a number from 0 to 1",
               [](Scene& s) { s.materials[0].mirror = 1.1; }},
        Broken{"material 1: mirror tint", [](Scene& s) { s.materials[0].mirror_tint.r = -1; }},
        Broken{"material 1: transmission", [](Scene& s) { s.materials[0].transmission = -0.1; }},
        Broken{"material 1: index of refraction", [](Scene& s) { s.materials[0].ior = 0; }},
        Broken{"material 1: transmission tint", [](Scene& s) { s.materials[0].transmission_tint.g = k_nan; }},
        Broken{"material 1: filter: expected a number from 0 to 1",
               [](Scene& s) { s.materials[0].filter = -0.1; }},
        Broken{"material 1: transmit: expected a number from 0 to 1",
               [](Scene& s) { s.materials[0].transmit = k_nan; }},
        Broken{"material 1: outline: expected a number from 0 to 1",
               [](Scene& s) { s.materials[0].outline = 1.5; }},
        Broken{"material 1: width of the outline: expected a number from 0 to 1",
               [](Scene& s) { s.materials[0].outline_width = -0.5; }},
        Broken{"material 1: filter + transmit: expected at most 1, found 0.5 + 0.75",
               [](Scene& s) { s.materials[0].filter = 0.5, s.materials[0].transmit = 0.75; }},
        Broken{"material 1: expected `angled_opacity` or `filter`, found both: the angle changes `transmit` "
               "alone",
               [](Scene& s) { s.materials[0].filter = 0.5, s.materials[0].angled_opacity = true; }},
        Broken{"material 1: expected `transmission` (with refraction) or `filter` and `transmit` (without), "
               "found both",
               [](Scene& s) { s.materials[0].transmission = 0.5, s.materials[0].transmit = 0.5; }},
        Broken{"limit: expected keep", [](Scene& s) { s.conventions.limit = static_cast<LimitRule>(3); }},
        Broken{"transparency: expected highlights",
               [](Scene& s) { s.conventions.transparency = static_cast<Transparency>(3); }},
        Broken{"transparent_surfaces: expected a whole number",
               [](Scene& s) { s.conventions.transparent_surfaces = 4097; }},
        Broken{"transform 1 flattens", [](Scene& s) { s.transforms[0].m[1][1] = 0; }},
        Broken{"transform 1: expected numbers", [](Scene& s) { s.transforms[0].m[1][3] = k_nan; }},
        Broken{"size: expected WIDTHxHEIGHT", [](Scene& s) { s.settings.width = 0; }},
        Broken{"size: expected WIDTHxHEIGHT", [](Scene& s) { s.settings.height = k_max_size + 1; }},
        Broken{"reflections: expected a whole number", [](Scene& s) { s.settings.reflections = -1; }},
        Broken{"aa: expected a whole number", [](Scene& s) { s.settings.samples = 65; }},
        Broken{"epsilon: expected a number", [](Scene& s) { s.conventions.epsilon = k_nan; }},
        Broken{"offset: expected ray", [](Scene& s) { s.conventions.offset = static_cast<Offset>(77); }}));

TEST(Validate, SmallAndLargeScenesAreValid) {
    Scene scene = good_scene();
    scene.get<Sphere>()[0] = {{1e12, -1e12, 0}, 1e-300};
    scene.get<Plane>()[0].normal = {0, 1e-300, 0};
    scene.camera.up = {0, 1e-200, 0};
    scene.camera.look_at = {1e-200, 0, 0};
    scene.camera.position = {0, 0, 1e-200};
    scene.transforms[0] = {{{1e-6, 0, 0, 1e9}, {0, 1e6, 0, 0}, {0, 0, -1, 0}}};
    EXPECT_TRUE(validate(scene).empty()) << validate(scene)[0].message;
}

TEST(Validate, MapsOfMeshesAreWellConditioned) {
    MeshData data;
    data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    data.triangles = {{0, 1, 2}};
    Scene scene;
    scene.files = {"a.glint"};
    scene.lights.emplace_back();
    scene.meshes.push_back(std::make_shared<const MeshData>(data));
    scene.transforms = {compose(rotation_x(30), scaling({1, 1, 1e-9}))};
    scene.add(Mesh{0}, k_none, 0);
    scene.shape_texts.places = {{12, 3, 0}};
    EXPECT_TRUE(validate(scene).empty()) << validate(scene)[0].message;
    scene.transforms[0] = compose(rotation_x(30), compose(scaling({9e-9, 1, 1}), rotation_y(40)));
    const auto diagnostics = validate(scene);
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(diagnostics[0].message,
              "mesh 1: expected a transform with a condition number of at most 1e7, found 7.24e+07");
    EXPECT_EQ(diagnostics[0].line, 12u);
    scene.transforms[0] = compose(rotation_x(30), compose(scaling({2e-7, 1, 1}), rotation_y(40)));
    EXPECT_TRUE(validate(scene).empty()) << validate(scene)[0].message;
    // Large or small is not badly conditioned, and other shapes have other formulas.
    scene.transforms[0] = scaling({1e-9, 1e-9, -1e-9});
    EXPECT_TRUE(validate(scene).empty()) << validate(scene)[0].message;
    scene.transforms[0] = scaling({1, 1, 1e-8});
    scene.shapes.clear();
    scene.add(Sphere{{0, 0, 0}, 1}, k_none, 0);
    EXPECT_TRUE(validate(scene).empty()) << validate(scene)[0].message;
}

TEST(Validate, StopsAfterTwentyErrors) {
    Scene scene = good_scene();
    for (int i = 0; i < 1000; ++i) scene.add(Sphere{{0, 0, 0}, -1});
    EXPECT_EQ(validate(scene).size(), 20u);
}

TEST(Validate, NamesAndPlacesAreThoseOfTheItem) {
    Scene scene = good_scene();
    scene.files = {"a.cgfs", "b.cgfs"};
    scene.get<Sphere>()[0].radius = 0;
    scene.shape_texts.names[0] = "ball";
    scene.shape_texts.places = {{12, 3, 1}};
    const auto diagnostics = validate(scene);
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(diagnostics[0].message.substr(0, 14), "sphere 'ball':");
    EXPECT_EQ(diagnostics[0].file, "b.cgfs");
    EXPECT_EQ(diagnostics[0].line, 12u);
    EXPECT_EQ(diagnostics[0].column, 3u);
}

TEST(Validate, WarnsAboutScenesWithoutLightsOrShapes) {
    Scene scene = good_scene();
    scene.lights.clear();
    ASSERT_EQ(validate(scene).size(), 1u);
    EXPECT_EQ(validate(scene)[0].severity, Severity::warning);
    EXPECT_EQ(validate(scene)[0].message,
              "the scene has no lights: the picture will be black but for its background");
    scene.materials.push_back({.emission = {1, 0.5, 0}});
    EXPECT_EQ(validate(scene)[0].message,
              "the scene has no lights: only its background and what emits light will be seen");
    scene.settings.shading = Shading::normals;
    EXPECT_TRUE(validate(scene).empty());
    ASSERT_EQ(validate(Scene{}).size(), 1u);
    EXPECT_EQ(validate(Scene{})[0].message, "the scene has no shapes: the picture shows only its background");
}

TEST(Validate, OmittedConesAreReportedOnce) {
    Scene scene = good_scene();
    scene.add(Cone{{0, 0, 0}, {0, 1, 0}, 1, 0, true});
    scene.add(Cone{{0, 3, 0}, {0, 1, 0}, 1, 0, true});
    EXPECT_TRUE(validate(scene).empty());
    ASSERT_TRUE(apply_profile(scene, "csc473"));
    const auto diagnostics = validate(scene);
    ASSERT_EQ(diagnostics.size(), 1u);
    EXPECT_EQ(diagnostics[0].severity, Severity::note);
    EXPECT_EQ(diagnostics[0].message,
              "the conventions of csc473 ignore cones; `--convention cones=true` renders them");
}

TEST(Scene, ItemTextsOfScenesMadeInCodeAreEmpty) {
    const ItemTexts texts;
    EXPECT_EQ(texts.name(0), "");
    EXPECT_EQ(texts.place(5), SourcePlace{});
}

TEST(Scene, ShapeKindsHaveWords) {
    EXPECT_EQ(to_string(ShapeKind::sphere), "sphere");
    EXPECT_EQ(to_string(ShapeKind::cylinder), "cylinder");
    EXPECT_EQ(to_string(static_cast<ShapeKind>(250)), "unknown shape");
}

}  // namespace
}  // namespace glint::test
