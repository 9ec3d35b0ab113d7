// SPDX-License-Identifier: Apache-2.0
// The callbacks of render(): finished tiles and the fraction done, one call at a time. Rendering into the
// caller's memory.
#include <thread>

#include "trace/pictures.h"
#include "world/world.h"

namespace glint::test {
namespace {

constexpr int k_width = 203, k_height = 150;  // not multiples of a tile's side

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

TEST_P(Tiles, AreWrittenToTheCallersMemory) {
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

TEST_P(Tiles, AreFinalAfterACancelledRender) {
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

// A tile of 64 x 64 samples takes seconds.
TEST_P(Tiles, AreNotFinishedAfterACancel) {
    const World uniform = some_world();
    RenderSettings settings = uniform.parts().settings;
    settings.samples = 64;
    settings.aa_threshold = 0.0;
    const World adaptive = *with_rules(uniform, uniform.parts().conventions, settings);
    for (const World& world : {uniform, adaptive}) {
        std::vector<float> memory(3 * std::size_t{k_width} * k_height, -7);
        std::atomic<bool> cancel{false};
        RenderOptions options;
        options.threads = GetParam();
        options.pixels = memory;
        options.cancel = &cancel;
        options.next_tile = [&]() -> std::optional<std::uint32_t> {
            cancel = true;
            return 17;  // in the middle: it is not empty
        };
        options.on_tile = [&](const FinishedTile&) { ADD_FAILURE(); };
        EXPECT_EQ(render(world, options).code, ErrorCode::cancelled);
        EXPECT_EQ(std::count(memory.begin(), memory.end(), -7.0f),
                  static_cast<std::ptrdiff_t>(memory.size()));
    }
}

TEST_P(Tiles, OfASubsetAreThoseOfTheWhole) {
    const World world = some_world();
    for (const Crop& crop : {Crop{k_width, k_height, 0, 0}, Crop{97, 71, 23, 40}}) {
        RenderOptions options;
        options.threads = GetParam();
        options.crop = crop;
        options.layers = {Layer::diffuse, Layer::depth};
        const Rendering whole = *render(world, options);
        std::vector<std::uint32_t> wanted;
        for (std::uint32_t tile = 1; tile < count_tiles(crop); tile += 3) wanted.push_back(tile);
        std::vector<float> memory(whole.image.rgb.size(), -7);
        options.pixels = memory;
        std::atomic<std::size_t> next{0};
        options.next_tile = [&]() -> std::optional<std::uint32_t> {
            const std::size_t i = next++;
            if (i >= wanted.size()) return std::nullopt;
            return wanted[i];
        };
        std::vector<std::uint32_t> handed_over;
        RayCounts rays;
        options.on_tile = [&](const FinishedTile& tile) {
            handed_over.push_back(tile.number);
            EXPECT_EQ(tile.area.x, tile_area(crop, tile.number).x);
            EXPECT_EQ(tile.layers.size(), 2u);
            rays.camera += tile.rays.camera;
        };
        const Rendering part = *render(world, options);
        std::sort(handed_over.begin(), handed_over.end());
        EXPECT_EQ(handed_over, wanted);
        EXPECT_EQ(rays.camera, part.rays.camera);
        std::vector<char> inside(memory.size() / 3);
        for (const std::uint32_t tile : wanted) {
            const Crop area = tile_area(crop, tile);
            for (int y = area.y - crop.y; y < area.y - crop.y + area.height; ++y) {
                for (int x = area.x - crop.x; x < area.x - crop.x + area.width; ++x)
                    inside[static_cast<std::size_t>(y * crop.width + x)] = 1;
            }
        }
        for (std::size_t i = 0; i < memory.size(); ++i)
            ASSERT_EQ(memory[i], inside[i / 3] ? whole.image.rgb[i] : -7) << i;
        for (std::size_t i = 0; i < inside.size(); ++i)
            ASSERT_EQ(part.layers[1].values[i], inside[i] ? whole.layers[1].values[i] : 0) << i;
    }
}

TEST_P(Tiles, WithoutAnImage) {
    const World world = some_world();
    const Crop crop{97, 71, 23, 40};
    RenderOptions options;
    options.threads = GetParam();
    options.crop = crop;
    options.layers = {Layer::position, Layer::depth};
    const Rendering whole = *render(world, options);
    std::size_t pixels = 0;
    options.keep_image = false;
    options.on_tile = [&](const FinishedTile& tile) {
        ASSERT_EQ(tile.layers.size(), 2u);
        EXPECT_EQ(tile.layers[0].layer, Layer::position);
        EXPECT_EQ(tile.layers[1].channels, 1);
        const auto expect_row = [&](const float* values, std::size_t row_floats, std::size_t channels,
                                    const std::vector<float>& expected, std::int32_t y) {
            const std::size_t first =
                static_cast<std::size_t>((tile.area.y - crop.y + y) * crop.width + tile.area.x - crop.x);
            values += static_cast<std::size_t>(y) * row_floats;
            for (std::size_t i = 0; i < channels * static_cast<std::size_t>(tile.area.width); ++i)
                ASSERT_EQ(values[i], expected[channels * first + i]);
        };
        for (std::int32_t y = 0; y < tile.area.height; ++y) {
            expect_row(tile.rgb, tile.row_floats, 3, whole.image.rgb, y);
            for (std::size_t l = 0; l < 2; ++l) {
                expect_row(tile.layers[l].values, tile.layers[l].row_floats,
                           static_cast<std::size_t>(tile.layers[l].channels), whole.layers[l].values, y);
            }
            pixels += static_cast<std::size_t>(tile.area.width);
        }
    };
    const Rendering none = *render(world, options);
    EXPECT_EQ(pixels, 97u * 71u);
    EXPECT_EQ(none.image.width, crop.width);
    EXPECT_TRUE(none.image.rgb.empty());
    ASSERT_EQ(none.layers.size(), 2u);
    EXPECT_TRUE(none.layers[1].values.empty());
    EXPECT_EQ(none.rays.total(), whole.rays.total());
}

INSTANTIATE_TEST_SUITE_P(Threads, Tiles, testing::Values(1, 3));

}  // namespace
}  // namespace glint::test
