// SPDX-License-Identifier: Apache-2.0
// The same bits for any threads, instruction set, crop and floating-point state of the caller; and what
// render() reports.
#include <gtest/gtest.h>
#include <oneapi/tbb/task_arena.h>

#include <atomic>
#include <chrono>
#include <mutex>

#include "trace/kernels.h"
#include "trace/pictures.h"
#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace glint::test {
namespace {

// A sanitizer makes rendering 5 to 20 times slower, and finds no more with more samples.
#if defined(GLINT_SANITIZED)
constexpr int k_samples = 1;
#else
constexpr int k_samples = 3;
#endif

// Every kind of shape, mirrors, glass, several lights, shadows, k_samples a side.
Scene everything() {
    Random random(91);
    Scene scene = random_scene(random, 150, 6);
    set_size(scene, 101, 75);
    scene.settings.samples = k_samples;
    scene.settings.reflections = 3;
    scene.conventions.fresnel = Fresnel::schlick;
    scene.conventions.beer = 0.2;
    scene.background = {0.2, 0.3, 0.4};
    scene.camera.position = {0, 2, 16};
    scene.camera.look_at = {0, 0, 0};
    for (int i = 0; i < 7; ++i) {
        Material m;
        m.diffuse = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
        m.specular = {0.5, 0.4, 0.3};
        m.shininess = log_uniform(random, 1, 300);
        m.mirror = i % 2 == 0 ? 0.4 : 0;
        m.transmission = i % 3 == 0 ? 0.7 : 0;
        m.transmission_tint = {1, 0.6, random.uniform(0, 1)};
        m.ior = 1.3;
        add_material(scene, m);
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        scene.shapes[i].material = static_cast<std::uint32_t>(i % 7);
    scene.lights = {ambient_light({0.3, 0.3, 0.3}), point_light({5, 9, 9}),
                    point_light({-9, 3, 5}, {0.5, 0.4, 0.9}), directional_light({1, 2, 3}, {0.2, 0.3, 0.1})};
    scene.lights[1].attenuation = {0.3, 0.02, 0.001};
    return scene;
}

const World& everything_world() {
    static const std::optional<World> world = make_world(everything());
    return *world;
}
const Image& everything_image() {
    static const Image image = [] {
        RenderOptions options;
        options.threads = 1;
        return render_world(everything_world(), options);
    }();
    return image;
}

TEST(Invariance, InstructionSetsAndThreads) {
    for (const std::string& isa : isa_names()) {
        for (const int threads : {1, 2, 7}) {
            SCOPED_TRACE(isa + ", " + std::to_string(threads) + " threads");
            RenderOptions options;
            options.isa = isa;
            options.threads = threads;
            Result<Rendering> result = render(everything_world(), options);
            ASSERT_TRUE(result);
            EXPECT_EQ(result->isa, isa);
            EXPECT_EQ(result->threads, threads);
            expect_same_picture(everything_image(), result->image);
        }
    }
}

TEST(Invariance, WorldsPreparedByAnyNumberOfThreads) {
    for (const int threads : {2, 7}) {
        const std::optional<World> world = make_world(everything(), threads);
        expect_same_picture(everything_image(), render_world(*world));
    }
}

TEST(Invariance, PictureAssembledFromCrops) {
    Random random(92);
    const Image& whole = everything_image();
    Image built = whole;
    built.rgb.assign(built.rgb.size(), -1);
    RayCounts rays;
    // Random columns, each divided into random rows.
    for (int x = 0; x < whole.width;) {
        const int width = std::min(whole.width - x, 1 + below(random, 45));
        for (int y = 0; y < whole.height;) {
            const int height = std::min(whole.height - y, 1 + below(random, 45));
            RenderOptions options;
            options.crop = Crop{width, height, x, y};
            options.threads = 1 + below(random, 2);
            Result<Rendering> result = render(everything_world(), options);
            ASSERT_TRUE(result);
            ASSERT_EQ(result->image.width, width);
            ASSERT_EQ(result->image.height, height);
            rays.camera += result->rays.camera;
            for (int row = 0; row < height; ++row) {
                const auto from = result->image.rgb.begin() + 3 * row * width;
                std::copy(from, from + 3 * width, built.rgb.begin() + 3 * ((y + row) * whole.width + x));
            }
            y += height;
        }
        x += width;
    }
    expect_same_picture(whole, built);
    EXPECT_EQ(rays.camera, unsigned{k_samples * k_samples} * 101u * 75u);
}

// Threads of an application that works in a task_arena.
TEST(Invariance, ArenaOfTheCaller) {
    for (const int threads : {1, 2}) {
        oneapi::tbb::task_arena arena(threads);
        const Result<Rendering> result = arena.execute([] { return render(everything_world()); });
        ASSERT_TRUE(result);
        EXPECT_EQ(result->threads, threads);
        expect_same_picture(everything_image(), result->image);
    }
}

TEST(Invariance, TileCulling) {
    // With an infinite plane behind the camera the picture is the same, but no tile is culled.
    Random random(94);
    for (int i = 0; i < 100; ++i) {
        const double far = log_uniform(random, 5, 1e6);
        Scene scene;
        set_size(scene, 160 + below(random, 60), 160);
        scene.background = {0.21, 0.33, 0.47};
        scene.settings.samples = 1 + below(random, 2);
        scene.settings.shading = Shading::color;
        scene.conventions.pixel_sample = static_cast<PixelSample>(below(random, 4));
        scene.camera.position = unit_direction(random) * far;
        scene.camera.look_at = point_in_cube(random, 3);
        // A cloud of shapes of a few pixels each, which fills the picture or is in its centre.
        scene.camera.fov_degrees = std::min(150.0, log_uniform(random, 600, 3000) / far);
        for (int k = 0; k < 30; ++k) {
            const Vec3 at = point_in_cube(random, 10);
            const double size = log_uniform(random, 0.05, 1);
            scene.add(Box{at, at + Vec3{size, size, size}});
        }
        const Image known = render_scene(scene);
        const Vec3 back = scene.camera.position - scene.camera.look_at;
        scene.add(Plane{scene.camera.position + back, back});
        scene.settings.reflections = 0;
        expect_same_picture(known, render_scene(scene));
    }
}

#if defined(__SSE2__)
TEST(Invariance, TheCallersFloatingPointState) {
    const unsigned before = _mm_getcsr();
    const Scene scene = everything();
    for (const unsigned state :
         {0x1f80u | 0x8040u, 0x1f80u | 0x2000u, 0x1f80u | 0x4000u | 0x8000u, 0x1f80u | 0x6000u | 0x40u}) {
        for (const int threads : {1, 2}) {
            _mm_setcsr(state);
            Result<World> prepared = prepare(scene, {.threads = threads});
            RenderOptions options;
            options.threads = threads;
            Result<Rendering> result = prepared ? render(*prepared, options) : Result<Rendering>{};
            const unsigned after = _mm_getcsr();
            _mm_setcsr(before);
            EXPECT_EQ(after & ~0x3fu, state)
                << "the caller's state is not restored";  // except for the exception flags
            ASSERT_TRUE(result);
            expect_same_picture(everything_image(), result->image);
        }
    }
}
#endif

TEST(Invariance, SamplesAreTheMeanOfAFinerPicture) {
    // 2 x 2 samples at pixel centres are the pixel centres of a picture twice as large.
    Scene scene = everything();
    scene.settings.samples = 2;
    set_size(scene, 60, 44);
    const Image coarse = render_scene(scene);
    scene.settings.samples = 1;
    set_size(scene, 120, 88);
    const Image fine = render_scene(scene);
    for (int y = 0; y < 44; ++y) {
        for (int x = 0; x < 60; ++x) {
            const Color sum = pixel(fine, 2 * x, 2 * y) + pixel(fine, 2 * x + 1, 2 * y) +
                              pixel(fine, 2 * x, 2 * y + 1) + pixel(fine, 2 * x + 1, 2 * y + 1);
            const Color got = pixel(coarse, x, y);
            EXPECT_NEAR(got.r, sum.r / 4, 1e-6);
            EXPECT_NEAR(got.g, sum.g / 4, 1e-6);
            EXPECT_NEAR(got.b, sum.b / 4, 1e-6);
        }
    }
}

TEST(Render, ReportsProgress) {
    for (const int threads : {1, 3}) {
        std::mutex mutex;
        std::vector<double> seen;
        RenderOptions options;
        options.threads = threads;
        options.progress = [&](double done) {
            const std::lock_guard lock(mutex);
            seen.push_back(done);
        };
        ASSERT_TRUE(render(everything_world(), options));
        ASSERT_FALSE(seen.empty());
        EXPECT_EQ(*std::max_element(seen.begin(), seen.end()), 1);
        for (std::size_t i = 0; i < seen.size(); ++i) {
            EXPECT_GT(seen[i], i > 0 ? seen[i - 1] : 0);
        }
    }
}

TEST(Render, StopsWhenCancelled) {
    Scene scene = everything();
    set_size(scene, 2000, 2000);
    scene.settings.samples = 8;
    const std::optional<World> world = make_world(scene);
    for (const bool at_once : {true, false}) {
        std::atomic<bool> cancel{at_once};
        RenderOptions options;
        options.threads = 2;
        options.cancel = &cancel;
        options.progress = [&](double) { cancel = true; };
        const auto start = std::chrono::steady_clock::now();
        const Result<Rendering> result = render(*world, options);
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        EXPECT_EQ(result.code, ErrorCode::cancelled);
        EXPECT_FALSE(result);
        EXPECT_EQ(result.message, "cancelled");
#if defined(GLINT_SANITIZED)
        EXPECT_LT(seconds.count(), 30);  // the whole picture would take an hour
#else
        EXPECT_LT(seconds.count(), 5);  // the whole picture would take minutes
#endif
    }
}

TEST(Render, ReportsInvalidOptions) {
    RenderOptions options;
    options.isa = "avx9";
    Result<Rendering> result = render(everything_world(), options);
    EXPECT_FALSE(result);
    EXPECT_NE(result.message.find("avx9"), std::string::npos);
    EXPECT_NE(result.message.find(isa_names().front()), std::string::npos);
    const Crop outside[] = {{0, 10, 0, 0},   {10, -1, 0, 0},
                            {102, 1, 0, 0},  {1, 1, 101, 0},
                            {1, 1, 0, -1},   {2147483647, 2147483647, 2147483647, 2147483647},
                            {50, 50, 52, 0}, {1, 1, -2147483647 - 1, 0}};
    for (const Crop& crop : outside) {
        options = {};
        options.crop = crop;
        result = render(everything_world(), options);
        EXPECT_FALSE(result);
        EXPECT_NE(result.message, "");
    }
}

TEST(Render, CountsRaysAsTracedByHand) {
    Scene scene;
    set_size(scene, 8, 4);
    scene.settings.reflections = 2;
    scene.camera.projection = Projection::orthographic;
    scene.camera.position = {0, 10, 0};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.up = {0, 0, -1};
    scene.camera.width = 8;
    Material m;
    m.mirror = 0.5;
    const auto mirror = add_material(scene, m);
    scene.add(Plane{{0, 0, 0}, {0, 1, 0}}, mirror);
    const auto count = [&] {
        const Result<Rendering> result = render(*make_world(scene));
        EXPECT_TRUE(result);
        EXPECT_EQ(result->rays.transmitted, 0u);
        return result->rays;
    };
    RayCounts rays = count();
    EXPECT_EQ(rays.camera, 32u);
    EXPECT_EQ(rays.shadow, 0u);
    EXPECT_EQ(rays.mirror, 32u);  // up, and away
    scene.lights = {ambient_light({1, 1, 1})};
    EXPECT_EQ(count().shadow, 0u);
    scene.lights.push_back(point_light({0, 3, 0}));
    EXPECT_EQ(count().shadow, 32u);
    scene.lights.push_back(point_light({0, -3, 0}));  // below: N·L < 0
    EXPECT_EQ(count().shadow, 32u);
    scene.lights.push_back(directional_light({1, 1, 1}));
    EXPECT_EQ(count().shadow, 64u);
    scene.lights.push_back(directional_light({1, 1, 1}, {0, 0, 0}));  // black
    EXPECT_EQ(count().shadow, 64u);
    scene.settings.shadows = false;
    EXPECT_EQ(count().shadow, 0u);
    scene.settings.shadows = true;
    scene.materials[mirror].diffuse = {0, 0, 0};  // and no specular: no light is reflected
    EXPECT_EQ(count().shadow, 0u);
    scene.settings.samples = 3;
    rays = count();
    EXPECT_EQ(rays.camera, 9u * 32u);
    EXPECT_EQ(rays.mirror, 9u * 32u);
    scene.settings.reflections = 0;
    EXPECT_EQ(count().mirror, 0u);
    // A ceiling above the camera, which is a mirror too: two more reflections.
    scene.settings.samples = 1;
    scene.settings.reflections = 3;
    scene.add(Plane{{0, 20, 0}, {0, 1, 0}}, mirror);
    EXPECT_EQ(count().mirror, 3u * 32u);
}

}  // namespace
}  // namespace glint::test
