// SPDX-License-Identifier: Apache-2.0
// Shadow rays: their start and end by each convention, and the effect of classic faults.
#include <gtest/gtest.h>

#include "trace/pictures.h"

namespace glint::test {
namespace {

// One pixel that shows P = (0, 0, 0) on the plane y = 0 along `view`, a light, and a small disc across the
// shadow ray.
struct Spot {
    Conventions conventions;
    Vec3 view{0.5, -1, 0.25};
    Light light;
    bool is_lit(Vec3 blocker, Vec3 facing) const {
        Scene scene;
        set_size(scene, 1, 1);
        scene.settings.shading = Shading::diffuse;
        scene.conventions = conventions;
        scene.conventions.facing = Facing::none;
        scene.camera.position = view * -20;
        scene.camera.look_at = {0, 0, 0};
        scene.lights = {light};
        Material m;
        m.diffuse = {1, 1, 1};
        scene.add(Plane{{0, 0, 0}, {0, 1, 0}}, add_material(scene, m));
        scene.add(Disc{blocker, facing, 1e-6});
        return pixel(render_scene(scene), 0, 0).r > 0;
    }
    // The blocker is at P + s to the light's position (or to_light).
    bool is_lit_past(double s) const {
        const Vec3 to_light = light.has_position() ? light.position : light.to_light;
        return is_lit(to_light * s, to_light);
    }
};

TEST(Shadows, OffsetRayIsAnIntervalOfT) {
    // CGFS: t in (0.001, 1) of P + tL, L not normalised; (0.001, inf) of a directional light.
    Spot s;
    s.conventions.offset = Offset::ray;
    s.conventions.epsilon = 0.001;
    for (const Vec3 to : {Vec3{1, 2, 1}, Vec3{100, 200, 100}}) {
        s.light = point_light(to);
        EXPECT_TRUE(s.is_lit_past(0.00099));
        EXPECT_FALSE(s.is_lit_past(0.00101));
        EXPECT_FALSE(s.is_lit_past(0.5));
        EXPECT_FALSE(s.is_lit_past(0.9999));
        EXPECT_TRUE(s.is_lit_past(1.0001));
        s.light = directional_light(to);
        EXPECT_TRUE(s.is_lit_past(0.00099));
        EXPECT_FALSE(s.is_lit_past(0.00101));
        EXPECT_FALSE(s.is_lit_past(1e4));
    }
    // A direction has any length.
    for (const double size : {1e-300, 1e-40, 1e-23, 1e-3, 1e11}) {
        s.light = directional_light(Vec3{1, 2, 1} * size);
        s.conventions.epsilon = 0;
        EXPECT_FALSE(s.is_lit({3, 6, 3}, {1, 2, 1})) << size;
        EXPECT_TRUE(s.is_lit({3, 6, 3.1}, {1, 2, 1})) << size;
    }
}

TEST(Shadows, OffsetNormalStartsAboveTheSurface) {
    // RT2: origin P + epsilon N; direction from there to the light.
    Spot s;
    s.conventions.offset = Offset::normal;
    s.conventions.epsilon = 0.1;
    s.light = point_light({3, 4, 0});
    const Vec3 start{0, 0.1, 0}, way = s.light.position - start;
    const auto lit = [&](double part) { return s.is_lit(start + way * part, way); };
    EXPECT_TRUE(lit(-0.001));
    EXPECT_FALSE(lit(0.001));
    EXPECT_FALSE(lit(0.9999));
    EXPECT_TRUE(lit(1.0001));
    EXPECT_TRUE(s.is_lit_past(0.5));  // the segment from P itself is a different one
}

TEST(Shadows, OffsetFacingStartsOnTheSideOfTheEye) {
    Spot s;
    s.conventions.offset = Offset::facing;
    s.conventions.epsilon = 0.1;
    s.light = directional_light({0, 1, 0});
    EXPECT_TRUE(s.is_lit({0, 0.05, 0}, {0, 1, 0}));
    EXPECT_FALSE(s.is_lit({0, 0.15, 0}, {0, 1, 0}));
    // Seen from below: the ray starts below the plane, which occludes it.
    s.view = {0.5, 1, 0.25};
    EXPECT_FALSE(s.is_lit({0, 5, 0}, {0, 1, 0}));
    EXPECT_FALSE(s.is_lit({5, 5, 0}, {0, 1, 0}));
    s.conventions.offset = Offset::normal;
    EXPECT_TRUE(s.is_lit({5, 5, 0}, {0, 1, 0}));
}

TEST(Shadows, OffsetDirectionEndsEpsilonPastTheLight) {
    // Lecture 5: origin P + epsilon L, L of unit length; occluded if s < |L_P - P|.
    Spot s;
    s.conventions.offset = Offset::direction;
    s.conventions.epsilon = 0.1;
    s.light = point_light({3, 4, 0});  // at a distance of 5
    EXPECT_TRUE(s.is_lit_past(0.099 / 5));
    EXPECT_FALSE(s.is_lit_past(0.101 / 5));
    EXPECT_FALSE(s.is_lit_past(1));
    EXPECT_FALSE(s.is_lit_past(5.099 / 5));
    EXPECT_TRUE(s.is_lit_past(5.101 / 5));
    s.light = directional_light({3, 4, 0});
    EXPECT_TRUE(s.is_lit_past(0.099 / 5));
    EXPECT_FALSE(s.is_lit_past(0.101 / 5));
    EXPECT_FALSE(s.is_lit_past(1000));
}

TEST(Shadows, OffsetScaleGrowsWithTheScene) {
    Spot s;
    s.conventions.offset = Offset::scale;
    s.conventions.epsilon = 0.001;
    s.light = directional_light({0, 1, 0});
    // The largest coordinate of the ray's origin is 20, so the ray starts at 0.02.
    EXPECT_TRUE(s.is_lit({0, 0.019, 0}, {0, 1, 0}));
    EXPECT_FALSE(s.is_lit({0, 0.021, 0}, {0, 1, 0}));
    s.conventions.epsilon = 1e-9;
    EXPECT_FALSE(s.is_lit({0, 1e-5, 0}, {0, 1, 0}));
    // Lit from the far side: the ray starts on the light's side, independent of the eye.
    s.view = {0.5, 1, 0.25};
    EXPECT_TRUE(s.is_lit({5, 5, 0}, {0, 1, 0}));
}

TEST(Shadows, ShapesBehindTheLightBlockItOnlyAsAFault) {
    for (const Offset offset :
         {Offset::ray, Offset::normal, Offset::facing, Offset::direction, Offset::scale}) {
        Spot s;
        s.conventions.offset = offset;
        s.conventions.epsilon = 0.001;
        s.light = point_light({0, 5, 0});
        EXPECT_TRUE(s.is_lit_past(1.5));
        s.conventions.shadow_stops_at_light = false;
        EXPECT_FALSE(s.is_lit_past(1.5));
        EXPECT_FALSE(s.is_lit_past(0.5));
        EXPECT_TRUE(s.is_lit_past(-0.5));
    }
}

// A sphere of radius 1 at (0, 1, 0) on a plane, seen from the front.
Scene ball_on_plane(Light light) {
    Scene scene;
    set_size(scene, 120, 90);
    scene.settings.shading = Shading::diffuse;
    scene.camera.position = {0, 3, 8};
    scene.camera.look_at = {0, 0.8, 0};
    scene.camera.fov_degrees = 50;
    scene.lights = {light};
    Material m;
    m.diffuse = {1, 1, 1};
    const auto material = add_material(scene, m);
    scene.add(Plane{{0, 0, 0}, {0, 1, 0}}, material);
    scene.add(Sphere{{0, 1, 0}, 1}, material);
    return scene;
}
int dark_pixels(const Image& image) {
    int dark = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) dark += pixel(image, x, y).r == 0;
    }
    return dark;
}

