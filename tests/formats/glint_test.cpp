// SPDX-License-Identifier: Apache-2.0
// .glint: the Scene that each block gives.
#include <map>

#include "formats/load_text.h"
#include "math/transform.h"

namespace glint::test {
namespace {

constexpr std::string_view k_camera = "camera { position = (0, 0, 5)  look_at = (0, 0, 0) }\n";

/// Texts by name, for includes.
class MapSources : public Sources {
  public:
    std::map<std::string, std::string> texts;
    int reads = 0;
    Result<std::string> read(std::string_view name, std::string_view from) override {
        ++reads;
        const std::string path = std::string(from.substr(0, from.rfind('/') + 1)) + std::string(name);
        const auto at = texts.find(path);
        if (at != texts.end()) return at->second;
        return Status{ErrorCode::io, "no such file", {}};
    }
};

std::string printed(const Result<Scene>& result) {
    std::string all;
    for (const Diagnostic& d : result.diagnostics) all += to_string(d);
    return all;
}

Scene scene_of(std::string_view text, Sources* sources = nullptr, const LoadOptions& options = {}) {
    Result<Scene> result = load_text(text, "a.glint", options, sources);
    EXPECT_TRUE(result) << printed(result);
    return result ? *std::move(result) : Scene{};
}

// Loads shapes, with the camera that a scene needs.
Scene shapes_of(const std::string& text, Sources* sources = nullptr) {
    return scene_of(std::string(k_camera) + text, sources);
}

std::string errors_of(const std::string& text, Sources* sources = nullptr) {
    const Result<Scene> result = load_text(text, "a.glint", {}, sources);
    EXPECT_FALSE(result);
    return printed(result);
}

const std::string k_ball = "sphere { center = (0, 0, 0)  radius = 1 ";

TEST(Glint, ReadsEveryShape) {
    const Scene s = shapes_of(R"(
        sphere "ball" { center = (1, 2, 3)  radius = 4 }
        plane { point = (0, -1, 0)  normal = (0, 2, 0) }
        cylinder { from = (0, 0, 0)  to = (0, 1, 0)  radius = 0.5 }
        cylinder { from = (0, 0, 0)  to = (0, 1, 0)  radius = 0.5  caps = false }
        cone { from = (0, 0, 0)  to = (0, 1, 0)  radius = (0.5, 0.25)  caps = false }
        cone { from = (0, 0, 0)  to = (0, 1, 0)  radius = 2 }
        disc { center = (0, 0, 1)  normal = (0, 0, 1)  radius = 3 }
        box { min = (-1, -2, -3)  max = (1, 2, 3) }
        triangle { vertices = ((0, 0, 0), (1, 0, 0), (0, 1, 0)) }
        triangle { vertices = ((0, 0, 0), (1, 0, 0), (0, 1, 0))  normals = ((0, 0, 1), (0, 1, 1), (1, 0, 1)) }
        polygon { vertices = ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)) }
        torus { center = (1, 2, 3)  axis = (0, 0, 2)  radius = 2  tube = 0.5 }
        disc { center = (0, 0, 1)  normal = (0, 0, 1)  radius = 3  hole = 1 }
    )");
    ASSERT_EQ(s.shapes.size(), 13u);
    EXPECT_EQ(s.get<Torus>()[0].center, (Vec3{1, 2, 3}));
    EXPECT_EQ(s.get<Torus>()[0].axis, (Vec3{0, 0, 2}));
    EXPECT_EQ(s.get<Torus>()[0].radius, 2);
    EXPECT_EQ(s.get<Torus>()[0].tube, 0.5);
    EXPECT_EQ(s.get<Disc>()[0].hole, 0);
    EXPECT_EQ(s.get<Disc>()[1].hole, 1);
    EXPECT_EQ(s.shape_texts.name(0), "ball");
    EXPECT_EQ(s.shape_texts.place(0).line, 3u);
    EXPECT_EQ(s.get<Sphere>()[0].center, (Vec3{1, 2, 3}));
    EXPECT_EQ(s.get<Sphere>()[0].radius, 4);
    EXPECT_EQ(s.get<Plane>()[0].normal, (Vec3{0, 2, 0}));
    EXPECT_TRUE(s.get<Cylinder>()[0].caps) << "solids are closed unless the text says otherwise";
    EXPECT_FALSE(s.get<Cylinder>()[1].caps);
    EXPECT_EQ(s.get<Cone>()[0].to_radius, 0.25);
    EXPECT_FALSE(s.get<Cone>()[0].caps);
    EXPECT_EQ(s.get<Cone>()[1].from_radius, 2);
    EXPECT_EQ(s.get<Cone>()[1].to_radius, 0);
    EXPECT_TRUE(s.get<Cone>()[1].caps);
    EXPECT_EQ(s.get<Disc>()[0].radius, 3);
    EXPECT_EQ(s.get<Box>()[0].min, (Vec3{-1, -2, -3}));
    EXPECT_EQ(s.get<Triangle>()[0].vertices[1], (Vec3{1, 0, 0}));
    EXPECT_EQ(s.get<SmoothTriangle>()[0].normals[2], (Vec3{1, 0, 1}));
    EXPECT_EQ(s.get<Polygon>()[0].count, 4u);
    EXPECT_EQ(s.polygon_vertices[2], (Vec3{1, 1, 1}));
    for (const Shape& shape : s.shapes) {
        EXPECT_EQ(shape.material, k_none);
        EXPECT_EQ(shape.transform, k_none);
    }
}

