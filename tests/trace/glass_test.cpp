// SPDX-License-Identifier: Apache-2.0
// Glass: the renderer compared with a recursion as in the sources, and pictures known in closed form.
#include <gtest/gtest.h>

#include "trace/hit_rule.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

constexpr double k_step = 1e-6;  // the ray offset in this file

// The recursion of CSC 473 and of the other conventions, with ambient light only.
class Recursion {
  public:
    Recursion(const Scene& scene, const World& world) : scene_(scene), world_(world) {}

    /// medium: the glass inside which the ray travels, or null.
    Color seen(Vec3 o, Vec3 d, const Material* medium, Color weight, int generation) {
        const Conventions& rules = scene_.conventions;
        const BruteHit hit = brute_nearest(world_, o, d, 0, 1e300);
        if (hit.slot == k_none) {
            return generation > 0 && rules.mirror_miss == MissRule::black ? Color{0, 0, 0}
                                                                          : scene_.background;
        }
        Color way{1, 1, 1};
        const Shape& shape = scene_.shapes[world_.parts().geometry->shape_index[hit.slot]];
        const Material& met = scene_.materials[shape.material];
        if (met.transmission > 0 && dot(normal(shape, o + d * hit.t), d) > 0) medium = &met;
        if (medium != nullptr && rules.beer > 0) {
            const auto left = [&](double tint) { return std::exp((1 - tint) * rules.beer * -hit.t); };
            const Color tint = medium->transmission_tint;
            way = {left(tint.r), left(tint.g), left(tint.b)};
        }
        return way * surface(hit, o, d, medium, weight * way, generation);
    }

  private:
    Color surface(const BruteHit& hit, Vec3 o, Vec3 d, const Material* medium, Color weight, int generation) {
        const Conventions& rules = scene_.conventions;
        const Shape& shape = scene_.shapes[world_.parts().geometry->shape_index[hit.slot]];
        const Material& m = scene_.materials[shape.material];
        const Color local = m.ambient * world_.parts().ambient;
        const double r = m.mirror, f = m.transmission;
        const bool blend = rules.mirror == MirrorRule::blend,
                   at_limit = generation == scene_.settings.reflections;
        Color sum =
            blend && !(at_limit && rules.limit == LimitRule::keep) ? local * ((1 - f) * (1 - r)) : local;
        if (at_limit) return sum;

        const Vec3 p = o + d * hit.t, outward = normal(shape, p);
        const bool inside = dot(outward, d) > 0;
        const Vec3 n = inside ? -outward : outward;
        // Snell's law: the tangential component is multiplied by eta.
        const double eta = inside ? m.ior : 1 / m.ior, cosine = -dot(n, d);
        const Vec3 along = (d + n * cosine) * eta;
        const double sine2 = dot(along, along);
        double reflectance = 0;
        if (rules.fresnel == Fresnel::schlick) {
            const double f0 = (m.ior - 1) * (m.ior - 1) / ((m.ior + 1) * (m.ior + 1));
            reflectance = f0 + (1 - f0) * std::pow(1 - cosine, 5);
        }
        if (sine2 > 1) reflectance = 1;
        const double share = blend ? (1 - f) * r + f * reflectance : r + f * reflectance;
        const Color reflected = m.mirror_tint * share;
        if (counts(weight * reflected))
            sum = sum + reflected * seen(p + n * k_step, d - n * (2 * dot(d, n)), medium, weight * reflected,
                                         generation + 1);
        Color through = Color{1, 1, 1} * (f * (1 - reflectance));
        if (!inside && !(rules.beer > 0)) through = through * m.transmission_tint;
        if (counts(weight * through)) {
            const Vec3 t = along - n * std::sqrt(1 - sine2);
            sum = sum +
                  through * seen(p - n * k_step, t, inside ? nullptr : &m, weight * through, generation + 1);
        }
        return sum;
    }
    bool counts(Color w) const {
        const double most = std::max({w.r, w.g, w.b});
        return most > 0 && most >= scene_.conventions.min_weight;
    }
    Vec3 normal(const Shape& shape, Vec3 p) const {
        if (shape.kind == ShapeKind::sphere) return normalize(p - scene_.get<Sphere>()[shape.index].center);
        if (shape.kind == ShapeKind::plane) return normalize(scene_.get<Plane>()[shape.index].normal);
        const Box& box = scene_.get<Box>()[shape.index];
        const auto on = [](double x, double face) {
            return std::fabs(x - face) < 1e-9 * (1 + std::fabs(face));
        };
        if (on(p.x, box.min.x)) return {-1, 0, 0};
        if (on(p.x, box.max.x)) return {1, 0, 0};
        if (on(p.y, box.min.y)) return {0, -1, 0};
        if (on(p.y, box.max.y)) return {0, 1, 0};
        return {0, 0, on(p.z, box.min.z) ? -1.0 : 1.0};
    }
    const Scene& scene_;
    const World& world_;
};

