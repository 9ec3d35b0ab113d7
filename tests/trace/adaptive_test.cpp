// SPDX-License-Identifier: Apache-2.0
// Adaptive sampling: each pixel is that of aa = 1 or of aa = n, as the neighbours in the picture decide.
#include <gtest/gtest.h>

#include <algorithm>

#include "glint/explain.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

// Larger than a tile in both directions, with mirrors, glass and shadows.
Scene edges() {
    Scene scene = mixture(17, 40);
    set_size(scene, 77, 45);
    scene.settings.reflections = 2;
    scene.background = {0.2, 0.3, 0.4};
    scene.camera.position = {0, 2, 16};
    Material m;
    m.specular = {0.5, 0.4, 0.3};
    m.mirror = 0.3;
    add_material(scene, m);
    m.transmission = 0.6;
    m.ior = 1.3;
    add_material(scene, m);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        scene.shapes[i].material = static_cast<std::uint32_t>(i % 2);
    scene.lights = {ambient_light({0.3, 0.3, 0.3}), point_light({5, 9, 9}),
                    directional_light({1, 2, 3}, {0.2, 0.3, 0.1})};
    return scene;
}

Scene with_samples(Scene scene, int n, std::optional<double> threshold = {}) {
    scene.settings.samples = n;
    scene.settings.aa_threshold = threshold;
    return scene;
}

// The rule of docs/lighting.md, in full.
bool is_refined(const Image& one, int x, int y, double threshold) {
    const Color own = one.pixel(x, y);
    const auto differs = [&](int nx, int ny) {
        if (nx < 0 || ny < 0 || nx >= one.width || ny >= one.height) return false;
        const Color other = one.pixel(nx, ny);
        return std::max({std::abs(own.r - other.r), std::abs(own.g - other.g), std::abs(own.b - other.b)}) >
               threshold;
    };
    return differs(x - 1, y) || differs(x + 1, y) || differs(x, y - 1) || differs(x, y + 1);
}

// Returns the number of refined pixels.
int expect_adaptive(const Scene& scene, int n, double threshold) {
    const Image one = render_scene(with_samples(scene, 1)), all = render_scene(with_samples(scene, n)),
                adaptive = render_scene(with_samples(scene, n, threshold));
    Image expected = one;
    int refined = 0;
    for (int y = 0; y < one.height; ++y) {
        for (int x = 0; x < one.width; ++x) {
            if (!is_refined(one, x, y, threshold)) continue;
            ++refined;
            const auto first = 3 * (y * one.width + x);
            std::copy_n(all.rgb.begin() + first, 3, expected.rgb.begin() + first);
        }
    }
    expect_same_picture(expected, adaptive);
    return refined;
}

TEST(Adaptive, EachPixelHasOneSampleOrAll) {
    const Scene scene = edges();
    const int pixels = scene.settings.width * scene.settings.height;
    int previous = pixels + 1;
    for (const double threshold : {0.0, 0.02, 0.1, 0.5}) {
        SCOPED_TRACE(threshold);
        const int refined = expect_adaptive(scene, 3, threshold);
        EXPECT_LT(refined, previous);
        EXPECT_GT(refined, 0);
        previous = refined;
    }
    EXPECT_EQ(expect_adaptive(scene, 2, 100), 0);
}

TEST(Adaptive, AnyConventionOfCameraRays) {
    for (const PixelSample where :
         {PixelSample::center, PixelSample::corner, PixelSample::whole, PixelSample::top_right}) {
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            Scene scene = edges();
            scene.conventions.pixel_sample = where;
            scene.camera.projection = projection;
            scene.camera.width = 20;
            SCOPED_TRACE(static_cast<int>(where));
            EXPECT_GT(expect_adaptive(scene, 2, 0.05), 100);
        }
    }
}