TEST(Glint, ReadsColorsInThreeWays) {
    const Scene s = shapes_of(
        "material a { color = (0.25, 0.5, 1) }\n"
        "material b { color = rgb255(200, 160, 40) }\n"
        "material c { color = \"#c8A028\" }\n"
        "material d { color = \"#fb0\" }\n");
    EXPECT_EQ(s.materials[0].color, (Color{0.25, 0.5, 1}));
    EXPECT_EQ(s.materials[1].color, (Color{200 / 255.0, 160 / 255.0, 40 / 255.0}));
    EXPECT_EQ(s.materials[2].color, s.materials[1].color);
    EXPECT_EQ(s.materials[3].color, (Color{1, 187 / 255.0, 0}));
}

TEST(Glint, MakesMaterialsOfCoefficientsAndOfColors) {
    const Scene s = shapes_of(R"(
        material empty { }
        material gold { color = (0.5, 0.25, 0)  ambient = 0.2  diffuse = 0.6  specular = 0.8  shininess = 40  mirror = 0.3 }
        material plain { color = (0.5, 0.25, 1) }
        material brass { ambient_color = (0.33, 0.22, 0.03)  diffuse_color = (3, 0.57, 0.11)  specular_color = (0.99, 0.94, 0.81)
                         ambient = 0.5 }
        material glass { mirror_color = (1, 0.5, 0)  transmission = 0.9  transmission_color = (0, 0.5, 1)  ior = 1.5 })");
    const auto equal = [](const Material& a, const Material& b) {
        return a.color == b.color && a.ambient == b.ambient && a.diffuse == b.diffuse &&
               a.specular == b.specular && a.shininess == b.shininess && a.mirror == b.mirror &&
               a.mirror_tint == b.mirror_tint && a.transmission == b.transmission && a.ior == b.ior &&
               a.transmission_tint == b.transmission_tint;
    };
    EXPECT_TRUE(equal(s.materials[0], Material{}));
    const Color gold{0.5, 0.25, 0};
    EXPECT_EQ(s.materials[1].ambient, gold * 0.2);
    EXPECT_EQ(s.materials[1].diffuse, gold * 0.6);
    EXPECT_EQ(s.materials[1].specular, gold * 0.8);
    EXPECT_EQ(s.materials[1].shininess, 40);
    EXPECT_EQ(s.materials[1].mirror, 0.3);
    EXPECT_EQ(s.materials[2].ambient, (Color{0.5, 0.25, 1} * 0.1));
    EXPECT_EQ(s.materials[2].diffuse, (Color{0.5, 0.25, 1} * 0.8));
    EXPECT_EQ(s.materials[2].specular, (Color{0, 0, 0}));
    EXPECT_EQ(s.materials[3].ambient, (Color{0.33, 0.22, 0.03})) << "the color overrides the coefficient";
    EXPECT_EQ(s.materials[3].diffuse, (Color{3, 0.57, 0.11}));
    EXPECT_EQ(s.materials[3].specular, (Color{0.99, 0.94, 0.81}));
    EXPECT_EQ(s.materials[3].color, Material{}.color);
    EXPECT_EQ(s.materials[4].mirror_tint, (Color{1, 0.5, 0}));
    EXPECT_EQ(s.materials[4].transmission, 0.9);
    EXPECT_EQ(s.materials[4].transmission_tint, (Color{0, 0.5, 1}));
    EXPECT_EQ(s.materials[4].ior, 1.5);
    EXPECT_EQ(s.material_texts.name(1), "gold");
    EXPECT_EQ(s.material_texts.place(1).line, 4u);
}

