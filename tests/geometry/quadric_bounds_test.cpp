// SPDX-License-Identifier: Apache-2.0
// The boxes of ellipsoids, beside those of spheres that are mapped.
#include "math/quadric_bounds.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/quadric-inl.h"
#include "math/ulp.h"

namespace glint::test {
namespace {

// The ellipsoid that the map makes of the sphere of radius 1.
Quadric mapped_sphere(const Affine& map) {
    const Quadric sphere{{1, 1, 1}, {}, {}, -1};
    return HWY_NAMESPACE::QuadricGeometry::apply_transform(sphere, map, *inverse(map));
}

constexpr Vec3 k_axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// Where a line is inside.
HWY_NAMESPACE::Crossing<double> crossing(const Quadric& quadric, Vec3 o, Vec3 d) {
    double p[HWY_NAMESPACE::QuadricGeometry::k_values];
    HWY_NAMESPACE::QuadricGeometry::pack(quadric, p);
    HWY_NAMESPACE::Crossing<double> found[2];
    HWY_NAMESPACE::QuadricGeometry::crossings(p, HWY_NAMESPACE::Ray<double>{{o.x, o.y, o.z}, {d.x, d.y, d.z}},
                                              found);
    return found[0];
}

TEST(QuadricBounds, AreThoseOfMappedSpheres) {
    Random random(5);
    int lines = 0;
    for (int i = 0; i < 2000; ++i) {
        Affine map;
        for (auto& row : map.m)
            for (double& x : row) x = random.uniform(-2, 2) * (i % 7 == 0 ? 1e-3 : 1);
        const bool is_far = i % 5 == 0;
        for (auto& row : map.m) row[3] *= is_far ? 100 : 1;
        if (!inverse(map)) continue;
        Vec3 lo, hi;
        const Quadric quadric = mapped_sphere(map);
        quadric_bounds(quadric, lo, hi);
        if (lo.x == -k_endless) continue;  // nearly flat
        const double low[] = {lo.x, lo.y, lo.z}, high[] = {hi.x, hi.y, hi.z};
        for (int a = 0; a < 3; ++a) {
            const double* const m = map.m[a];
            const double reach = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
            // The coefficients of a far and thin one do not tell its size.
            if (!is_far) {
                EXPECT_NEAR(low[a], m[3] - reach, 1e-3 * reach);
                EXPECT_NEAR(high[a], m[3] + reach, 1e-3 * reach);
            }
            // Lines beside the farthest point.
            for (const double nearer : {1e-3, 1e-5, 1e-7, 1e-9}) {
                const double part = (1 - nearer) / reach;
                const Vec3 o = transform_point(map, {m[0] * part, m[1] * part, m[2] * part});
                const auto [enter, exit] = crossing(quadric, o, k_axes[a]);
                if (!(enter <= exit)) continue;
                ++lines;
                const double at = a == 0 ? o.x : a == 1 ? o.y : o.z;
                EXPECT_GE(at + enter, low[a]);
                EXPECT_LE(at + exit, high[a]);
            }
        }
    }
    EXPECT_GT(lines, 10000);
}

TEST(QuadricBounds, FewEllipsoidsHaveNone) {
    Random random(6);
    int endless = 0;
    for (int i = 0; i < 1000; ++i) {
        Affine map;
        for (auto& row : map.m)
            for (double& x : row) x = random.uniform(-2, 2);
        Vec3 lo, hi;
        quadric_bounds(mapped_sphere(map), lo, hi);
        endless += lo.x == -k_endless ? 1 : 0;
    }
    EXPECT_LT(endless, 30);
}

TEST(QuadricBounds, OthersHaveNoEnds) {
    for (const Quadric& q : {Quadric{{1, 1, -1}, {}, {}, -1}, Quadric{{1, 1, 0}, {}, {0, 0, 1}, 0},
                             Quadric{{1, 1, 1}, {3, 0, 0}, {}, -1}, Quadric{{-1, -1, -1}, {}, {}, 1},
                             Quadric{{0, 0, 0}, {}, {1, 0, 0}, 0}}) {
        Vec3 lo, hi;
        quadric_bounds(q, lo, hi);
        EXPECT_EQ(lo.z, -k_endless);
        EXPECT_EQ(hi.y, k_endless);
    }
    Vec3 lo, hi;
    quadric_bounds({{1, 4, 1}, {}, {-2, 0, 0}, 2}, lo, hi);  // empty: around its middle
    EXPECT_NEAR(lo.x, 1, 1e-6);
    EXPECT_NEAR(hi.y, 0, 1e-6);
}

}  // namespace
}  // namespace glint::test
