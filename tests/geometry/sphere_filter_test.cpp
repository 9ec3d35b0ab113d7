// The sphere's filter in single precision never rejects what double hits.
#include <gtest/gtest.h>

#include <vector>

#include "geometry/random_values.h"
#include "glint/shapes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/sphere_filter_test.cpp"
#include <hwy/foreach_target.h>

#include "geometry/sphere-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

// columns: center, radius, origin, direction. may[i] = what the filter says; count is a multiple of 16.
void filter_lanes(const std::vector<float>* columns, std::size_t count, std::uint8_t* may) {
    for (std::size_t i = 0; i < count; i += lane_count<float>()) {
        Floats v[10];
        for (int c = 0; c < 10; ++c) v[c] = load(columns[c].data() + i);
        const Ray<Floats> ray{{v[4], v[5], v[6]}, {v[7], v[8], v[9]}};
        const std::uint32_t bits = to_bits(SphereGeometry::may_hit(v, ray));
        for (int k = 0; k < lane_count<float>(); ++k) may[i + k] = bits >> k & 1;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {
HWY_EXPORT(filter_lanes);
namespace testing {
namespace {

namespace plain = HWY_NAMESPACE;

#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr int k_blocks = 10000;
#else
constexpr int k_blocks = 500;
#endif
constexpr std::size_t k_block = 1024;  // 10 million cases in all

struct Case {
    Sphere sphere;
    Vec3 origin, direction;
};

// Half of the rays pass the sphere at r (1 +- 2^-k); half of the others start at its surface.
Case random_case(Random& random) {
    Case c;
    c.sphere.radius = log_uniform(random, 1e-6, 1e6);
    const double reach = chance(random, 0.5) ? c.sphere.radius : log_uniform(random, 1e-3, 1e6);
    c.sphere.center = point_in_cube(random, reach);
    const Vec3 d = chance(random, 0.2) ? axis_direction(random) : unit_direction(random);
    const Vec3 aside = perpendicular(random, d);
    double closest = c.sphere.radius;
    if (chance(random, 0.5)) {
        closest *= 1 + std::ldexp(chance(random, 0.7) ? -1.0 : 1.0, -3 - below(random, 50));
    } else {
        closest *= random.uniform(0, 1.1);
    }
    const double along = chance(random, 0.2) ? 0 : log_uniform(random, 1e-3 * c.sphere.radius, 1e6);
    c.origin = c.sphere.center + aside * closest - d * along;
    c.direction = d * log_uniform(random, 1e-3, 1e3);
    return c;
}

TEST(SphereFilter, NeverRejectsWhatDoubleHits) {
    Random random(41);
    std::vector<float> columns[10];
    for (auto& c : columns) c.resize(k_block);
    std::vector<Case> cases(k_block);
    std::vector<std::uint8_t> may(k_block);
    long long hits = 0, rejected = 0, total = 0;
    for (int block = 0; block < k_blocks; ++block) {
        for (std::size_t i = 0; i < k_block; ++i) {
            const Case c = cases[i] = random_case(random);
            const double values[10] = {
                c.sphere.center.x, c.sphere.center.y, c.sphere.center.z, c.sphere.radius, c.origin.x,
                c.origin.y,        c.origin.z,        c.direction.x,     c.direction.y,   c.direction.z};
            for (int k = 0; k < 10; ++k) columns[k][i] = static_cast<float>(values[k]);
        }
        HWY_DYNAMIC_DISPATCH(filter_lanes)(columns, k_block, may.data());
        for (std::size_t i = 0; i < k_block; ++i) {
            float p[4];
            for (int k = 0; k < 4; ++k) p[k] = columns[k][i];
            const plain::Ray<float> ray{{columns[4][i], columns[5][i], columns[6][i]},
                                        {columns[7][i], columns[8][i], columns[9][i]}};
            ASSERT_EQ(plain::SphereGeometry::may_hit(p, ray), may[i] != 0) << "lanes and float differ";
            double exact[4];
            plain::SphereGeometry::pack(cases[i].sphere, exact);
            const Vec3 o = cases[i].origin, d = cases[i].direction;
            const bool hit = plain::SphereGeometry::hit(
                                 exact, plain::Ray<double>{{o.x, o.y, o.z}, {d.x, d.y, d.z}}, -1e300)
                                 .hit;
            ++total;
            hits += hit;
            rejected += !may[i];
            ASSERT_TRUE(may[i] || !hit) << "block " << block << " case " << i << ": a hit was filtered away";
        }
    }
    EXPECT_GT(hits, total / 4);
    EXPECT_GT(rejected, total / 50);  // and it does reject
}

TEST(SphereFilter, RejectsMostOfWhatMisses) {
    // Rays past a unit sphere at twice its radius, from within 100 of it: that is what it is for.
    Random random(42);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 d = unit_direction(random), c = point_in_cube(random, 100);
        const Vec3 o = c + perpendicular(random, d) * 2 - d * random.uniform(-100, 100);
        const auto f = [](double x) { return static_cast<float>(x); };
        const float p[4] = {f(c.x), f(c.y), f(c.z), 1};
        const plain::Ray<float> ray{{f(o.x), f(o.y), f(o.z)}, {f(d.x), f(d.y), f(d.z)}};
        ASSERT_FALSE(plain::SphereGeometry::may_hit(p, ray));
    }
}

}  // namespace
}  // namespace testing
}  // namespace glint
#endif