TEST(Glint, MaterialsMayBeUsedBeforeTheyAreDefined) {
    const Scene s =
        shapes_of(k_ball + "material = late }\n" + k_ball + "material = \"two words\"  ior = 2 }\n" +
                  "group { material = late  mirror = 0.5 " + k_ball +
                  "ior = 3 } }\n"
                  "material late { color = (1, 0, 0)  diffuse = 0.5 }\n"
                  "material \"two words\" { color = (0, 1, 0) }\n");
    const auto of = [&](std::size_t i) { return s.materials[s.shapes[i].material]; };
    EXPECT_EQ(of(0).diffuse, (Color{0.5, 0, 0}));
    EXPECT_EQ(s.material_texts.name(s.shapes[0].material), "late");
    EXPECT_EQ(s.material_texts.place(s.shapes[0].material).line, 5u);
    EXPECT_EQ(of(1).color, (Color{0, 1, 0}));
    EXPECT_EQ(of(1).ior, 2);
    EXPECT_EQ(of(2).diffuse, (Color{0.5, 0, 0}));
    EXPECT_EQ(of(2).mirror, 0.5);
    EXPECT_EQ(of(2).ior, 3);
}

TEST(Glint, MaterialsInABlockStartFromTheCurrentOne) {
    const Scene s =
        shapes_of("material gold { color = (1, 0.5, 0)  diffuse = 0.5  shininess = 40 }\n" + k_ball +
                  "color = (0, 1, 0)  shininess = 10 }\n" + k_ball + "shininess = 10  color = (0, 1, 0) }\n" +
                  k_ball + "color = (0, 0, 1)  material = gold }\n" + "group { material = gold " + k_ball +
                  "shininess = 9 } " + k_ball + "} }");
    const auto of = [&](std::size_t i) { return s.materials[s.shapes[i].material]; };
    EXPECT_EQ(of(0).color, (Color{0, 1, 0}));
    EXPECT_EQ(of(0).shininess, 10);
    EXPECT_EQ(s.shapes[0].material, s.shapes[1].material) << "equal materials are shared";
    EXPECT_EQ(of(2).diffuse, (Color{0, 0, 0.5}));
    EXPECT_EQ(of(2).shininess, 40);
    EXPECT_EQ(of(3).color, (Color{1, 0.5, 0}));
    EXPECT_EQ(of(3).shininess, 9);
    EXPECT_EQ(s.shapes[4].material, 0u);
    EXPECT_EQ(s.materials.size(), 4u);
}

TEST(Glint, ReadsColorsOfShapes) {
    const Scene s = shapes_of(R"(
        material gold { color = (0.8, 0.6, 0.2)  mirror = 0.3 }
        )" + k_ball + R"( material = gold }
        )" + k_ball + R"( material = gold  shape_color = (0.1, 0.5, 1) }
        triangle { vertices = ((0, 0, 0), (1, 0, 0), (0, 1, 0))  shape_color = rgb255(255, 128, 0) }
        group { material = gold  )" +
                              k_ball + R"( shape_color = "#00ff00"  translate = (1, 0, 0) } }
        )" + k_ball + "}");
    EXPECT_EQ(s.materials.size(), 1u) << "one material for all";
    ASSERT_EQ(s.shape_colors.size(), 4u);
    EXPECT_EQ(s.shape_color(0), std::nullopt);
    EXPECT_EQ(s.shape_color(1), (Color{0.1f, 0.5f, 1}));
    EXPECT_EQ(s.shape_color(2), (Color{1, static_cast<float>(128 / 255.0), 0}));
    EXPECT_EQ(s.shape_color(3), (Color{0, 1, 0}));
    EXPECT_EQ(s.shape_color(4), std::nullopt);
    EXPECT_EQ(s.shapes[1].material, 0u);
    EXPECT_EQ(s.shapes[3].material, 0u);
}

