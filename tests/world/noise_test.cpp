// SPDX-License-Identifier: Apache-2.0
// Noise and the patterns made of it: their ranges, their smoothness, and what moves them.
#include "world/appearance/noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/ulp.h"
#include "world/appearance/texture.h"

namespace glint::test {
namespace {

TEST(Noise, IsZeroAtWholePointsAndFarAway) {
    for (const Vec3 p : {Vec3{0, 0, 0}, Vec3{3, -7, 12}, Vec3{-1e6, 4, 2}}) EXPECT_EQ(gradient_noise(p), 0);
    for (const double far : {1e12, -3e9, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(gradient_noise({far, 0.5, 0.5}), 0);
        EXPECT_EQ(gradient_noise({0.5, 0.5, far}), 0);
    }
    EXPECT_NE(gradient_noise({2147483646.5, 0.3, 0.5}), 0);
}

TEST(Noise, IsWithinOneAndHasNoMean) {
    Random random(71);
    double sum = 0, square = 0, least = 0, most = 0, product = 0;
    constexpr int k_count = 100'000;
    for (int i = 0; i < k_count; ++i) {
        const Vec3 p{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50)};
        const double x = gradient_noise(p);
        sum += x, square += x * x;
        product += x * gradient_noise(p, 1);
        least = std::min(least, x), most = std::max(most, x);
    }
    EXPECT_GE(least, -1);
    EXPECT_LE(most, 1);
    EXPECT_LT(least, -0.7);
    EXPECT_GT(most, 0.7);
    const double deviation = std::sqrt(square / k_count);
    EXPECT_GT(deviation, 0.2);
    EXPECT_LT(std::fabs(sum / k_count), 6 * deviation / std::sqrt(k_count / 10.0));
    EXPECT_LT(std::fabs(product / square), 0.05) << "series do not depend on each other";
}

// Of class C2: no seams between cells.
TEST(Noise, IsSmooth) {
    Random random(72);
    for (int i = 0; i < 2000; ++i) {
        Vec3 p{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
        if (i % 2 == 0) p.x = std::floor(p.x);  // a seam
        constexpr double k_step = 1e-5;
        const double before = gradient_noise(p - Vec3{k_step, 0, 0}), at = gradient_noise(p),
                     after = gradient_noise(p + Vec3{k_step, 0, 0});
        EXPECT_LT(std::fabs(after - at), 4 * k_step);
        EXPECT_LT(std::fabs(after - 2 * at + before), 60 * k_step * k_step);
    }
}

TEST(Noise, PatternsAreFromZeroToBelowOne) {
    Random random(73);
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 p{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-5, 5)};
        for (const double u : {noise_pattern(p), granite(p), wrinkles(p)}) {
            EXPECT_GE(u, 0);
            EXPECT_LT(u, 1);
        }
    }
}

TEST(Noise, TurbulenceMovesThePoint) {
    Texture texture;
    texture.mapping = TextureMapping::planar;
    const Vec3 p{0.3, 0.6, -1.7};
    EXPECT_EQ(place_on(texture, p).u, 0.3);
    texture.turbulence = {0.5, 0, 0};
    texture.octaves = 1;
    const Vec3 d{gradient_noise(p, 1), gradient_noise(p, 2), gradient_noise(p, 3)};
    EXPECT_EQ(place_on(texture, p).u, 0.3 + 0.5 * d.x);
    EXPECT_EQ(place_on(texture, p).v, 0.6);
    texture.octaves = 2;
    texture.gain = 0.25;
    texture.lacunarity = 3;
    EXPECT_EQ(noise_displacement(texture, p).y, d.y + gradient_noise(p * 3, 2) * 0.25);
    texture.octaves = 1.5;
    EXPECT_EQ(noise_displacement(texture, p).y, d.y + gradient_noise(p * 3, 2) * 0.125);
    texture.octaves = 0;
    EXPECT_EQ(noise_displacement(texture, p), Vec3{});
}

}  // namespace
}  // namespace glint::test