Scene glass_scene(Random& random) {
    Scene scene;
    set_size(scene, 24, 20);
    scene.background = {0.3, 0.6, 0.9};
    scene.conventions.offset = Offset::facing;
    scene.conventions.epsilon = k_step;
    scene.camera.position = {0.5, 1, 6};
    scene.camera.look_at = {0, 0.2, -2};
    scene.lights = {ambient_light({1, 0.5, 2})};
    const auto material = [&](double mirror, double transmission, double ior) {
        Material m;
        m.ambient = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
        m.mirror = mirror;
        m.mirror_tint = {random.uniform(0.5, 1), 1, random.uniform(0.5, 1)};
        m.transmission = transmission;
        m.transmission_tint = {random.uniform(0.2, 1), random.uniform(0.2, 1), 1};
        m.ior = ior;
        return add_material(scene, m);
    };
    scene.add(Plane{{0, -2, 0}, {0, 1, 0.1}}, material(0.3, 0, 1));
    scene.add(Plane{{0, 0, -6}, {0, 0, 1}}, material(0, 0, 1));
    for (int i = 0; i < 9; ++i) {
        const Vec3 at{random.uniform(-2, 2), random.uniform(-1.5, 2), random.uniform(-4, 2)};
        const auto m = material(i % 3 == 0 ? 0 : random.uniform(0, 1), i == 1 ? 1 : random.uniform(0.3, 1),
                                i % 4 == 0 ? 0.7 : random.uniform(1, 2.4));
        if (i % 3 == 2) {
            scene.add(Box{at - Vec3{0.4, 0.6, 0.3}, at + Vec3{0.4, 0.5, 0.7}}, m);
        } else {
            scene.add(Sphere{at, random.uniform(0.3, 0.9)}, m);
        }
    }
    return scene;
}

void expect_recursion(const Scene& scene) {
    const std::optional<World> world = make_world(scene);
    const Result<Rendering> result = render(*world);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->rays.transmitted > 0, scene.settings.reflections > 0);
    Recursion recursion(scene, *world);
    const PreparedCamera& camera = world->parts().camera;
    int wrong = 0;
    for (int j = 0; j < scene.settings.height; ++j) {
        for (int i = 0; i < scene.settings.width; ++i) {
            const double sx = (i + 0.5 - scene.settings.width * 0.5) / scene.settings.width;
            const double sy = (scene.settings.height * 0.5 - (j + 0.5)) / scene.settings.height;
            Vec3 d = camera.forward + (camera.right * sx + camera.up * sy);
            d = d / std::sqrt(dot(d, d));
            const Color want = recursion.seen(camera.position, d, nullptr, {1, 1, 1}, 0);
            const Color got = pixel(result->image, i, j);
            for (double Color::*c : {&Color::r, &Color::g, &Color::b}) {
                wrong += !(std::fabs(want.*c - got.*c) <= 1e-6 * (1 + std::fabs(want.*c)));
            }
        }
    }
    EXPECT_EQ(wrong, 0) << "channels of " << 3 * scene.settings.width * scene.settings.height;
}

TEST(Glass, EqualsTheRecursionForEveryRule) {
    Random random(83);
    Scene scene = glass_scene(random);
    for (const int reflections : {0, 1, 6}) {
        for (const MirrorRule mirror : {MirrorRule::blend, MirrorRule::add}) {
            for (const LimitRule limit : {LimitRule::keep, LimitRule::drop}) {
                for (const Fresnel fresnel : {Fresnel::none, Fresnel::schlick}) {
                    for (const double beer : {0.0, 0.4}) {
                        for (const double min_weight : {0.0, 0.05}) {
                            SCOPED_TRACE(std::to_string(reflections) + " reflections, rules " +
                                         std::to_string(static_cast<int>(mirror)) +
                                         std::to_string(static_cast<int>(limit)) +
                                         std::to_string(static_cast<int>(fresnel)) + ", beer " +
                                         std::to_string(beer) + ", min_weight " + std::to_string(min_weight));
                            scene.settings.reflections = reflections;
                            scene.conventions.mirror = mirror;
                            scene.conventions.limit = limit;
                            scene.conventions.fresnel = fresnel;
                            scene.conventions.beer = beer;
                            scene.conventions.min_weight = min_weight;
                            scene.conventions.mirror_miss = beer > 0 ? MissRule::black : MissRule::background;
                            expect_recursion(scene);
                            if (HasFailure()) return;
                        }
                    }
                }
            }
        }
    }
}