TEST(Glint, ReadsCameras) {
    const Scene plain =
        scene_of("camera { position = (0, 2, 8)  look_at = (0, 1, 0)  up = (0, 0, 1)  fov_y = 50 }");
    EXPECT_EQ(plain.camera.position, (Vec3{0, 2, 8}));
    EXPECT_EQ(plain.camera.look_at, (Vec3{0, 1, 0}));
    EXPECT_EQ(plain.camera.up, (Vec3{0, 0, 1}));
    EXPECT_EQ(plain.camera.fov_degrees, 50);
    EXPECT_EQ(plain.camera.fov_axis, FovAxis::y);
    EXPECT_FALSE(plain.camera.frame);
    const Scene flat = scene_of(
        "camera { projection = orthographic  width = 43  position = (0, 0, 30)  look_at = (0, 0, 0)  "
        "lighting_eye = (40, -10, 25) }");
    EXPECT_EQ(flat.camera.projection, Projection::orthographic);
    EXPECT_EQ(flat.camera.width, 43);
    EXPECT_EQ(flat.camera.lighting_eye, (Vec3{40, -10, 25}));
    const Scene frame = scene_of("camera { right = (1, 0, 0)  up = (0, 0.75, 0)  forward = (0, 0, 1) }");
    EXPECT_EQ(frame.camera.frame, (CameraFrame{{1, 0, 0}, {0, 0.75, 0}, {0, 0, 1}}));
}

TEST(Glint, ReadsLights) {
    const Scene s = shapes_of(R"(light { type = ambient  intensity = 0.2 }
        light "key" { type = point  position = (2, 4, 5)  color = (1, 0.5, 0.25)  specular_color = (1, 1, 1)
                      attenuation = (1, 0.1, 0.01)  intensity = 2 }
        light { position = (1, 2, 3)  color = (1, 0.5, 0.25)  intensity = 0.5 }
        light { type = directional  to_light = (1, 4, 4) }
        light { type = directional  direction = (1, 4, 4) })");
    EXPECT_EQ(s.lights[0].kind, LightKind::ambient);
    EXPECT_EQ(s.lights[0].color, (Color{0.2, 0.2, 0.2}));
    EXPECT_EQ(s.light_texts.name(1), "key");
    EXPECT_EQ(s.lights[1].color, (Color{2, 1, 0.5}));
    EXPECT_EQ(s.lights[1].specular_color, (Color{2, 2, 2}));
    EXPECT_EQ(s.lights[1].attenuation, (Attenuation{1, 0.1, 0.01}));
    EXPECT_EQ(s.lights[2].kind, LightKind::point);
    EXPECT_EQ(s.lights[2].specular_color, (Color{0.5, 0.25, 0.125}));
    EXPECT_EQ(s.lights[3].to_light, (Vec3{1, 4, 4}));
    EXPECT_EQ(s.lights[4].to_light, (Vec3{1, 4, 4}));
}

TEST(Glint, ReadsSpots) {
    const Scene s = shapes_of(R"(light { type = spot  position = (2, 4, 5)  axis = (0, -2, 0) }
        light { type = spot  position = (2, 4, 5)  target = (1, 0, 5)  inner_angle = 10  outer_angle = 10
                tightness = 3  fade_distance = 2  fade_power = 1.5  casts_shadows = false }
        light { target = (1, 2, 3)  position = (1, 2, 3)  axis = (0, 0, 1) })");
    EXPECT_EQ(s.lights[0].kind, LightKind::spot);
    EXPECT_EQ(s.lights[0].axis, (Vec3{0, -2, 0}));
    EXPECT_EQ(s.lights[0].inner_angle, 30);
    EXPECT_EQ(s.lights[0].outer_angle, 45);
    EXPECT_TRUE(s.lights[0].casts_shadows);
    const Light& other = s.lights[1];
    EXPECT_EQ(other.axis, (Vec3{-1, -4, 0}));
    EXPECT_EQ(other.inner_angle, 10);
    EXPECT_EQ(other.outer_angle, 10);
    EXPECT_EQ(other.tightness, 3);
    EXPECT_EQ(other.fade_distance, 2);
    EXPECT_EQ(other.fade_power, 1.5);
    EXPECT_FALSE(other.casts_shadows);
    EXPECT_EQ(s.lights[2].kind, LightKind::point) << "its target and its axis are ignored, with a warning";
}

