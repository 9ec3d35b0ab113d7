// SPDX-License-Identifier: Apache-2.0
// Area lights against the lights that they stand for, and against POV-Ray's weights.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "glint/explain.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

// Two balls and a slab above a mirror-like floor, so that mirror rays meet soft shadows, too.
Scene room(const Light& light, AreaShading shading) {
    Scene scene;
    set_size(scene, 83, 61);
    scene.conventions.area_shading = shading;
    scene.camera.position = {0, 3, 9};
    scene.camera.look_at = {0, 0.5, 0};
    Material floor, ball;
    floor.mirror = 0.3;
    ball.specular = {0.5, 0.4, 0.3};
    add_material(scene, floor);
    add_material(scene, ball);
    scene.add(Plane{}, 0);
    scene.add(Sphere{.center = {-1.5, 1, 0}, .radius = 1}, 1);
    scene.add(Sphere{.center = {1, 0.6, 1.5}, .radius = 0.6}, 1);
    scene.add(Box{.min = {0.5, 2, -1}, .max = {2, 2.1, 0.5}}, 1);
    scene.lights = {ambient_light({0.1, 0.1, 0.1}), light, point_light({5, 6, 8}, {0.2, 0.2, 0.3})};
    return scene;
}

Light panel(std::int32_t columns, std::int32_t rows) {
    Light light = point_light({-1, 5, 1}, {0.9, 0.8, 0.7});
    light.kind = LightKind::parallelogram;
    light.side_u = {2, 0.5, 0};
    light.side_v = {0, 0, 1.5};
    light.samples_u = columns;
    light.samples_v = rows;
    return light;
}

Light round_light(LightKind kind) {
    Light light = panel(3, 5);
    light.kind = kind;
    light.axis = {0.3, -2, 0.1};
    light.radius = 0.8;
    return light;
}

const ExplainedHit* first_hit(const Explanation& e) {
    return !e.rays.empty() && e.rays[0].hit ? &*e.rays[0].hit : nullptr;
}

TEST(AreaLights, AreAsManyPointLights) {
    const Light light = panel(4, 3);
    const Scene scene = room(light, AreaShading::samples);
    Scene points = scene;
    points.lights.resize(1);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            Light point = point_light({}, light.color * (1.0 / 12));
            point.specular_color = light.specular_color * (1.0 / 12);
            point.position = light.position + (light.side_u * ((column + 0.5) / 4 - 0.5) +
                                               light.side_v * ((row + 0.5) / 3 - 0.5));
            points.lights.push_back(point);
        }
    }
    points.lights.push_back(scene.lights[2]);
    expect_same_picture(render_scene(scene), render_scene(points));
}

TEST(AreaLights, OfOneSampleAreOneLight) {
    for (const AreaShading shading : {AreaShading::samples, AreaShading::center}) {
        const Scene scene = room(panel(1, 1), shading);
        Scene point = scene;
        point.lights[1].kind = LightKind::point;
        expect_same_picture(render_scene(scene), render_scene(point));
    }
}

TEST(AreaLights, WithoutShadowsShineFromTheirCentre) {
    Scene scene = room(panel(4, 4), AreaShading::center);
    Scene point = scene;
    point.lights[1].kind = LightKind::point;
    scene.settings.shadows = point.settings.shadows = false;
    expect_same_picture(render_scene(scene), render_scene(point));
    scene.settings.shadows = point.settings.shadows = true;
    scene.lights[1].casts_shadows = point.lights[1].casts_shadows = false;
    expect_same_picture(render_scene(scene), render_scene(point));
}