// A pane of glass in front of a colored wall, seen perpendicularly: each part of its light is known.
Scene pane(double thickness) {
    Scene scene;
    set_size(scene, 9, 9);
    scene.camera.position = {0, 0, 5};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.fov_degrees = 1;
    scene.lights = {ambient_light({1, 1, 1})};
    scene.conventions.limit = LimitRule::drop;
    Material wall, glass;
    wall.ambient = {0.8, 0.4, 0.2};
    glass.ambient = {0.1, 0.2, 0.3};
    glass.transmission = 0.75;
    glass.transmission_tint = {0.5, 0.25, 1};
    glass.ior = 1;
    scene.add(Plane{{0, 0, -5}, {0, 0, 1}}, add_material(scene, wall));
    scene.add(Box{{-9, -9, -thickness}, {9, 9, 0}}, add_material(scene, glass));
    return scene;
}

// The colors of the pane's front and back, and of the wall behind it.
void expect_pane(const Scene& scene, Color back, Color wall) {
    const Color own = Color{0.1, 0.2, 0.3} * 0.25;
    const Image image = render_scene(scene);
    for (int y = 0; y < 9; ++y) {
        for (int x = 0; x < 9; ++x) {
            const Color want = own + back * own + wall * Color{0.8, 0.4, 0.2}, got = pixel(image, x, y);
            EXPECT_NEAR(got.r, want.r, 1e-4);
            EXPECT_NEAR(got.g, want.g, 1e-4);
            EXPECT_NEAR(got.b, want.b, 1e-4);
        }
    }
}

TEST(Glass, TintAppliesOnceAndTransmissionAtEachSurface) {
    const Color tint{0.5, 0.25, 1};
    expect_pane(pane(1), tint * 0.75, tint * (0.75 * 0.75));
    expect_pane(pane(3), tint * 0.75, tint * (0.75 * 0.75));
}

TEST(Glass, BeersLawDependsOnTheThickness) {
    for (const double thickness : {0.5, 2.0}) {
        Scene scene = pane(thickness);
        scene.conventions.beer = 0.15;
        const auto left = [&](double tint) { return std::exp((1 - tint) * 0.15 * -thickness); };
        const Color way{left(0.5), left(0.25), left(1)};
        expect_pane(scene, way * 0.75, way * (0.75 * 0.75));
    }
}

TEST(Glass, BeersLawInHollowGlass) {
    // A pane of thickness 2 with a layer of air of thickness 1 inside absorbs like a pane of thickness 1.
    Scene scene = pane(2);
    scene.conventions.beer = 0.15;
    scene.settings.reflections = 6;
    scene.materials[1].transmission = 1;
    Material air;
    air.ambient = {0, 0, 0};
    air.transmission = 1;
    scene.add(Box{{-8, -8, -1.5}, {8, 8, -0.5}}, add_material(scene, air));
    const Color got = pixel(render_scene(scene), 4, 4);
    const auto left = [](double tint) { return std::exp((1 - tint) * 0.15 * -1); };
    EXPECT_NEAR(got.r, 0.8 * left(0.5), 1e-4);
    EXPECT_NEAR(got.g, 0.4 * left(0.25), 1e-4);
    EXPECT_NEAR(got.b, 0.2 * left(1), 1e-4);
    // With the camera inside the glass, in front of the air.
    scene.camera.position = {0, 0, -0.25};
    scene.camera.look_at = {0, 0, -5};
    const Color inside = pixel(render_scene(scene), 4, 4);
    EXPECT_NEAR(inside.b, 0.2, 1e-4);
    // The ray hits the front of the air. It is not known to start in glass, so only the far wall absorbs.
    EXPECT_NEAR(inside.g, 0.4 * std::exp(0.75 * 0.15 * -0.5), 1e-4);
}

TEST(Glass, AClearBallOfAirIsInvisible) {
    Scene scene = pane(1);
    scene.get<Box>().clear();
    scene.shapes.pop_back();
    const Image without = render_scene(scene);
    Material air;
    air.ambient = {1, 1, 1};
    air.transmission = 1;
    air.ior = 1;
    scene.add(Sphere{{0, 0, 1}, 2}, add_material(scene, air));
    for (std::size_t i = 0; i < without.rgb.size(); ++i)
        EXPECT_EQ(render_scene(scene).rgb[i], without.rgb[i]);
}

