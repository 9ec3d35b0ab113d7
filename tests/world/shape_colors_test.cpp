// SPDX-License-Identifier: Apache-2.0
// A shape with a color of its own looks, to the bit, as if it had a material of that color.
#include <limits>

#include "gallery/scene_file.h"
#include "glint/check.h"
#include "glint/explain.h"
#include "trace/worlds.h"
#include "world/same_pictures.h"

namespace glint::test {
namespace {

constexpr float k_no_number = std::numeric_limits<float>::quiet_NaN();

// Gives three of four shapes a color of their own.
void color_shapes(Scene& scene, unsigned seed) {
    Random random(seed);
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        if (i % 4 == 1) continue;
        scene.set_shape_color(i, Color{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)});
    }
}

// The same scene with a material for each color.
Scene with_materials_instead(Scene scene) {
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        const auto color = scene.shape_color(i);
        if (!color) continue;
        std::uint32_t& material = scene.shapes[i].material;
        const Material base = material == k_none ? Material{} : scene.materials[material];
        material = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back(with_color(base, *color));
    }
    scene.shape_colors.clear();
    return scene;
}

// Compares the picture and every layer but the numbers of the materials.
void expect_same_pictures(const World& a, const World& b) {
    RenderOptions options;
    options.threads = 1;
    for (const LayerInfo& info : layer_infos())
        if (info.layer != Layer::material) options.layers.push_back(info.layer);
    const Rendering of_a = render(a, options).value(), of_b = render(b, options).value();
    EXPECT_TRUE(same_bits(of_a.image.rgb, of_b.image.rgb)) << "the pictures differ";
    for (std::size_t i = 0; i < of_a.layers.size(); ++i)
        EXPECT_TRUE(same_bits(of_a.layers[i].values, of_b.layers[i].values))
            << "layer " << layer_infos()[static_cast<std::size_t>(of_a.layers[i].layer)].name << " differs";
}

Scene uncolored_scene(unsigned seed, int count) {
    Random random(seed);
    Scene scene = random_scene(random, count, 6);
    scene.settings.width = 60;
    scene.settings.height = 44;
    scene.camera.position = {7, 4, 12};
    scene.camera.look_at = {0, 0, 0};
    scene.background = {0.2, 0.3, 0.4};
    scene.lights.assign(2, Light{});
    scene.lights[0].position = {6, 12, 6};
    scene.lights[1] = {.kind = LightKind::ambient, .color = {0.7, 0.8, 0.9}};
    scene.materials.assign(3, Material{});
    scene.materials[0].color = {0.9, 0.6, 0.3};
    for (auto* k : {&scene.materials[0].ambient, &scene.materials[0].diffuse, &scene.materials[0].specular})
        *k = scene.materials[0].color * 0.7;
    scene.materials[1].specular = {1, 1, 1};  // no multiple of the color: stays
    scene.materials[1].mirror = 0.4;
    scene.materials[2] = with_color(Material{}, {});  // black
    scene.materials[2].transmission = 0.5;
    scene.materials[2].ior = 1.3;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        scene.shapes[i].material = i % 5 == 3 ? k_none : static_cast<std::uint32_t>(i % 3);
    return scene;
}

Scene colored_scene(unsigned seed = 1, int count = 60) {
    Scene scene = uncolored_scene(seed, count);
    color_shapes(scene, seed);
    return scene;
}

World colored_world(const Scene& scene) { return *make_world(scene); }
World changed_world(const Result<World>& result) {
    EXPECT_TRUE(result.has_value()) << to_string(result);
    return result.value_or(World());
}

TEST(ShapeColors, EqualAMaterialForEachColor) {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Scene scene = colored_scene(seed, 200);
        if (seed == 2) scene.settings.shading = Shading::color;
        if (seed == 3) scene.settings.shading = Shading::phong, scene.settings.samples = 2;
        if (seed == 4) scene.conventions.beer = 0.2;
        if (seed == 5) scene.shape_colors.resize(70);
        expect_same_pictures(colored_world(scene), colored_world(with_materials_instead(scene)));
    }
}

