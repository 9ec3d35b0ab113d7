// SPDX-License-Identifier: Apache-2.0
// The hit rule at the limits of single precision: grazing rays, tiny and huge scenes, short directions.
#include <gtest/gtest.h>

#include <bit>

#include "trace/hit_rule.h"
#include "trace/worlds.h"

namespace glint::test {
namespace {

/// Every instruction set and packet size gives the bits of the brute force. Returns the number of hits.
int expect_brute_force(const World& world, const Rays& rays) {
    const Hits expected = brute_hits(world, rays);
    int hit = 0;
    for (const std::uint32_t slot : expected.slot) hit += slot != k_none;
    for (const Kernels& kernels : available_kernels()) {
        for (const int packet : {1, 8, 13, 64}) {
            const Hits got = nearest_hits(kernels, world, rays, packet);
            const auto occluded = any_hits(kernels, world, rays, packet);
            int wrong = 0, wrong_any = 0;
            for (std::size_t i = 0; i < got.t.size(); ++i) {
                wrong +=
                    std::bit_cast<std::uint64_t>(expected.t[i]) != std::bit_cast<std::uint64_t>(got.t[i]) ||
                    expected.slot[i] != got.slot[i];
                wrong_any += (occluded[i] != 0) != (expected.slot[i] != k_none);
            }
            EXPECT_EQ(wrong, 0) << kernels.isa << ", packets of " << packet << ", of " << rays.size()
                                << " rays";
            EXPECT_EQ(wrong_any, 0) << kernels.isa << ", packets of " << packet << ", any hit";
        }
    }
    return hit;
}

/// Spheres, cylinders, cones and triangles, and bundles of rays at their outlines, edges and vertices, all
/// times `scale`.
struct Grazing {
    Scene scene;
    Rays rays;