TEST(AreaLights, PointsAreOnTheirShape) {
    for (const LightKind kind : {LightKind::parallelogram, LightKind::disc, LightKind::sphere}) {
        for (const bool jitter : {false, true}) {
            Light light = kind == LightKind::parallelogram ? panel(3, 5) : round_light(kind);
            light.jitter = jitter;
            const Scene scene = room(light, AreaShading::samples);
            const std::optional<World> world = make_world(scene);
            std::set<double> distances;
            for (int x = 0; x < 83; x += 9) {
                const Explanation e = explain(scene, *world, x, 50).value();
                const ExplainedHit* hit = first_hit(e);
                ASSERT_TRUE(hit != nullptr && hit->lights.size() == 16);
                for (int i = 0; i < 15; ++i) {
                    const LightTerms& terms = hit->lights[static_cast<std::size_t>(i)];
                    ASSERT_EQ(terms.light, 1u);
                    ASSERT_EQ(terms.sample, i);
                    const Vec3 from_center = hit->point + terms.to_light - light.position;
                    const double r = length(from_center), along = dot(from_center, light.axis);
                    if (kind == LightKind::sphere) {
                        EXPECT_NEAR(r, 0.8, 1e-12);
                    }
                    if (kind == LightKind::disc) {
                        // Rings of equal area.
                        const int ring = i % 3;
                        EXPECT_NEAR(along, 0, 1e-12);
                        EXPECT_GE(r, 0.8 * std::sqrt(ring / 3.0) - 1e-12);
                        EXPECT_LE(r, 0.8 * std::sqrt((ring + 1) / 3.0) + 1e-12);
                    }
                    if (kind == LightKind::parallelogram) {
                        const double u = from_center.x / 2 + 0.5, v = from_center.z / 1.5 + 0.5;
                        EXPECT_EQ(std::floor(u * 3), i % 3);
                        EXPECT_EQ(std::floor(v * 5), i / 3);
                        EXPECT_NEAR(from_center.y, from_center.x / 4, 1e-12);
                    }
                    distances.insert(std::round(length(from_center - light.side_u) * 1e9));
                }
            }
            if (jitter) {
                EXPECT_GT(distances.size(), 140u) << "each point has samples of its own";
            } else {
                EXPECT_LE(distances.size(), 15u);
            }
        }
    }
}

TEST(AreaLights, OneSidedGiveLightByTheirCosine) {
    Light light = panel(1, 1);
    light.side_u = {1, 0, 0};
    light.side_v = {0, 0, 1};  // x × z = -y
    light.one_sided = true;
    Light point = light;
    point.kind = LightKind::point;
    const Scene scene = room(light, AreaShading::samples), other = room(point, AreaShading::samples);
    const std::optional<World> world = make_world(scene), other_world = make_world(other);
    int below = 0, above = 0;
    for (int y = 0; y < 61; y += 4) {
        for (int x = 0; x < 83; x += 5) {
            const Explanation e = explain(scene, *world, x, y).value(),
                              o = explain(other, *other_world, x, y).value();
            const ExplainedHit* hit = first_hit(e);
            if (hit == nullptr) continue;
            const LightTerms& terms = hit->lights[0];
            const double cosine = terms.to_light.y / terms.distance;
            EXPECT_NEAR(terms.emitter, std::max(cosine, 0.0), 1e-15);
            EXPECT_NEAR(terms.diffuse.r, first_hit(o)->lights[0].diffuse.r * terms.emitter, 1e-15);
            (cosine > 0 ? below : above) += 1;
            if (cosine <= 0 && terms.n_l > 0) {
                EXPECT_EQ(reason(terms), LightReason::back_of_light);
            }
        }
    }
    EXPECT_GT(below, 50);
    // Turned over, it lights nothing.
    Scene turned = scene;
    std::swap(turned.lights[1].side_u, turned.lights[1].side_v);
    Scene without = scene;
    without.lights.erase(without.lights.begin() + 1);
    expect_same_picture(render_scene(turned), render_scene(without));
}