TEST(ShapeColors, EqualAMaterialForEachColorInEveryGalleryScene) {
    for (const std::string& file : scene_files(GLINT_PROJECT_DIR "/scenes")) {
        SCOPED_TRACE(file);
        auto scene = load_file(file, "size=40x30 aa=1");
        ASSERT_TRUE(scene);
        color_shapes(*scene, 7);
        expect_same_pictures(colored_world(*scene), colored_world(with_materials_instead(*scene)));
    }
}

TEST(ShapeColors, CostNothingWithoutAny) {
    Scene scene = uncolored_scene(1, 50);
    scene.shape_colors.resize(50);  // none is set
    const World world = colored_world(scene);
    EXPECT_TRUE(world.parts().slot_color->empty() && world.parts().color_factors->empty());
    EXPECT_EQ(memory_usage(world).colors, 0u);
    color_shapes(scene, 1);
    const std::size_t colors = memory_usage(colored_world(scene)).colors;
    EXPECT_GE(colors, 12 * scene.shapes.size());
}

TEST(ShapeColors, FactorsOfAMaterial) {
    Material m;
    m.color = {0.9, 0.6, 0.3};
    m.ambient = m.color * 0.3;
    m.diffuse = m.color * 0.1;
    m.specular = {1, 1, 1};
    const Color blue{0, 0, 1};
    const Material changed = with_color(m, blue);
    EXPECT_EQ(changed.color, blue);
    EXPECT_EQ(changed.ambient, blue * 0.3);  // 0.3 * 0.6 / 0.6 is not 0.3
    EXPECT_EQ(changed.diffuse, blue * 0.1);
    EXPECT_EQ(changed.specular, (Color{1, 1, 1}));
    EXPECT_EQ(with_color(Material{}, blue).diffuse, blue * 0.8) << "0.8 * 0.8 is not 0.64";
    EXPECT_EQ(with_color(Material{}, blue).ambient, blue * 0.1);
    EXPECT_EQ(with_color({.color = {1, 0, 0}, .diffuse = {0, 0.8, 0}}, blue).diffuse, (Color{0, 0.8, 0}))
        << "another color, as bright";
    EXPECT_EQ(with_color(with_color(m, {}), blue).diffuse, blue * 0.8) << "black";
    m.diffuse = m.color * 2.5;
    EXPECT_EQ(with_color(m, blue).diffuse, blue * 2.5) << "above 1";
}

TEST(ShapeColors, FollowChangesOfTheWorld) {
    const Scene scene = colored_scene();
    const World world = colored_world(scene);
    Scene edited = scene;
    edited.materials[0].specular = {0, 0, 0};
    EXPECT_TRUE(
        draw_the_same(changed_world(with_material(world, 0, edited.materials[0])), colored_world(edited)));
    edited.materials.insert(edited.materials.end(), 2, edited.materials[1]);
    EXPECT_TRUE(draw_the_same(changed_world(with_materials(world, edited.materials)), colored_world(edited)));

    Scene recolored = scene;
    color_shapes(recolored, 9);
    EXPECT_TRUE(draw_the_same(changed_world(with_shape_colors(world, recolored.shape_colors)),
                              colored_world(recolored)));
    recolored.shape_colors.clear();
    EXPECT_TRUE(draw_the_same(changed_world(with_shape_colors(world, {})), colored_world(recolored)));
    EXPECT_TRUE(
        draw_the_same(changed_world(with_shape_colors(colored_world(recolored), scene.shape_colors)), world));
    EXPECT_TRUE(draw_the_same(world, colored_world(scene))) << "the World it was made from has changed";

    Scene assigned = scene;
    assigned.shapes[0].material = assigned.shapes[4].material = 1;
    World other = world;
    ASSERT_TRUE(assign_material(other, std::vector<std::uint32_t>{0, 4}, 1));
    EXPECT_TRUE(draw_the_same(other, colored_world(assigned)));
}

