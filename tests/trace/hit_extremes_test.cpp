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
/// times `scale`. The rays of a bundle are parallel, or not.
struct Grazing {
    Scene scene;
    Rays rays;
    std::vector<Vec3> at;  // on outlines, edges and vertices, without `scale`

    Grazing(Random& random, int shapes, int bundles, double scale, double distance, double length,
            bool parallel) {
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
        for (int b = 0; b < bundles; ++b)
            parallel ? add_parallel(random, scale, distance, length)
                     : add_bundle(random, scale, distance, length);
    }

  private:
    Vec3 target(Random& random) const {
        return at[static_cast<std::size_t>(below(random, static_cast<int>(at.size())))];
    }
    void add_bundle(Random& random, double scale, double distance, double length) {
        const bool one_origin = chance(random, 0.5), starts = chance(random, 0.3);
        Vec3 o = unit_direction(random) * distance;
        const Vec3 middle = target(random);
        for (int i = 0; i < 24; ++i) {
            Vec3 to = target(random);
            if (i % 3 == 0) to = middle + unit_direction(random) * log_uniform(random, 1e-9, 1e-1);
            if (!one_origin) o = o + point_in_cube(random, 1e-3 * distance);
            const Vec3 d = to - o;
            const double far = std::sqrt(dot(d, d));
            // t at the target, times nearly 1 or less
            const double t_min = starts ? far * random.uniform(0, 1.01) * scale / length : 0;
            rays.push(o * scale, d * (length / far), t_min);
        }
    }
    /// Parallel rays, some of which start near the shapes or behind them. In some bundles t_min differs, or
    /// is negative for some rays, or some rays end near a target.
    void add_parallel(Random& random, double scale, double distance, double length) {
        const Vec3 d = chance(random, 0.2) ? axis_direction(random) : unit_direction(random);
        const double unit = scale / length;  // of t
        const bool starts = chance(random, 0.5), negative = chance(random, 0.2), ends = chance(random, 0.2);
        const int count = 8 + below(random, 90);
        for (int i = 0; i < count; ++i) {
            const double before = chance(random, 0.5) ? distance : log_uniform(random, 1e-9, 1);
            const Vec3 o = target(random) - d * (chance(random, 0.8) ? before : -before);
            const Vec3 aside = unit_direction(random) * log_uniform(random, 1e-12, 1e-1);
            double t_min = 0, t_max = std::numeric_limits<double>::infinity();
            if (starts) t_min = log_uniform(random, 1e-9, 30) * unit;
            if (negative && chance(random, 0.2)) t_min = -log_uniform(random, 1e-9, 30) * unit;
            if (ends && chance(random, 0.2)) t_max = (before + random.uniform(-1, 1)) * unit;
            rays.push((o + aside) * scale, d * length, t_min, t_max);
        }
    }
};

void expect_grazing(std::uint64_t seed, double scale, double distance, double length, bool parallel = false) {
    SCOPED_TRACE(::testing::Message()
                 << "scale " << scale << ", from " << distance << ", directions of " << length);
    Random random(seed);
    const Grazing g(random, 60, 60, scale, distance, length, parallel);
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

TEST(HitExtremes, ParallelRays) {
    std::uint64_t seed = 350;
    for (const double scale : {1e-22, 1e-20, 1e-19, 1e-15, 1e-5, 1.0, 1e5}) {
        for (const double distance : {1.0, 1e3, 1e7}) expect_grazing(seed++, scale, distance, 1, true);
    }
    for (const double length : {1e-20, 1e-5, 1e5, 1e20}) expect_grazing(seed++, 1, 20, length, true);
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
    const double infinity = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
    const double ends[] = {-infinity, -1e300, -1e38, -20, -1,   -1e-300, -0.0,    0,
                           1e-300,    1,      5,     20,  1e38, 1e300,   infinity};
    for (int b = 0; b < 200; ++b) {
        const Vec3 o = point_in_cube(random, 12), d = unit_direction(random);
        for (int i = 0; i < 20; ++i) {
            const double from = chance(random, 0.1) ? nan : ends[below(random, 14)];
            rays.push(o + point_in_cube(random, 0.1), d + point_in_cube(random, 0.02), from,
                      ends[below(random, 15)]);
        }
    }
    EXPECT_GT(expect_brute_force(*world, rays), 100);
}

}  // namespace
}  // namespace glint::test
