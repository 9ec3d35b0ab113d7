// SPDX-License-Identifier: Apache-2.0
// Mirrors: the renderer's weighted sum compared with the recursion of the sources, for every rule.
#include <gtest/gtest.h>

#include "trace/hit_rule.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

// The recursion of CGFS and RT2, with ambient light only.
class MirrorRecursion {
  public:
    MirrorRecursion(const Scene& scene, const World& world) : scene_(scene), world_(world) {}

    Color seen(Vec3 o, Vec3 d, double t_min, Color weight, int generation) {
        ++rays_;
        const Conventions& rules = scene_.conventions;
        const BruteHit hit = brute_nearest(world_, o, d, t_min, 1e300);
        if (hit.slot == k_none) {
            return generation > 0 && rules.mirror_miss == MissRule::black ? Color{0, 0, 0}
                                                                          : scene_.background;
        }
        const Shape& shape = scene_.shapes[world_.parts().geometry->shape_index[hit.slot]];
        const Material& m = scene_.materials[shape.material];
        const Color local = m.ambient * world_.parts().ambient;
        const double a = m.mirror;
        if (a == 0) return local;
        const bool at_limit = generation == scene_.settings.reflections;
        if (at_limit && rules.limit == LimitRule::keep) return local;
        const Color own = rules.mirror == MirrorRule::blend ? local * (1 - a) : local;
        if (at_limit) return own;
        const Color below = weight * a * m.mirror_tint;
        if (std::max({below.r, below.g, below.b}) < rules.min_weight) return own;
        const Vec3 p = o + d * hit.t, n = normal(shape, p), v = -d;
        const Vec3 r = n * (2 * dot(n, v)) - v;
        return own + a * m.mirror_tint * seen(p, r, rules.epsilon, below, generation + 1);
    }
    std::uint64_t rays() const { return rays_; }

  private:
    Vec3 normal(const Shape& shape, Vec3 p) const {
        if (shape.kind == ShapeKind::sphere) return normalize(p - scene_.get<Sphere>()[shape.index].center);
        return normalize(scene_.get<Plane>()[shape.index].normal);
    }
    const Scene& scene_;
    const World& world_;
    std::uint64_t rays_ = 0;
};

