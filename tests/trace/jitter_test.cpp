// SPDX-License-Identifier: Apache-2.0
// Jittered samples: each ray is where the hash says, whatever the tile, crop and instruction set.
#include <gtest/gtest.h>

#include "glint/explain.h"
#include "math/sample_hash.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

Scene balls() {
    Random random(29);
    Scene scene = random_scene(random, 30, 6);
    set_size(scene, 70, 45);
    scene.settings.samples = 3;
    scene.settings.jitter = true;
    scene.background = {0.2, 0.3, 0.4};
    scene.camera.position = {0, 2, 16};
    scene.camera.look_at = {0, 0, 0};
    scene.lights = {ambient_light({0.3, 0.3, 0.3}), point_light({5, 9, 9})};
    return scene;
}

TEST(Jitter, EachRayIsWhereTheHashSays) {
    // An orthographic camera with one world unit for each pixel: the ray's origin is its place in the
    // picture.
    for (const PixelSample where : {PixelSample::center, PixelSample::corner}) {
        Scene scene = balls();
        scene.conventions.pixel_sample = where;
        scene.camera.projection = Projection::orthographic;
        scene.camera.position = {0, 0, 100};
        scene.camera.width = 70;
        scene.settings.seed = 12345;
        const World world = *make_world(scene);
        for (const int x : {0, 31, 32, 69}) {
            for (const int y : {0, 33, 44}) {
                const Explanation e = explain(scene, world, x, y).value();
                int cameras = 0;
                for (const ExplainedRay& ray : e.rays) {
                    if (ray.parent >= 0) continue;
                    ++cameras;
                    const auto hash = [&](std::uint32_t coordinate) {
                        const std::uint32_t h =
                            ray_hash(12345, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                     static_cast<std::uint32_t>(ray.sample), k_camera_path);
                        return unit_number(
                            hash_with(hash_with(h, purpose_word(SamplePurpose::pixel, 0)), coordinate));
                    };
                    const int i = ray.sample % 3, j = ray.sample / 3;
                    ASSERT_NEAR(ray.origin.x, x + (i + hash(0)) / 3 - 35, 1e-9);
                    ASSERT_NEAR(ray.origin.y, 22.5 - (y + (j + hash(1)) / 3), 1e-9);
                }
                ASSERT_EQ(cameras, 9);
            }
        }
    }
}

TEST(Jitter, CropsThreadsAndInstructionSets) {
    for (const std::optional<double> threshold : {std::optional<double>(), std::optional<double>(0.05)}) {
        Scene scene = balls();
        scene.settings.aa_threshold = threshold;
        expect_same_crops(*make_world(scene), 20);
    }
}

TEST(Jitter, AdaptivePixelsHaveAllJitteredSamplesOrOne) {
    Scene scene = balls();
    const Image all = render_scene(scene);
    scene.settings.samples = 1;
    const Image one = render_scene(scene);
    scene.settings.jitter = false;
    expect_same_picture(one, render_scene(scene));  // one sample is not jittered
    scene.settings = balls().settings;
    scene.settings.aa_threshold = 0.05;
    const Image adaptive = render_scene(scene);
    int refined = 0;
    for (int y = 0; y < one.height; ++y) {
        for (int x = 0; x < one.width; ++x) {
            if (adaptive.pixel(x, y) == one.pixel(x, y)) continue;
            ASSERT_EQ(adaptive.pixel(x, y), all.pixel(x, y)) << x << ',' << y;
            ++refined;
        }
    }
    EXPECT_GT(refined, 100);
    EXPECT_LT(refined, 2000);
}

TEST(Jitter, SeedsGiveOtherPicturesWithTheSameMean) {
    const auto mean = [](const Image& image) {
        double sum = 0;
        for (const float v : image.rgb) sum += v;
        return sum / static_cast<double>(image.rgb.size());
    };
    Scene scene = balls();
    const Image first = render_scene(scene);
    scene.settings.seed = 1;
    const Image second = render_scene(scene);
    EXPECT_NE(first.rgb, second.rgb);
    scene.settings.jitter = false;
    const Image regular = render_scene(scene);
    EXPECT_NE(regular.rgb, second.rgb);
    for (const Image* image : {&first, &second}) EXPECT_NEAR(mean(*image), mean(regular), 2e-3);
}

TEST(Jitter, ExplainedAsDrawn) {
    const Scene scene = balls();
    const std::optional<World> world = make_world(scene);
    const Image whole = render_world(*world);
    for (int y = 0; y < whole.height; y += 4) {
        for (int x = 0; x < whole.width; x += 3) {
            const Explanation e = explain(scene, *world, x, y).value();
            ASSERT_EQ((Color{e.value[0], e.value[1], e.value[2]}), whole.pixel(x, y)) << x << ',' << y;
        }
    }
}

}  // namespace
}  // namespace glint::test
