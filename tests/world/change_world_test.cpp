// SPDX-License-Identifier: Apache-2.0
// A World with changed shading equals the World of the changed scene, for every scene of the gallery.
#include "gallery/scene_file.h"
#include "trace/worlds.h"
#include "world/same_pictures.h"

namespace glint::test {
namespace {

#if defined(GLINT_SANITIZED)
constexpr const char* k_size = "size=20x15 aa=1";
#else
constexpr const char* k_size = "size=40x30 aa=1";
#endif

World made(const Result<World>& result) {
    EXPECT_TRUE(result.has_value()) << to_string(result);
    return result.value_or(World());
}

World prepared(const Scene& scene) { return made(prepare(scene, {.threads = 1})); }

std::string message(const Result<World>& result) {
    EXPECT_FALSE(result.has_value());
    return result.message;
}

Material some_material() {
    Material m;
    m.diffuse = {0.2, 0.5, 0.1};
    m.specular = {0.4, 0.4, 0.9};
    m.shininess = 7;
    m.mirror = 0.3;
    m.transmission = 0.4;
    m.ior = 1.2;
    return m;
}

// A change to a scene, and the function that makes it in a World.
struct Change {
    const char* name;
    void (*edit)(Scene&);
    Result<World> (*apply)(const World&, const Scene& edited);
};

Result<World> apply_rules(const World& world, const Scene& s) {
    return with_rules(world, s.conventions, s.settings);
}
Result<World> apply_lights(const World& world, const Scene& s) { return with_lights(world, s.lights); }
Result<World> apply_camera(const World& world, const Scene& s) { return with_camera(world, s.camera); }

const Change k_changes[] = {
    {"lights",
     [](Scene& s) {
         Light ambient{LightKind::ambient}, sun{LightKind::directional};
         ambient.color = {0.1, 0.2, 0.05};
         sun.to_light = {1, 2, 0.5};
         s.lights.insert(s.lights.begin(), ambient);
         s.lights.push_back(sun);
     },
     apply_lights},
    {"a spot without shadows",
     [](Scene& s) {
         Light spot{LightKind::spot};
         spot.position = {1, 5, 2};
         spot.casts_shadows = false;
         s.lights.push_back(spot);
     },
     apply_lights},
    {"no lights", [](Scene& s) { s.lights.clear(); }, apply_lights},
    {"camera moved",
     [](Scene& s) {
         s.camera.position = s.camera.position + Vec3{0.1, 0.2, 0.3};
         s.camera.look_at = s.camera.look_at + Vec3{0.3, 0, 0.1};
     },
     apply_camera},
    {"camera orthographic",
     [](Scene& s) {
         s.camera.projection = Projection::orthographic;
         s.camera.width = 5;
     },
     apply_camera},
    {"background",
     [](Scene& s) {
         s.background = {0.3, 0.1, 0.7};
     },
     [](const World& world, const Scene& s) { return with_background(world, s.background); }},
    {"size",
     [](Scene& s) {
         s.settings.width = 70;
         s.settings.height = 31;
     },
     apply_rules},
    {"facing none", [](Scene& s) { s.conventions.facing = Facing::none; }, apply_rules},
    {"facing open", [](Scene& s) { s.conventions.facing = Facing::open; }, apply_rules},
    {"facing all", [](Scene& s) { s.conventions.facing = Facing::all; }, apply_rules},
    {"facing winding", [](Scene& s) { s.conventions.facing = Facing::winding; }, apply_rules},
    {"glass without shadow", [](Scene& s) { s.conventions.glass_shadow = GlassShadow::none; }, apply_rules},
    {"glass with shadow", [](Scene& s) { s.conventions.glass_shadow = GlassShadow::opaque; }, apply_rules},
    {"other rules",
     [](Scene& s) {
         s.conventions.offset = Offset::scale;
         s.conventions.epsilon = 1e-9;
         s.conventions.mirror = MirrorRule::add;
         s.conventions.pixel_sample = PixelSample::corner;
         s.settings.shading = Shading::phong;
         s.settings.reflections = 2;
         s.settings.samples = 2;
     },
     apply_rules},
    {"first material",
     [](Scene& s) {
         if (!s.materials.empty()) s.materials[0] = some_material();
     },
     [](const World& world, const Scene& s) {
         return s.materials.empty() ? with_materials(world, {}) : with_material(world, 0, s.materials[0]);
     }},
    {"first material transparent",
     [](Scene& s) {
         if (s.materials.empty()) return;
         s.materials[0].transmission = 0;
         s.materials[0].filter = 0.5;
         s.materials[0].transmit = 0.2;
     },
     [](const World& world, const Scene& s) {
         return s.materials.empty() ? with_materials(world, {}) : with_material(world, 0, s.materials[0]);
     }},
    {"first material without shadow",
     [](Scene& s) {
         if (!s.materials.empty()) s.materials[0].casts_shadow = false;
     },
     [](const World& world, const Scene& s) {
         return s.materials.empty() ? with_materials(world, {}) : with_material(world, 0, s.materials[0]);
     }},
    {"first material with shadow",
     [](Scene& s) {
         if (!s.materials.empty()) s.materials[0].casts_shadow = true;
     },
     [](const World& world, const Scene& s) {
         return s.materials.empty() ? with_materials(world, {}) : with_material(world, 0, s.materials[0]);
     }},
    {"materials without shadow",
     [](Scene& s) {
         for (Material& m : s.materials) m.casts_shadow = false;
     },
     [](const World& world, const Scene& s) { return with_materials(world, s.materials); }},
    {"all materials",
     [](Scene& s) {
         for (Material& m : s.materials) m = some_material();
     },
     [](const World& world, const Scene& s) { return with_materials(world, s.materials); }},
    {"more materials", [](Scene& s) { s.materials.insert(s.materials.end(), 3, some_material()); },
     [](const World& world, const Scene& s) { return with_materials(world, s.materials); }},
    {"a material assigned",
     [](Scene& s) {
         for (std::size_t i = 0; i < s.shapes.size(); i += 2)
             s.shapes[i].material = s.materials.empty() ? k_none : 0;
     },
     [](const World& world, const Scene& s) -> Result<World> {
         World result = world;
         std::vector<std::uint32_t> shapes;
         for (std::uint32_t i = 0; i < s.shapes.size(); i += 2) shapes.push_back(i);
         const Status assigned = assign_material(result, shapes, s.materials.empty() ? k_none : 0);
         if (!assigned) return assigned;
         return result;
     }},
};

class ChangedWorld : public ::testing::TestWithParam<std::string> {};

TEST_P(ChangedWorld, EqualsTheWorldOfTheChangedScene) {
    const auto scene = test::load_file(GetParam(), k_size);
    ASSERT_TRUE(scene);
    const World world = prepared(*scene);
    for (const Change& change : k_changes) {
        SCOPED_TRACE(change.name);
        Scene edited = *scene;
        change.edit(edited);
        const World changed = made(change.apply(world, edited));
        EXPECT_TRUE(draw_the_same(changed, prepared(edited)));
        EXPECT_EQ(&*changed.parts().geometry, &*world.parts().geometry) << "the geometry is shared";
        EXPECT_TRUE(draw_the_same(world, prepared(*scene))) << "the World it was made from has changed";
    }
}

TEST_P(ChangedWorld, AppliesSuccessiveChanges) {
    auto scene = test::load_file(GetParam(), k_size);
    ASSERT_TRUE(scene);
    World world = prepared(*scene);
    for (const Change& change : k_changes) {
        if (std::string_view(change.name) == "more materials") continue;  // they would grow at every change
        change.edit(*scene);
        world = made(change.apply(world, *scene));
    }
    EXPECT_TRUE(draw_the_same(world, prepared(*scene)));
}

INSTANTIATE_TEST_SUITE_P(Gallery, ChangedWorld,
                         ::testing::ValuesIn(test::scene_files(GLINT_PROJECT_DIR "/scenes")),
                         [](const auto& p) {
                             std::string name = p.param.substr(p.param.find("/scenes/") + 8);
                             for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                             return name;
                         });

Scene two_spheres() {
    Scene scene;
    scene.settings.width = scene.settings.height = 32;
    scene.camera.position = {0, 0, 6};
    scene.lights.push_back(Light{});
    scene.lights[0].position = {3, 4, 5};
    scene.materials.assign(2, Material{});
    scene.materials[1].diffuse = {1, 0, 0};
    scene.add(Sphere{{-1, 0, 0}, 1}, 0);
    scene.add(Sphere{{1, 0, 0}, 1}, 1);
    scene.add(Sphere{{0, 1, 0}, 0.5});
    return scene;
}

TEST(ChangeWorld, ReportsInvalidArguments) {
    const World world = prepared(two_spheres());
    Light light;
    light.color.r = NAN;
    EXPECT_NE(message(with_lights(world, {{Light{}, light}})).find("light 2: color"), std::string::npos);
    Camera camera;
    camera.look_at = camera.position;
    EXPECT_NE(message(with_camera(world, camera)).find("the camera"), std::string::npos);
    EXPECT_NE(message(with_background(world, {0, INFINITY, 0})).find("background"), std::string::npos);
    RenderSettings settings;
    settings.width = 0;
    EXPECT_NE(message(with_rules(world, {}, settings)).find("size"), std::string::npos);
    Conventions conventions;
    conventions.epsilon = -1;
    EXPECT_NE(message(with_rules(world, conventions, {})).find("epsilon"), std::string::npos);
    Material material;
    material.mirror = 2;
    EXPECT_NE(message(with_material(world, 1, material)).find("material 2: mirror"), std::string::npos);
    EXPECT_EQ(message(with_material(world, 2, {})), "there is no material 3: the scene has 2");
    EXPECT_NE(message(with_materials(world, {{material, Material{}}})).find("material 1: mirror"),
              std::string::npos);
    EXPECT_EQ(message(with_materials(world, {{Material{}}})),
              "shape 2 has a material that is not among the 1 given");
    World assigned = world;
    const std::uint32_t shapes[] = {0, 3};
    EXPECT_EQ(assign_material(assigned, shapes, 0).message, "there is no shape 4: the scene has 3");
    EXPECT_EQ(assign_material(assigned, {}, 2).message, "there is no material 3: the scene has 2");
    EXPECT_TRUE(draw_the_same(assigned, world));
}

TEST(ChangeWorld, FewerMaterialsThanBeforeAreEnoughIfNoShapeNeedsThem) {
    Scene scene = two_spheres();
    scene.shapes[1].material = 0;
    const World world = prepared(scene);
    scene.materials.pop_back();
    EXPECT_TRUE(draw_the_same(made(with_materials(world, scene.materials)), prepared(scene)));
}

TEST(ChangeWorld, ConesNeedPrepare) {
    Scene scene = two_spheres();
    Conventions without = scene.conventions;
    without.cones = false;
    made(with_rules(prepared(scene), without, scene.settings));  // there are none
    scene.add(Cone{{0, 0, 0}, {0, 1, 0}, 1, 0, true});
    for (const bool cones : {true, false}) {
        scene.conventions.cones = cones;
        Conventions other = scene.conventions;
        other.cones = !cones;
        EXPECT_NE(message(with_rules(prepared(scene), other, scene.settings)).find("prepare()"),
                  std::string::npos);
    }
}

TEST(ChangeWorld, TheDefaultWorldIsEmpty) {
    const World none;
    Scene scene;
    EXPECT_TRUE(draw_the_same(none, prepared(scene)));
    World world = prepared(two_spheres());
    const World moved = std::move(world);
    EXPECT_TRUE(draw_the_same(world, none));  // NOLINT(bugprone-use-after-move): that is what is tested
    EXPECT_TRUE(draw_the_same(moved, prepared(two_spheres())));
    scene.lights.push_back(Light{});
    scene.background = {1, 0, 1};
    World changed = made(with_lights(none, scene.lights));
    changed = made(with_background(changed, scene.background));
    EXPECT_TRUE(draw_the_same(changed, prepared(scene)));
}

TEST(ChangeWorld, PrepareReportsTheProgressOfMeshes) {
    Scene scene;
    for (const std::uint32_t triangles : {10u, 90u}) {
        MeshData mesh;
        for (std::uint32_t i = 0; i < triangles; ++i) mesh.triangles.push_back({0, 1, 2});
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        scene.meshes.push_back(std::make_shared<const MeshData>(mesh));
        scene.add(Mesh{triangles == 10 ? 0u : 1u});
    }
    std::vector<double> reported;
    PrepareOptions options;
    options.progress = [&](double done) { reported.push_back(done); };
    ASSERT_TRUE(prepare(scene, options));
    EXPECT_TRUE(std::is_sorted(reported.begin(), reported.end()));
    EXPECT_GE(reported.size(), 5u);
    EXPECT_EQ(reported.back(), 1);
}

TEST(ChangeWorld, PrepareReportsProgressAndCanBeCancelled) {
    Random random(5);
    const Scene scene = random_scene(random, 30000);
    std::atomic<int> calls{0};
    std::atomic<bool> cancel{false};
    PrepareOptions options;
    options.threads = 2;
    options.progress = [&](double done) {
        EXPECT_GE(done, 0);
        EXPECT_LE(done, 1);
        ++calls;
    };
    EXPECT_TRUE(prepare(scene, options));
    EXPECT_GE(calls, 3);
    options.progress = [&](double) { cancel = true; };
    options.cancel = &cancel;
    const Result<World> result = prepare(scene, options);
    EXPECT_FALSE(result);
    EXPECT_EQ(result.code, ErrorCode::cancelled);
    EXPECT_FALSE(has_errors(result.diagnostics));
    EXPECT_FALSE(prepare(scene, options)) << "cancelled before it began";
}

}  // namespace
}  // namespace glint::test
