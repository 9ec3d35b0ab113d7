// SPDX-License-Identifier: Apache-2.0
// Background gradients against their formula.
#include <gtest/gtest.h>

#include <cmath>

#include "glint/layers.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

double dot_of(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Color expected_gradient(const BackgroundGradient& gradient, Vec3 from) {
    const double length = std::sqrt(dot_of(gradient.up, gradient.up));
    double v = (dot_of(from, gradient.up) / length - gradient.bottom) / (gradient.top - gradient.bottom);
    v = gradient.repeats ? v - std::floor(v) : std::min(std::max(v, 0.0), 1.0);
    return gradient.top_color * v + gradient.bottom_color * (1 - v);
}

void expect_near_color(Color a, Color b, int x, int y) {
    ASSERT_NEAR(a.r, b.r, 1e-6) << x << ',' << y;
    ASSERT_NEAR(a.g, b.g, 1e-6) << x << ',' << y;
    ASSERT_NEAR(a.b, b.b, 1e-6) << x << ',' << y;
}

// A small sphere in a corner: nearly all tiles show only the background.
Scene gradient_scene(const BackgroundGradient& gradient) {
    Scene scene;
    set_size(scene, 80, 60);
    scene.camera.fov_degrees = 90;
    scene.add(Sphere{{-9.5, 7, -10}, 0.2}, add_material(scene, {}));
    scene.gradient = gradient;
    return scene;
}

TEST(BackgroundGradient, Sphere) {
    for (const bool repeats : {false, true}) {
        const BackgroundGradient gradient{GradientKind::sphere, {0.5, 2, -1}, -0.2,   0.3,
                                          {1, 0.5, 0},          {0, 0.25, 1}, repeats};
        const Image image = render_scene(gradient_scene(gradient));
        for (int y = 10; y < 60; ++y) {
            for (int x = 0; x < 80; ++x) {
                Vec3 d{(x + 0.5 - 40) / 40, (30 - y - 0.5) / 40, -1};
                d = d * (1 / std::sqrt(dot_of(d, d)));
                expect_near_color(image.pixel(x, y), expected_gradient(gradient, d), x, y);
            }
        }
    }
}

TEST(BackgroundGradient, Plane) {
    const BackgroundGradient gradient{GradientKind::plane, {0, 3, 0},    -1,   1.2,
                                      {1, 0.5, 0},         {0, 0.25, 1}, false};
    Scene scene = gradient_scene(gradient);
    scene.camera.projection = Projection::orthographic;
    scene.camera.width = 8;
    const Image image = render_scene(scene);
    for (int y = 10; y < 60; ++y)
        for (int x = 0; x < 80; ++x)
            expect_near_color(image.pixel(x, y), expected_gradient(gradient, {0, (30 - y - 0.5) / 10, 0}), x,
                              y);
}

TEST(BackgroundGradient, InMirrorsAndFog) {
    // A mirror that looks straight up.
    Scene scene;
    set_size(scene, 1, 1);
    Material mirror;
    mirror.ambient = mirror.diffuse = {0, 0, 0};
    mirror.mirror = 0.5;
    scene.add(Plane{{0, 0, -4}, {0, 1, 1}}, add_material(scene, mirror));
    scene.gradient = BackgroundGradient{};
    scene.conventions.mirror_miss = MissRule::background;
    expect_near_color(render_scene(scene).pixel(0, 0), scene.gradient->top_color * 0.5, 0, 0);
    scene.fog = Fog{FogKind::exp, {0, 0, 0}, 1e-9, 0, 0, 0.25};
    expect_near_color(render_scene(scene).pixel(0, 0), scene.gradient->top_color * 0.125, 0, 0);
}

TEST(BackgroundGradient, EmptyTilesHaveTheBitsOfOthers) {
    for (const std::optional<double> threshold : {std::optional<double>{}, std::optional<double>{0.01}}) {
        for (const bool alpha : {false, true}) {
            Scene scene = gradient_scene(BackgroundGradient{});
            scene.settings.samples = 2;
            scene.settings.aa_threshold = threshold;
            scene.settings.alpha = alpha;
            const std::optional<World> world = make_world(scene);
            RenderOptions options;
            options.layers = {Layer::background};
            const Rendering all = render(*world, options).value();
            expect_same_picture(all.image, render_world(*world));
            EXPECT_EQ(all.image.pixel(70, 50) == Color{}, alpha);
        }
    }
}

TEST(BackgroundGradient, IsReplacedWithoutPreparing) {
    Scene scene = gradient_scene(BackgroundGradient{});
    const Image image = render_scene(scene);
    scene.gradient.reset();
    const std::optional<World> plain = make_world(scene);
    expect_same_picture(image, render_world(with_gradient(*plain, BackgroundGradient{}).value()));
    BackgroundGradient wrong;
    wrong.top = wrong.bottom;
    EXPECT_FALSE(with_gradient(*plain, wrong));
    wrong = {};
    wrong.up = {0, 0, 0};
    EXPECT_FALSE(with_gradient(*plain, wrong));
    wrong = {};
    wrong.top_color.r = std::nan("");
    EXPECT_FALSE(with_gradient(*plain, wrong));
}

}  // namespace
}  // namespace glint::test
