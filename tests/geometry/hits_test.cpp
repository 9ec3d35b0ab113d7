// SPDX-License-Identifier: Apache-2.0
// Each shape's formula is compared with its long double instantiation, and with the definition of the
// shape.
#include <gtest/gtest.h>

#include <vector>

#include "geometry/shape_cases.h"

namespace glint::test {
namespace {

template <class ShapeCase> class Hits : public ::testing::Test {};
using ShapeCases =
    ::testing::Types<SphereCase, PlaneCase, CylinderCase<false>, CylinderCase<true>, EllipsoidCase,
                     ConeCase<false>, ConeCase<true>, DiscCase, BoxCase, TriangleCase, TorusCase>;
TYPED_TEST_SUITE(Hits, ShapeCases);

struct TestRay {
    Vec3 origin, direction;
};

/// Rays to a shape of about `size` at `at`: from outside, inside, far away, tangent, along the axes, at its
/// edge.
TestRay random_ray(Random& random, Vec3 at, double size) {
    const Vec3 d = chance(random, 0.2) ? axis_direction(random) : unit_direction(random);
    const Vec3 aside = perpendicular(random, d);
    // Many close to the silhouette.
    const double miss = chance(random, 0.3) ? 1 + std::ldexp(random.uniform(-1, 1), -below(random, 40))
                                            : random.uniform(0, 1.3);
    const double away =
        chance(random, 0.25) ? random.uniform(0, 1) * size : log_uniform(random, size, size + 1e6);
    return {at + aside * (miss * size) - d * away, d * log_uniform(random, 1e-3, 1e3)};
}

TYPED_TEST(Hits, AreOnTheSurfaceAndAgreeWithLongDouble) {
    using Geometry = typename TypeParam::Geometry;
    Random random(21);
    double worst = 0, worst_normal = 0;
    int hits = 0, unsure = 0;
    constexpr int cases = 200000;
    for (int i = 0; i < cases; ++i) {
        const double size =
            chance(random, 0.5) ? (chance(random, 0.5) ? 1e-6 : 1) : log_uniform(random, 1e-6, 1e6);
        const Vec3 at = point_in_cube(random, chance(random, 0.5) ? size : log_uniform(random, 1e-3, 1e3));
        const TypeParam shape_case = TypeParam::make(random, at, size);
        double p[Geometry::k_values];
        shape_case.pack(p);
        const auto [o, d] = random_ray(random, at, size);
        const auto got = formula_hit<Geometry, double>(p, o, d, 0);
        const auto exact = formula_hit<Geometry, Long>(p, o, d, 0);
        const double magnitude = length(o) + shape_case.magnitude() + (got.valid ? got.t * length(d) : 0);
        // Where a surface is strongly curved (a cone near its apex), the roots of a grazing ray are less
        // accurate.
        const auto sure = [size](const Nearness& near) {
            return near.bend < Long(size) ? static_cast<double>(near.bend) / size : 1.0;
        };
        const Long tolerance = 8 * k_epsilon * magnitude;
        if (got.valid) {
            ++hits;
            ASSERT_TRUE(got.t > 0 && got.t < 1e300) << "case " << i;
            const LongVec point = to_long(o) + to_long(d) * Long(got.t);
            const Nearness near = shape_case.nearness(point);
            const auto off =
                static_cast<double>(std::fabs(near.distance) / (k_epsilon * magnitude)) * sure(near);
            worst = std::max(worst, off);
            ASSERT_LT(off, 8) << "case " << i << ": off the surface";

            const Packed<Geometry, double> packed(p);
            const Vec3 found = to_vec(triple_of<double>(o) + triple_of<double>(d) * got.t);
            const Vec3 n = to_vec(Geometry::normal(packed.data(), triple_of<double>(found)));
            EXPECT_NEAR(dot(n, n), 1, 8 * k_epsilon) << "case " << i;
            // The normal's uncertainty for a point with rounding errors, on a shape of this size.
            const Long off_unit = plain::length(to_long(n) - near.outward);
            const double allowed =
                64 * k_epsilon * (1 + magnitude / static_cast<double>(std::min<Long>(near.bend, size)));
            if (static_cast<double>(off_unit) > allowed && !std::is_same_v<Geometry, plain::SphereGeometry>) {
                // At a rim both normals are right, if the point is on both surfaces.
                const Long step = 1e3 * tolerance;
                const Nearness there = shape_case.nearness(point + to_long(n) * step);
                ASSERT_NEAR(static_cast<double>(there.distance / step), 1, 0.01)
                    << "case " << i << ": normal";
            } else {
                worst_normal = std::max(worst_normal, static_cast<double>(off_unit) / allowed);
                ASSERT_LT(static_cast<double>(off_unit), allowed) << "case " << i << ": normal";
            }
        }
        if (got.valid != exact.valid) {
            // Only if rounding decides: the ray passes the silhouette or an edge, or starts on the surface.
            ++unsure;
            const Long t = got.valid ? Long(got.t) : exact.t;
            const LongVec point = to_long(o) + to_long(d) * t;
            const Nearness near = shape_case.nearness(point);
            EXPECT_LT(std::fabs(near.distance) * Long(sure(near)), tolerance) << "case " << i;
        }
    }
    EXPECT_GT(hits, cases / 10);
    EXPECT_LT(unsure, cases / 50);
    this->RecordProperty("worst_off_surface_eps", std::to_string(worst));
    std::printf(
        "    hits %d, decided by rounding %d, off the surface by at most %.2f eps, normal %.2f of what is "
        "allowed\n",
        hits, unsure, worst, worst_normal);
}

TYPED_TEST(Hits, NoIntersectionIsMissed) {
    // Along a ray, inside and outside change only at hits.
    if constexpr (TypeParam::k_solid) {
        using Geometry = typename TypeParam::Geometry;
        Random random(22);
        int crossings = 0;
        for (int i = 0; i < 30000; ++i) {
            const double size = log_uniform(random, 1e-6, 1e6);
            const Vec3 at = point_in_cube(random, size);
            const TypeParam shape_case = TypeParam::make(random, at, size);
            double p[Geometry::k_values];
            shape_case.pack(p);
            const auto ray = random_ray(random, at, size);
            const Vec3 o = ray.origin, d = ray.direction;
            const double magnitude = length(o) + shape_case.magnitude();
            const auto first = formula_hit<Geometry, double>(p, o, d, 0);
            const double end = first.valid ? first.t : 3 * magnitude / length(d);
            const auto side = [&](double t) {
                return shape_case.nearness(to_long(o) + to_long(d) * Long(t)).distance;
            };
            const Long tolerance = 32 * k_epsilon * (magnitude + end * length(d));
            const Long start = side(0);
            if (std::fabs(start) < tolerance) continue;
            for (int k = 1; k < 16; ++k) {
                const Long here = side(end * k / 16);
                if (std::fabs(here) < tolerance) continue;
                ASSERT_EQ(here > 0, start > 0) << "case " << i << ", " << k << "/16 of the way";
            }
            if (!first.valid) continue;
            // The next hit from there must be another one.
            const auto second = formula_hit<Geometry, double>(p, o, d, first.t);
            if (second.valid) {
                EXPECT_GT(second.t, first.t);
                ++crossings;
                const double middle = first.t + (second.t - first.t) * 0.5;
                if (std::fabs(side(middle)) > tolerance) {
                    ASSERT_NE(side(middle) > 0, start > 0) << "case " << i;
                }
            }
        }
        if (!std::is_same_v<TypeParam, PlaneCase>) {
            EXPECT_GT(crossings, 3000);
        }
    }
}

TYPED_TEST(Hits, InvalidRaysMiss) {
    using Geometry = typename TypeParam::Geometry;
    Random random(23);
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
    const double values[] = {nan, infinity, -infinity, 0, -0.0, 1, 1e300, -1e300, 1e-320, 1e154};
    for (int i = 0; i < 200000; ++i) {
        const TypeParam shape_case = TypeParam::make(random, {0, 0, 0}, 1);
        double p[Geometry::k_values];
        shape_case.pack(p);
        const auto value = [&] { return values[below(random, 10)]; };
        const Vec3 o{value(), value(), value()}, d{value(), value(), value()};
        const auto c = formula_hit<Geometry, double>(p, o, d, 0);
        if (!c.valid) continue;
        ASSERT_TRUE(c.t > 0 && c.t < infinity) << "case " << i << ": t " << c.t;
    }
}

TEST(CylinderHits, AlongTheAxisAndThroughTheRim) {
    for (const bool caps : {false, true}) {
        double p[plain::CylinderGeometry::k_values];
        plain::CylinderGeometry::pack({{0, 0, 0}, {0, 0, 2}, 1, caps}, p);
        const auto hit = [&](Vec3 o, Vec3 d, double t_min = 0.0) {
            return formula_hit<plain::CylinderGeometry, double>(p, o, d, t_min);
        };
        // Parallel to the axis, inside and outside: only the caps.
        EXPECT_EQ(hit({0, 0, -3}, {0, 0, 1}).valid, caps);
        EXPECT_EQ(hit({0.5, 0, -3}, {0, -0.0, 1}).valid, caps);
        if (caps) {
            EXPECT_EQ(hit({0.5, 0, -3}, {0, 0, 2}).t, 1.5);
            EXPECT_EQ(hit({0.5, 0, 5}, {0, 0, -1}).t, 3);
            EXPECT_EQ(hit({0.5, 0, 1}, {0, 0, 1}).t, 1);
            EXPECT_EQ(hit({0.5, 0, -3}, {0, 0, 1}, 3).t, 5);
        }
        EXPECT_FALSE(hit({1.5, 0, -3}, {0, 0, 1}).valid);
        EXPECT_FALSE(hit({0, 0, 3}, {0, 0, 1}).valid);
        // Perpendicular to it: the ends are part of it.
        EXPECT_EQ(hit({-3, 0, 0}, {1, 0, 0}).t, 2);
        EXPECT_EQ(hit({-3, 0, 2}, {1, 0, 0}).t, 2);
        EXPECT_FALSE(hit({-3, 0, 2.0000001}, {1, 0, 0}).valid);
        // From inside, and the far side.
        EXPECT_EQ(hit({0, 0, 1}, {1, 0, 0}).t, 1);
        EXPECT_EQ(hit({-3, 0, 1}, {1, 0, 0}, 2.5).t, 4);
        // Through the open end to the inside of the far side; through the cap first, if there is one.
        EXPECT_EQ(hit({-1, 0, 3}, {1, 0, -1}).t, caps ? 1 : 2);
        // Tangent.
        EXPECT_EQ(hit({-3, 1, 1}, {1, 0, 0}).t, 3);
        EXPECT_FALSE(hit({-3, 1.0000001, 1}, {1, 0, 0}).valid);
    }
}

TEST(TriangleHits, AMeshHasNoGaps) {
    // Rays through the vertices and edges of an uneven square, which its neighbours close.
    Random random(24);
    constexpr int n = 12;
    for (const double size : {1e-4, 1.0, 1e4}) {
        const Vec3 middle = point_in_cube(random, 300);
        Vec3 v[n + 1][n + 1];
        for (int y = 0; y <= n; ++y) {
            for (int x = 0; x <= n; ++x) {
                v[y][x] = middle + Vec3{x + random.uniform(-0.3, 0.3), y + random.uniform(-0.3, 0.3),
                                        random.uniform(-0.3, 0.3)} *
                                       size;
            }
        }
        std::vector<Triangle> mesh;
        for (int y = 0; y < n; ++y) {
            for (int x = 0; x < n; ++x) {
                mesh.push_back({{v[y][x], v[y][x + 1], v[y + 1][x]}});
                mesh.push_back({{v[y + 1][x], v[y][x + 1], v[y + 1][x + 1]}});
            }
        }
        for (int i = 0; i < 3000; ++i) {
            const int x = 1 + below(random, n - 2), y = 1 + below(random, n - 2);
            const Vec3 others[3] = {v[y][x + 1], v[y + 1][x], v[y + 1][x - 1]};
            const double along = chance(random, 0.3) ? 0 : chance(random, 0.5) ? 0.5 : random.uniform(0, 1);
            const Vec3 to = v[y][x] * (1 - along) + others[below(random, 3)] * along;
            const Vec3 from = to + Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 2} *
                                       (size * log_uniform(random, 0.5, 1e3));
            int hits = 0;
            for (const Triangle& triangle : mesh) {
                double p[9];
                plain::TriangleGeometry::pack(triangle, p);
                hits += formula_hit<plain::TriangleGeometry, double>(p, from, to - from, 0).valid;
            }
            ASSERT_GE(hits, 1) << "size " << size << ", ray " << i;
        }
    }
}

TEST(SmoothTriangleHits, NormalsAreInterpolated) {
    const SmoothTriangle t{{{0, 0, 1}, {4, 0, 1}, {0, 2, 1}}, {{0, 0, 3}, {1, 0, 0}, {0, -1, 0}}};
    double p[plain::SmoothTriangleGeometry::k_values];
    plain::SmoothTriangleGeometry::pack(t, p);
    const auto normal = [&](Vec3 at) {
        return to_vec(plain::SmoothTriangleGeometry::normal(p, triple_of<double>(at)));
    };
    EXPECT_EQ(normal({0, 0, 1}), (Vec3{0, 0, 1}));
    EXPECT_EQ(normal({4, 0, 1}), (Vec3{1, 0, 0}));
    EXPECT_EQ(normal({0, 2, 1}), (Vec3{0, -1, 0}));
    const Vec3 middle = normal({2, 1, 1});  // half way from the second to the third
    EXPECT_NEAR(middle.x, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(middle.y, -std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(middle.z, 0, 1e-15);
    const Vec3 half = normal({2, 0, 1});
    EXPECT_NEAR(half.x, std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(half.z, std::sqrt(0.5), 1e-15);
}

TEST(PlaneHits, RaysInThePlaneMiss) {
    double p[plain::PlaneGeometry::k_values];
    plain::PlaneGeometry::pack({{0, 1, 0}, {0, 5, 0}}, p);
    const auto hit = [&](Vec3 o, Vec3 d) { return formula_hit<plain::PlaneGeometry, double>(p, o, d, 0); };
    EXPECT_FALSE(hit({0, 1, 0}, {1, 0, 0}).valid);
    EXPECT_FALSE(hit({0, 2, 0}, {1, -0.0, 0}).valid);
    EXPECT_FALSE(hit({0, 2, 0}, {1, 1e-310, 0}).valid);
    EXPECT_FALSE(hit({0, 2, 0}, {0, 1, 0}).valid);
    EXPECT_EQ(hit({7, 3, 0}, {0, -2, 0}).t, 1);
    EXPECT_EQ(hit({7, -3, 0}, {0, 2, 5}).t, 2);
}

}  // namespace
}  // namespace glint::test