TEST(Glass, ABallInvertsThePicture) {
    // Red above and green below, far behind a ball of index 1.5, whose focus is 1.5 radii from its centre.
    Scene scene;
    set_size(scene, 41, 41);
    scene.camera.position = {0, 0, 10};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.fov_degrees = 8;
    scene.lights = {ambient_light({1, 1, 1})};
    Material red, green, ball;
    red.ambient = {1, 0, 0};
    green.ambient = {0, 1, 0};
    ball.transmission = 1;
    ball.ior = 1.5;
    scene.add(Box{{-50, 0, -31}, {50, 50, -30}}, add_material(scene, red));
    scene.add(Box{{-50, -50, -31}, {50, 0, -30}}, add_material(scene, green));
    scene.add(Sphere{{0, 0, 0}, 1}, add_material(scene, ball));
    const Image image = render_scene(scene);
    for (const int y : {10, 15}) {
        EXPECT_EQ(pixel(image, 20, y), (Color{0, 1, 0})) << "the picture is inverted";
        EXPECT_EQ(pixel(image, 20, 40 - y), (Color{1, 0, 0}));
    }
}

TEST(Glass, TotalInternalReflectionBeyondTheCriticalAngle) {
    // A camera inside glass of index 1.5 looks at a flat face: it is dark outside and bright inside.
    for (const double degrees : {41.0, 42.0}) {  // the critical angle is 41.81 degrees
        Scene scene;
        set_size(scene, 1, 1);
        scene.settings.reflections = 1;
        scene.background = {0, 0, 0};
        scene.lights = {ambient_light({1, 1, 1})};
        const double a = degrees * M_PI / 180;
        scene.camera.position = {0, -1, 0};
        scene.camera.look_at = Vec3{std::sin(a), -1 + std::cos(a), 0};
        scene.camera.up = {0, 0, 1};
        Material glass, lamp;
        glass.transmission = 1;
        glass.ambient = {0, 0, 0};
        glass.ior = 1.5;
        lamp.ambient = {1, 1, 1};
        scene.add(Plane{{0, 0, 0}, {0, 1, 0}}, add_material(scene, glass));
        scene.add(Plane{{0, -5, 0}, {0, 1, 0}}, add_material(scene, lamp));
        const Result<Rendering> result = render(*make_world(scene));
        ASSERT_TRUE(result);
        EXPECT_EQ(pixel(result->image, 0, 0), degrees > 41.81 ? (Color{1, 1, 1}) : (Color{0, 0, 0}));
        EXPECT_EQ(result->rays.mirror, degrees > 41.81 ? 1u : 0u);
        EXPECT_EQ(result->rays.transmitted, degrees > 41.81 ? 0u : 1u);
    }
}

TEST(Glass, CastsAShadowIfTheConventionSaysSo) {
    Scene scene = pane(1);
    scene.lights = {point_light({0, 0, 4})};
    scene.materials[0].diffuse = {1, 1, 1};
    scene.materials[1].diffuse = {0, 0, 0};
    EXPECT_EQ(pixel(render_scene(scene), 4, 4).r, 0);
    scene.conventions.glass_shadow = GlassShadow::none;
    const double straight = 0.75 * 0.75 * 0.5;  // two surfaces, the tint
    EXPECT_NEAR(pixel(render_scene(scene), 4, 4).r, straight, 1e-3);
    // Opaque shapes still cast shadows.
    scene.add(Sphere{{0, 0, 3}, 0.5}, add_material(scene, Material{}));
    scene.camera.position = {4, 0, 2};
    scene.camera.look_at = {0, 0, -5};
    EXPECT_EQ(pixel(render_scene(scene), 4, 4).r, 0);
}

TEST(Glass, TheNumberOfRaysIsLimited) {
    Random random(84);
    Scene scene = glass_scene(random);
    set_size(scene, 16, 16);
    scene.settings.reflections = 1000;
    scene.conventions.mirror = MirrorRule::add;
    for (Material& m : scene.materials) m.mirror = m.transmission = 1;
    const Result<Rendering> result = render(*make_world(scene));
    ASSERT_TRUE(result);
    EXPECT_LE(result->rays.mirror + result->rays.transmitted, 256u * k_max_sample_rays);
    EXPECT_GT(result->rays.cut, 0u) << "the limit was reached";
    for (const float f : result->image.rgb) EXPECT_TRUE(f >= 0);
}

}  // namespace
}  // namespace glint::test
