// SPDX-License-Identifier: Apache-2.0
// What render() hands over while it draws: tiles and the fraction done, one call at a time; and pictures in
// the caller's memory.
#include <thread>

#include "trace/pictures.h"

namespace glint::test {
namespace {

constexpr int k_width = 203, k_height = 150;  // no multiples of a tile's side

World some_world() {
    Scene scene;
    set_size(scene, k_width, k_height);
    scene.camera.position = {0, 2, 8};
    scene.background = {0.1, 0.2, 0.3};
    Material mirror;
    mirror.mirror = 0.5;
    add_material(scene, mirror);
    scene.add(Plane{{0, -1, 0}, {0, 1, 0}}, 0);
    for (int i = 0; i < 5; ++i) scene.add(Sphere{{i - 2.0, 0, 0}, 0.6});
    scene.lights = {point_light({5, 6, 7})};
    return *make_world(scene);
}

class Tiles : public testing::TestWithParam<int> {};

TEST_P(Tiles, CoverThePictureOnceWithItsFinalPixels) {
    const World world = some_world();
    const Image whole = render_world(world);
    for (const Crop& crop : {Crop{k_width, k_height, 0, 0}, Crop{97, 71, 23, 40}}) {
        RenderOptions options;
        options.threads = GetParam();
        options.crop = crop;
        std::vector<int> drawn(static_cast<std::size_t>(k_width * k_height));
        bool inside = false;
        double before = 0;
        options.on_tile = [&](const FinishedTile& tile) {
            EXPECT_FALSE(inside) << "one call at a time";
            inside = true;
            for (int y = 0; y < tile.area.height; ++y) {
                for (int x = 0; x < tile.area.width; ++x) {
                    const int px = tile.area.x + x, py = tile.area.y + y;
                    ASSERT_TRUE(px >= crop.x && px < crop.x + crop.width && py >= crop.y &&
                                py < crop.y + crop.height);
                    ++drawn[static_cast<std::size_t>(py * k_width + px)];
                    const float* rgb = tile.rgb + static_cast<std::size_t>(y) * tile.row_floats + 3 * x;
                    ASSERT_EQ((Color{rgb[0], rgb[1], rgb[2]}), whole.pixel(px, py)) << px << ", " << py;
                }
            }
            std::this_thread::yield();
            inside = false;
        };
        options.progress = [&](double done) {
            EXPECT_FALSE(inside) << "one call at a time";
            EXPECT_GT(done, before);
            before = done;
        };
        ASSERT_TRUE(render(world, options));
        EXPECT_EQ(before, 1);
        for (int y = 0; y < k_height; ++y) {
            for (int x = 0; x < k_width; ++x) {
                const bool within =
                    x >= crop.x && x < crop.x + crop.width && y >= crop.y && y < crop.y + crop.height;
                ASSERT_EQ(drawn[static_cast<std::size_t>(y * k_width + x)], within ? 1 : 0) << x << ", " << y;
            }
        }
    }
}

TEST_P(Tiles, GoIntoTheCallersMemory) {
    const World world = some_world();
    const Crop crop{97, 71, 23, 40};
    RenderOptions options;
    options.threads = GetParam();
    options.crop = crop;
    const Image expected = render_world(world, options);
    std::vector<float> memory(expected.rgb.size() + 2, -7);
    options.pixels = std::span(memory).subspan(1, expected.rgb.size());
    options.on_tile = [&](const FinishedTile& tile) {
        EXPECT_EQ(tile.rgb, &memory[1] + 3 * ((tile.area.y - crop.y) * crop.width + tile.area.x - crop.x));
        EXPECT_EQ(tile.row_floats, std::size_t{3} * crop.width);
    };
    const Result<Rendering> result = render(world, options);
    ASSERT_TRUE(result) << result.message;
    EXPECT_EQ(result->image.width, crop.width);
    EXPECT_EQ(result->image.height, crop.height);
    EXPECT_TRUE(result->image.rgb.empty());
    EXPECT_TRUE(std::equal(expected.rgb.begin(), expected.rgb.end(), memory.begin() + 1));
    EXPECT_EQ(memory.front(), -7);
    EXPECT_EQ(memory.back(), -7);
}

TEST_P(Tiles, AreWhatACancelledRenderLeaves) {
    const World world = some_world();
    const Image whole = render_world(world);
    std::vector<float> memory(whole.rgb.size(), -7);
    std::atomic<bool> cancel{false};
    RenderOptions options;
    options.threads = GetParam();
    options.pixels = memory;
    options.cancel = &cancel;
    options.on_tile = [&](const FinishedTile&) { cancel = true; };
    EXPECT_EQ(render(world, options).code, ErrorCode::cancelled);
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < memory.size(); ++i) {
        if (memory[i] == -7) continue;
        ++drawn;
        ASSERT_EQ(memory[i], whole.rgb[i]) << i;
    }
    EXPECT_GT(drawn, 0u);
    EXPECT_LT(drawn, memory.size());
}

INSTANTIATE_TEST_SUITE_P(Threads, Tiles, testing::Values(1, 3));

}  // namespace
}  // namespace glint::test
