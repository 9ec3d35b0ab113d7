// SPDX-License-Identifier: Apache-2.0
// Light from all directions against closed forms; the same bits for any crops, threads and instruction sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glint/explain.h"
#include "trace/pictures.h"
#include "world/appearance/prepare_sky.h"

namespace glint::test {
namespace {

// A white floor, seen from above; nothing else.
Scene open_floor() {
    Scene scene;
    set_size(scene, 9, 7);
    Material m;
    m.ambient = {0, 0, 0};
    m.diffuse = {0.5, 0.25, 1};
    scene.add(Plane{{0, 0, 0}, {0, 1, 0}}, add_material(scene, m));
    scene.camera.position = {0, 5, 0.001};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.fov_degrees = 1;
    scene.occlusion = Occlusion{};
    scene.occlusion->color = {1, 0.5, 0.25};
    return scene;
}

TEST(Occlusion, FixedDirectionsAreTachyons) {
    const std::vector<Vec3> d = fixed_directions(3);
    const Vec3 expected[] = {{-0.41542, 0.60995531, -0.67481893},
                             {0.01681162, 0.87673128, -0.48068672},
                             {-0.27811012, 0.74392796, -0.60763979}};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(d[i].x, expected[i].x, 1e-7);
        EXPECT_NEAR(d[i].y, expected[i].y, 1e-7);
        EXPECT_NEAR(d[i].z, expected[i].z, 1e-7);
    }
}

TEST(Occlusion, OpenFloor) {
    Scene scene = open_floor();
    for (const int samples : {1, 7, 12, 64, 100}) {
        scene.occlusion->samples = samples;
        scene.occlusion->method = OcclusionMethod::hashed;
        EXPECT_EQ(render_scene(scene).pixel(4, 3), (Color{0.5, 0.125, 0.25})) << samples;
        scene.occlusion->method = OcclusionMethod::fixed;
        double sum = 0;
        for (const Vec3& d : fixed_directions(static_cast<std::size_t>(samples))) sum += std::abs(d.y);
        EXPECT_NEAR(render_scene(scene).pixel(4, 3).r, 0.5 * 2 / samples * sum, 1e-6) << samples;
    }
}

TEST(Occlusion, BelowASphere) {
    // The sphere's part of the light at the point below it is (r/d)^2.
    Scene scene = open_floor();
    scene.camera.position = {0.5, 0.001, 0};
    scene.camera.look_at = {0, 0, 0};
    set_size(scene, 1, 1);
    scene.occlusion->color = {1, 1, 1};
    for (const double distance : {1.5, 2.0, 4.0}) {
        scene.get<Sphere>().clear();
        scene.shapes.resize(1);
        scene.add(Sphere{{0, distance, 0}, 1}, 0);
        for (const OcclusionMethod method : {OcclusionMethod::hashed, OcclusionMethod::fixed}) {
            scene.occlusion->method = method;
            scene.occlusion->samples = 4096;
            scene.occlusion->reach = std::numeric_limits<double>::infinity();
            EXPECT_NEAR(render_scene(scene).pixel(0, 0).b, 1 - 1 / (distance * distance), 0.02) << distance;
            scene.occlusion->reach = distance - 1.001;
            EXPECT_NEAR(render_scene(scene).pixel(0, 0).b, 1, 0.02) << distance;
        }
        scene.occlusion->method = OcclusionMethod::hashed;
        EXPECT_EQ(render_scene(scene).pixel(0, 0).b, 1);
        scene.occlusion->reach = distance - 0.9;
        EXPECT_LT(render_scene(scene).pixel(0, 0).b, 1);
        scene.settings.shadows = false;
        EXPECT_EQ(render_scene(scene).pixel(0, 0).b, 1);
        scene.settings.shadows = true;
    }
}

TEST(Occlusion, DirectIsAFactorOfTheLights) {
    Scene scene = open_floor();
    scene.occlusion->color = {0, 0, 0};
    scene.occlusion->direct = 0.25;
    scene.materials[0].specular = {0.5, 0.5, 0.5};
    scene.lights = {ambient_light({0.5, 0.5, 0.5}), point_light({1, 4, 2})};
    const Image scaled = render_scene(scene);
    scene.occlusion->direct = 1;
    scene.lights[1].color = scene.lights[1].color * 0.25;
    scene.lights[1].specular_color = scene.lights[1].specular_color * 0.25;
    expect_same_picture(scaled, render_scene(scene));
}

Scene occlusion_mixture(OcclusionMethod method, bool transparent = false) {
    Scene scene = mirrors_and_glass(43);
    if (transparent) {
        Material& m = scene.materials[1];
        m.filter = 0.5, m.transmit = 0.4, m.color = {0.9, 0.6, 0.3};
    }
    scene.lights = {ambient_light({0.1, 0.1, 0.1}), point_light({5, 9, 19})};
    scene.occlusion = Occlusion{};
    scene.occlusion->method = method;
    scene.occlusion->samples = 6;
    scene.occlusion->color = {0.7, 0.8, 0.9};
    scene.occlusion->direct = 0.6;
    scene.gradient = BackgroundGradient{};
    scene.gradient->up = {1, 3, -0.5};
    scene.gradient->bottom = -0.4;
    scene.gradient->top = 0.3;
    return scene;
}
constexpr OcclusionMethod k_occlusion_methods[] = {OcclusionMethod::hashed, OcclusionMethod::fixed};

TEST(Occlusion, CropsThreadsAndInstructionSets) {
    for (const OcclusionMethod method : k_occlusion_methods) {
        for (const bool adaptive : {false, true}) {
            Scene scene = occlusion_mixture(method, !adaptive);
            if (adaptive) scene.settings.aa_threshold = 0.1;
            expect_same_crops(*make_world(scene), 12);
        }
    }
}

TEST(Occlusion, HashedSamplesDifferBetweenPixels) {
    Scene scene = open_floor();
    scene.add(Sphere{{0, 1.5, 0}, 1}, 0);
    scene.camera.position = {3, 0.5, 0};
    scene.occlusion->samples = 4;
    std::vector<double> values;
    const Image image = render_scene(scene);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) values.push_back(image.pixel(x, y).r);
    std::sort(values.begin(), values.end());
    EXPECT_GE(std::unique(values.begin(), values.end()) - values.begin(), 3);
}

