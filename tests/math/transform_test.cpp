// SPDX-License-Identifier: Apache-2.0
#include "math/transform.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/ulp.h"

namespace glint::test {
namespace {

using test::Random;

Vec3 random_vector(Random& random, double size) {
    const double x = random.uniform(-size, size), y = random.uniform(-size, size);
    return {x, y, random.uniform(-size, size)};
}

Affine random_map(Random& random) {
    const auto angle = [&random] { return random.uniform(-360, 360); };
    const auto factor = [&random] { return std::exp(random.uniform(-3, 3)); };
    Affine map = rotation_y(angle());
    map = compose(scaling({factor(), -factor(), factor()}), map);
    map = compose(rotation_x(angle()), map);
    map = compose(rotation_z(angle()), map);
    return compose(translation(random_vector(random, 10)), map);
}

void expect_near(Vec3 a, Vec3 b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Vec3, LengthAndDirection) {
    EXPECT_EQ(length({3, 4, 12}), 13);
    EXPECT_EQ(length({0, 0, 0}), 0);
    EXPECT_EQ(length({0, -5e-324, 0}), 5e-324);
    EXPECT_NEAR(length({3e200, 4e200, 0}) / 5e200, 1, 1e-15);
    EXPECT_NEAR(length({3e-200, 4e-200, 0}) / 5e-200, 1, 1e-15);
    EXPECT_EQ(normalize({0, 0, 0}), (Vec3{0, 0, 0}));
    EXPECT_EQ(normalize({0, -7, 0}), (Vec3{0, -1, 0}));
    EXPECT_EQ(normalize({0, 0, 5e-324}), (Vec3{0, 0, 1}));
    expect_near(normalize({3e300, 0, -4e300}), {0.6, 0, -0.8}, 1e-15);
    expect_near(normalize({3e-310, 0, -4e-310}), {0.6, 0, -0.8}, 1e-12);
    Random random(1);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 v = random_vector(random, 1000);
        EXPECT_NEAR(length(normalize(v)), 1, 4.5e-16);
        EXPECT_EQ(
            length(v),
            std::sqrt(dot(v, v)));  // scaling by powers of two does not change the bits of ordinary vectors
    }
}

TEST(Affine, QuarterTurnsAreExactAndRightHanded) {
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    EXPECT_EQ(transform_vector(rotation_x(90), y), z);
    EXPECT_EQ(transform_vector(rotation_y(90), z), x);
    EXPECT_EQ(transform_vector(rotation_z(90), x), y);
    EXPECT_EQ(transform_vector(rotation_z(-450), x), -y);
    EXPECT_EQ(rotation_x(720), Affine{});
}

TEST(Affine, TheInnerMapComesFirst) {
    const Affine map = compose(translation({10, 0, 0}), compose(rotation_z(90), scaling({2, 3, 4})));
    EXPECT_EQ(transform_point(map, {1, 1, 1}), (Vec3{7, 2, 4}));
    EXPECT_EQ(transform_vector(map, {1, 1, 1}), (Vec3{-3, 2, 4}));
}

TEST(Affine, InverseUndoesTheMap) {
    Random random(2);
    for (int i = 0; i < 10000; ++i) {
        const Affine map = random_map(random);
        const auto back = inverse(map);
        ASSERT_TRUE(back);
        const Vec3 p = random_vector(random, 10);
        expect_near(transform_point(*back, transform_point(map, p)), p, 1e-11);
        expect_near(transform_point(compose(map, *back), p), p, 1e-11);
    }
}

TEST(Affine, InverseDetectsSingularMaps) {
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(inverse(scaling({1, 0, 1})));
    EXPECT_FALSE(inverse(scaling({0, 0, 0})));
    EXPECT_FALSE(inverse(scaling({1, inf, 1})));
    EXPECT_FALSE(inverse(scaling({1, std::numeric_limits<double>::quiet_NaN(), 1})));
    EXPECT_FALSE(inverse(scaling({1e-308, 1e-308, 1e-308})));
    EXPECT_FALSE(inverse(scaling({1e200, 1e200, 1e200})));
    // Rank 2, with a determinant that rounding makes 6.7e-16.
    EXPECT_FALSE(inverse({{{0.1, 0.2, 0.3, 0}, {0.4, 0.5, 0.6, 0}, {0.7, 0.8, 0.9, 0}}}));
    // Small, flat and sheared, but not singular.
    EXPECT_TRUE(inverse(scaling({1e-90, 1e-90, 1e-90})));
    EXPECT_TRUE(inverse(compose(rotation_x(33), scaling({1, 1e-20, 1}))));
    EXPECT_TRUE(inverse(compose(scaling({1, 1e-20, 1}), rotation_x(33))));
    EXPECT_TRUE(inverse({{{1, 1e12, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}}));
}

TEST(Affine, NormalsStayPerpendicularAndOnTheirSide) {
    Random random(3);
    for (int i = 0; i < 10000; ++i) {
        const Affine world_from_object = random_map(random);
        const Affine object_from_world = *inverse(world_from_object);
        const Vec3 tangent = random_vector(random, 1), outward = random_vector(random, 1);
        const Vec3 normal = cross(tangent, random_vector(random, 1));
        const Vec3 turned = transform_normal(object_from_world, normal);
        EXPECT_NEAR(dot(turned, transform_vector(world_from_object, tangent)), 0, 1e-11);
        EXPECT_NEAR(dot(turned, transform_vector(world_from_object, outward)), dot(normal, outward), 1e-11);
    }
}

}  // namespace
}  // namespace glint::test
