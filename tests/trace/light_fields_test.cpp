// SPDX-License-Identifier: Apache-2.0
// What a light's own fields do to a picture: spots, attenuation, lights and surfaces without shadows.
#include <gtest/gtest.h>

#include "trace/pictures.h"

namespace glint::test {
namespace {

constexpr int k_size = 121;
constexpr double k_view_width = 12;

// The plane y = 0, seen from above by parallel rays: x to the right, z downwards.
Scene floor_under(const Light& light) {
    Scene scene;
    set_size(scene, k_size, k_size);
    scene.settings.shading = Shading::diffuse;
    scene.camera.projection = Projection::orthographic;
    scene.camera.position = {0, 50, 0};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.up = {0, 0, -1};
    scene.camera.width = k_view_width;
    scene.lights = {light};
    Material white;
    white.diffuse = {1, 1, 1};
    scene.add(Plane{}, add_material(scene, white));
    return scene;
}

Vec3 floor_point(int i, int j) {
    return {(i + 0.5 - k_size * 0.5) * k_view_width / k_size, 0,
            (j + 0.5 - k_size * 0.5) * k_view_width / k_size};
}

// Compares the diffuse light with factor(distance, degrees off the axis) * N·L.
template <class Factor> void expect_floor(const Scene& scene, const Factor& factor) {
    const Light& light = scene.lights[0];
    expect_picture(render_scene(scene), [&](int i, int j) {
        const Vec3 way = floor_point(i, j) - light.position;
        const double d = std::sqrt(dot(way, way));
        const double cosine = dot(way, light.axis) / (d * std::sqrt(dot(light.axis, light.axis)));
        const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / M_PI;
        Layers layers;
        layers.diffuse = light.color * (factor(d, angle) * light.position.y / d);
        return layers;
    });
}

Light slanting_spot() {
    Light light = point_light({-1, 4, 0.5}, {1, 0.8, 0.6});
    light.kind = LightKind::spot;
    light.axis = {2, -6, 1};
    light.inner_angle = 15;
    light.outer_angle = 32;
    return light;
}

double cubic(double angle, double inner, double outer) {
    const double ct = std::cos(angle * M_PI / 180), ci = std::cos(inner * M_PI / 180),
                 co = std::cos(outer * M_PI / 180);
    const double s = std::clamp((ct - co) / (ci - co), 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

TEST(Spots, FallOffCubically) {
    const Scene scene = floor_under(slanting_spot());
    expect_floor(scene, [](double, double angle) { return cubic(angle, 15, 32); });
}

TEST(Spots, AreTight) {
    Light light = slanting_spot();
    light.tightness = 12;
    expect_floor(floor_under(light), [](double, double angle) {
        return cubic(angle, 15, 32) * std::pow(std::cos(angle * M_PI / 180), 12);
    });
}

TEST(Spots, FallOffLinearly) {
    Light light = slanting_spot();
    light.tightness = 12;  // not used
    Scene scene = floor_under(light);
    scene.conventions.spot_falloff = SpotFalloff::linear;
    expect_floor(scene, [](double, double angle) { return std::clamp((32 - angle) / (32 - 15), 0.0, 1.0); });
}

TEST(Spots, HaveASharpEdgeIfTheAnglesAreEqual) {
    for (const SpotFalloff falloff : {SpotFalloff::cubic, SpotFalloff::linear}) {
        Light light = slanting_spot();
        light.inner_angle = light.outer_angle = 20;
        Scene scene = floor_under(light);
        scene.conventions.spot_falloff = falloff;
        expect_floor(scene, [](double, double angle) { return angle < 20 ? 1.0 : 0.0; });
    }
}

// A cone of 180 degrees is a point light, even behind the spot.
TEST(Spots, OfAllDirectionsArePointLights) {
    Light spot = slanting_spot(), point = slanting_spot();
    spot.axis = {0, 1, 0};
    spot.inner_angle = spot.outer_angle = 180;
    point.kind = LightKind::point;
    expect_same_picture(render_scene(floor_under(spot)), render_scene(floor_under(point)));
}

TEST(Spots, HaveHighlightsOfTheSameFactor) {
    Light light = slanting_spot();
    light.axis = {1, -4, -0.5};
    Scene scene = floor_under(light);
    scene.settings.shading = Shading::phong;
    scene.materials[0].diffuse = {0, 0, 0};
    scene.materials[0].specular = {1, 1, 1};
    scene.materials[0].shininess = 3;
    expect_picture(render_scene(scene), [&](int i, int j) {
        const Vec3 way = floor_point(i, j) - light.position;
        const double d = std::sqrt(dot(way, way)), size = std::sqrt(dot(light.axis, light.axis));
        const double angle = std::acos(std::min(1.0, dot(way, light.axis) / (d * size))) * 180 / M_PI;
        Layers layers;  // R·V is L's y: the eye is straight above
        layers.specular = light.color * (cubic(angle, 15, 32) * std::pow(light.position.y / d, 3));
        return layers;
    });
}

TEST(Attenuation, FadesAsInPovray) {
    Light light = point_light({-1, 4, 0.5}, {1, 0.8, 0.6});
    for (const double power : {0.7, 2.0, 5.0}) {
        light.fade_distance = 4.5;
        light.fade_power = power;
        light.attenuation = {};
        expect_floor(floor_under(light),
                     [&](double d, double) { return 2 / (1 + std::pow(d / 4.5, power)); });
        light.attenuation = {0.5, 0.1, 0.03};
        expect_floor(floor_under(light), [&](double d, double) {
            return 2 / (1 + std::pow(d / 4.5, power)) * std::min(1 / (0.5 + 0.1 * d + 0.03 * d * d), 1.0);
        });
    }
}

TEST(Attenuation, ExceedsOneIfItIsNotClamped) {
    Light light = point_light({-1, 4, 0.5}, {0.2, 0.1, 0.05});
    for (const Attenuation& a : {Attenuation{0.1, 0.01, 0.02}, Attenuation{0.25, 0, 0}}) {
        light.attenuation = a;
        Scene scene = floor_under(light);
        const auto factor = [&](double d) { return 1 / (a.c0 + a.c1 * d + a.c2 * d * d); };
        expect_floor(scene, [&](double d, double) { return std::min(factor(d), 1.0); });
        scene.conventions.clamp_attenuation = false;
        expect_floor(scene, [&](double d, double) { return factor(d); });
    }
}

// A ball above the floor, under a light above it.
Scene ball_under(const Light& light) {
    Scene scene = floor_under(light);
    scene.camera.position = {0, 50, 0};
    Material black;
    black.diffuse = {0, 0, 0};
    scene.add(Sphere{{0, 2, 0}, 1}, add_material(scene, black));
    return scene;
}

double middle_ring(const Scene& scene) {  // a point in the shadow that the ball does not hide from the camera
    const Image image = render_scene(scene);
    return image.rgb[3 * (60 * k_size + 60 + 14)];
}

TEST(Shadows, CanBeOffForALight) {
    Light light = point_light({0, 4, 0});
    Scene scene = ball_under(light);
    EXPECT_EQ(middle_ring(scene), 0);
    scene.lights[0].casts_shadows = false;
    EXPECT_GT(middle_ring(scene), 0.5);
    scene.lights.push_back(light);  // another light still has its shadow
    EXPECT_EQ(middle_ring(scene) * 2, [&] {
        Scene both = scene;
        both.lights[1].casts_shadows = false;
        return middle_ring(both);
    }());
}

TEST(Shadows, CanBeOffForAMaterial) {
    Scene scene = ball_under(point_light({0, 4, 0}));
    scene.materials[1].casts_shadow = false;
    EXPECT_GT(middle_ring(scene), 0.5);
    // A second ball of another material below it still casts one, and so does the default material.
    scene.add(Sphere{{0, 1.1, 0}, 1.05}, add_material(scene, {}));
    EXPECT_EQ(middle_ring(scene), 0);
    scene.shapes.back().material = k_none;
    EXPECT_EQ(middle_ring(scene), 0);
}

}  // namespace
}  // namespace glint::test