TEST(Shadows, AcneWithoutEpsilonAndNoneWithIt) {
    for (const Light& light : {point_light({3, 9, 7}), directional_light({3, 9, 7})}) {
        Scene scene = ball_on_plane(light);
        const Image clean = render_scene(scene);
        scene.settings.shadows = false;
        const Image without = render_scene(scene);
        scene.settings.shadows = true;
        scene.conventions.epsilon = 0;
        const Image acne = render_scene(scene);
        // With the default, the only dark points that face the light are in the sphere's shadow on the plane.
        int spots = 0;
        for (int y = 0; y < 90; ++y) {
            for (int x = 0; x < 120; ++x) {
                spots += pixel(acne, x, y).r == 0 && pixel(clean, x, y).r > 0;
                if (pixel(clean, x, y).r != 0 || pixel(without, x, y).r == 0) continue;
                // On the plane, the point is behind the sphere as seen from the light.
                const std::optional<World> world = make_world(scene);
                const double sx = (x + 0.5 - 60) / 120, sy = (45 - (y + 0.5)) / 90;
                const Vec3 d = world->parts().camera.forward + world->parts().camera.right * sx +
                               world->parts().camera.up * sy;
                const Vec3 p = scene.camera.position + d * (-scene.camera.position.y / d.y);
                const Vec3 to_light = light.way_from(p);
                const Vec3 l = normalize(to_light), q = Vec3{0, 1, 0} - p;
                const Vec3 f = q - l * dot(q, l);
                EXPECT_LT(dot(f, f), 1 + 1e-6) << "a dark pixel at (" << x << ", " << y << ")";
            }
        }
        EXPECT_GT(spots, 20);
        EXPECT_GT(dark_pixels(clean), dark_pixels(without));
    }
}