TEST(Glint, ReadsSurfacesWithoutShadows) {
    const Scene s =
        shapes_of("material ghost { casts_shadow = false }\n" + k_ball + "material = ghost }\n" + k_ball +
                  "casts_shadow = false }\n" + k_ball + "material = ghost  casts_shadow = true }\n");
    EXPECT_FALSE(s.materials[s.shapes[0].material].casts_shadow);
    EXPECT_FALSE(s.materials[s.shapes[1].material].casts_shadow);
    EXPECT_TRUE(s.materials[s.shapes[2].material].casts_shadow);
}

TEST(Glint, ReadsTransparency) {
    const Scene s = shapes_of("material pane { color = (1, 0, 0)  filter = 0.7  transmit = 0.1 }\n" + k_ball +
                              "material = pane }\n" + k_ball + "material = pane  transmit = 0 }\n" + k_ball +
                              "transmit = 1 }\n");
    const Material& pane = s.materials[s.shapes[0].material];
    EXPECT_EQ(pane.filter, 0.7);
    EXPECT_EQ(pane.transmit, 0.1);
    EXPECT_EQ(s.materials[s.shapes[1].material].filter, 0.7);
    EXPECT_EQ(s.materials[s.shapes[1].material].transmit, 0);
    EXPECT_EQ(s.materials[s.shapes[2].material].transmit, 1);
}

TEST(Glint, ReadsAreaLights) {
    const Scene s = shapes_of(
        R"(light { type = parallelogram  position = (2, 4, 5)  side_u = (0, 2, 0)  side_v = (3, 0, 1)
                samples_u = 5  samples_v = 1  one_sided = true  adaptive = 0 }
        light { type = disc  position = (2, 4, 5)  target = (1, 0, 5)  radius = 0.5  jitter = true }
        light { type = sphere  position = (2, 4, 5)  radius = 2 })");
    EXPECT_EQ(s.lights[0].kind, LightKind::parallelogram);
    EXPECT_EQ(s.lights[0].side_u, (Vec3{0, 2, 0}));
    EXPECT_EQ(s.lights[0].side_v, (Vec3{3, 0, 1}));
    EXPECT_EQ(s.lights[0].samples_u, 5);
    EXPECT_EQ(s.lights[0].samples_v, 1);
    EXPECT_EQ(s.lights[0].adaptive, 0);
    EXPECT_TRUE(s.lights[0].one_sided);
    EXPECT_EQ(s.lights[1].axis, (Vec3{-1, -4, 0}));
    EXPECT_EQ(s.lights[1].radius, 0.5);
    EXPECT_TRUE(s.lights[1].jitter);
    EXPECT_EQ(s.lights[2].kind, LightKind::sphere);
    EXPECT_EQ(s.lights[2].samples_u, 4);
    EXPECT_EQ(s.lights[2].adaptive, k_all_levels);
    EXPECT_FALSE(s.lights[2].one_sided || s.lights[2].jitter);
}

TEST(Glint, AppliesTransformsInTheOrderWritten) {
    const Scene s = shapes_of(k_ball + "scale = (1, 2, 3)  translate = (1, 0, 0)  rotate = (0, 0, 90) }\n" +
                              k_ball + "rotate = (90, 90, 0) }\n" + k_ball +
                              "matrix = ((0.1, 0.2, 0.3, 4), (0, 1, 0.7, 5), (0, 0, 1, -0.0)) }\n" + k_ball +
                              "translate = (0, 0, 0)  scale = 1 }\n");
    ASSERT_EQ(s.transforms.size(), 4u);
    EXPECT_EQ(transform_point(s.transforms[0], {1, 1, 1}), (Vec3{-2, 2, 3}));
    // About x first: y goes to z, then about y: z goes to x.
    EXPECT_EQ(transform_point(s.transforms[1], {0, 1, 0}), (Vec3{1, 0, 0}));
    EXPECT_EQ(s.transforms[2], (Affine{{{0.1, 0.2, 0.3, 4}, {0, 1, 0.7, 5}, {0, 0, 1, 0}}}));
    EXPECT_TRUE(1 / s.transforms[2].m[2][3] < 0) << "the bits of the text, -0 too";
    EXPECT_EQ(s.transforms[3], Affine{}) << "the identity is kept, as in other formats";
}

