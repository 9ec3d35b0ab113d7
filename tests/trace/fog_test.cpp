// SPDX-License-Identifier: Apache-2.0
// Fog against its formulas, and against the recursion over mirrors.
#include <gtest/gtest.h>

#include <cmath>

#include "glint/explain.h"
#include "trace/lighting/ground_fog.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

double visibility(const Fog& fog, double d) {
    const double x = d - fog.start;
    const double f = fog.kind == FogKind::linear ? (fog.end - d) / (fog.end - fog.start)
                     : fog.kind == FogKind::exp  ? std::exp(-fog.density * x)
                                                 : std::exp(-(fog.density * x) * (fog.density * x));
    return std::min(std::max({f, 0.0, fog.transmit}), 1.0);
}

// A wall that shines white, 10 units away along the view, with nothing above the horizon.
Scene wall() {
    Scene scene;
    set_size(scene, 41, 31);
    scene.background = {0, 0, 1};
    Material m;
    m.ambient = {1, 1, 1};
    m.diffuse = {0, 0, 0};
    add_material(scene, m);
    scene.lights = {ambient_light({1, 1, 1})};
    scene.camera.fov_degrees = 100;
    scene.polygon_vertices = {{-100, -100, -10}, {100, -100, -10}, {100, 0, -10}, {-100, 0, -10}};
    scene.add(Polygon{0, 4}, 0);
    return scene;
}

const Fog k_fogs[] = {
    {FogKind::linear, {0.5, 0.25, 1}, 0, 8, 20, 0},    {FogKind::linear, {0.5, 0.25, 1}, 0, 8, 12, 0.2},
    {FogKind::exp, {0.5, 0.25, 1}, 0.1, 0, 0, 0},      {FogKind::exp, {0.5, 0.25, 1}, 0.05, 12, 0, 0.1},
    {FogKind::exp2, {0.5, 0.25, 1}, 0.1, 0, 0, 0},     {FogKind::exp2, {0.5, 0.25, 1}, 0.2, 12, 0, 0},
    {FogKind::exp, {0.5, 0.25, 1}, 1e12, -1e12, 0, 0}, {FogKind::exp2, {0.5, 0.25, 1}, 1e12, 1e12, 0, 0},
    {FogKind::linear, {0.5, 0.25, 1}, 0, 10, 1e12, 0},
};

TEST(Fog, Formulas) {
    for (const Fog& fog : k_fogs) {
        for (const FogDistance distance : {FogDistance::ray, FogDistance::depth}) {
            for (const bool background : {true, false}) {
                Scene scene = wall();
                scene.fog = fog;
                scene.conventions.fog_distance = distance;
                scene.conventions.fog_background = background;
                const Image plain = render_scene(wall()), image = render_scene(scene);
                for (int y = 0; y < image.height; ++y) {
                    for (int x = 0; x < image.width; ++x) {
                        const bool is_wall = plain.pixel(x, y).r == 1;
                        // From the centre of the picture, at distance 1.
                        const double sx = (x + 0.5 - 20.5) / 41 * 2 * std::tan(50 * M_PI / 180),
                                     sy = (15.5 - y - 0.5) / 41 * 2 * std::tan(50 * M_PI / 180);
                        const double d =
                            distance == FogDistance::depth ? 10 : 10 * std::sqrt(1 + sx * sx + sy * sy);
                        const double f = is_wall ? visibility(fog, d) : background ? fog.transmit : 1;
                        const Color seen = plain.pixel(x, y), c = image.pixel(x, y);
                        ASSERT_NEAR(c.r, f * seen.r + (1 - f) * fog.color.r, 2e-6) << x << ',' << y;
                        ASSERT_NEAR(c.g, f * seen.g + (1 - f) * fog.color.g, 2e-6) << x << ',' << y;
                        ASSERT_NEAR(c.b, f * seen.b + (1 - f) * fog.color.b, 2e-6) << x << ',' << y;
                    }
                }
            }
        }
    }
}

// The integral of the density by the midpoint rule, over heights in falloffs.
double mean_density(double from, double to) {
    double sum = 0;
    constexpr int k_steps = 20000;
    for (int i = 0; i < k_steps; ++i) {
        const double z = std::max(0.0, from + (to - from) * (i + 0.5) / k_steps);
        sum += 1 / (1 + z * z);
    }
    return sum / k_steps;
}

