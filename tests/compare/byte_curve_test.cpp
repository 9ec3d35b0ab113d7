// SPDX-License-Identifier: Apache-2.0
// ByteCurve computes few values of a curve, and gives the bytes of all of them.
#include "compare/byte_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/picture_faults.h"
#include "math/elementary.h"
#include "math/srgb.h"

namespace glint::test {
namespace {

TEST(ByteCurve, IsTheCurveAtEveryValue) {
    using Curve = std::function<double(double)>;
    const Curve curves[] = {[](double v) { return 1 - v; }, srgb_encode, srgb_decode,
                            [](double v) { return pow(v, 2.2); },
                            [](double v) { return pow(v, 1 / (2.2 * 2.2)); }};
    constexpr int k_values = 100000;
    for (const Curve& curve : curves) {
        int computed = 0;
        const ByteCurve bytes([&](double v) {
            ++computed;
            return curve(v);
        });
        const int at_first = computed;
        for (int i = 0; i <= k_values; ++i) {
            const double v = static_cast<double>(i) / k_values;
            ASSERT_EQ(int{bytes(v)}, int{to_byte(curve(v))}) << v;
        }
        EXPECT_LT(computed - at_first, k_values / 10);
        EXPECT_EQ(int{bytes(-1)}, int{to_byte(curve(0))});
        EXPECT_EQ(int{bytes(2)}, int{to_byte(curve(1))});
        const double nan = std::numeric_limits<double>::quiet_NaN();
        EXPECT_EQ(int{bytes(nan)}, int{to_byte(curve(nan))});
    }
}

}  // namespace
}  // namespace glint::test