TEST(Adaptive, EmptyTilesBesideObjects) {
    // A sphere at a corner of four tiles: its edge is in some of them, and next to others.
    Scene scene;
    set_size(scene, 96, 96);
    scene.background = {0.1, 0.2, 0.3};
    scene.lights = {ambient_light({1, 1, 1})};
    scene.camera.look_at = {0, 0, -1};
    for (const double radius : {0.02, 0.3, 0.331}) {
        scene.get<Sphere>().clear();
        scene.shapes.clear();
        scene.add(Sphere{{-0.19, 0.19, -1}, radius * 0.5});
        EXPECT_GT(expect_adaptive(scene, 3, 0.01), 0);
    }
}

TEST(Adaptive, CropsThreadsAndInstructionSets) {
    expect_same_crops(*make_world(with_samples(edges(), 3, 0.05)), 30);
}

TEST(Adaptive, LayersAreThoseOfThePixelsSamples) {
    const double threshold = 0.05;
    RenderOptions options;
    for (const LayerInfo& info : layer_infos()) options.layers.push_back(info.layer);
    const auto rendering = [&](const Scene& scene) { return render(*make_world(scene), options).value(); };
    const Rendering one = rendering(with_samples(edges(), 1)), all = rendering(with_samples(edges(), 3)),
                    adaptive = rendering(with_samples(edges(), 3, threshold));
    expect_same_picture(render_scene(with_samples(edges(), 3, threshold)), adaptive.image);
    for (std::size_t l = 0; l < one.layers.size(); ++l) {
        const auto channels = static_cast<std::size_t>(one.layers[l].channels);
        for (std::size_t i = 0; i < one.layers[l].values.size(); ++i) {
            const int p = static_cast<int>(i / channels), x = p % one.image.width, y = p / one.image.width;
            const Rendering& from = is_refined(one.image, x, y, threshold) ? all : one;
            ASSERT_EQ(adaptive.layers[l].values[i], from.layers[l].values[i])
                << layer_infos()[l].name << " at " << x << ',' << y;
        }
    }
}

TEST(Adaptive, ExplainedAsDrawn) {
    const Scene scene = with_samples(edges(), 2, 0.05);
    const std::optional<World> world = make_world(scene);
    const Image whole = render_world(*world), one = render_scene(with_samples(scene, 1));
    int refined = 0;
    for (int y = 0; y < whole.height; y += 3) {
        for (int x = 0; x < whole.width; x += 2) {
            const Explanation e = explain(scene, *world, x, y).value();
            const Color drawn = whole.pixel(x, y);
            ASSERT_EQ((Color{e.value[0], e.value[1], e.value[2]}), drawn) << x << ',' << y;
            ASSERT_TRUE(e.adaptive);
            ASSERT_EQ(e.samples, is_refined(one, x, y, 0.05) ? 2 : 1);
            ASSERT_EQ(e.adaptive->own, one.pixel(x, y));
            ASSERT_EQ(e.adaptive->neighbor, one.pixel(e.adaptive->x, e.adaptive->y));
            ASSERT_EQ(e.adaptive->difference > 0.05, e.samples == 2);
            ASSERT_EQ(std::count_if(e.rays.begin(), e.rays.end(), [](auto& ray) { return ray.parent < 0; }),
                      e.samples * e.samples);
            refined += e.samples > 1 ? 1 : 0;
            // The last sample is recorded alone; without refinement, the only one.
            const Explanation last = explain(scene, *world, x, y, {.sample = 3}).value();
            ASSERT_FALSE(last.rays.empty());
            ASSERT_EQ(last.rays[0].sample, e.samples == 2 ? 3 : 0);
        }
    }
    EXPECT_GT(refined, 50);
}

TEST(Adaptive, OnePixel) {
    Scene scene = with_samples(edges(), 4, 0.0);
    set_size(scene, 1, 1);
    const Explanation e = explain(scene, *make_world(scene), 0, 0).value();
    EXPECT_EQ(e.samples, 1);
    EXPECT_EQ(e.adaptive->x, -1);
    expect_same_picture(render_scene(scene), render_scene(with_samples(scene, 1)));
}

}  // namespace
}  // namespace glint::test
