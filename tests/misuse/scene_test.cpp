// SPDX-License-Identifier: Apache-2.0
// Invalid scenes, with one fault each: validate() reports it, and no function renders or writes
// them.
#include <functional>

#include "misuse/misused.h"

namespace glint::test {
namespace {

using Edit = std::function<void(Scene&)>;

void expect_refused(const Edit& edit, const char* what) {
    Scene scene = some_scene();
    edit(scene);
    EXPECT_TRUE(has_errors(validate(scene))) << what;
    const Result<World> prepared = prepare(scene);
    EXPECT_FALSE(prepared) << what;
    EXPECT_TRUE(has_errors(prepared.diagnostics)) << what;
    EXPECT_EQ(write_glint(scene).code, ErrorCode::invalid_scene) << what;
    EXPECT_EQ(check(scene).code, ErrorCode::invalid_scene) << what;
}

TEST(Misuse, OfIndices) {
    for (const std::uint32_t index : {4u, 1000000u, k_none - 1, k_none}) {
        expect_refused([&](Scene& s) { s.shapes[0].index = index; }, "parameters");
        if (index == k_none) continue;  // the default
        expect_refused([&](Scene& s) { s.shapes[1].material = index; }, "material");
        expect_refused([&](Scene& s) { s.shapes[1].transform = index; }, "transform");
    }
    expect_refused([](Scene& s) { s.get<Sphere>().clear(); }, "shapes without parameters");
    expect_refused([](Scene& s) { s.materials.clear(); }, "shapes without materials");
    expect_refused([](Scene& s) { s.transforms.clear(); }, "shapes without transforms");
    for (const Polygon p : {Polygon{0, 3}, Polygon{k_none, k_none}, Polygon{1, k_none}, Polygon{}})
        expect_refused([&](Scene& s) { s.add(p); }, "polygon");
    expect_refused(
        [](Scene& s) {
            s.polygon_vertices.resize(5000);
            s.add(Polygon{0, 5000});
        },
        "a polygon with too many vertices");
}

TEST(Misuse, OfEnumerations) {
    const Edit edits[] = {
        [](Scene& s) { s.shapes[0].kind = beyond<ShapeKind>(); },
        [](Scene& s) { s.lights[0].kind = beyond<LightKind>(); },
        [](Scene& s) { s.camera.projection = beyond<Projection>(); },
        [](Scene& s) { s.camera.fov_axis = beyond<FovAxis>(); },
        [](Scene& s) { s.settings.shading = beyond<Shading>(); },
        [](Scene& s) { s.conventions.pixel_sample = beyond<PixelSample>(); },
        [](Scene& s) { s.conventions.ray_direction = beyond<RayDirection>(); },
        [](Scene& s) { s.conventions.offset = beyond<Offset>(); },
        [](Scene& s) { s.conventions.mirror = beyond<MirrorRule>(); },
        [](Scene& s) { s.conventions.limit = beyond<LimitRule>(); },
        [](Scene& s) { s.conventions.mirror_miss = beyond<MissRule>(); },
        [](Scene& s) { s.conventions.fresnel = beyond<Fresnel>(); },
        [](Scene& s) { s.conventions.glass_shadow = beyond<GlassShadow>(); },
        [](Scene& s) { s.conventions.facing = beyond<Facing>(); },
        [](Scene& s) { s.conventions.spot_falloff = beyond<SpotFalloff>(); },
        [](Scene& s) { s.conventions.area_shading = beyond<AreaShading>(); },
        [](Scene& s) { s.lights[4].samples_u = 0; },
        [](Scene& s) { s.lights[4].samples_v = -2147483647; },
        [](Scene& s) { s.lights[4].samples_v = 2147483647; },
        [](Scene& s) { s.lights[4].adaptive = -1; },
        [](Scene& s) { s.conventions.transfer = beyond<Transfer>(); },
        [](Scene& s) { s.conventions.rounding = beyond<Rounding>(); },
    };
    for (const Edit& edit : edits) expect_refused(edit, "an enumeration");
    EXPECT_EQ(to_string(beyond<ShapeKind>()), "unknown shape");
}

// Every double of a scene, as a function that finds it.
std::vector<std::function<double&(Scene&)>> numbers() {
    std::vector<std::function<double&(Scene&)>> all;
    const auto point = [&](std::function<Vec3&(Scene&)> at) {
        all.push_back([at](Scene& s) -> double& { return at(s).x; });
        all.push_back([at](Scene& s) -> double& { return at(s).y; });
        all.push_back([at](Scene& s) -> double& { return at(s).z; });
    };
    const auto color = [&](std::function<Color&(Scene&)> at) {
        all.push_back([at](Scene& s) -> double& { return at(s).r; });
        all.push_back([at](Scene& s) -> double& { return at(s).g; });
        all.push_back([at](Scene& s) -> double& { return at(s).b; });
    };
    const auto number = [&](std::function<double&(Scene&)> at) { all.push_back(std::move(at)); };
    point([](Scene& s) -> Vec3& { return s.camera.position; });
    point([](Scene& s) -> Vec3& { return s.camera.look_at; });
    point([](Scene& s) -> Vec3& { return s.camera.up; });
    point([](Scene& s) -> Vec3& { return s.camera.lighting_eye.emplace(); });
    point([](Scene& s) -> Vec3& { return s.camera.frame.emplace().right; });
    point([](Scene& s) -> Vec3& { return s.camera.frame.emplace().up; });
    point([](Scene& s) -> Vec3& { return s.camera.frame.emplace().forward; });
    number([](Scene& s) -> double& { return s.camera.fov_degrees; });
    number([](Scene& s) -> double& {
        s.camera.projection = Projection::orthographic;
        return s.camera.width;
    });
    color([](Scene& s) -> Color& { return s.background; });
    color([](Scene& s) -> Color& { return s.lights[0].color; });
    point([](Scene& s) -> Vec3& { return s.lights[1].position; });
    color([](Scene& s) -> Color& { return s.lights[1].color; });
    color([](Scene& s) -> Color& { return s.lights[1].specular_color; });
    number([](Scene& s) -> double& { return s.lights[1].attenuation.c0; });
    number([](Scene& s) -> double& { return s.lights[1].attenuation.c1; });
    number([](Scene& s) -> double& { return s.lights[1].attenuation.c2; });
    point([](Scene& s) -> Vec3& { return s.lights[2].to_light; });
    number([](Scene& s) -> double& { return s.lights[1].fade_distance; });
    number([](Scene& s) -> double& { return s.lights[1].fade_power; });
    point([](Scene& s) -> Vec3& { return s.lights[3].axis; });
    number([](Scene& s) -> double& { return s.lights[3].inner_angle; });
    number([](Scene& s) -> double& { return s.lights[3].outer_angle; });
    number([](Scene& s) -> double& { return s.lights[3].tightness; });
    point([](Scene& s) -> Vec3& { return s.lights[4].side_u; });
    point([](Scene& s) -> Vec3& { return s.lights[4].side_v; });
    number([](Scene& s) -> double& { return s.lights[5].radius; });
    color([](Scene& s) -> Color& { return s.materials[0].color; });
    color([](Scene& s) -> Color& { return s.materials[0].ambient; });
    color([](Scene& s) -> Color& { return s.materials[0].diffuse; });
    color([](Scene& s) -> Color& { return s.materials[0].specular; });
    color([](Scene& s) -> Color& { return s.materials[0].mirror_tint; });
    color([](Scene& s) -> Color& { return s.materials[0].transmission_tint; });
    number([](Scene& s) -> double& { return s.materials[0].shininess; });
    number([](Scene& s) -> double& { return s.materials[0].mirror; });
    number([](Scene& s) -> double& { return s.materials[0].transmission; });
    number([](Scene& s) -> double& { return s.materials[0].ior; });
    for (int i = 0; i < 12; ++i) number([i](Scene& s) -> double& { return s.transforms[0].m[i / 4][i % 4]; });
    number([](Scene& s) -> double& { return s.conventions.camera_t_min; });
    number([](Scene& s) -> double& { return s.conventions.epsilon; });
    number([](Scene& s) -> double& { return s.conventions.beer; });
    number([](Scene& s) -> double& { return s.conventions.min_weight; });
    const auto last = [](auto& list) -> auto& { return list.back(); };
    point([=](Scene& s) -> Vec3& { return s.add(Sphere{}), last(s.get<Sphere>()).center; });
    number([=](Scene& s) -> double& { return s.add(Sphere{}), last(s.get<Sphere>()).radius; });
    point([=](Scene& s) -> Vec3& { return s.add(Plane{}), last(s.get<Plane>()).point; });
    point([=](Scene& s) -> Vec3& { return s.add(Plane{}), last(s.get<Plane>()).normal; });
    point([=](Scene& s) -> Vec3& { return s.add(Cylinder{}), last(s.get<Cylinder>()).from; });
    point([=](Scene& s) -> Vec3& { return s.add(Cylinder{}), last(s.get<Cylinder>()).to; });
    number([=](Scene& s) -> double& { return s.add(Cylinder{}), last(s.get<Cylinder>()).radius; });
    point([=](Scene& s) -> Vec3& { return s.add(Cone{}), last(s.get<Cone>()).from; });
    point([=](Scene& s) -> Vec3& { return s.add(Cone{}), last(s.get<Cone>()).to; });
    number([=](Scene& s) -> double& { return s.add(Cone{}), last(s.get<Cone>()).from_radius; });
    number([=](Scene& s) -> double& { return s.add(Cone{}), last(s.get<Cone>()).to_radius; });
    point([=](Scene& s) -> Vec3& { return s.add(Disc{}), last(s.get<Disc>()).center; });
    point([=](Scene& s) -> Vec3& { return s.add(Disc{}), last(s.get<Disc>()).normal; });
    number([=](Scene& s) -> double& { return s.add(Disc{}), last(s.get<Disc>()).radius; });
    number([=](Scene& s) -> double& { return s.add(Disc{}), last(s.get<Disc>()).hole; });
    point([=](Scene& s) -> Vec3& { return s.add(Torus{}), last(s.get<Torus>()).center; });
    point([=](Scene& s) -> Vec3& { return s.add(Torus{}), last(s.get<Torus>()).axis; });
    number([=](Scene& s) -> double& { return s.add(Torus{}), last(s.get<Torus>()).radius; });
    number([=](Scene& s) -> double& { return s.add(Torus{}), last(s.get<Torus>()).tube; });
    point([=](Scene& s) -> Vec3& { return s.add(Quadric{}), last(s.get<Quadric>()).squares; });
    point([=](Scene& s) -> Vec3& { return s.add(Quadric{}), last(s.get<Quadric>()).products; });
    point([=](Scene& s) -> Vec3& { return s.add(Quadric{}), last(s.get<Quadric>()).linear; });
    number([=](Scene& s) -> double& { return s.add(Quadric{}), last(s.get<Quadric>()).constant; });
    for (std::size_t i = 0; i < std::size(k_quartic_terms); ++i)
        number([=](Scene& s) -> double& { return s.add(Quartic{}), last(s.get<Quartic>()).coefficients[i]; });
    point([=](Scene& s) -> Vec3& { return s.add(Box{}), last(s.get<Box>()).min; });
    point([=](Scene& s) -> Vec3& { return s.add(Box{}), last(s.get<Box>()).max; });
    for (int i = 0; i < 3; ++i) {
        point([=](Scene& s) -> Vec3& { return s.add(Triangle{}), last(s.get<Triangle>()).vertices[i]; });
        point([=](Scene& s) -> Vec3& {
            return s.add(SmoothTriangle{}), last(s.get<SmoothTriangle>()).vertices[i];
        });
        point([=](Scene& s) -> Vec3& {
            return s.add(SmoothTriangle{}), last(s.get<SmoothTriangle>()).normals[i];
        });
        point([=](Scene& s) -> Vec3& {
            s.polygon_vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
            s.add(Polygon{0, 3});
            return s.polygon_vertices[static_cast<std::size_t>(i)];
        });
    }
    return all;
}

TEST(Misuse, OfNumbersOfAScene) {
    for (const auto& number : numbers())
        for (const double odd : k_odd_numbers) expect_refused([&](Scene& s) { number(s) = odd; }, "a number");
}

TEST(Misuse, OfSizes) {
    for (const std::int32_t size : k_odd_sizes) {
        expect_refused([&](Scene& s) { s.settings.width = size; }, "width");
        expect_refused([&](Scene& s) { s.settings.height = size; }, "height");
        expect_refused([&](Scene& s) { s.settings.samples = size; }, "samples");
        if (size != 0) expect_refused([&](Scene& s) { s.settings.reflections = size; }, "reflections");
    }
}

TEST(Misuse, OfTextsOfAScene) {
    Scene scene = some_scene();
    scene.origins = {{beyond<SettingOrigin::Kind>(), {7, 7, 7}}};
    scene.files.clear();
    scene.camera_place = {9, 9, 9};
    scene.shape_texts.places.assign(1000, {1, 1, 65535});
    scene.light_texts.names = {{k_none, "\xff\0"}};
    scene.profile = "none";
    EXPECT_FALSE(has_errors(validate(scene)));
    EXPECT_EQ(scene.shape_texts.name(k_none), "");
    EXPECT_EQ(scene.shape_texts.place(k_none), SourcePlace{});
    scene.lights[1].color.r = k_nan;  // a message with a place in no file
    EXPECT_TRUE(has_errors(validate(scene)));
}

TEST(Misuse, OfWriteGlint) {
    Scene scene = some_scene();
    const SceneText texts[] = {{"", "", ""}, {"none.glint", "# \xff\xfe", "none"}};
    scene.files = {"a.glint"};
    scene.shape_texts.places.assign(4, {100, 100, 3});
    scene.material_texts.names = {{0u, std::string("a\n\"}\0", 5)}, {77u, "nobody"}};
    scene.profile = "no such profile";
    const std::string text = write_glint(scene, texts).value();
    EXPECT_NE(text, "");
    const SceneText again{"again.glint", text, ""};
    EXPECT_TRUE(load({&again, 1})) << text;
    EXPECT_TRUE(write_glint(Scene{}));
}

TEST(Misuse, OfWriteScene) {
    ASSERT_FALSE(written_formats().empty());
    for (const WrittenFormat& format : written_formats()) {
        EXPECT_TRUE(write_scene(Scene{}, format.name)) << format.name;
        EXPECT_TRUE(write_scene(some_scene(), format.name)) << format.name;
        Scene dangling = some_scene();
        dangling.shapes[0].material = 77;
        EXPECT_EQ(write_scene(dangling, format.name).code, ErrorCode::invalid_scene) << format.name;
        Scene named = some_scene();
        named.files = {"\xff"};
        named.shape_texts.names = {{0u, std::string("a\n\"}\0\xff", 6)}, {77u, "nobody"}};
        named.profile = "no such profile";
        const Result<std::string> bytes = write_scene(named, format.name);
        ASSERT_TRUE(bytes) << format.name;
        const SceneText again{"again" + std::string(format.extension), *bytes, ""};
        EXPECT_TRUE(load({&again, 1})) << format.name;
    }
    for (const std::string_view none : {"", "GLB", "png", "\xff"})
        EXPECT_EQ(write_scene(Scene{}, none).code, ErrorCode::invalid_argument) << none;
}

TEST(Misuse, OfLights) {
    EXPECT_EQ(to_string(beyond<LightKind>()), "unknown light");
    const Light odd{
        .kind = beyond<LightKind>(), .position = {k_nan, 0, 0}, .attenuation = {k_nan, k_nan, k_nan}};
    EXPECT_FALSE(odd.is_ambient() || odd.has_position() || odd.has_direction() || odd.has_attenuation() ||
                 odd.falls_off() || odd.moves_samples() || odd.fades() || odd.is_spot() ||
                 odd.is_parallelogram() || odd.is_disc() || odd.is_sphere() || odd.is_area() ||
                 odd.is_flat() || odd.may_be_one_sided() || odd.has_radius() || odd.has_axis() ||
                 odd.has_emitter_cosine());
    EXPECT_TRUE(odd.has_specular_color());  // as of all that are not ambient
    EXPECT_EQ(odd.way_from({k_nan, k_nan, k_nan}), odd.to_light);
}

TEST(Misuse, OfFogAndSamples) {
    EXPECT_EQ(to_string(beyond<FogKind>()), "unknown fog");
    const Fog odd{.kind = beyond<FogKind>(), .density = k_nan, .end = k_nan};
    EXPECT_TRUE(odd.has_density());
    EXPECT_FALSE(odd.has_end());
    EXPECT_FALSE(odd.has_falloff() || odd.is_on_ground());
    Scene scene = some_scene();
    scene.fog = odd;
    EXPECT_FALSE(prepare(scene));
    RenderSettings settings;
    settings.aa_threshold = k_nan;
    EXPECT_FALSE(settings.is_adaptive());
    settings.samples = 2;
    EXPECT_TRUE(settings.is_adaptive());
    scene = some_scene();
    scene.settings = settings;
    EXPECT_FALSE(prepare(scene));
}

TEST(Misuse, OfCameras) {
    Camera odd;
    odd.projection = beyond<Projection>();
    EXPECT_TRUE(odd.has_target());
    EXPECT_FALSE(odd.has_fov() || odd.has_width());
    odd.frame = CameraFrame{};
    EXPECT_FALSE(odd.has_target());
}

TEST(Misuse, OfVectors) {
    const Vec3 odd{k_nan, k_infinity, 0};
    EXPECT_NE(dot(odd, odd), 0);
    EXPECT_FALSE(cross(odd, Vec3{}) == Vec3{});  // NaN
}

TEST(Misuse, TexturesWithoutImages) {
    Texture texture;
    texture.alpha = static_cast<TextureAlpha>(77);
    EXPECT_FALSE(texture.has_alpha()) << "it has no image";
    EXPECT_TRUE(texture.needs_uv());
    texture.mapping = static_cast<TextureMapping>(99);
    EXPECT_FALSE(texture.needs_uv());
    EXPECT_FALSE(texture.has_holes());
    EXPECT_EQ(texture.opacity(k_nan), 1);
    EXPECT_EQ(texture.own_opacity(k_nan), 1);
    EXPECT_EQ(TextureImage{}.channels(), 3u);
    Scene scene = some_scene();
    texture.wrap_u = static_cast<TextureWrap>(9);
    EXPECT_TRUE(texture.has_wrap(static_cast<TextureWrap>(9)));
    EXPECT_FALSE(texture.has_wrap(TextureWrap::clip));
    scene.textures.push_back(texture);
    EXPECT_FALSE(prepare(scene));
    EXPECT_EQ(to_string(texture.wrap_u), "unknown");
    EXPECT_EQ(to_string(texture.alpha), "unknown");
    EXPECT_EQ(to_string(static_cast<TextureFilter>(9)), "unknown");
    EXPECT_EQ(to_string(static_cast<TextureMix>(9)), "unknown");
    EXPECT_EQ(to_string(static_cast<TextureEncoding>(9)), "unknown");
    EXPECT_EQ(to_string(static_cast<TextureMapping>(99)), "unknown");
}

TEST(Misuse, MeshesWithoutTheVerticesOfTheirTriangles) {
    MeshData mesh;
    EXPECT_EQ(mesh.vertex_count(), 0u);
    EXPECT_EQ(mesh.position(7), (Vec3{}));
    EXPECT_FALSE(mesh.corner_normals(0));
    mesh.normals.values = {{0, 0, 1}};
    mesh.triangles = {{0, 1, 2}};
    EXPECT_EQ(to_vec3(mesh.normals.values[0]), (Vec3{0, 0, 1}));
    EXPECT_EQ(to_single(Vec3{0, 0.1, -0.5}), (Float3{0, 0.1F, -0.5F}));
    EXPECT_EQ(write_ply(mesh).code, ErrorCode::invalid_argument) << "no vertices";
    EXPECT_FALSE(mesh.corner_normals(0)) << "two of its vertices have no normals";
    mesh.colors.values = {{1, 0, 0}};
    mesh.colors.corners = {{0, 0, CornerValues::k_none}};
    EXPECT_FALSE(mesh.corner_values(mesh.colors, 0)) << "one of its corners has no color";
    EXPECT_FALSE(mesh.corner_values(mesh.colors, 1)) << "no such triangle";
    Scene scene;
    scene.add(Mesh{0});
    EXPECT_TRUE(has_errors(validate(scene))) << "no such mesh";
    scene.meshes.push_back(nullptr);
    EXPECT_TRUE(has_errors(validate(scene))) << "null";
    scene.meshes[0] = std::make_shared<const MeshData>(mesh);
    EXPECT_TRUE(has_errors(validate(scene))) << "no vertices";
}

}  // namespace
}  // namespace glint::test