TEST(Glint, GroupsApplyToTheirContents) {
    const Scene s =
        shapes_of("material gold { }\ngroup \"tower\" { material = gold  scale = 2  translate = (1, 0, 0) " +
                  k_ball + "}" + k_ball + "} group { rotate = (0, 0, 90) " + k_ball +
                  "translate = (0, 1, 0) }" + k_ball + "} } } " + k_ball + "}");
    ASSERT_EQ(s.shapes.size(), 5u);
    EXPECT_EQ(s.shapes[0].transform, s.shapes[1].transform);
    EXPECT_EQ(s.transforms.size(), 3u);
    const auto at = [&](std::size_t i, Vec3 p) {
        return transform_point(s.transforms[s.shapes[i].transform], p);
    };
    EXPECT_EQ(at(0, {1, 1, 1}), (Vec3{3, 2, 2}));
    EXPECT_EQ(at(2, {0, 0, 0}), (Vec3{-1, 0, 0})) << "the innermost first";
    EXPECT_EQ(at(3, {0, 1, 0}), (Vec3{-1, 0, 0}));
    for (const std::size_t i : {0, 1, 2, 3}) EXPECT_EQ(s.shapes[i].material, 0u);
    EXPECT_EQ(s.shapes[4].material, k_none);
    EXPECT_EQ(s.shapes[4].transform, k_none);
}

TEST(Glint, SetsConventionsAndSettings) {
    const std::string text =
        "profile = cgfs\nconventions { specular_gate = true  epsilon = 1e-3, offset = normal }\n"
        "render { size = 320 x 200  shading = blinn-phong; aa = 3 }\n" +
        std::string(k_camera);
    const Scene s = scene_of(text);
    EXPECT_EQ(s.profile, "cgfs");
    EXPECT_EQ(s.conventions.pixel_sample, PixelSample::corner);
    EXPECT_TRUE(s.conventions.specular_gate);
    EXPECT_EQ(s.conventions.offset, Offset::normal);
    EXPECT_EQ(s.settings.width, 320);
    EXPECT_EQ(s.settings.height, 200);
    EXPECT_EQ(s.settings.shading, Shading::blinn_phong);
    EXPECT_EQ(s.settings.samples, 3);
    EXPECT_EQ(s.settings.reflections, 3) << "the profile's";
    const SettingOrigin origin = s.origins[*find_setting("epsilon")];
    EXPECT_EQ(origin.kind, SettingOrigin::Kind::file);
    EXPECT_EQ(origin.place, (SourcePlace{2, 37, 0}));

    LoadOptions options;
    options.profile = "epfl";
    options.settings = {{"aa", "2"}};
    const Scene overridden = scene_of(text, nullptr, options);
    EXPECT_EQ(overridden.profile, "epfl");
    EXPECT_EQ(overridden.conventions.mirror_miss, MissRule::black);
    EXPECT_EQ(overridden.conventions.epsilon, 1e-3) << "explicit values in the text override a profile";
    EXPECT_EQ(overridden.settings.samples, 2);
    EXPECT_EQ(scene_of("render { size=64x48 }" + std::string(k_camera)).settings.height, 48);
}

TEST(Glint, RequiresACamera) {
    EXPECT_NE(errors_of("sphere { center = (0, 0, 0)  radius = 1 }").find("expected a camera"),
              std::string::npos);
    const SceneText texts[] = {{"a.glint", "sphere { center = (0, 0, 0)  radius = 1 }", {}},
                               {"b.glint", k_camera, {}}};
    EXPECT_TRUE(load(texts)) << "one of several texts has it";
}