Scene hall_of_mirrors(Random& random, bool closed) {
    Scene scene;
    set_size(scene, 24, 20);
    scene.background = {0.3, 0.6, 0.9};
    scene.conventions.offset = Offset::ray;
    scene.conventions.epsilon = 1e-6;
    scene.conventions.facing = Facing::none;
    scene.camera.position = {0.5, 1, 3};
    scene.camera.look_at = {0, 0.4, -2};
    scene.lights = {ambient_light({1, 0.5, 2})};
    const auto mirror = [&](double a) {
        Material m;
        m.ambient = {random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
        m.mirror = a;
        m.mirror_tint = {random.uniform(0.5, 1), random.uniform(0.5, 1), 1};
        return add_material(scene, m);
    };
    scene.add(Plane{{0, 0, -4}, {0, 0, 1}}, mirror(0.9));
    scene.add(Plane{{0, 0, 4}, {0, 0, -1}}, mirror(0.8));
    if (closed) {
        scene.add(Plane{{-3, 0, 0}, {1, 0.1, 0}}, mirror(1));
        scene.add(Plane{{3, 0, 0}, {-1, 0, 0.1}}, mirror(0.7));
        scene.add(Plane{{0, -2, 0}, {0, 1, 0}}, mirror(0.5));
        scene.add(Plane{{0, 3, 0}, {0, -1, 0}}, mirror(0.95));
    }
    for (int i = 0; i < 6; ++i) {
        scene.add(Sphere{{random.uniform(-2, 2), random.uniform(-1.5, 2), random.uniform(-3, 1)}, 0.5},
                  mirror(i == 0 ? 0 : random.uniform(0.2, 1)));
    }
    return scene;
}

void expect_recursion(Scene& scene, const std::optional<World>& world) {
    Result<Rendering> result = render(*world);
    ASSERT_TRUE(result);
    const Vec3 forward = normalize(scene.camera.look_at - scene.camera.position);
    const Vec3 x = normalize(cross(forward, scene.camera.up)), y = cross(x, forward);
    MirrorRecursion recursion(scene, *world);
    const PreparedCamera& camera = world->parts().camera;
    EXPECT_NEAR(dot(camera.forward, forward) + dot(normalize(camera.right), x) + dot(normalize(camera.up), y),
                3, 1e-14);
    int wrong = 0;
    for (int j = 0; j < scene.settings.height; ++j) {
        for (int i = 0; i < scene.settings.width; ++i) {
            const double sx = (i + 0.5 - scene.settings.width * 0.5) / scene.settings.width;
            const double sy = (scene.settings.height * 0.5 - (j + 0.5)) / scene.settings.height;
            Vec3 d = camera.forward + (camera.right * sx + camera.up * sy);
            d = d / std::sqrt(dot(d, d));
            const Color want = recursion.seen(camera.position, d, 0, {1, 1, 1}, 0),
                        got = pixel(result->image, i, j);
            for (double Color::*c : {&Color::r, &Color::g, &Color::b}) {
                wrong += !(std::fabs(want.*c - got.*c) <= 3e-7 * (1 + std::fabs(want.*c)));
            }
        }
    }
    EXPECT_EQ(wrong, 0) << "channels of " << 3 * scene.settings.width * scene.settings.height;
    EXPECT_EQ(result->rays.camera + result->rays.mirror, recursion.rays());
}

TEST(Mirrors, TheSumEqualsTheRecursionForEveryRule) {
    Random random(81);
    for (const bool closed : {false, true}) {
        Scene scene = hall_of_mirrors(random, closed);
        for (const int reflections : {0, 1, 3, 64}) {
            for (const MirrorRule mirror : {MirrorRule::blend, MirrorRule::add}) {
                for (const LimitRule limit : {LimitRule::keep, LimitRule::drop}) {
                    for (const MissRule miss : {MissRule::background, MissRule::black}) {
                        for (const double min_weight : {0.0, 0.05}) {
                            SCOPED_TRACE(std::to_string(reflections) + " reflections, rules " +
                                         std::to_string(static_cast<int>(mirror)) +
                                         std::to_string(static_cast<int>(limit)) +
                                         std::to_string(static_cast<int>(miss)) + ", min_weight " +
                                         std::to_string(min_weight));
                            scene.settings.reflections = reflections;
                            scene.conventions.mirror = mirror;
                            scene.conventions.limit = limit;
                            scene.conventions.mirror_miss = miss;
                            scene.conventions.min_weight = min_weight;
                            expect_recursion(scene, make_world(scene));
                            if (HasFailure()) return;
                        }
                    }
                }
            }
        }
    }
}

TEST(Mirrors, TwoFacingMirrorsAreAGeometricSeries) {
    // Between two equal plane mirrors all generations have the same local color. The pixel is
    // local (1 - a) (1 + a + a^2 + ...) + a^N local.
    for (const int n : {0, 1, 3, 64, 1000}) {
        for (const LimitRule limit : {LimitRule::keep, LimitRule::drop}) {
            for (const MirrorRule rule : {MirrorRule::blend, MirrorRule::add}) {
                Scene scene;
                set_size(scene, 33, 33);
                scene.settings.reflections = n;
                scene.conventions.limit = limit;
                scene.conventions.mirror = rule;
                scene.camera.look_at = {0.02, 0.03, -1};
                scene.camera.fov_degrees = 0.5;
                scene.lights = {ambient_light({1, 1, 1})};
                Material m;
                m.ambient = {0.75, 0.5, 0.25};
                m.mirror = 0.9;
                const auto material = add_material(scene, m);
                scene.add(Plane{{0, 0, -1}, {0, 0, 1}}, material);
                scene.add(Plane{{0, 0, 1}, {0, 0, 1}}, material);
                const double a = 0.9;
                double own = 0, weight = 1;
                for (int i = 0; i < n; ++i, weight *= a)
                    own += weight * (rule == MirrorRule::blend ? 1 - a : 1.0);
                own += weight * (rule == MirrorRule::blend && limit == LimitRule::drop ? 1 - a : 1.0);
                const double first =
                    rule == MirrorRule::blend && (n > 0 || limit == LimitRule::drop) ? 1 - a : 1.0;
                expect_picture(
                    render_scene(scene),
                    [&](int, int) {
                        Layers layers;
                        layers.ambient = m.ambient * first;
                        layers.reflected = m.ambient * (own - first);
                        return layers;
                    },
                    2);
            }
        }
    }
}

TEST(Mirrors, UnlitShadingModesTraceNoMirrorRays) {
    Random random(82);
    Scene scene = hall_of_mirrors(random, true);
    for (const Shading shading : {Shading::color, Shading::normals}) {
        scene.settings.shading = shading;
        const Result<Rendering> result = render(*make_world(scene));
        EXPECT_EQ(result->rays.mirror, 0u);
        EXPECT_EQ(result->rays.shadow, 0u);
        EXPECT_EQ(result->rays.camera, 24u * 20u);
    }
}

}  // namespace
}  // namespace glint::test
