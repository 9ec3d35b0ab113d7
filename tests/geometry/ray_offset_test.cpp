// SPDX-License-Identifier: Apache-2.0
// Rays that start at a surface: their origins by each convention, and that with glint's they never hit the
// same surface again.
#include "geometry/ray_offset-inl.h"

#include <gtest/gtest.h>

#include "geometry/shape_cases.h"

namespace glint::test {
namespace {

using Point = plain::SurfacePoint<double>;

TEST(RayOffset, EachConventionByItsDefinition) {
    const Point s{{1, 2, 3}, {0, 1, 0}, {3, -4, 0}, 10};
    const plain::Vector3<double> out{0, 3, 4}, in{0, -3, 4};
    const auto at = [&](const Point& p, plain::Vector3<double> d, Offset offset, double e) {
        return to_vec(plain::spawn_ray(p, d, offset, e).origin);
    };
    EXPECT_EQ(at(s, out, Offset::ray, 0.5), (Vec3{1, 2, 3}));
    EXPECT_EQ(at(s, out, Offset::normal, 0.5), (Vec3{1, 2.5, 3}));
    EXPECT_EQ(at(s, in, Offset::normal, 0.5), (Vec3{1, 2.5, 3}));
    EXPECT_EQ(at(s, in, Offset::facing, 0.5), (Vec3{1, 2.5, 3}));
    Point behind = s;
    behind.incoming = {3, 4, 0};
    EXPECT_EQ(at(behind, out, Offset::facing, 0.5), (Vec3{1, 1.5, 3}));
    EXPECT_EQ(at(s, out, Offset::direction, 0.5), (Vec3{1, 2.3, 3.4}));
    EXPECT_EQ(at(s, out, Offset::scale, 0.01), (Vec3{1, 2.1, 3}));
    EXPECT_EQ(at(s, in, Offset::scale, 0.01), (Vec3{1, 1.9, 3}));
    EXPECT_EQ(plain::spawn_ray(s, out, Offset::ray, 0.5).t_min, 0.5);
    for (const Offset o : {Offset::normal, Offset::facing, Offset::direction, Offset::scale}) {
        EXPECT_EQ(plain::spawn_ray(s, out, o, 0.5).t_min, 0);
        EXPECT_EQ(at(s, out, o, 0), (Vec3{1, 2, 3}));
    }
}

template <class ShapeCase> class Reintersect : public ::testing::Test {};
using ShapeCases =
    ::testing::Types<SphereCase, PlaneCase, CylinderCase<false>, CylinderCase<true>, EllipsoidCase,
                     ConeCase<false>, ConeCase<true>, DiscCase, BoxCase, TriangleCase, TorusCase>;
TYPED_TEST_SUITE(Reintersect, ShapeCases);

TYPED_TEST(Reintersect, NeverUnderGlintsConvention) {
    using Geometry = typename TypeParam::Geometry;
    const Conventions glint;
    Random random(31);
    int left = 0, outside = 0, again = 0, first_case = -1;
    constexpr int cases = 100000;
    for (int i = 0; left < cases; ++i) {
        ASSERT_LT(i, 20 * cases);
        const double size = log_uniform(random, 1e-6, 1e6);
        // Near the world's origin, far from it, or (a ground of a large radius) with its surface near the
        // origin.
        Vec3 at = point_in_cube(random, chance(random, 0.5) ? size : log_uniform(random, 1e-3, 1e3));
        if (chance(random, 0.2)) at = unit_direction(random) * size;
        const Vec3 to = at + point_in_cube(random, size);
        Vec3 o = chance(random, 0.2) ? at + point_in_cube(random, 0.5 * size)
                                     : to + unit_direction(random) * log_uniform(random, 1e-3 * size, 1e6);
        Vec3 d = normalize(to - o);
        if (chance(random, 0.1)) {
            // All numbers are small, except the shape's centre: cancellation of large numbers.
            const double near = log_uniform(random, 1e-3, 1);
            at = unit_direction(random) * size;
            o = at * (-near / size);
            d = normalize(normalize(at) + unit_direction(random) * 0.5);
        }
        const TypeParam shape_case = TypeParam::make(random, at, size);
        double p[Geometry::k_values];
        shape_case.pack(p);
        const auto hit = formula_hit<Geometry, double>(p, o, d, 0);
        if (!hit.valid) continue;
        // The same as in trace/surface/surface-inl.h.
        const plain::Vector3<double> point = triple_of<double>(o) + triple_of<double>(d) * hit.t;
        plain::Vector3<double> normal = Geometry::normal(p, point);
        if (plain::dot(normal, triple_of<double>(d)) > 0) normal = -normal;
        const Point surface{
            point, normal, triple_of<double>(d),
            plain::max_abs(triple_of<double>(o)) + plain::max_abs(point) + shape_case.max_coordinate()};
        const Vec3 n = to_vec(normal);
        // Arbitrary directions, many of them grazing.
        Vec3 out = unit_direction(random);
        if (chance(random, 0.3))
            out = perpendicular(random, n) + n * std::ldexp(random.uniform(-1, 1), -below(random, 50));
        const auto spawned = plain::spawn_ray(surface, triple_of<double>(out), glint);
        const auto next = formula_hit<Geometry, double>(p, to_vec(spawned.origin), out, spawned.t_min);
        ++left;
        const double reach = glint.epsilon * surface.magnitude;
        const Nearness near = shape_case.nearness(to_long(to_vec(point)));
        const LongVec outward = near.outward;
        // At a cone's apex, within the rounding of its points, no normal is correct.
        if (static_cast<double>(near.bend) < 1e-9 * surface.magnitude && near.bend < 1e-3L * Long(size))
            continue;
        // A ray along the surface is on the side that the normal shows.
        const bool outwards = (plain::dot(to_long(n), outward) > 0) == (dot(n, out) >= 0);
        bool wrong = false;
        outside += outwards ? 1 : 0;
        if (outwards && TypeParam::k_convex) {
            wrong = next.valid;
        } else if (next.valid) {
            // Inside, or across a hole, the other side is a chord away; the same surface must not be hit next
            // to the point.
            const LongVec there =
                shape_case.nearness(to_long(to_vec(spawned.origin)) + to_long(out) * Long(next.t)).outward;
            wrong = next.t * length(out) < 100 * reach && std::fabs(dot(n, out)) > 1e-2 &&
                    reach < 1e-4 * static_cast<double>(std::min<Long>(near.bend, size)) &&
                    plain::dot(there, outward) > 0.5L;
        }
        if (wrong) {
            ++again;
            if (first_case < 0) {
                first_case = i;
                ADD_FAILURE() << std::hexfloat << "case " << i << ": size " << size << ", from (" << o.x
                              << ", " << o.y << ", " << o.z << "), reach " << reach << ", found again at "
                              << next.t;
            }
        }
    }
    EXPECT_GT(outside, cases / 3);
    EXPECT_EQ(again, 0) << "of " << cases << ", first in case " << first_case;
}

}  // namespace
}  // namespace glint::test