TEST(Fog, OnTheGround) {
    // The camera is at the origin, looks along -z, and sees the wall at distance 10 below the horizon.
    for (const double height : {-30.0, -3.0, 0.0, 2.0}) {
        for (const FogDistance distance : {FogDistance::ray, FogDistance::depth}) {
            for (const double start : {0.0, 4.0}) {
                Scene scene = wall();
                Fog fog{FogKind::exp, {0.5, 0.25, 1}, 0.1, start, 0, 0.05};
                fog.falloff = 2;
                fog.height = height;
                fog.up = {0, 3, 0};
                scene.fog = fog;
                scene.conventions.fog_distance = distance;
                const Image plain = render_scene(wall()), image = render_scene(scene);
                for (int y = 0; y < image.height; ++y) {
                    const int x = 7;
                    const double across = 2 * std::tan(50 * M_PI / 180) / 41, sx = (x - 20) * across,
                                 sy = (15 - y) * across;
                    const double scale =
                        distance == FogDistance::depth ? 1 : std::sqrt(1 + sx * sx + sy * sy);
                    const double begin = start / scale, z0 = (sy * begin - height) / 2,
                                 z1 = (sy * 10 - height) / 2;
                    double way = (10 - begin) * scale * mean_density(z0, z1);
                    if (plain.pixel(x, y).r != 1) {
                        const double rest = M_PI / 2 - std::atan(std::max(z0, 0.0)) - std::min(z0, 0.0);
                        way = sy > 0 ? rest * 2 * scale / sy : 1e9;
                    }
                    const double f = std::max(std::exp(-0.1 * way), 0.05);
                    const Color seen = plain.pixel(x, y), c = image.pixel(x, y);
                    ASSERT_NEAR(c.r, f * seen.r + (1 - f) * 0.5, 2e-6) << height << ' ' << y;
                    ASSERT_NEAR(c.b, f * seen.b + (1 - f), 2e-6) << height << ' ' << y;
                }
            }
        }
    }
}

TEST(Fog, OnTheGroundKeepsItsDigits) {
    // Level rays, and almost level ones; heights and distances of all sizes.
    EXPECT_DOUBLE_EQ(fog_along({2, 0}, 3, 8), 5 / 5.0);
    EXPECT_DOUBLE_EQ(fog_along({2, 1e-17}, 3, 8), 5 / 5.0);
    EXPECT_NEAR(fog_along({2, 1e-12}, 3, 8), 1, 1e-9);
    EXPECT_DOUBLE_EQ(fog_along({-2, 0}, 3, 8), 5);
    EXPECT_DOUBLE_EQ(fog_along({-2, 1e-3}, 3, 8), 5);
    EXPECT_DOUBLE_EQ(fog_along({2, 0}, 8, 3), -1) << "before the fog begins";
    EXPECT_NEAR(fog_along({0, 1}, 0, 1e300), M_PI / 2, 1e-15);
    EXPECT_NEAR(fog_along({-3, 1}, 0, INFINITY), 3 + M_PI / 2, 1e-14);
    EXPECT_NEAR(fog_along({5, 2}, 0, INFINITY), (M_PI / 2 - std::atan(5)) / 2, 1e-15);
    for (const double slope : {0.0, -1.0, -1e-300}) EXPECT_EQ(fog_along({5, slope}, 0, INFINITY), 1e200);
    EXPECT_EQ(fog_along({-1e21, 1e-300}, 0, INFINITY), 1e200);
}

TEST(Fog, MirrorsAreFoggedOnEveryPartOfThePath) {
    // The camera looks at a mirror 4 units away, and sees the wall behind itself, 16 units from the mirror.
    Scene scene;
    set_size(scene, 1, 1);
    Material mirror, white;
    mirror.ambient = mirror.diffuse = {0, 0, 0};
    mirror.mirror = 0.75;
    white.ambient = {1, 0.5, 0.25};
    white.diffuse = {0, 0, 0};
    scene.add(Plane{{0, 0, -4}, {0, 0, 1}}, add_material(scene, mirror));
    scene.add(Plane{{0, 0, 12}, {0, 0, -1}}, add_material(scene, white));
    scene.lights = {ambient_light({1, 1, 1})};
    Fog fog;
    fog.color = {0.125, 0.5, 0.75};
    fog.density = 0.05;
    scene.fog = fog;
    for (const FogDistance distance : {FogDistance::ray, FogDistance::depth}) {
        scene.conventions.fog_distance = distance;
        const double near = std::exp(-0.2), far = std::exp(-0.8);
        const Color c = render_scene(scene).pixel(0, 0);
        const auto expected = [&](double wall_color, double fog_color) {
            const double reflected = far * wall_color + (1 - far) * fog_color;
            return near * 0.75 * reflected + (1 - near) * fog_color;
        };
        EXPECT_NEAR(c.r, expected(1, 0.125), 1e-6);
        EXPECT_NEAR(c.g, expected(0.5, 0.5), 1e-6);
        EXPECT_NEAR(c.b, expected(0.25, 0.75), 1e-6);
    }
}