    Grazing(Random& random, int shapes, int bundles, double scale, double distance, double length) {
        std::vector<Vec3> at;
        for (int i = 0; i < shapes; ++i) {
            const Vec3 c = point_in_cube(random, 10);
            if (i % 2 == 0) {
                const double r = log_uniform(random, 0.01, 3);
                scene.add(Sphere{c * scale, r * scale});
                for (int k = 0; k < 4; ++k) at.push_back(c + unit_direction(random) * r);
                continue;
            }
            const double r = log_uniform(random, 0.01, 10);
            if (i % 4 == 1) {
                const Vec3 along = unit_direction(random), aside = perpendicular(random, along);
                const double height = log_uniform(random, 0.1, 30), end = r * random.uniform(0, 1);
                const Vec3 to = c + along * height;
                const bool capped = chance(random, 0.5);
                if (chance(random, 0.5)) {
                    scene.add(Cylinder{c * scale, to * scale, r * scale, capped});
                    at.push_back(c + along * (height * random.uniform(0, 1)) + aside * r);
                    at.push_back(to + aside * r);
                } else {
                    scene.add(Cone{c * scale, to * scale, r * scale, end * scale, capped});
                    at.push_back(c + aside * r);
                    at.push_back(to + aside * end);
                }
                continue;
            }
            const Vec3 v[3] = {c, c + unit_direction(random) * r, c + unit_direction(random) * r};
            scene.add(Triangle{{v[0] * scale, v[1] * scale, v[2] * scale}});
            for (int k = 0; k < 3; ++k) {
                at.push_back(v[k]);
                at.push_back(v[k] + (v[(k + 1) % 3] - v[k]) * random.uniform(0, 1));
            }
        }
        for (int b = 0; b < bundles; ++b) {
            const bool one_origin = chance(random, 0.5);
            Vec3 o = unit_direction(random) * distance;
            const Vec3 middle = at[static_cast<std::size_t>(below(random, static_cast<int>(at.size())))];
            for (int i = 0; i < 24; ++i) {
                Vec3 to = at[static_cast<std::size_t>(below(random, static_cast<int>(at.size())))];
                if (i % 3 == 0) to = middle + unit_direction(random) * log_uniform(random, 1e-9, 1e-1);
                if (!one_origin) o = o + point_in_cube(random, 1e-3 * distance);
                const Vec3 d = to - o;
                rays.push(o * scale, d * (length / std::sqrt(dot(d, d))));
            }
        }
    }
};

void expect_grazing(std::uint64_t seed, double scale, double distance, double length) {
    SCOPED_TRACE(::testing::Message()
                 << "scale " << scale << ", from " << distance << ", directions of " << length);
    Random random(seed);
    const Grazing g(random, 60, 60, scale, distance, length);
    const std::optional<World> world = make_world(g.scene);
    ASSERT_TRUE(world);
    const int hit = expect_brute_force(*world, g.rays);
    // Shorter directions intersect few boxes: their components count as at least 1e-30.
    if (length > 1e-27) {
        EXPECT_GT(hit, 100);
    }
}

TEST(HitExtremes, GrazingRaysFromNearAndFar) {
    std::uint64_t seed = 100;
    for (const double distance : {20.0, 1e3, 1e5, 1e7}) {
        for (int i = 0; i < 3; ++i) expect_grazing(seed++, 1, distance, 1);
    }
}

TEST(HitExtremes, TinyAndHugeScenes) {
    std::uint64_t seed = 200;
    for (const double scale : {1e-26, 1e-24, 1e-22, 1e-20, 1e-19, 1e-18, 1e-15, 1e-10, 1e5, 1e10})
        expect_grazing(seed++, scale, 30, 1);
}

TEST(HitExtremes, ShortAndLongDirections) {
    std::uint64_t seed = 300;
    for (const double length : {1e-33, 1e-30, 1e-29, 1e-28, 1e-25, 1e-20, 1e20, 1e30, 1e36})
        expect_grazing(seed++, 1, 30, length);
}

TEST(HitExtremes, DirectionsWithVeryDifferentComponents) {
    Random random(400);
    Scene scene;
    for (int i = 0; i < 200; ++i) {
        const Vec3 c = point_in_cube(random, 5);
        if (i % 2 == 0)
            scene.add(Sphere{c, 0.5});
        else
            scene.add(Triangle{{c, c + unit_direction(random), c + unit_direction(random)}});
    }
    const std::optional<World> world = make_world(scene);
    for (const double length : {1e-27, 1e-20, 1.0, 1e20}) {
        SCOPED_TRACE(length);
        Rays rays;
        for (int b = 0; b < 100; ++b) {
            const Vec3 o = point_in_cube(random, 8);
            double d[3];
            for (double& c : d)
                c = chance(random, 0.3) ? 0 : log_uniform(random, 1e-9, 1) * (chance(random, 0.5) ? 1 : -1);
            d[below(random, 3)] = 1;
            const Vec3 way = Vec3{d[0], d[1], d[2]} * length;
            for (int i = 0; i < 12; ++i)
                rays.push(o + point_in_cube(random, 0.3), way * random.uniform(0.9, 1.1));
        }
        EXPECT_GT(expect_brute_force(*world, rays), 100);
    }
}

TEST(HitExtremes, NegativeEmptyAndUndefinedRanges) {
    Random random(500);
    const Scene scene = random_scene(random, 300);
    const std::optional<World> world = make_world(scene);
    Rays rays;
    const double infinity = std::numeric_limits<double>::infinity();
    const double ends[] = {-infinity, -1e300, -1e38, -20, -1,   -1e-300, -0.0,    0,
                           1e-300,    1,      5,     20,  1e38, 1e300,   infinity};
    for (int b = 0; b < 200; ++b) {
        const Vec3 o = point_in_cube(random, 12), d = unit_direction(random);
        for (int i = 0; i < 20; ++i) {
            rays.push(o + point_in_cube(random, 0.1), d + point_in_cube(random, 0.02),
                      ends[below(random, 14)], ends[below(random, 15)]);
        }
    }
    EXPECT_GT(expect_brute_force(*world, rays), 100);
}

}  // namespace
}  // namespace glint::test
