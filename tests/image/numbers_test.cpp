// SPDX-License-Identifier: Apache-2.0
// The conversion of floats to the numbers of a file.
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>

#include "glint/image.h"
#include "image/quantize.h"

namespace glint::test {
namespace {

constexpr float k_inf = std::numeric_limits<float>::infinity();
constexpr float k_nan = std::numeric_limits<float>::quiet_NaN();

TEST(ToByte, ClampsAndMapsNanToZero) {
    for (const Transfer t : {Transfer::none, Transfer::srgb}) {
        EXPECT_EQ(to_byte(k_nan, t), 0);
        EXPECT_EQ(to_byte(-k_nan, t), 0);
        EXPECT_EQ(to_byte(k_inf, t), 255);
        EXPECT_EQ(to_byte(-k_inf, t), 0);
        EXPECT_EQ(to_byte(-0.0f, t), 0);
        EXPECT_EQ(to_byte(-1e-30f, t), 0);
        EXPECT_EQ(to_byte(std::numeric_limits<float>::denorm_min(), t), 0);
        EXPECT_EQ(to_byte(1.0f, t), 255);
        EXPECT_EQ(to_byte(std::nextafter(1.0f, 2.0f), t), 255);
        EXPECT_EQ(to_byte(3e38f, t), 255);
    }
}

TEST(ToByte, RoundsHalfToEven) {
    // 0.5 * 255 = 127.5 and 0.25 * 65535 = 16383.75 are exact.
    EXPECT_EQ(to_byte(0.5f), 128);
    EXPECT_EQ(to_byte(std::nextafter(0.5f, 0.0f)), 127);
    EXPECT_EQ(quantize(0.5, 65535), 32768u);
    for (int k = 0; k < 255; ++k) {  // ties that a double can express, with a scale of 256
        EXPECT_EQ(quantize((k + 0.5) / 256, 256), static_cast<std::uint32_t>(k % 2 == 0 ? k : k + 1)) << k;
    }
}

TEST(ToByte, IsTheNearestForEveryFloatNearATie) {
    for (int k = 0; k < 255; ++k) {
        float v = static_cast<float>((k + 0.5) / 255);
        for (int i = 0; i < 20; ++i) v = std::nextafter(v, 0.0f);
        for (int i = 0; i < 40; ++i, v = std::nextafter(v, 1.0f)) {
            const long double exact = static_cast<long double>(v) * 255;
            ASSERT_EQ(to_byte(v), static_cast<int>(std::nearbyint(exact))) << v;
        }
    }
}

TEST(ToByte, DoesNotDependOnTheRoundingMode) {
    for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
        for (const float v : {0.1f, 0.5f, 0.49803922f, 0.7f, 0.99803f}) {
            const int expected = to_byte(v);
            std::fesetround(mode);
            const int found = to_byte(v);
            std::fesetround(FE_TONEAREST);
            EXPECT_EQ(found, expected) << v << " mode " << mode;
        }
    }
}

TEST(Srgb, IsTheStandardCurve) {
    for (int i = 1; i <= 20000; ++i) {
        const double x = i / 20000.0;
        const long double exact =
            x <= 0.0031308 ? 12.92L * x : 1.055L * std::pow(static_cast<long double>(x), 1 / 2.4L) - 0.055L;
        ASSERT_NEAR(srgb_encode(x), static_cast<double>(exact), 1e-15) << x;
    }
    EXPECT_EQ(to_byte(0.5f, Transfer::srgb), 188);
    EXPECT_EQ(to_byte(0.2158605f, Transfer::srgb), 128);
}

TEST(Srgb, IsMonotone) {
    double before = 0;
    for (int i = 0; i <= 300000; ++i) {
        const double now = srgb_encode(i / 300000.0);
        ASSERT_GE(now, before) << i;
        before = now;
    }
}

}  // namespace
}  // namespace glint::test
