// SPDX-License-Identifier: Apache-2.0
// The samples of circular and oriented area lights.
#include <gtest/gtest.h>

#include <cmath>

#include "glint/explain.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

// A floor below a light of 5 x 3 samples.
Scene floor_below(bool circular, bool oriented) {
    Scene scene;
    set_size(scene, 9, 9);
    scene.camera.position = {0, 6, 9};
    add_material(scene, Material{});
    scene.add(Plane{}, 0);
    Light light = point_light({0.5, 4, 0.25}, {1, 1, 1});
    light.kind = LightKind::parallelogram;
    light.side_u = {2, 0.5, 0};
    light.side_v = {0, 0, 1.5};
    light.samples_u = 5;
    light.samples_v = 3;
    light.circular = circular;
    light.oriented = oriented;
    scene.lights = {light};
    scene.conventions.area_shading = AreaShading::center;
    return scene;
}

// The samples' places from -1/2 to 1/2 along both sides.
void place_of(int sample, bool circular, double& p, double& q) {
    p = sample % 5 / 4.0 - 0.5;
    q = sample / 5 / 2.0 - 0.5;
    const double r = std::hypot(p, q);
    if (!circular || r == 0) return;
    const double factor = std::max(std::abs(p), std::abs(q)) / r;
    p *= factor;
    q *= factor;
}

TEST(BentAreaLights, SamplesAreWherePovrayHasThem) {
    for (const bool oriented : {false, true}) {
        for (const bool circular : {false, true}) {
            const Scene scene = floor_below(circular, oriented);
            const Light& light = scene.lights[0];
            const std::optional<World> world = make_world(scene);
            for (int x = 0; x < 9; x += 2) {
                const Explanation e = explain(scene, *world, x, 6).value();
                ASSERT_TRUE(!e.rays.empty() && e.rays[0].hit && e.rays[0].hit->lights.size() == 1);
                const ExplainedHit& hit = *e.rays[0].hit;
                Vec3 side_u = light.side_u, side_v = light.side_v;
                if (oriented) {
                    const Vec3 way = normalize(hit.point - light.position);
                    side_u = normalize(cross(way, {0, 0, 1})) * length(light.side_u);
                    side_v = cross(way, side_u);
                }
                const std::vector<ShadowSample>& samples = hit.lights[0].samples;
                ASSERT_EQ(samples.size(), 15u);
                for (const ShadowSample& sample : samples) {
                    double p = 0, q = 0;
                    place_of(sample.sample, circular, p, q);
                    const Vec3 expected = light.position + side_u * p + side_v * q;
                    EXPECT_NEAR(length(sample.position - expected), 0, 1e-14) << sample.sample;
                    // The ray is traced to or from that place.
                    const Vec3 end = sample.origin + sample.direction * sample.t_max;
                    EXPECT_LT(std::min(length(sample.origin - expected), length(end - expected)), 1e-6);
                }
            }
        }
    }
}

TEST(BentAreaLights, AreAsManyPointLights) {
    Scene scene = floor_below(true, false);
    scene.conventions.area_shading = AreaShading::samples;
    scene.add(Sphere{.center = {0.2, 1, 0.3}, .radius = 0.7}, 0);
    Scene points = scene;
    const Light light = scene.lights[0];
    points.lights.clear();
    for (int sample = 0; sample < 15; ++sample) {
        double p = (sample % 5 + 0.5) / 5 - 0.5, q = (sample / 5 + 0.5) / 3 - 0.5;
        const double r = std::hypot(p, q), factor = r > 0 ? std::max(std::abs(p), std::abs(q)) / r : 1;
        Light point = point_light({}, light.color * (1.0 / 15));
        point.specular_color = light.specular_color * (1.0 / 15);
        point.position = light.position + light.side_u * (p * factor) + light.side_v * (q * factor);
        points.lights.push_back(point);
    }
    const Image a = render_scene(scene), b = render_scene(points);
    for (std::size_t i = 0; i < a.rgb.size(); ++i) EXPECT_NEAR(a.rgb[i], b.rgb[i], 1e-6);
}

TEST(BentAreaLights, AboveAPointOnTheZAxisHaveSides) {
    Scene scene = floor_below(true, true);
    scene.get<Plane>()[0] = Plane{{0, 0, 0}, {0, 0, 1}};
    scene.camera.position = {0, 0, 9};
    scene.camera.look_at = {0, 0, 0};
    scene.lights[0].position = {0, 0, 4};
    const Explanation e = explain(scene, *make_world(scene), 4, 4).value();
    ASSERT_TRUE(!e.rays.empty() && e.rays[0].hit && e.rays[0].hit->lights.size() == 1);
    for (const ShadowSample& sample : e.rays[0].hit->lights[0].samples) {
        double p = 0, q = 0;
        place_of(sample.sample, true, p, q);
        EXPECT_NEAR(sample.position.x, p * std::sqrt(4.25), 1e-14);
        EXPECT_NEAR(std::abs(sample.position.y), std::abs(q) * std::sqrt(4.25), 1e-14);
        EXPECT_NEAR(sample.position.z, 4, 1e-14);
    }
}

}  // namespace
}  // namespace glint::test