// The weight of each sample where all but one are visible, or blocked, by explain's visible part.
TEST(AreaLights, WeightsAreThoseOfPovray) {
    const std::vector<std::vector<double>> weights = {
        {1}, {0.5, 0.5}, {0.25, 0.5, 0.25}, {0.25, 0.25, 0.25, 0.25}, {0.125, 0.25, 0.25, 0.25, 0.125}};
    for (int n = 1; n <= 5; ++n) {
        for (int m = 1; m <= 5; ++m) {
            const Scene scene = room(panel(n, m), AreaShading::center);
            const std::optional<World> world = make_world(scene);
            int partly = 0;
            for (int y = 30; y < 61; y += 3) {
                for (int x = 0; x < 83; x += 4) {
                    const Explanation e = explain(scene, *world, x, y).value();
                    const ExplainedHit* hit = first_hit(e);
                    if (hit == nullptr || !hit->lights[0].may_add) continue;
                    const LightTerms& terms = hit->lights[0];
                    ASSERT_EQ(terms.samples.size(), static_cast<std::size_t>(n * m));
                    double part = 0;
                    for (const ShadowSample& sample : terms.samples) {
                        const int u = sample.sample % n, v = sample.sample / n;
                        if (!sample.blocked) part += weights[n - 1u].at(u) * weights[m - 1u].at(v);
                        ASSERT_EQ(sample.blocked, sample.blocker.has_value());
                        const Vec3 at = panel(n, m).position +
                                        panel(n, m).side_u * (n == 1 ? 0 : u / (n - 1.0) - 0.5) +
                                        panel(n, m).side_v * (m == 1 ? 0 : v / (m - 1.0) - 0.5);
                        ASSERT_LT(length(sample.position - at), 1e-12);
                    }
                    ASSERT_EQ(terms.visible, part);
                    ASSERT_EQ(terms.blocked, part == 0);
                    partly += part > 0 && part < 1 ? 1 : 0;
                }
            }
            if (n * m > 1) {
                EXPECT_GT(partly, 5) << n << 'x' << m;
            }
        }
    }
}

TEST(AreaLights, QuarteringTracesFewerSamples) {
    Scene scene = room(panel(9, 9), AreaShading::center);
    const auto rays = [&](std::int32_t adaptive) {
        scene.lights[1].adaptive = adaptive;
        return render(*make_world(scene)).value().rays.shadow;
    };
    const std::uint64_t all = rays(k_all_levels);
    EXPECT_EQ(rays(3), all);  // 9 = 2^3 + 1
    EXPECT_LT(rays(2), all);
    EXPECT_LT(rays(1), rays(2));
    EXPECT_LT(rays(0), rays(1));
    EXPECT_LT(4 * rays(0), all);
    // Only where the corners agree, the picture may differ from that of all samples.
    const std::optional<World> world = make_world(scene);
    Scene full = scene;
    full.lights[1].adaptive = k_all_levels;
    const std::optional<World> full_world = make_world(full);
    int uneven = 0;
    for (int y = 0; y < 61; y += 3) {
        for (int x = 0; x < 83; x += 4) {
            const Explanation few = explain(scene, *world, x, y).value(),
                              every = explain(full, *full_world, x, y).value();
            const ExplainedHit* hit = first_hit(few);
            if (hit == nullptr || !hit->lights[0].may_add) continue;
            const LightTerms &a = hit->lights[0], &b = first_hit(every)->lights[0];
            ASSERT_GE(a.samples.size(), 4u);
            double sum = 0, part = 0;
            for (const ShadowSample& sample : a.samples) {
                sum += sample.weight;
                part += sample.blocked ? 0 : sample.weight;
            }
            ASSERT_EQ(sum, 1);
            ASSERT_EQ(part, a.visible);
            uneven += a.samples[0].weight != a.samples.back().weight ? 1 : 0;
            if (a.samples.size() == 4) {
                ASSERT_EQ(a.visible, a.samples[0].blocked ? 0 : 1);
            }
            if (a.samples.size() == b.samples.size()) {
                ASSERT_EQ(a.visible, b.visible);
            }
        }
    }
    EXPECT_GT(uneven, 5);
}

