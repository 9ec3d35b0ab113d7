// SPDX-License-Identifier: Apache-2.0
// The torus beside roots that were computed to 400 bits, on its axis, and where it intersects itself.
#include <gtest/gtest.h>

#include "geometry/shape_cases.h"
#include "geometry/torus_roots.h"

namespace glint::test {
namespace {

using Geometry = plain::TorusGeometry;

struct PackedTorus {
    double p[Geometry::k_values];
    explicit PackedTorus(const Torus& torus) { Geometry::pack(torus, p); }
    plain::Hit<double> hit(Vec3 o, Vec3 d, double t_min = 0) const {
        return formula_hit<Geometry, double>(p, o, d, t_min);
    }
    Vec3 normal(Vec3 at) const { return to_vec(Geometry::normal(p, triple_of<double>(at))); }
};

/// The distance of a point from the surface, also of a torus that intersects itself.
Long distance_from(const Torus& torus, LongVec point) {
    const LongVec axis = plain::normalize(to_long(torus.axis)), q = point - to_long(torus.center);
    const Long y = plain::dot(q, axis), rho = plain::length(q - axis * y);
    const auto off = [&](Long center) {
        return std::fabs(plain::sqrt((rho - center) * (rho - center) + y * y) - Long(torus.tube));
    };
    return std::min(off(torus.radius), off(-torus.radius));
}

TEST(TorusHits, AgreeWithRootsOf400Bits) {
    double worst_off = 0, worst_t = 0;
    int hits = 0, misses = 0;
    for (const TorusRoot& c : k_torus_roots) {
        const plain::Hit<double> got = PackedTorus(c.torus).hit(c.origin, c.direction);
        const auto number = &c - k_torus_roots;
        ASSERT_EQ(got.valid, c.t > 0) << "case " << number;
        if (!got.valid) {
            ++misses;
            continue;
        }
        ++hits;
        const double magnitude = length(c.origin) + length(c.torus.center) + c.torus.radius + c.torus.tube;
        const LongVec point = to_long(c.origin) + to_long(c.direction) * Long(got.t);
        const auto off = static_cast<double>(distance_from(c.torus, point)) / (k_epsilon * magnitude);
        worst_off = std::max(worst_off, off);
        EXPECT_LT(off, 2) << "case " << number;
        // Along the ray, as far as the angle to the surface decides.
        const Vec3 n = PackedTorus(c.torus).normal(c.origin + c.direction * c.t);
        const double error =
            std::fabs(got.t - c.t) * std::fabs(dot(n, c.direction)) / (k_epsilon * magnitude);
        worst_t = std::max(worst_t, error);
        EXPECT_LT(error, 4) << "case " << number;
    }
    EXPECT_GT(hits, 100);
    EXPECT_GT(misses, 20);
    std::printf("    %d hits, %d misses, off the surface by at most %.2f eps, t by %.2f\n", hits, misses,
                worst_off, worst_t);
}

TEST(TorusHits, AlongTheAxesAndTangent) {
    const PackedTorus torus({{0, 1, 0}, {0, 3, 0}, 2, 0.5});
    EXPECT_FALSE(torus.hit({0, 5, 0}, {0, -1, 0}).valid) << "through the hole";
    EXPECT_EQ(torus.hit({2, 5, 0}, {0, -1, 0}).t, 3.5);
    EXPECT_EQ(torus.hit({2, 5, 0}, {0, -1, 0}, 3.75).t, 4.5);
    EXPECT_FALSE(torus.hit({2, 5, 0}, {0, -1, 0}, 4.5).valid);
    // Across the hole: four roots.
    double t = 0;
    for (const double expected : {2.5, 3.5, 6.5, 7.5}) {
        const auto hit = torus.hit({-5, 1, 0}, {1, 0, 0}, t);
        ASSERT_TRUE(hit.valid);
        EXPECT_NEAR(hit.t, expected, 1e-15 * 8);
        t = hit.t;
    }
    EXPECT_FALSE(torus.hit({-5, 1, 0}, {1, 0, 0}, t).valid);
    // From within the tube, and from the hole.
    EXPECT_NEAR(torus.hit({2, 1, 0}, {0, 0, 1}).t, 1.5, 1e-15);
    EXPECT_NEAR(torus.hit({0, 1, 0}, {0, 0, 1}).t, 1.5, 1e-15);
    // In the plane that touches it along a circle, and beside that.
    EXPECT_TRUE(torus.hit({-5, 1.4999999, 0}, {1, 0, 0}).valid);
    EXPECT_FALSE(torus.hit({-5, 1.5000001, 0}, {1, 0, 0}).valid);
    // Beside its outermost and its innermost circle.
    EXPECT_TRUE(torus.hit({-5, 1, 2.4999999}, {1, 0, 0}).valid);
    EXPECT_FALSE(torus.hit({-5, 1, 2.5000001}, {1, 0, 0}).valid);
    EXPECT_FALSE(torus.hit({1.4999999, 5, 0}, {0, -1, 0}).valid);
    EXPECT_TRUE(torus.hit({1.5000001, 5, 0}, {0, -1, 0}).valid);
    EXPECT_EQ(torus.normal({2.5, 1, 0}), (Vec3{1, 0, 0}));
    EXPECT_EQ(torus.normal({1.5, 1, 0}), (Vec3{-1, 0, 0}));
    EXPECT_EQ(torus.normal({0, 1.5, 2}), (Vec3{0, 1, 0}));
}

TEST(TorusHits, ThatIntersectsItself) {
    const PackedTorus torus({{0, 0, 0}, {0, 1, 0}, 3, 5});
    // Along the axis, the surface meets itself at y = 4 and -4.
    const auto tip = torus.hit({0, 9, 0}, {0, -1, 0});
    ASSERT_TRUE(tip.valid);
    EXPECT_NEAR(tip.t, 5, 1e-7);
    EXPECT_EQ(torus.normal({0, 4, 0}), (Vec3{0, 1, 0}));
    EXPECT_EQ(torus.normal({0, -4, 0}), (Vec3{0, -1, 0}));
    // Across: the outer surface at -8 and 8, the inner one at -2 and 2.
    double t = 0;
    for (const double expected : {2, 8, 12, 18}) {
        const auto hit = torus.hit({-10, 0, 0}, {1, 0, 0}, t);
        ASSERT_TRUE(hit.valid);
        EXPECT_NEAR(hit.t, expected, 2e-14);
        t = hit.t;
    }
    EXPECT_FALSE(torus.hit({-10, 0, 0}, {1, 0, 0}, t).valid);
    EXPECT_EQ(torus.normal({8, 0, 0}), (Vec3{1, 0, 0}));
    EXPECT_EQ(torus.normal({2, 0, 0}), (Vec3{-1, 0, 0})) << "into the space that counts as outside";
}

// Tubes of a millionth of the radius, from far away: a polynomial's coefficients would lose them.
TEST(TorusHits, ThinTubesFromFarAway) {
    Random random(25);
    int hits = 0;
    for (int i = 0; i < 20000; ++i) {
        const Torus shape{{0, 0, 0}, {0, 1, 0}, 1, log_uniform(random, 1e-6, 1e-2)};
        const PackedTorus torus(shape);
        const Vec3 out = perpendicular(random, {0, 1, 0}), d = unit_direction(random);
        // To a point of the tube, from up to 1e6 radii away; across the tube or beside it.
        const double miss = random.uniform(0, 1.5), away = log_uniform(random, 2, 1e6);
        const Vec3 along = normalize(cross({0, 1, 0}, out)), aside = cross(along, d);
        if (length(aside) < 0.1) continue;
        const Vec3 o = out + aside * (miss * shape.tube / length(aside)) - d * away;
        const auto hit = torus.hit(o, d, away - 0.5);
        const auto exact = formula_hit<Geometry, Long>(torus.p, o, d, away - 0.5);
        const double magnitude = away + 1;
        if (hit.valid) {
            ++hits;
            const LongVec point = to_long(o) + to_long(d) * Long(hit.t);
            ASSERT_LT(static_cast<double>(distance_from(shape, point)), 2 * k_epsilon * magnitude)
                << "case " << i;
        }
        // The tube is a few rounding errors wide at the greatest distances.
        if (std::fabs(miss - 1) * shape.tube > 1e-3 * shape.tube + 8 * k_epsilon * magnitude) {
            ASSERT_EQ(hit.valid, exact.valid) << "case " << i;
            if (miss < 1) {
                ASSERT_TRUE(hit.valid) << "case " << i;
            }
        }
    }
    EXPECT_GT(hits, 10000);
}

}  // namespace
}  // namespace glint::test
