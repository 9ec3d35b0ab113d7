// SPDX-License-Identifier: Apache-2.0
// The layers of a picture: their light adds up to it, and they describe the visible surfaces.
#include "glint/layers.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "gallery/scene_file.h"

namespace glint::test {
namespace {

std::vector<Layer> all_layers() {
    std::vector<Layer> layers;
    for (const LayerInfo& info : layer_infos()) layers.push_back(info.layer);
    return layers;
}

const LayerImage& of(const Result<Rendering>& result, Layer layer) {
    return result->layers[static_cast<std::size_t>(layer)];  // all layers were requested
}

Result<Rendering> with_layers(const World& world, std::optional<Crop> crop = {}) {
    RenderOptions options;
    options.layers = all_layers();
    options.crop = crop;
    return render(world, options);
}

TEST(Layers, LightAddsUpToThePicture) {
    for (const std::string& file : test::scene_files(GLINT_PROJECT_DIR "/scenes")) {
        SCOPED_TRACE(file);
        auto scene = test::load_file(file);
        ASSERT_TRUE(scene);
        scene->settings.height = 131 * scene->settings.height / scene->settings.width;
        scene->settings.width = 131;
        const Result<World> world = prepare(*scene);
        const Result<Rendering> plain = render(*world), result = with_layers(*world);
        ASSERT_TRUE(plain && result);
        ASSERT_EQ(result->layers.size(), std::size_t{k_layers});
        EXPECT_EQ(plain->image.rgb, result->image.rgb) << "requesting layers changes the picture";
        EXPECT_EQ(plain->rays.total(), result->rays.total());
        for (std::size_t i = 0; i < plain->image.rgb.size(); ++i) {
            float sum = 0;
            for (int l = 0; l < k_light_layers; ++l) sum += of(result, static_cast<Layer>(l)).values[i];
            ASSERT_EQ(sum, plain->image.rgb[i]) << "value " << i;
        }
    }
}

TEST(Layers, DescribeTheFirstSurface) {
    Scene scene;
    scene.background = {0, 0, 1};
    scene.materials.resize(2);
    scene.materials[1].diffuse = {0.1, 0.2, 0.3};
    scene.add(Plane{.point = {0, -1, 0}}, 0);
    scene.add(Sphere{.center = {0, 0, -5}, .radius = 1}, 1);
    scene.lights.push_back({.position = {0, 0, 10}});
    scene.lights.push_back({.kind = LightKind::directional, .to_light = {1, 1, 0.3}});
    scene.settings.width = scene.settings.height = 33;
    const Result<World> world = prepare(scene);
    ASSERT_TRUE(world);
    const Result<Rendering> r = with_layers(*world);
    const std::size_t middle = 16 * 33 + 16, sky = 16;
    EXPECT_FLOAT_EQ(of(r, Layer::depth).values[middle], 4);
    EXPECT_EQ(of(r, Layer::object).values[middle], 2);
    EXPECT_EQ(of(r, Layer::material).values[middle], 2);
    EXPECT_FLOAT_EQ(of(r, Layer::normal).values[3 * middle + 2], 1);
    EXPECT_FLOAT_EQ(of(r, Layer::position).values[3 * middle + 2], -4);
    EXPECT_EQ(of(r, Layer::albedo).values[3 * middle + 1], 0.2f);
    EXPECT_EQ(of(r, Layer::shadow).values[middle], 0);
    EXPECT_TRUE(std::isinf(of(r, Layer::depth).values[sky]));
    EXPECT_EQ(of(r, Layer::object).values[sky], 0);
    EXPECT_EQ(of(r, Layer::normal).values[3 * sky], 0);
    EXPECT_EQ(of(r, Layer::background).values[3 * sky + 2], 1);
    // The sphere casts a shadow on the plane.
    bool shadowed = false;
    for (std::size_t p = 0; p < 33 * 33; ++p) {
        const float share = of(r, Layer::shadow).values[p];
        ASSERT_TRUE(share == 0 || share == 0.5f || share == 1);
        shadowed = shadowed || (share > 0 && of(r, Layer::object).values[p] == 1);
    }
    EXPECT_TRUE(shadowed);
}

TEST(Layers, AreTheSameInCropsAndOnEveryInstructionSet) {
    const auto scene = test::load_file(GLINT_PROJECT_DIR "/scenes/glint/still_life.glint", "size=90x70 aa=3");
    ASSERT_TRUE(scene);
    const Result<World> world = prepare(*scene);
    const Result<Rendering> whole = with_layers(*world), part = with_layers(*world, Crop{40, 33, 21, 17});
    ASSERT_TRUE(whole && part);
    for (int l = 0; l < k_layers; ++l) {
        const LayerImage &w = of(whole, static_cast<Layer>(l)), &p = of(part, static_cast<Layer>(l));
        const auto channels = static_cast<std::size_t>(w.channels);
        for (std::size_t y = 0; y < 33; ++y)
            for (std::size_t i = 0; i < 40 * channels; ++i)
                ASSERT_EQ(p.values[y * 40 * channels + i], w.values[((y + 17) * 90 + 21) * channels + i])
                    << l;
        for (const std::string& isa : isa_names()) {
            RenderOptions options;
            options.layers = all_layers();
            options.isa = isa;
            EXPECT_EQ(of(render(*world, options), static_cast<Layer>(l)).values, w.values) << isa << " " << l;
        }
    }
}

TEST(Layers, InvalidRequests) {
    const Result<World> world = prepare(Scene{});
    RenderOptions options;
    options.layers = {Layer::depth, Layer::depth};
    EXPECT_EQ(render(*world, options).code, ErrorCode::invalid_argument);
    options.layers = {static_cast<Layer>(77)};
    EXPECT_EQ(render(*world, options).code, ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace glint::test
