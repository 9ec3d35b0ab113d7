// SPDX-License-Identifier: Apache-2.0
// The conversion of floats to the numbers of a file.
#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <limits>

#include "glint/image.h"
#include "image/quantize.h"
#include "math/srgb.h"

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

TEST(ToByte, FollowsTheRule) {
    const ByteRule up{.rounding = Rounding::half_up}, down{.rounding = Rounding::down};
    EXPECT_EQ(to_byte(0.5f, up), 128);
    EXPECT_EQ(to_byte(1.5f / 255, up), 2);
    EXPECT_EQ(to_byte(std::nextafter(0.5f, 0.0f), up), 127);
    EXPECT_EQ(to_byte(std::nextafter(1.0f, 0.0f), down), 254);
    EXPECT_EQ(to_byte(1.0f, down), 255);
    EXPECT_EQ(to_number(0.5f, 16, down), 32767u);
    for (int k = 0; k < 100000; ++k) {
        const float v = static_cast<float>(k) / 90000;
        const long double exact = std::min(static_cast<long double>(v), 1.0L) * 255;
        ASSERT_EQ(to_byte(v, down), static_cast<int>(std::floor(exact))) << v;
        ASSERT_EQ(to_byte(v, up), static_cast<int>(std::floor(exact + 0.5L))) << v;
    }
    // POV-Ray's bytes of rgb <.5, .25, .75>, measured.
    const auto bytes = [](double gamma) {
        const ByteRule rule{Transfer::srgb, gamma, Rounding::half_up};
        return std::array{int{to_byte(0.5f, rule)}, int{to_byte(0.25f, rule)}, int{to_byte(0.75f, rule)}};
    };
    EXPECT_EQ(bytes(1), (std::array{188, 137, 225}));
    EXPECT_EQ(bytes(2), (std::array{137, 71, 198}));
    EXPECT_EQ(bytes(2.2), (std::array{128, 61, 193}));
    for (const float v : {k_nan, -1.0f, 0.0f}) EXPECT_EQ(to_byte(v, ByteRule{Transfer::srgb, 2.2}), 0);
    EXPECT_EQ(to_byte(k_inf, ByteRule{Transfer::none, 0.1, Rounding::down}), 255);
}

TEST(ToByte, IsUnchangedInAPictureAsWritten) {
    const Image image{2, 1, {0.1f, 0.5f, 0.9f, 2, -1, k_nan}};
    EXPECT_TRUE(std::isnan(as_written(image, {}).rgb[5])) << "the default rule changes nothing";
    const ByteRule rule{Transfer::srgb, 2, Rounding::down};
    const Image written = as_written(image, rule);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(to_byte(written.rgb[i]), to_byte(image.rgb[i], rule)) << i;
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