TEST(Occlusion, ExplainedAsDrawn) {
    for (const OcclusionMethod method : k_occlusion_methods) {
        for (const bool fog : {false, true}) {
            Scene scene = occlusion_mixture(method, fog);
            if (fog) scene.fog = Fog{FogKind::exp, {0.5, 0.6, 0.7}, 0.06, 5, 0, 0.05};
            const std::optional<World> world = make_world(scene);
            RenderOptions options;
            options.layers = {Layer::occlusion};
            const Rendering whole = render(*world, options).value();
            for (int y = 0; y < 50; y += 2) {
                for (int x = 0; x < 70; x += 3) {
                    const Explanation e = explain(scene, *world, x, y).value();
                    ASSERT_EQ((Color{e.value[0], e.value[1], e.value[2]}), whole.image.pixel(x, y));
                    double sums[k_light_layers] = {};
                    int tested = 0, blocked = 0;
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
                            const ExplainedOcclusion& o = ray.hit->occlusion.value();
                            add(Layer::sky, o.part);
                            int named = 0;
                            for (const auto& occluder : o.occluders) named += occluder.samples;
                            ASSERT_EQ(named, o.blocked);
                            ASSERT_EQ(o.samples, 6);
                            if (ray.generation == 0) tested += o.samples, blocked += o.blocked;
                        } else {
                            add(Layer::background, ray.background);
                        }
                        add(Layer::fog, ray.fog);
                    }
                    float value = 0;
                    for (int l = 0; l < k_light_layers; ++l) {
                        ASSERT_EQ(static_cast<float>(sums[l] / 4), e.layers[l][1])
                            << x << ',' << y << ' ' << l;
                        value += e.layers[l][1];
                    }
                    ASSERT_EQ(value, e.value[1]);
                    const float part = whole.layers[0].values[static_cast<std::size_t>(70 * y + x)];
                    ASSERT_EQ(part,
                              tested > 0 ? static_cast<float>(static_cast<double>(blocked) / tested) : 0);
                }
            }
        }
    }
}

TEST(Occlusion, IsReplacedWithoutPreparing) {
    Scene scene = occlusion_mixture(OcclusionMethod::fixed);
    const Image occluded = render_scene(scene);
    const std::optional<Occlusion> occlusion = scene.occlusion;
    scene.occlusion.reset();
    const std::optional<World> clear = make_world(scene);
    const Result<World> again = with_occlusion(*clear, occlusion);
    ASSERT_TRUE(again);
    expect_same_picture(occluded, render_world(*again));
    expect_same_picture(render_scene(scene), render_world(with_occlusion(*again, {}).value()));
    const auto refused = [&](auto change) {
        Occlusion wrong;
        change(wrong);
        return !with_occlusion(*clear, wrong);
    };
    EXPECT_TRUE(refused([](Occlusion& o) { o.samples = 0; }));
    EXPECT_TRUE(refused([](Occlusion& o) { o.samples = k_max_occlusion_samples + 1; }));
    EXPECT_TRUE(refused([](Occlusion& o) { o.reach = 0; }));
    EXPECT_TRUE(refused([](Occlusion& o) { o.reach = std::nan(""); }));
    EXPECT_TRUE(refused([](Occlusion& o) { o.direct = -1; }));
    EXPECT_TRUE(refused([](Occlusion& o) { o.color.g = std::nan(""); }));
    EXPECT_TRUE(refused([](Occlusion& o) { o.method = static_cast<OcclusionMethod>(2); }));
}

}  // namespace
}  // namespace glint::test