TEST(Glint, TheFirstOfSeveralTextsHasTheProfile) {
    const SceneText texts[] = {{"a.glint", k_camera, {}},
                               {"b.glint", "profile = cgfs\nconventions { limit = drop }", {}}};
    const Result<Scene> result = load(texts);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->profile, "glint");
    EXPECT_EQ(result->conventions.limit, LimitRule::drop);
    EXPECT_NE(printed(result).find("b.glint:1:1: warning: glint ignores 'profile' here"), std::string::npos);
}

TEST(GlintInclude, AddsAnotherTextsItems) {
    MapSources sources;
    sources.texts = {
        {"parts/b.glint", "material gold { ior = 3 }\n" + k_ball + "material = gold }\ninclude \"c.glint\""},
        {"parts/c.glint", k_ball + "material = gold }"},
        {"d.cgfs", "sphere { center = (1, 2, 3) radius = 1 color = (0, 255, 0) }"}};
    const Scene s =
        shapes_of("include \"parts/b.glint\"\ninclude \"d.cgfs\"\n" + k_ball + "material = gold }", &sources);
    ASSERT_EQ(s.shapes.size(), 4u);
    EXPECT_EQ(s.shapes[0].material, s.shapes[1].material);
    EXPECT_EQ(s.shapes[0].material, s.shapes[3].material);
    EXPECT_EQ(s.materials[s.shapes[2].material].color, (Color{0, 1, 0}));
    EXPECT_EQ(s.files, (std::vector<std::string>{"a.glint", "parts/b.glint", "parts/c.glint", "d.cgfs"}));
    EXPECT_EQ(s.shape_texts.place(1), (SourcePlace{1, 1, 2}));
    EXPECT_EQ(s.shape_texts.place(3).file, 0);
    EXPECT_EQ(s.conventions, Conventions{}) << "those of the first text";
}

TEST(GlintInclude, InheritsTheEnclosingGroup) {
    MapSources sources;
    sources.texts = {{"b.glint", k_ball + "}" + k_ball + "ior = 2  translate = (1, 0, 0) }"},
                     {"d.cgfs", "sphere { center = (0, 0, 0) radius = 1 color = (0, 255, 0) }"}};
    const Scene s = shapes_of(
        "material gold { shininess = 9 }\ngroup { material = gold  scale = 2  include \"b.glint\" "
        "include \"d.cgfs\" }\ngroup { translate = (0, 5, 0)  include \"b.glint\" }",
        &sources);
    ASSERT_EQ(s.shapes.size(), 5u);
    EXPECT_EQ(sources.reads, 2) << "a text is read once";
    const auto at = [&](std::size_t i, Vec3 p) {
        return transform_point(s.transforms[s.shapes[i].transform], p);
    };
    EXPECT_EQ(at(0, {1, 1, 1}), (Vec3{2, 2, 2}));
    EXPECT_EQ(at(1, {0, 0, 0}), (Vec3{2, 0, 0}));
    EXPECT_EQ(at(2, {1, 0, 0}), (Vec3{2, 0, 0}));
    EXPECT_EQ(at(3, {0, 0, 0}), (Vec3{0, 5, 0}));
    EXPECT_EQ(at(4, {0, 0, 0}), (Vec3{1, 5, 0}));
    EXPECT_EQ(s.shapes[0].material, 0u);
    EXPECT_EQ(s.materials[s.shapes[2].material].color, (Color{0, 1, 0})) << "it has its own material";
    EXPECT_EQ(s.shapes[3].material, k_none);
}

TEST(GlintInclude, ItsCameraCountsOnlyIfThereIsNoOther) {
    MapSources sources;
    sources.texts = {
        {"b.glint", "camera { position = (7, 0, 0) }\nbackground = (0, 1, 0)\nrender { aa = 8 }"}};
    EXPECT_EQ(scene_of("include \"b.glint\"", &sources).camera.position, (Vec3{7, 0, 0}));
    for (const char* text : {"include \"b.glint\"\ncamera { position = (1, 0, 0) } background = (1, 0, 0)",
                             "camera { position = (1, 0, 0) } background = (1, 0, 0)\ninclude \"b.glint\""}) {
        const Result<Scene> result = load_text(text, "a.glint", {}, &sources);
        ASSERT_TRUE(result);
        EXPECT_EQ(result->camera.position, (Vec3{1, 0, 0}));
        EXPECT_EQ(result->background, (Color{1, 0, 0}));
        EXPECT_EQ(result->settings.samples, 1);
        EXPECT_NE(printed(result).find("camera"), std::string::npos);
        EXPECT_NE(printed(result).find("glint ignores 'render' here: the first file has the say"),
                  std::string::npos);
    }
}

