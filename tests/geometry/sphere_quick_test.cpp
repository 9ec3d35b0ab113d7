// SPDX-License-Identifier: Apache-2.0
// The quick tests of spheres never contradict the formula, and answer most questions.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "geometry/ray_cases.h"
#include "geometry/sphere-inl.h"

namespace glint::test {
namespace {

namespace plain = HWY_NAMESPACE;

constexpr int k_cases = 100000 * k_more_cases;

// A sphere and a ray, often from near its surface. t_min is 0, or near one of the ray's hits.
struct QuickCase {
    double p[4], t_min = 0;
    plain::Ray<double> ray;
    plain::Hit<double> hit;
    bool from_surface;

    explicit QuickCase(Random& random) : from_surface(chance(random, 0.5)) {
        const auto c = from_surface ? ray_from_sphere(random) : random_sphere(random);
        plain::SphereGeometry::pack(c.shape, p);
        ray = {plain::vector3(&c.origin.x), plain::vector3(&c.direction.x)};
        if (chance(random, 0.5)) {
            const auto first = plain::SphereGeometry::hit(p, ray, 0.0);
            const auto last = plain::SphereGeometry::hit(p, ray, first.t);
            const double t = last.valid && chance(random, 0.5) ? last.t : first.t;
            const double side = chance(random, 0.5) ? 1 : -1;
            if (first.valid) t_min = t * (1 + std::ldexp(side, -3 - below(random, 50)));
        }
        hit = plain::SphereGeometry::hit(p, ray, t_min);
    }
    double length() const { return std::sqrt(dot(ray.direction, ray.direction)); }
    plain::ParallelFrame frame() const {
        const auto &o = ray.origin, &d = ray.direction;
        return {{d.x, d.y, d.z}, std::fabs(o.x) + std::fabs(o.y) + std::fabs(o.z)};
    }
};

// Counts the answers of a quick test, which must not contradict the formula.
struct QuickAnswers {
    int hits = 0, known_hits = 0, misses = 0, known_misses = 0, own = 0, known_own = 0;

    template <class T> void add(const QuickCase& c, const plain::SphereGeometry::QuickResult<T>& quick) {
        ASSERT_TRUE(quick.may_hit || !c.hit.valid) << "a hit was rejected";
        ASSERT_TRUE(!quick.is_hit || c.hit.valid) << "a miss counts as a hit";
        ++(c.hit.valid ? hits : misses);
        known_hits += quick.is_hit;
        known_misses += !quick.may_hit;
        own += c.from_surface && !c.hit.valid;
        known_own += c.from_surface && !quick.may_hit;
    }
    // At least this part is known: of the hits, the misses, and the rays that leave the sphere on which they
    // start.
    void expect_known(double of_hits, double of_misses, double of_own) const {
        EXPECT_GT(hits, k_cases / 5);
        EXPECT_GT(misses, k_cases / 5);
        EXPECT_GT(known_hits, hits * of_hits);
        EXPECT_GT(known_misses, misses * of_misses);
        EXPECT_GT(known_own, own * of_own);
    }
};

// The answers of test(case) to random cases.
template <class Test> QuickAnswers answers_of(std::uint64_t seed, const Test& test) {
    Random random(seed);
    QuickAnswers answers;
    for (int i = 0; i < k_cases; ++i) {
        const QuickCase c(random);
        answers.add(c, test(c));
        if (!::testing::Test::HasFatalFailure()) continue;
        ADD_FAILURE() << "case " << i;
        break;
    }
    return answers;
}

TEST(SphereQuickTest, AgreesWithTheFormula) {
    const auto test = [](const QuickCase& c) {
        const double d_2 = dot(c.ray.direction, c.ray.direction);
        return plain::SphereGeometry::quick_test(c.p, c.ray, d_2, c.t_min * d_2, 0.0);
    };
    answers_of(46, test).expect_known(0.12, 0.33, 0.5);
}

using ParallelTest = plain::SphereGeometry::ParallelTest<double>;
using NarrowParallelTest = plain::SphereGeometry::ParallelTest<float>;

ParallelTest parallel_test(const QuickCase& c, double slack) {
    return ParallelTest::of(c.p, c.frame(), slack, c.t_min * c.length());
}

TEST(SphereParallelTest, AgreesWithTheFormula) {
    const auto test = [](const QuickCase& c) {
        return parallel_test(c, ParallelTest::k_double_slack).test(c.frame().coordinates(c.ray.origin));
    };
    answers_of(47, test).expect_known(0.12, 0.33, 0.4);
}

TEST(SphereParallelTest, AgreesWithTheFormulaInSinglePrecision) {
    const auto narrow = [](const plain::Vector3<double>& v) {
        return plain::Vector3<float>{static_cast<float>(v.x), static_cast<float>(v.y),
                                     static_cast<float>(v.z)};
    };
    const auto test = [&](const QuickCase& c) {
        const ParallelTest exact = parallel_test(c, ParallelTest::k_single_slack);
        const NarrowParallelTest single{narrow(exact.center), static_cast<float>(exact.reach_2),
                                        static_cast<float>(exact.inner_2), static_cast<float>(exact.ahead)};
        return single.test(narrow(c.frame().coordinates(c.ray.origin)));
    };
    answers_of(48, test).expect_known(0.1, 0.1, 0.1);
}

}  // namespace
}  // namespace glint::test