// A light so dim that light and shadow differ by at most 0.1 is not divided.
TEST(AreaLights, QuarteringDependsOnTheLight) {
    const auto rays = [](Color color, double attenuation) {
        Light light = panel(5, 5);
        light.color = color;
        light.adaptive = 0;
        light.attenuation = {attenuation, 0, 0};
        Scene scene = room(light, AreaShading::center);
        scene.lights.resize(2);
        return render(*make_world(scene)).value().rays.shadow;
    };
    const std::uint64_t bright = rays({1, 1, 1}, 1), dim = rays({0.03, 0.03, 0.03}, 1);
    EXPECT_GT(bright, dim);
    EXPECT_EQ(dim % 4, 0u);
    EXPECT_EQ(rays({0.1, 0, 0}, 1), dim);
    EXPECT_EQ(rays({0.05, 0.04, 0.02}, 1), bright);
    EXPECT_EQ(rays({1, 1, 1}, 50), dim);
    EXPECT_EQ(rays({-0.05, 0.06, 0}, 1), bright);
}

std::vector<Scene> scenes() {
    std::vector<Scene> list;
    for (const AreaShading shading : {AreaShading::samples, AreaShading::center}) {
        for (const bool jitter : {false, true}) {
            Light facing = panel(4, 3);
            facing.circular = facing.oriented = true;
            for (Light light :
                 {panel(3, 4), facing, round_light(LightKind::disc), round_light(LightKind::sphere)}) {
                light.jitter = jitter;
                light.one_sided = light.is_disc();
                if (light.is_parallelogram()) light.adaptive = 1;
                list.push_back(room(light, shading));
                list.back().settings.samples = jitter ? 2 : 1;
            }
        }
    }
    return list;
}

TEST(AreaLights, CropsThreadsAndInstructionSets) {
    std::uint32_t seed = 17;
    for (const Scene& scene : scenes())
        expect_same_crops(*make_world(scene), static_cast<int>(isa_names().size()), seed++);
}

TEST(AreaLights, ExplainedAsDrawn) {
    for (const Scene& scene : scenes()) {
        expect_explained_as_drawn(scene, 4, 3, [](const Explanation& e, int, int) {
            for (const ExplainedRay& ray : e.rays) {
                if (!ray.hit) continue;
                Color diffuse, specular;
                for (const LightTerms& terms : ray.hit->lights) {
                    diffuse = diffuse + terms.diffuse;
                    specular = specular + terms.specular;
                    ASSERT_EQ(terms.blocked, terms.blocker.has_value());
                }
                ASSERT_EQ(diffuse, ray.hit->diffuse);
                ASSERT_EQ(specular, ray.hit->specular);
            }
        });
    }
}

TEST(AreaLights, TheShadowLayerIsSoft) {
    for (const AreaShading shading : {AreaShading::samples, AreaShading::center}) {
        Scene scene = room(panel(5, 5), shading);
        scene.lights = {scene.lights[1]};
        RenderOptions options;
        options.layers = {Layer::shadow};
        const Rendering all = render(*make_world(scene), options).value();
        std::set<float> values(all.layers[0].values.begin(), all.layers[0].values.end());
        EXPECT_GT(values.size(), 8u);
        EXPECT_EQ(*values.begin(), 0);
        EXPECT_EQ(*values.rbegin(), 1);
    }
}

TEST(AreaLights, ConventionIsReplacedWithoutPreparing) {
    Scene scene = room(panel(3, 3), AreaShading::samples);
    const std::optional<World> world = make_world(scene);
    scene.conventions.area_shading = AreaShading::center;
    const Result<World> center = with_rules(*world, scene.conventions, scene.settings);
    ASSERT_TRUE(center);
    expect_same_picture(render_scene(scene), render_world(*center));
}

}  // namespace
}  // namespace glint::test