TEST(GlintInclude, MistakesAreReportedAtTheirPlace) {
    MapSources sources;
    sources.texts = {
        {"b.glint", "\nsphere { center = (0, 0, 0)  radius = -1 }"},
        {"flat.glint", "\n\n  cylinder { from = (1, 1, 1)  to = (1, 1, 1)  radius = 1 }"},
        {"a.glint", "include \"a.glint\""},
        {"loop.glint", "include \"back.glint\""},
        {"back.glint", "include \"loop.glint\""},
        {"x/deep.glint", "include \"./deep.glint\""},
        {"twice.glint", "include \"twice2.glint\" include \"twice2.glint\" include \"./twice.glint\""},
        {"twice2.glint", k_ball + "}"}};
    EXPECT_EQ(errors_of("include \"b.glint\"", &sources).substr(0, 32), "b.glint:2:39: error: expected a ");
    EXPECT_EQ(errors_of(std::string(k_camera) + "include \"flat.glint\"", &sources).substr(0, 32),
              "flat.glint:3:3: error: cylinder ");
    EXPECT_NE(errors_of("include \"a.glint\"", &sources)
                  .find("a text cannot include itself: 'a.glint' -> 'a.glint'"),
              std::string::npos);
    EXPECT_NE(
        errors_of("include \"loop.glint\"", &sources).find("'loop.glint' -> 'back.glint' -> 'loop.glint'"),
        std::string::npos);
    EXPECT_NE(errors_of("include \"b.txt\"", &sources)
                  .find("a.glint:1:9: error: 'b.txt': expected a name that ends"),
              std::string::npos);
    EXPECT_NE(errors_of("include b", &sources).find("expected the name of a file in quotes, found 'b'"),
              std::string::npos);
}

TEST(GlintInclude, MissingTextsAreErrors) {
    MapSources sources;
    const std::string text = std::string(k_camera) + k_ball + "}\ninclude \"none.glint\"";
    for (Sources* const given : {static_cast<Sources*>(&sources), static_cast<Sources*>(nullptr)}) {
        const Result<Scene> result = load_text(text, "a.glint", {}, given);
        EXPECT_FALSE(result);
        ASSERT_EQ(result.diagnostics.size(), 1u);
        const Diagnostic& missing = result.diagnostics[0];
        EXPECT_EQ(missing.severity, Severity::error);
        EXPECT_EQ(missing.message,
                  given == nullptr ? "'none.glint': this text cannot include others: no files are read here"
                                   : "'none.glint': no such file");
        EXPECT_EQ(missing.line, static_cast<std::uint32_t>(1 + std::count(text.begin(), text.end(), '\n')));
        EXPECT_EQ(missing.column, 9u);
    }
}

TEST(GlintInclude, CyclesEnd) {
    MapSources sources;
    for (int i = 0; i < 20; ++i) {
        std::string text;
        for (int k = 0; k < 10; ++k) text += "include \"" + std::to_string(i + 1) + ".glint\"\n";
        sources.texts.emplace(std::to_string(i) + ".glint", text);
    }
    EXPECT_NE(errors_of("include \"0.glint\"", &sources).find("nested more than 16 deep"), std::string::npos);
    sources.texts["15.glint"] = k_ball + "}";
    EXPECT_NE(errors_of("include \"0.glint\"", &sources).find("more than 10000 includes"), std::string::npos);
}

TEST(GlintInclude, AFileWithMaterialsMayBeIncludedTwice) {
    MapSources sources;
    sources.texts = {{"b.glint", "material gold { }\n" + k_ball + "material = gold }"}};
    EXPECT_EQ(shapes_of("include \"b.glint\" include \"b.glint\"", &sources).materials.size(), 1u);
    EXPECT_NE(errors_of("include \"b.glint\"\nmaterial gold { }", &sources)
                  .find("a second material called 'gold': the first is in line 1 of b.glint"),
              std::string::npos);
}

}  // namespace
}  // namespace glint::test
