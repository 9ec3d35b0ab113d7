// SPDX-License-Identifier: Apache-2.0
// The layers that show one light, or none.
#include <gtest/gtest.h>

#include <cmath>

#include "gallery/scene_file.h"

namespace glint::test {
namespace {

std::vector<Layer> light_layers(const Scene& scene) {
    std::vector<Layer> layers{Layer::no_light};
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) layers.push_back(light_layer(i));
    return layers;
}

Rendering rendered(const World& world, std::vector<Layer> layers, std::optional<Crop> crop = {},
                   const std::string& isa = {}) {
    RenderOptions options;
    options.layers = std::move(layers);
    options.crop = crop;
    options.isa = isa;
    return render(world, options).value();
}

// Renders all light layers; their sum is the picture, and each light adds something to it.
void expect_sum(const Scene& scene) {
    const World world = prepare(scene).value();
    const Rendering plain = rendered(world, {}), r = rendered(world, light_layers(scene));
    ASSERT_EQ(plain.image.rgb, r.image.rgb) << "requesting layers changes the picture";
    for (std::size_t i = 0; i < r.image.rgb.size(); ++i) {
        double sum = 0, most = 1;
        for (const LayerImage& layer : r.layers) {
            sum += static_cast<double>(layer.values[i]);
            most = std::max(most, std::abs(static_cast<double>(layer.values[i])));
        }
        ASSERT_NEAR(sum, r.image.rgb[i], 1e-5 * most) << "value " << i;
    }
}

TEST(LightLayers, AddUpToThePictureInTheGallery) {
    for (const std::string& file : scene_files(GLINT_PROJECT_DIR "/scenes")) {
        SCOPED_TRACE(file);
        auto scene = load_file(file);
        ASSERT_TRUE(scene);
        if (scene->shapes.size() > 10000 || scene->lights.size() > 20) continue;
        scene->settings.height = 51 * scene->settings.height / scene->settings.width;
        scene->settings.width = 51;
        expect_sum(*scene);
    }
}

TEST(LightLayers, AddUpWithAdaptiveSampling) {
    for (const char* const settings :
         {"size=67x51 aa=adaptive:3:0.02", "size=67x51 aa=adaptive:2:0.1:jitter"}) {
        for (const char* const name : {"window", "stained_glass", "colonnade", "three_spots", "peapod"}) {
            SCOPED_TRACE(name);
            const auto scene =
                load_file(GLINT_PROJECT_DIR "/scenes/glint/" + std::string(name) + ".glint", settings);
            ASSERT_TRUE(scene);
            expect_sum(*scene);
        }
    }
}

// A mirror and a glass ball in fog, in front of a gradient, under lights of every kind.
Scene some_lights() {
    Scene scene;
    scene.settings.width = 67, scene.settings.height = 50;
    scene.camera.position = {0, 1.5, 6};
    scene.camera.look_at = Vec3{0, 0.5, 0};
    scene.background = {0.2, 0.3, 0.4};
    scene.gradient = BackgroundGradient{};
    scene.fog = Fog{.color = {0.6, 0.5, 0.4}, .density = 0.05};
    scene.occlusion = Occlusion{.samples = 8, .color = {0.2, 0.2, 0.3}, .direct = 0.7};
    scene.materials.resize(3);
    scene.materials[0].emission = {0.1, 0.2, 0};
    scene.materials[1].mirror = 0.5;
    scene.materials[2].transmission = 0.6, scene.materials[2].ior = 1.4;
    scene.add(Plane{.point = {0, 0, 0}, .normal = {0, 1, 0}}, 1);
    scene.add(Sphere{.center = {-0.8, 0.6, 0}, .radius = 0.6}, 0);
    scene.add(Sphere{.center = {0.8, 0.6, 1}, .radius = 0.6}, 2);
    scene.lights.push_back({.kind = LightKind::ambient, .color = {0.3, 0.3, 0.3}});
    scene.lights.push_back({.position = {3, 4, 2}, .color = {0.5, 0.2, 0.2}});
    scene.lights.push_back(
        {.kind = LightKind::directional, .to_light = {-1, 1, 1}, .color = {0.1, 0.3, 0.1}});
    scene.lights.push_back({.kind = LightKind::ambient, .color = {0, 0, 0.2}});
    scene.lights.push_back({.kind = LightKind::sphere,
                            .position = {-3, 4, 3},
                            .color = {0.2, 0.2, 0.5},
                            .radius = 0.5,
                            .samples_u = 2,
                            .samples_v = 2,
                            .jitter = true});
    for (Light& light : scene.lights) light.specular_color = light.color;
    return scene;
}

TEST(LightLayers, AddUpForLightsOfEachKind) {
    Scene scene = some_lights();
    expect_sum(scene);
    scene.settings.samples = 2;
    expect_sum(scene);
    scene.settings.alpha = true;
    expect_sum(scene);
    scene.gradient.reset();
    scene.conventions.limit = LimitRule::background;
    scene.settings.reflections = 1;
    expect_sum(scene);
    scene.settings.shading = Shading::normals;
    expect_sum(scene);
}

TEST(LightLayers, AreTheSceneWithBlackOthers) {
    const Scene scene = some_lights();
    const Rendering r = rendered(prepare(scene).value(), light_layers(scene));
    for (std::uint32_t light = 0; light < scene.lights.size(); ++light) {
        Scene alone = scene;
        for (std::uint32_t i = 0; i < alone.lights.size(); ++i)
            if (i != light) alone.lights[i].color = alone.lights[i].specular_color = {0, 0, 0};
        alone.background = alone.fog->color = alone.occlusion->color = {0, 0, 0};
        alone.gradient.reset();
        alone.materials[0].emission = {0, 0, 0};
        EXPECT_EQ(rendered(prepare(alone).value(), {}).image.rgb, r.layers[light + 1].values) << light;
    }
    Scene none = scene;
    none.lights.clear();
    EXPECT_EQ(rendered(prepare(none).value(), {}).image.rgb, r.layers[0].values);
}

TEST(LightLayers, AreTheSameInCropsTilesAndOnEveryInstructionSet) {
    for (const bool adaptive : {false, true}) {
        Scene scene = some_lights();
        scene.settings.samples = 2;
        if (adaptive) scene.settings.aa_threshold = 0.05;
        const World world = prepare(scene).value();
        std::vector<Layer> wanted = light_layers(scene);
        wanted.insert(wanted.begin() + 2, Layer::depth);
        const Rendering whole = rendered(world, wanted), part = rendered(world, wanted, Crop{40, 33, 21, 13});
        for (std::size_t l = 0; l < wanted.size(); ++l) {
            const std::size_t channels = static_cast<std::size_t>(whole.layers[l].channels);
            for (std::size_t y = 0; y < 33; ++y)
                for (std::size_t i = 0; i < 40 * channels; ++i)
                    ASSERT_EQ(part.layers[l].values[y * 40 * channels + i],
                              whole.layers[l].values[((y + 13) * 67 + 21) * channels + i])
                        << l;
        }
        for (const std::string& isa : isa_names()) {
            const Rendering other = rendered(world, wanted, {}, isa);
            for (std::size_t l = 0; l < wanted.size(); ++l)
                EXPECT_EQ(other.layers[l].values, whole.layers[l].values) << isa << " " << l;
        }
        // In the memory of tiles.
        RenderOptions options;
        options.layers = wanted;
        options.keep_image = false;
        bool same = true;
        options.on_tile = [&](const FinishedTile& tile) {
            for (std::size_t l = 0; l < wanted.size(); ++l) {
                const TileLayer& layer = tile.layers[l];
                const auto channels = static_cast<std::size_t>(layer.channels);
                for (std::int32_t y = 0; y < tile.area.height; ++y)
                    for (std::size_t i = 0; i < static_cast<std::size_t>(tile.area.width) * channels; ++i)
                        same =
                            same &&
                            layer.values[static_cast<std::size_t>(y) * layer.row_floats + i] ==
                                whole.layers[l]
                                    .values[static_cast<std::size_t>((tile.area.y + y) * 67 + tile.area.x) *
                                                channels +
                                            i];
            }
        };
        ASSERT_TRUE(render(world, options));
        EXPECT_TRUE(same);
    }
}

TEST(LightLayers, HaveNames) {
    EXPECT_EQ(layer_name(light_layer(1)), "light:2");
    EXPECT_EQ(layer_name(Layer::no_light), "light:none");
    EXPECT_EQ(layer_name(Layer::depth), "depth");
    EXPECT_EQ(layer_name(static_cast<Layer>(77)), "");
    EXPECT_EQ(layer_channels(light_layer(1)), "RGB");
    EXPECT_EQ(layer_channels(static_cast<Layer>(77)), "");
    EXPECT_EQ(find_layer("light:2"), light_layer(1));
    EXPECT_EQ(find_layer("light:none"), Layer::no_light);
    EXPECT_EQ(light_of(light_layer(k_max_light_layers - 1)), k_max_light_layers - 1);
    EXPECT_EQ(light_of(Layer::no_light), std::nullopt);
    for (const char* const name :
         {"light:", "light:0", "light:-1", "light:2x", "light:lamp", "light:4294967295", "light"})
        EXPECT_FALSE(find_layer(name)) << name;
    Scene scene = some_lights();
    scene.light_texts.names = {{1, "lamp"}, {2, "lamp"}, {4, "1"}};
    EXPECT_EQ(find_layer("light:lamp", scene), light_layer(1));
    EXPECT_EQ(find_layer("light:1", scene), light_layer(4));
    EXPECT_EQ(find_layer("light:3", scene), light_layer(2));
    EXPECT_EQ(find_layer("light:none", scene), Layer::no_light);
    EXPECT_EQ(find_layer("depth", scene), Layer::depth);
    for (const char* const name : {"light:6", "light:0", "light:lam", "light:", "lamp"})
        EXPECT_FALSE(find_layer(name, scene)) << name;
}

TEST(LightLayers, InvalidRequests) {
    const Scene scene = some_lights();
    const World world = prepare(scene).value();
    RenderOptions options;
    options.layers = {light_layer(5)};
    EXPECT_EQ(render(world, options).message, "there is no light 6 for the layer 'light:6': the scene has 5");
    options.layers = {light_layer(4), light_layer(4)};
    EXPECT_EQ(render(world, options).message, "the layer 'light:5' is asked for twice");
    options.layers = {static_cast<Layer>(0xfffe)};
    EXPECT_EQ(render(world, options).code, ErrorCode::invalid_argument);
    options.layers = {static_cast<Layer>(0xffffffff)};
    EXPECT_EQ(render(world, options).code, ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace glint::test
