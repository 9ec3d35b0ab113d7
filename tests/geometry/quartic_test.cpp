// SPDX-License-Identifier: Apache-2.0
// The quartic beside its polynomial in long double, and beside tori and quadrics, which are quartics too.
#include <gtest/gtest.h>

#include <random>

#include "geometry/shape_cases.h"
#include "math/quartic_value.h"

namespace glint::test {
namespace {

using OfQuartic = plain::QuarticGeometry;
using Crossing = plain::Crossing<double>;
constexpr double k_no_end = std::numeric_limits<double>::infinity();
constexpr double k_double_eps = std::numeric_limits<double>::epsilon();

double& term(Quartic& quartic, std::string_view name) {
    const auto at = std::find(std::begin(k_quartic_terms), std::end(k_quartic_terms), name);
    return quartic.coefficients[at - std::begin(k_quartic_terms)];
}

std::array<Crossing, 3> crossings(const Quartic& quartic, Vec3 o, Vec3 d) {
    std::array<Crossing, 3> to;
    OfQuartic::crossings(quartic.coefficients, plain::Ray<double>{triple_of<double>(o), triple_of<double>(d)},
                         to.data());
    return to;
}
template <std::size_t N> bool contains(const std::array<Crossing, N>& all, double t) {
    return std::any_of(all.begin(), all.end(), [t](const Crossing& c) { return c.enter < t && t < c.exit; });
}

struct Value {
    Long f = 0, size = 0;  // size: the sum of the terms' magnitudes
};
// By the names of the terms.
Value value(const Quartic& quartic, Vec3 origin, Vec3 direction, Long t) {
    const Long p[] = {origin.x + direction.x * t, origin.y + direction.y * t, origin.z + direction.z * t};
    Value sum;
    for (std::size_t i = 0; i < std::size(k_quartic_terms); ++i) {
        Long product = quartic.coefficients[i];
        if (k_quartic_terms[i] != "constant") {
            Long last = 1;
            for (const char c : k_quartic_terms[i]) {
                if (c >= 'x') {
                    last = p[c - 'x'];
                    product *= last;
                } else {
                    for (int n = 1; n < c - '0'; ++n) product *= last;
                }
            }
        }
        sum.f += product, sum.size += std::fabs(product);
    }
    return sum;
}

class Numbers {
  public:
    explicit Numbers(unsigned seed) : random_(seed) {}
    double number() { return static_cast<double>(random_() % 2001) / 1000 - 1; }
    Vec3 vector() { return {number(), number(), number()}; }
    bool one_of(unsigned n) { return random_() % n == 0; }

