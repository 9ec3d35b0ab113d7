// SPDX-License-Identifier: Apache-2.0
// The elementary functions compared with the C library's long double, whose error is about 2^-63.
#include "math/elementary.h"

#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <limits>

#include "math/ulp.h"

namespace glint::test {
namespace {

using test::Random;
using test::ulps;
using test::WorstError;

constexpr double k_inf = std::numeric_limits<double>::infinity();
constexpr double k_pi = 3.14159265358979323846;

void report(const char* name, const WorstError& worst) {
    std::printf("%s: at most %.3f ulp over %lld points, at %a, %a\n", name, worst.ulp,
                static_cast<long long>(worst.points), worst.x, worst.y);
}

void add_pow(WorstError& worst, double x, double y) {
    const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(y));
    if (exact < 1.0000001L * DBL_MIN || exact > DBL_MAX) return;
    worst.add(ulps(pow(x, y), exact), x, y);
}

TEST(Pow, OfCosines) {
    Random random(1);
    WorstError worst;
    for (int i = 0; i < 700000; ++i) {
        const double x = random.uniform(0, 1);  // (arguments of a call have no order)
        add_pow(worst, x, std::exp(random.uniform(0, 13.8)));
        // Near the middle of a highlight, where large exponents matter.
        const double angle = std::exp(random.uniform(-18, 0));
        add_pow(worst, std::cos(angle), random.uniform(0, 1e6));
    }
    for (int n = 0; n <= 1000; ++n) {
        for (int i = 1; i <= 256; ++i) add_pow(worst, i / 256.0, n);
    }
    report("pow of cosines", worst);
    EXPECT_LT(worst.ulp, 0.68);
    EXPECT_GT(worst.points, 1000000);
}

TEST(Pow, OverTheWholeRange) {
    Random random(2);
    WorstError worst;
    for (int i = 0; i < 500000; ++i) {
        const double x = std::exp(random.uniform(-708.3, 709));
        add_pow(worst, x, random.uniform(-1, 1) * 709 / std::fabs(std::log(x)));
        const double near_one = 1 + random.uniform(-0.5, 0.5) * std::exp(random.uniform(-36, 0));
        if (near_one != 1)
            add_pow(worst, near_one, random.uniform(-1, 1) * 709 / std::fabs(std::log(near_one)));
        add_pow(worst, random.uniform(0, 1), 1 / 2.4);  // sRGB
    }
    report("pow of everything", worst);
    EXPECT_LT(worst.ulp, 0.68);
}

TEST(Pow, ExactAndSpecialValues) {
    EXPECT_EQ(pow(0.0, 0), 1);
    EXPECT_EQ(pow(-0.0, 0), 1);
    EXPECT_EQ(pow(0.0, 5), 0);
    EXPECT_EQ(pow(0.0, -5), k_inf);
    EXPECT_EQ(pow(-0.5, 2), 0);
    EXPECT_EQ(pow(-0.5, 0), 0);
    EXPECT_EQ(pow(0.25, 0), 1);
    EXPECT_EQ(pow(1e300, 0), 1);
    EXPECT_EQ(pow(1e300, 1e-300), 1);
    EXPECT_EQ(pow(4, 0.5), 2);
    EXPECT_EQ(pow(9, 0.5), 3);
    EXPECT_EQ(pow(0.5, 1), 0.5);
    EXPECT_EQ(pow(3, 5), 243);
    EXPECT_EQ(pow(7, -1), 1.0 / 7);
    for (double y : {-DBL_MAX, -1e300, -1e6, -3.5, 0.0, 1.0, 2.5, 1e6, 1e300, DBL_MAX})
        EXPECT_EQ(pow(1, y), 1) << y;
    for (int e = -1022; e <= 1023; ++e) EXPECT_EQ(pow(2, e), std::ldexp(1.0, e));
    Random random(3);
    for (int i = 0; i < 100000; ++i) {
        const double x = random.uniform(0, 4);
        ASSERT_EQ(pow(x, 1), x);
        const double half_length = static_cast<float>(x);
        ASSERT_EQ(pow(half_length, 2), half_length * half_length);
    }
}

TEST(Pow, OverflowAndUnderflow) {
    EXPECT_EQ(pow(2, 1024), k_inf);
    EXPECT_EQ(pow(2, 1023.999), std::pow(2.0, 1023.999));
    EXPECT_EQ(pow(1e300, 1e300), k_inf);
    EXPECT_EQ(pow(1e-300, -1e300), k_inf);
    EXPECT_EQ(pow(1.0000001, DBL_MAX), k_inf);
    EXPECT_EQ(pow(0.9999999, DBL_MAX), 0);
    EXPECT_EQ(pow(1e300, -1e300), 0);
    EXPECT_EQ(pow(0.5, 1022), DBL_MIN);
    EXPECT_EQ(pow(0.5, 1022.0000001), 0);  // below the least normal number: 0, never subnormal
    EXPECT_EQ(pow(0.5, 1023), 0);
    EXPECT_EQ(pow(0.5, 1e6), 0);
    EXPECT_EQ(pow(0.999, 1e6), 0);
    EXPECT_GT(pow(0.9999, 1e6), 0);
    EXPECT_EQ(pow(5e-324, 1), 0);
    EXPECT_EQ(pow(5e-324, 0), 1);
    EXPECT_EQ(pow(5e-324, -1), k_inf);
    EXPECT_EQ(pow(5e-324, 0.5), 0);  // subnormal numbers count as 0
    EXPECT_EQ(pow(DBL_MIN, 0.5), std::sqrt(DBL_MIN));
    EXPECT_EQ(pow(DBL_MIN, 1), DBL_MIN);
    EXPECT_EQ(pow(DBL_MAX, 1), DBL_MAX);
    EXPECT_EQ(pow(std::sqrt(DBL_MAX), 2.0000001), k_inf);
    EXPECT_EQ(pow(1 + DBL_EPSILON, -3.2e18), 0);  // 2^-1025
    EXPECT_GT(pow(1 + DBL_EPSILON, -3.1e18), 0);
    // Just around the limits, where hi + lo rounds to a whole number.
    for (double x : {0.3, 0.7, 0.99, 0.999999}) {
        double y = -1022 / std::log2(x);
        for (int i = 0; i < 20; ++i) y = std::nextafter(y, 0);
        for (int i = 0; i < 40; ++i, y = std::nextafter(y, 1e300)) {
            const long double exact = std::pow(static_cast<long double>(x), static_cast<long double>(y));
            ASSERT_EQ(pow(x, y) == 0, exact < DBL_MIN) << x << ' ' << y;
            ASSERT_TRUE(pow(x, y) == 0 || pow(x, y) >= DBL_MIN) << x << ' ' << y;
        }
    }
    // Over the whole range of underflow: never subnormal, and 0 exactly if the true value is below the
    // smallest normal number.
    for (int i = 0; i < 100000; ++i) {
        const double y = 1020 + i * 4e-5;
        const double result = pow(0.5, y);
        ASSERT_EQ(result == 0, y > 1022) << y;
        ASSERT_TRUE(result == 0 || result >= DBL_MIN) << y;
    }
}

TEST(Pow, IsMonotone) {
    Random random(4);
    for (int i = 0; i < 100000; ++i) {
        const double x = random.uniform(0.5, 1);
        const double n = std::exp(random.uniform(0, 9));
        const double step = 1e-12;
        ASSERT_LE(pow(x, n), pow(x * (1 + step), n)) << x << ' ' << n;
        ASSERT_GE(pow(x, n), pow(x, n * (1 + 1e-9))) << x << ' ' << n;
        ASSERT_LE(pow(x, n), 1);
    }
}

TEST(Exp, ErrorAndLimits) {
    Random random(5);
    WorstError worst;
    for (int i = 0; i < 700000; ++i) {
        for (double size : {708.39, 1.0}) {
            const double x = random.uniform(-size, size);
            worst.add(ulps(exp(x), std::exp(static_cast<long double>(x))), x);
        }
    }
    report("exp", worst);
    EXPECT_LT(worst.ulp, 0.68);
    EXPECT_EQ(exp(0), 1);
    EXPECT_EQ(exp(1e300), k_inf);
    EXPECT_EQ(exp(-1e300), 0);
    const double greatest = std::log(DBL_MAX);
    EXPECT_LT(exp(greatest), k_inf);
    EXPECT_EQ(exp(std::nextafter(greatest, 1000)), k_inf);
    const double least = -0x1.6232bdd7abcd2p+9;
    EXPECT_GE(exp(least), DBL_MIN);
    EXPECT_LT(std::exp(static_cast<long double>(std::nextafter(least, -1000))),
              static_cast<long double>(DBL_MIN));
    EXPECT_EQ(exp(std::nextafter(least, -1000)), 0);
}

TEST(Log, ErrorAndLimits) {
    Random random(6);
    WorstError worst;
    for (int i = 0; i < 500000; ++i) {
        const double near_one = 1 + random.uniform(-0.5, 0.5) * std::exp(random.uniform(-36, 0));
        for (double x : {std::exp(random.uniform(-708.3, 709)), random.uniform(0, 2), near_one}) {
            if (x == 1) continue;
            worst.add(ulps(log(x), std::log(static_cast<long double>(x))), x);
        }
    }
    report("log", worst);
    EXPECT_LT(worst.ulp, 0.51);
    EXPECT_EQ(log(1), 0);
    EXPECT_EQ(log(0), -k_inf);
    EXPECT_EQ(log(-1), -k_inf);
    EXPECT_EQ(log(5e-324), -k_inf);  // subnormal numbers count as 0
    EXPECT_EQ(log(DBL_MIN), std::log(DBL_MIN));
    EXPECT_EQ(log(DBL_MAX), std::log(DBL_MAX));
}

TEST(Exp, IsTheInverseOfLog) {
    Random random(7);
    for (int i = 0; i < 100000; ++i) {
        const double x = std::exp(random.uniform(-700, 700));
        // Half an ulp of a logarithm up to 700 is 2^-44 of x.
        ASSERT_NEAR(exp(log(x)) / x, 1, 0x1p-43);
        const double y = random.uniform(-700, 700);
        ASSERT_NEAR(log(exp(y)), y, std::fabs(y) * 0x1p-52 + 0x1p-52);
    }
}

class Angles : public ::testing::Test {
  protected:
    void add(double x) {
        const long double exact_sin = std::sin(static_cast<long double>(x));
        const long double exact_cos = std::cos(static_cast<long double>(x));
        if (x == 0) return;
        sin_.add(ulps(sin(x), exact_sin), x);
        cos_.add(ulps(cos(x), exact_cos), x);
        tan_.add(ulps(tan(x), exact_sin / exact_cos), x);
    }
    void check() {
        report("sin", sin_), report("cos", cos_), report("tan", tan_);
        EXPECT_LT(sin_.ulp, 0.81);
        EXPECT_LT(cos_.ulp, 0.81);
        EXPECT_LT(tan_.ulp, 0.95);
    }
    WorstError sin_, cos_, tan_;
};

TEST_F(Angles, Random) {
    Random random(8);
    for (int i = 0; i < 400000; ++i) {
        add(random.uniform(-7, 7));
        add(random.uniform(-1e5, 1e5));
        add(std::exp(random.uniform(-40, 11.5)));
    }
    check();
}

TEST_F(Angles, NearestToEveryMultipleOfAQuadrant) {
    for (int n = 1; n < 63661; ++n) {
        const double x =
            static_cast<double>(n * (static_cast<long double>(k_pi) + 1.2246467991473532e-16L) / 2);
        add(x);
        add(std::nextafter(x, 0));
        add(std::nextafter(x, 1e9));
    }
    check();
}

TEST(Degrees, ExactValues) {
    const double sines[] = {0, 0.5, 1, 0.5, 0, -0.5, -1, -0.5};  // of 0, 30, 90, 150, 180, 210, 270, 330
    const int angles[] = {0, 30, 90, 150, 180, 210, 270, 330};
    for (int turn = -1000; turn <= 1000; ++turn) {
        for (int i = 0; i < 8; ++i) {
            const double angle = angles[i] + 360.0 * turn;
            EXPECT_EQ(sin_degrees(angle), sines[i]) << angle;
            EXPECT_EQ(cos_degrees(90 - angle), sines[i]) << angle;
        }
        EXPECT_EQ(tan_degrees(180.0 * turn), 0);
        EXPECT_EQ(tan_degrees(180.0 * turn + 45), 1);
        EXPECT_EQ(tan_degrees(180.0 * turn - 45), -1);
        EXPECT_EQ(tan_degrees(180.0 * turn + 90), k_inf);
    }
}

TEST(Degrees, Error) {
    Random random(9);
    WorstError sines, cosines, tangents;
    const auto add = [&](double x) {
        if (std::fmod(x, 90) == 0) return;
        // Reduced exactly first: the long double pi is not accurate enough for large angles.
        int quadrant = 0;
        const double degrees = std::remquo(x, 90, &quadrant);
        const long double r = degrees * (3.14159265358979323846264338L / 180);
        const bool odd = quadrant % 2 != 0, turned = (quadrant & 2) != 0;
        const long double s = odd ? std::cos(r) : std::sin(r), c = odd ? -std::sin(r) : std::cos(r);
        sines.add(ulps(sin_degrees(x), turned ? -s : s), x);
        cosines.add(ulps(cos_degrees(x), turned ? -c : c), x);
        tangents.add(ulps(tan_degrees(x), s / c), x);
    };
    for (int i = -1440; i <= 1440; ++i) add(i / 2.0);
    for (int i = 0; i < 400000; ++i) {
        add(random.uniform(-360, 360));
        add(random.uniform(-1e5, 1e5));
    }
    report("sin_degrees", sines), report("cos_degrees", cosines), report("tan_degrees", tangents);
    EXPECT_LT(sines.ulp, 0.81);
    EXPECT_LT(cosines.ulp, 0.81);
    EXPECT_LT(tangents.ulp, 0.95);
}

TEST(Degrees, AreFiniteAndWithinOneForAnyAngle) {
    Random random(10);
    for (int i = 0; i < 200000; ++i) {
        const double x = std::exp(random.uniform(-744, 709)) * (i % 2 ? 1 : -1);
        for (double value : {sin(x), cos(x), sin_degrees(x), cos_degrees(x)})
            ASSERT_LE(std::fabs(value), 1) << x;
        ASSERT_FALSE(std::isnan(tan(x)) || std::isnan(tan_degrees(x))) << x;
        ASSERT_NEAR(sin(x) * sin(x) + cos(x) * cos(x), 1, 1e-15);
    }
    for (double x : {k_inf, -k_inf, std::numeric_limits<double>::quiet_NaN(), 1e5 + 1, 1e300}) {
        EXPECT_EQ(sin(x), 0) << x;
        EXPECT_EQ(cos(x), 1) << x;
    }
}

TEST(Acos, ErrorAndLimits) {
    Random random(12);
    WorstError worst;
    for (int i = 0; i < 500000; ++i) {
        const double near_one = 1 - std::exp(random.uniform(-36, 0));
        for (const double x :
             {random.uniform(-1, 1), near_one, -near_one, std::exp(random.uniform(-60, -0.7))}) {
            if (x == 1) continue;
            worst.add(ulps(acos(x), std::acos(static_cast<long double>(x))), x);
        }
    }
    for (double x : {0.5, std::nextafter(0.5, 0), std::nextafter(0.5, 1)}) {
        worst.add(ulps(acos(x), std::acos(static_cast<long double>(x))), x);
        worst.add(ulps(acos(-x), std::acos(static_cast<long double>(-x))), -x);
    }
    report("acos", worst);
    EXPECT_LT(worst.ulp, 0.66);
    EXPECT_EQ(acos(1), 0);
    EXPECT_EQ(acos(-1), k_pi);
    EXPECT_EQ(acos(0), k_pi / 2);
    EXPECT_EQ(acos(-0.0), k_pi / 2);
    for (const double beyond : {1 + DBL_EPSILON, 2.0, 1e300, k_inf}) {
        EXPECT_EQ(acos(beyond), 0);
        EXPECT_EQ(acos(-beyond), k_pi);
    }
    for (int i = 0; i < 100000; ++i) {
        const double x = random.uniform(-1, 1);
        ASSERT_GE(acos(x), acos(x + 1e-12)) << x;
        ASSERT_NEAR(cos(acos(x)), x, 4e-16) << x;
    }
}

TEST(Atan2, ErrorAndLimits) {
    Random random(13);
    WorstError worst;
    const auto add = [&](double y, double x) {
        const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
        if (y != 0) worst.add(ulps(atan2(y, x), exact), y, x);
    };
    for (int i = 0; i < 400000; ++i) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        add(y, x);
        add(y * std::exp(random.uniform(-300, 300)), x * std::exp(random.uniform(-300, 300)));
        const double size = std::exp(random.uniform(-600, 690));
        add(y * size, x * size);
        add(x * (1 + random.uniform(-1, 1) * std::exp(random.uniform(-36, 0))), x);         // near pi/4
        add(x * (0.4142135623730951 + random.uniform(-1e-9, 1e-9)), x * (i % 2 ? 1 : -1));  // near pi/8
    }
    report("atan2", worst);
    EXPECT_LT(worst.ulp, 0.70);
    EXPECT_GT(worst.points, 1000000);
    EXPECT_EQ(atan2(0, 0), 0);
    EXPECT_EQ(atan2(0, 5), 0);
    EXPECT_EQ(atan2(0, -5), k_pi);
    EXPECT_EQ(atan2(-0.0, -5), k_pi);
    for (double size : {1e-270, 1.0, 3.0, 1e300}) {
        EXPECT_EQ(atan2(size, 0), k_pi / 2);
        EXPECT_EQ(atan2(-size, 0), -k_pi / 2);
        EXPECT_EQ(atan2(size, size), k_pi / 4);
        EXPECT_EQ(atan2(size, -size), std::atan2(1.0, -1.0));
        EXPECT_EQ(atan2(-size, -size), std::atan2(-1.0, -1.0));
    }
    for (int i = 0; i < 100000; ++i) {
        const double angle = random.uniform(-k_pi, k_pi);
        ASSERT_NEAR(atan2(3 * sin(angle), 3 * cos(angle)), angle, 1e-15);
    }
}

TEST(InverseFunctions, HaveTheSameBitsEverywhere) {
    Random random(14);
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&hash](double value) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u;
    };
    for (int i = 0; i < 100000; ++i) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        add(acos(x)), add(atan2(y, x)), add(atan2(y * 1000, x)), add(acos(1 - x * x * 1e-9));
    }
    EXPECT_EQ(hash, 17527987311875556097u);
}

// A checksum over the bits of many results: every compiler and the browser build must give this number.
TEST(Elementary, HasTheSameBitsEverywhere) {
    Random random(11);
    std::uint64_t hash = 0xcbf29ce484222325u;
    const auto add = [&hash](double value) {
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3u;
    };
    for (int i = 0; i < 100000; ++i) {
        const double x = random.uniform(0, 1), n = random.uniform(0, 1000),
                     angle = random.uniform(-1000, 1000);
        add(pow(x, n)), add(pow(n, x)), add(exp(angle)), add(log(n));
        add(sin(angle)), add(cos(angle)), add(tan(angle));
        add(sin_degrees(angle)), add(cos_degrees(angle)), add(tan_degrees(angle));
    }
    EXPECT_EQ(hash, 1419076546128840599u);
}

}  // namespace
}  // namespace glint::test