TEST(Shadows, NoAcneAtAnySizeOrPlace) {
    // A single convex shape: all points that face the light are fully lit.
    Random random(101);
    for (int i = 0; i < 40; ++i) {
        const double size = log_uniform(random, 1e-5, 1e5);
        const Vec3 at = point_in_cube(random, size * log_uniform(random, 1, 1e3));
        Scene scene;
        set_size(scene, 40, 40);
        scene.settings.shading = Shading::diffuse;
        const Vec3 eye = unit_direction(random);
        scene.camera.position = at + eye * (4 * size);
        scene.camera.look_at = at;
        scene.lights = {point_light(at + (eye + unit_direction(random) * 0.7) * (7 * size))};
        Material m;
        m.diffuse = {1, 1, 1};
        const auto material = add_material(scene, m);
        switch (i % 5) {
            case 0:
                scene.add(Sphere{at, size}, material);
                break;
            case 1:
                scene.add(Cylinder{at, at + unit_direction(random) * size, size, true}, material);
                break;
            case 2:
                scene.add(Cone{at, at + unit_direction(random) * size, size, 0.1 * size, true}, material);
                break;
            case 3:
                scene.add(Box{at - Vec3{size, size, size}, at + Vec3{size, size, size}}, material);
                break;
            default:
                scene.add(Plane{at, eye}, material);
        }
        const Image shadowed = render_scene(scene);
        scene.settings.shadows = false;
        expect_same_picture(render_scene(scene), shadowed);
    }
}

TEST(Shadows, ALightInsideASphereLightsNothingOutside) {
    Scene scene = ball_on_plane(point_light({0.1, 1.2, 0}));
    EXPECT_EQ(dark_pixels(render_scene(scene)), 120 * 90);
    // Seen from inside, the inside is lit.
    scene.camera.position = {0.3, 0.9, 0};
    scene.camera.look_at = {-5, 1, 1};
    EXPECT_EQ(dark_pixels(render_scene(scene)), 0);
    scene.conventions.facing = Facing::none;  // the outward normal points away from the light
    EXPECT_EQ(dark_pixels(render_scene(scene)), 120 * 90);
}

TEST(Shadows, ALightInTheSurfaceItself) {
    // Its own surface is at grazing incidence and stays dark; the others are lit.
    Scene scene = ball_on_plane(point_light({2, 0, 1}));
    Image image = render_scene(scene);
    const Image sphere_only = [&] {
        Scene copy = scene;
        copy.settings.shading = Shading::color;
        copy.materials.push_back({});
        copy.materials[1].color = {0, 0, 0};
        copy.shapes[0].material = 1;
        return render_scene(copy);
    }();
    int lit_on_sphere = 0;
    for (int y = 0; y < 90; ++y) {
        for (int x = 0; x < 120; ++x) {
            EXPECT_FALSE(std::isnan(pixel(image, x, y).r));
            if (pixel(sphere_only, x, y).r == 0) {
                EXPECT_LT(pixel(image, x, y).r, 1e-9);
            } else {
                lit_on_sphere += pixel(image, x, y).r > 0;
            }
        }
    }
    EXPECT_GT(lit_on_sphere, 200);
    // A light exactly at a pixel's hit point has no direction there, and gives no light.
    scene.lights[0].position = {0, 2, 0};
    scene.camera.projection = Projection::orthographic;
    scene.camera.position = {0, 10, 0};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.up = {0, 0, -1};
    set_size(scene, 1, 1);
    image = render_scene(scene);
    EXPECT_EQ(pixel(image, 0, 0).r, 0);
}

}  // namespace
}  // namespace glint::test