  private:
    std::mt19937 random_;
};

TEST(QuarticCrossings, AreWhereThePolynomialChangesItsSign) {
    Numbers random(7);
    int ends = 0, endless = 0;
    double worst = 0;
    for (int i = 0; i < 3000; ++i) {
        Quartic quartic;
        for (double& c : quartic.coefficients) c = random.one_of(2) ? random.number() : 0;
        const Vec3 origin = random.vector() * (random.one_of(3) ? 100.0 : 2.0);
        Vec3 direction = random.one_of(2) ? random.vector() : -origin + random.vector() * 0.5;
        if (direction == Vec3{}) direction.x = 1;
        const auto found = crossings(quartic, origin, direction);
        const double speed = length(direction), middle = -dot(origin, direction) / (speed * speed);
        for (int k = -199; k < 200; ++k) {
            const double t = middle + std::tan(k * 1.5707 / 200) / speed;
            const Value at = value(quartic, origin, direction, t);
            if (std::fabs(at.f) < 1e-10L * at.size) continue;
            ASSERT_EQ(contains(found, t), at.f < 0) << "case " << i << ", t " << t;
        }
        double before = -k_no_end;
        for (const Crossing& c : found) {
            if (!(c.enter <= c.exit)) continue;
            EXPECT_GE(c.enter, before) << "case " << i;
            before = c.exit;
            for (const double t : {c.enter, c.exit}) {
                if (std::fabs(t) == k_no_end) {
                    ++endless;
                    continue;
                }
                ++ends;
                const Value at = value(quartic, origin, direction, t);
                const Value near = value(quartic, origin, direction, middle);
                // By the rounding of t, too.
                const Long h = std::fabs(t) * k_double_eps;
                const Long slope = std::fabs(value(quartic, origin, direction, t + h).f - at.f) +
                                   std::fabs(value(quartic, origin, direction, t - h).f - at.f);
                const Vec3 lost{length(origin) * k_double_eps, length(origin) * k_double_eps,
                                length(origin) * k_double_eps};
                const Long moved = std::fabs(value(quartic, origin + lost, direction, t).f - at.f);
                const Long unit = k_double_eps * (at.size + near.size) + slope + moved;
                worst = std::max(worst, static_cast<double>(std::fabs(at.f) / unit));
            }
        }
    }
    EXPECT_LT(worst, 16);
    EXPECT_GT(ends, 3000);
    EXPECT_GT(endless, 500);
    std::printf("    %d crossings, at most %.2f units off\n", ends, worst);
}

// (x^2 + y^2 + z^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2), R = 2, r = 0.5.
TEST(QuarticCrossings, OfATorusAreThoseOfTheTorus) {
    Quartic quartic;
    for (const char* name : {"x4", "y4", "z4"}) term(quartic, name) = 1;
    for (const char* name : {"x2y2", "x2z2", "y2z2"}) term(quartic, name) = 2;
    const double k = 4 - 0.25;
    term(quartic, "x2") = term(quartic, "z2") = 2 * k - 16;
    term(quartic, "y2") = 2 * k;
    term(quartic, "constant") = k * k;
    double p[plain::TorusGeometry::k_values];
    plain::TorusGeometry::pack(Torus{{0, 0, 0}, {0, 1, 0}, 2, 0.5}, p);
    Numbers random(3);
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 origin = random.vector() * 5, direction = random.vector() * 2 - origin;
        const auto found = crossings(quartic, origin, direction);
        std::array<Crossing, 2> expected;
        plain::TorusGeometry::crossings(
            p, plain::Ray<double>{triple_of<double>(origin), triple_of<double>(direction)}, expected.data());
        for (std::size_t n = 0; n < 2; ++n) {
            if (!(expected[n].enter < expected[n].exit - 1e-6)) continue;
            EXPECT_NEAR(found[n].enter, expected[n].enter, 1e-9);
            EXPECT_NEAR(found[n].exit, expected[n].exit, 1e-9);
            ++compared;
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST(QuarticCrossings, OfALowerDegreeAreThoseOfTheQuadric) {
    Quartic sphere;
    for (const char* name : {"x2", "y2", "z2"}) term(sphere, name) = 1;
    term(sphere, "constant") = -1;
    const auto through = crossings(sphere, {0, 0, -5}, {0, 0, 2});
    EXPECT_DOUBLE_EQ(through[0].enter, 2);
    EXPECT_DOUBLE_EQ(through[0].exit, 3);
    EXPECT_GT(through[1].enter, through[1].exit);
    EXPECT_GT(crossings(sphere, {0, 1.5, -5}, {0, 0, 2})[0].enter, 1e300);
    Quartic half;  // y < 0.25
    term(half, "y") = 2, term(half, "constant") = -0.5;
    EXPECT_EQ(crossings(half, {0, 1, 0}, {0, -1, 0})[0].enter, 0.75);
    EXPECT_EQ(crossings(half, {0, 1, 0}, {0, -1, 0})[0].exit, k_no_end);
    EXPECT_EQ(crossings(half, {0, 1, 0}, {1, 0, 0})[0].exit, -k_no_end);
    EXPECT_EQ(crossings(half, {0, -1, 0}, {1, 0, 0})[0].exit, k_no_end);
}

TEST(Quartic, NormalIsTheGradient) {
    Numbers random(11);
    for (int i = 0; i < 200; ++i) {
        Quartic quartic;
        for (double& c : quartic.coefficients) c = random.number();
        const Vec3 at = random.vector();
        const auto along = [&](Vec3 d) {
            const Long h = 1e-6L;
            return static_cast<double>((value(quartic, at, d, h).f - value(quartic, at, d, -h).f) / (2 * h));
        };
        const Vec3 gradient{along({1, 0, 0}), along({0, 1, 0}), along({0, 0, 1})};
        const Vec3 normal = to_vec(OfQuartic::normal(quartic.coefficients, triple_of<double>(at)));
        EXPECT_LT(length(normal - gradient * (1 / length(gradient))), 1e-9 / length(gradient));
        EXPECT_NEAR(quartic_value(quartic.coefficients, at), static_cast<double>(value(quartic, at, {}, 0).f),
                    1e-13);
    }
    EXPECT_EQ(to_vec(OfQuartic::normal(Quartic{}.coefficients, triple_of<double>({0, 0, 0}))),
              (Vec3{0, 1, 0}));
}

TEST(Quartic, DegreesAreThoseOfTheNames) {
    Quartic only;
    for (std::size_t i = 0; i < std::size(k_quartic_terms); ++i) {
        only = {};
        only.coefficients[i] = 1;
        EXPECT_EQ(quartic_value(only.coefficients, {2, 2, 2}), 1 << quartic_degree(i)) << k_quartic_terms[i];
    }
}

}  // namespace
}  // namespace glint::test