Scene foggy_mixture() {
    Scene scene = mirrors_and_glass(41);
    scene.lights = {ambient_light({0.3, 0.3, 0.3}), point_light({5, 9, 19})};
    scene.fog = Fog{FogKind::exp, {0.5, 0.6, 0.7}, 0.06, 5, 0, 0.05};
    return scene;
}

Scene mixture_on_foggy_ground() {
    Scene scene = foggy_mixture();
    scene.fog->falloff = 0.7;
    scene.fog->height = -1;
    scene.fog->up = {0.1, 1, 0.2};
    return scene;
}

TEST(Fog, CropsThreadsAndInstructionSets) {
    expect_same_crops(*make_world(foggy_mixture()), 20);
    expect_same_crops(*make_world(mixture_on_foggy_ground()), 20);
}

TEST(Fog, EmptyTilesHaveTheBitsOfOthers) {
    // A shape in a corner: most tiles are filled without tracing. Layers make every tile be traced.
    Scene scene = wall();
    set_size(scene, 150, 100);
    scene.shapes.clear();
    scene.get<Polygon>().clear();
    scene.add(Sphere{{-9, 6, -10}, 1}, 0);
    scene.settings.samples = 3;
    scene.fog = Fog{FogKind::exp, {0.7, 0.6, 0.3}, 0.06, 0, 0, 0.3};
    const std::optional<World> world = make_world(scene);
    RenderOptions options;
    options.layers = {Layer::fog};
    const Rendering all = render(*world, options).value();
    expect_same_picture(all.image, render_world(*world));
    Scene on_ground = scene;
    on_ground.fog->falloff = 3;
    const std::optional<World> ground = make_world(on_ground);
    expect_same_picture(render(*ground, options).value().image, render_world(*ground));
    EXPECT_FLOAT_EQ(all.layers[0].values[3 * 14900], 0.7f * 0.7f);
}

TEST(Fog, ExplainedAsDrawn) {
    for (const int variant : {0, 1, 2, 3}) {
        Scene scene = variant < 2 ? foggy_mixture() : mixture_on_foggy_ground();
        scene.settings.alpha = variant % 2 == 1;
        expect_explained_as_drawn(scene, 3, 2, [&](const Explanation& e, int x, int y) {
            double sums[k_light_layers] = {};
            for (std::size_t i = 0; i < e.rays.size(); ++i) {
                const ExplainedRay& ray = e.rays[i];
                const auto layer = layer_of(e, i);
                const auto add = [&](Layer own, Color c) {
                    sums[static_cast<std::size_t>(layer.value_or(own))] += c.g;
                };
                if (ray.hit) {
                    add(Layer::ambient, ray.hit->parts[0]);
                    add(Layer::diffuse, ray.hit->parts[1]);
                    add(Layer::specular, ray.hit->parts[2]);
                } else {
                    add(Layer::background, ray.background);
                }
                add(Layer::fog, ray.fog);
            }
            float value = 0;
            for (int l = 0; l < k_light_layers; ++l) {
                ASSERT_EQ(static_cast<float>(sums[l] / 4), e.layers[l][1]) << x << ',' << y << ' ' << l;
                value += e.layers[l][1];
            }
            ASSERT_EQ(value, e.value[1]);
        });
    }
}

TEST(Fog, IsReplacedWithoutPreparing) {
    Scene scene = foggy_mixture();
    const Image foggy = render_scene(scene);
    const std::optional<Fog> fog = scene.fog;
    scene.fog.reset();
    const std::optional<World> clear = make_world(scene);
    const Result<World> again = with_fog(*clear, fog);
    ASSERT_TRUE(again);
    expect_same_picture(foggy, render_world(*again));
    expect_same_picture(render_scene(scene), render_world(with_fog(*again, {}).value()));
    EXPECT_FALSE(with_fog(*clear, Fog{FogKind::linear, {}, 0, 5, 5, 0}));
    EXPECT_FALSE(with_fog(*clear, Fog{FogKind::exp, {}, -1, 0, 0, 0}));
    EXPECT_FALSE(with_fog(*clear, Fog{FogKind::exp, {}, 1, std::nan(""), 0, 0}));
}

}  // namespace
}  // namespace glint::test