TEST(ShapeColors, AreEditedWithTheShapes) {
    for (const bool had_colors : {true, false}) {
        SCOPED_TRACE(had_colors);
        Scene scene = had_colors ? colored_scene() : uncolored_scene(1, 60);
        for (const bool many : {false, true}) {
            World world = colored_world(scene);
            std::vector<std::uint32_t> changed{2};
            if (many)
                for (std::uint32_t i = 3; i < 40; ++i) changed.push_back(i);
            Scene edited = scene;
            for (const std::uint32_t i : changed) edited.set_shape_color(i, Color{0.1 * (i % 10), 1, 0});
            if (had_colors) edited.set_shape_color(changed.back(), std::nullopt);
            ASSERT_EQ(edit_shapes(world, edited, changed).value(), ShapeEdit::refitted);
            EXPECT_TRUE(draw_the_same(world, colored_world(edited)));
        }
        // Another number of shapes: rebuilt.
        World world = colored_world(scene);
        Scene more = scene;
        more.set_shape_color(more.add(Sphere{{0, 0, 3}, 2}), Color{1, 0, 0});
        ASSERT_EQ(edit_shapes(world, more, std::vector<std::uint32_t>{0}).value(), ShapeEdit::rebuilt);
        EXPECT_TRUE(draw_the_same(world, colored_world(more)));
    }
}

TEST(ShapeColors, AreExplained) {
    const Scene scene = colored_scene(3, 200);
    const World world = colored_world(scene);
    const Image picture = render(world, {.threads = 1}).value().image;
    int colored = 0;
    for (int y = 0; y < picture.height; y += 3) {
        for (int x = 0; x < picture.width; x += 3) {
            const Explanation e = explain(scene, world, x, y).value();
            const Color drawn = picture.pixel(x, y);
            EXPECT_EQ(static_cast<float>(drawn.r), e.value[0]);
            if (!e.rays[0].hit) continue;
            const ExplainedHit& hit = *e.rays[0].hit;
            const auto color = scene.shape_color(hit.shape);
            ASSERT_EQ(hit.color, color);
            if (!color) continue;
            ++colored;
            EXPECT_EQ(material_of(hit, scene).color, *color);
            EXPECT_EQ(hit.ambient, material_of(hit, scene).ambient * scene.lights[1].color);
        }
    }
    EXPECT_GT(colored, 20);
}

TEST(ShapeColors, AreValidated) {
    const auto errors = [](const Scene& scene) {
        const Result<World> world = prepare(scene);
        return world ? std::string() : to_string(world);
    };
    Scene scene = colored_scene();
    scene.shape_colors[3] = {1, k_no_number, 0};
    EXPECT_NE(errors(scene).find("color: expected each channel to be a number from -1e6 to 1e6"),
              std::string::npos)
        << errors(scene);
    EXPECT_FALSE(with_shape_colors(colored_world(colored_scene()), scene.shape_colors));
    scene.shape_colors[3] = {1, 2e6f, 0};
    EXPECT_NE(errors(scene).find("4: color"), std::string::npos) << errors(scene);
    scene = colored_scene();
    scene.shape_colors.resize(scene.shapes.size() + 1);
    EXPECT_NE(errors(scene).find("61 colors of shapes: the scene has 60 shapes"), std::string::npos)
        << errors(scene);
    EXPECT_FALSE(with_shape_colors(colored_world(colored_scene()), scene.shape_colors));
}

TEST(ShapeColors, AreSeenByTheChecks) {
    Scene scene;
    scene.settings.width = scene.settings.height = 64;
    scene.camera.position = {0, 0, 5};
    scene.materials.push_back(with_color(Material{}, {0, 0, 1}));
    scene.lights.push_back({.position = {2, 3, 5}, .color = {1, 0, 0}, .specular_color = {1, 0, 0}});
    scene.add(Sphere{}, 0);
    const auto finds = [&] {
        const std::vector<Finding> findings = check(scene).value();
        for (const Finding& f : findings)
            if (f.id == "light-adds-nothing") return true;
        return false;
    };
    EXPECT_TRUE(finds()) << "blue reflects no red";
    scene.set_shape_color(0, Color{1, 0, 0});
    EXPECT_FALSE(finds());
}

}  // namespace
}  // namespace glint::test
