// SPDX-License-Identifier: Apache-2.0
// Rendering with invalid options.
#include "misuse/misused.h"

namespace glint::test {
namespace {

void expect_error(const Result<Rendering>& result, const char* what) {
    EXPECT_NE(result.message, "") << what;
    EXPECT_FALSE(result) << what;
    EXPECT_EQ(result.code, ErrorCode::invalid_argument) << what;
}

TEST(Misuse, OfRender) {
    const Scene scene = some_scene();
    const World world = world_of(scene);
    RenderOptions options;
    for (const char* const isa : {"avx9", " ", "AVX2", "avx2,sse4"}) {
        options.isa = isa;
        expect_error(render(world, options), isa);
    }
    const std::int32_t most = std::numeric_limits<std::int32_t>::max(),
                       least = std::numeric_limits<std::int32_t>::min();
    for (const Crop crop : {Crop{}, Crop{0, 5, 0, 0}, Crop{-1, 5, 0, 0}, Crop{17, 1, 0, 0}, Crop{1, 13, 0, 0},
                            Crop{1, 1, 16, 0}, Crop{1, 1, -1, 0}, Crop{most, most, most, most},
                            Crop{least, least, least, least}, Crop{1, 1, most, most}, Crop{most, 1, 1, 0}}) {
        options = {};
        options.crop = crop;
        expect_error(render(world, options), "crop");
    }
    for (const auto& layers : std::vector<std::vector<Layer>>{
             {beyond<Layer>()}, {static_cast<Layer>(k_layers)}, {Layer::depth, Layer::depth}}) {
        options = {};
        options.layers = layers;
        expect_error(render(world, options), "layers");
    }
    for (const int threads : {-1, std::numeric_limits<int>::min(), 1000, std::numeric_limits<int>::max()}) {
        options = {};
        options.threads = threads;
        EXPECT_TRUE(render(world, options)) << threads;
    }
    std::vector<float> memory(3 * 16 * 12 + 1);
    for (const std::size_t size : {std::size_t{0}, memory.size() - 2, memory.size()}) {
        options = {};
        options.pixels = std::span(memory).first(size);
        expect_error(render(world, options), "pixels");
    }
    options.pixels = std::span<float>();
    expect_error(render(world, options), "no pixels");
    options.pixels = std::span(memory).first(3 * 16 * 12);
    EXPECT_TRUE(render(world, options));
    options.keep_image = false;
    expect_error(render(world, options), "keep_image");
    for (const std::uint32_t tile : {1u, k_none}) {  // the picture has one tile
        options = {};
        options.next_tile = [tile] { return tile; };
        expect_error(render(world, options), "next_tile");
    }
    const std::atomic<bool> cancel{true};
    options = {};
    options.cancel = &cancel;
    const Result<Rendering> cancelled = render(world, options);
    EXPECT_EQ(cancelled.code, ErrorCode::cancelled);
    EXPECT_FALSE(cancelled);
    EXPECT_FALSE(isa_names().empty());
}

TEST(Misuse, OfTiles) {
    const std::int32_t most = std::numeric_limits<std::int32_t>::max(),
                       least = std::numeric_limits<std::int32_t>::min();
    for (const Crop none : {Crop{}, Crop{0, 5, 0, 0}, Crop{5, -1, 0, 0}, Crop{least, least, 0, 0}}) {
        EXPECT_EQ(count_tiles(none), 0u);
        EXPECT_EQ(tile_area(none, 0).width, 0);
    }
    EXPECT_EQ(count_tiles({most, most, 0, 0}), std::size_t{1} << 52);
    const Crop crop{33, 32, 5, 6};
    EXPECT_EQ(count_tiles(crop), 2u);
    EXPECT_EQ(tile_area(crop, 1).width, 1);
    EXPECT_EQ(tile_area(crop, 1).x, 37);
    EXPECT_EQ(tile_area(crop, 2).width, 0);
    EXPECT_EQ(tile_area(crop, std::numeric_limits<std::size_t>::max()).height, 0);
}

TEST(Misuse, OfPrepare) {
    for (const int threads : {-1, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()})
        EXPECT_TRUE(prepare(some_scene(), {.threads = threads})) << threads;
    Scene invalid = some_scene();
    invalid.camera.look_at = invalid.camera.position;
    const Result<World> prepared = prepare(invalid);
    EXPECT_FALSE(prepared);
    EXPECT_TRUE(has_errors(prepared.diagnostics));
    const std::atomic<bool> cancel{true};
    const Result<World> cancelled = prepare(some_scene(), {.cancel = &cancel});
    EXPECT_FALSE(cancelled);
    EXPECT_EQ(cancelled.code, ErrorCode::cancelled);
}

TEST(Misuse, OfAWorldWithoutShapes) {
    Scene scene;
    scene.settings.width = scene.settings.height = 3;
    const World world = world_of(scene);
    const Bounds box = scene_bounds(world);
    EXPECT_GT(box.min.x, box.max.x);
    EXPECT_EQ(memory_usage(world).packed, 0u);
    EXPECT_EQ(memory_usage(world).each(), 0);
    EXPECT_EQ(WorldMemory{}.total(), 0u);
    EXPECT_EQ(RayCounts{}.total(), 0u);
    EXPECT_TRUE(render(world));
}

TEST(Misuse, OfADefaultOrMovedFromWorld) {
    World world = world_of(some_scene());
    const World elsewhere = std::move(world);
    EXPECT_EQ(render(elsewhere).value().image.width, 16);
    // NOLINTNEXTLINE(bugprone-use-after-move): that is what is tested
    for (const World& empty : {World{}, world}) {
        EXPECT_EQ(render(empty).value().image.width, RenderSettings{}.width);
        EXPECT_EQ(memory_usage(empty).packed, 0u);
        EXPECT_GT(scene_bounds(empty).min.x, scene_bounds(empty).max.x);
        const Ray ray{{0, 0, 5}, {0, 0, -1}};
        EXPECT_EQ(nearest_hits(empty, {&ray, 1}).value().at(0).shape, k_none);
        EXPECT_EQ(occluded(empty, {&ray, 1}).value().at(0), 0);
        EXPECT_EQ(explain(Scene{}, empty, 3, 4).message, "");
        EXPECT_NE(explain(some_scene(), empty, 3, 4).message, "");
        EXPECT_FALSE(with_material(empty, 0, Material{}));
        EXPECT_TRUE(with_lights(empty, {}));
    }
    EXPECT_FALSE(Result<World>{});
}

// The World does not refer to the Scene.
TEST(Misuse, OfASceneThatIsGone) {
    auto scene = std::make_unique<Scene>(some_scene());
    const World world = world_of(*scene);
    const Image before = render(world).value().image;
    *scene = {};
    scene.reset();
    EXPECT_EQ(render(world).value().image.rgb, before.rgb);
}

}  // namespace
}  // namespace glint::test
