// SPDX-License-Identifier: Apache-2.0
// The quadric beside crossings that were computed to 400 bits, and those of lines of which a root is missing.
#include <gtest/gtest.h>

#include "geometry/quadric_roots.h"
#include "geometry/shape_cases.h"

namespace glint::test {
namespace {

using OfQuadric = plain::QuadricGeometry;
constexpr double k_endless = std::numeric_limits<double>::infinity();

struct PackedQuadric {
    double p[OfQuadric::k_values];
    explicit PackedQuadric(const Quadric& quadric) { OfQuadric::pack(quadric, p); }

    /// The finite ends of the intervals, in ascending order, and whether the line is inside before the first.
    std::pair<std::vector<double>, bool> crossings(Vec3 o, Vec3 d) const {
        plain::Crossing<double> to[2];
        OfQuadric::crossings(p, plain::Ray<double>{triple_of<double>(o), triple_of<double>(d)}, to);
        std::vector<double> ends;
        bool is_inside = false;
        for (const auto& c : to) {
            if (!(c.enter <= c.exit)) continue;
            is_inside = is_inside || c.enter == -k_endless;
            for (const double t : {c.enter, c.exit}) {
                if (std::fabs(t) < k_endless) ends.push_back(t);
            }
        }
        return {ends, is_inside};
    }
    Vec3 normal(Vec3 at) const { return to_vec(OfQuadric::normal(p, triple_of<double>(at))); }
};

// The sum of the magnitudes of f's terms.
Long size_of_terms(const Quadric& c, Vec3 at) {
    const Long x = std::fabs(at.x), y = std::fabs(at.y), z = std::fabs(at.z);
    const auto sum = [](Vec3 v, Long a, Long b, Long e) {
        return std::fabs(v.x) * a + std::fabs(v.y) * b + std::fabs(v.z) * e;
    };
    return sum(c.squares, x * x, y * y, z * z) + sum(c.products, x * y, x * z, y * z) +
           sum(c.linear, x, y, z) + std::fabs(c.constant);
}

TEST(QuadricCrossings, AgreeWithRootsOf400Bits) {
    double worst = 0;
    int crossings = 0, misses = 0;
    for (const QuadricRoots& c : k_quadric_roots) {
        const auto number = &c - k_quadric_roots;
        const PackedQuadric quadric(c.quadric);
        const auto [ends, is_inside] = quadric.crossings(c.origin, c.direction);
        ASSERT_EQ(ends.size(), static_cast<std::size_t>(c.count)) << "case " << number;
        misses += c.count == 0 ? 1 : 0;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            ++crossings;
            const double t = c.t[i];
            const Vec3 point = c.origin + c.direction * t;
            const Vec3 gradient = to_vec(OfQuadric::gradient(quadric.p, triple_of<double>(point)));
            // By rounding of the coefficients at the points of the root and nearest to 0, and of the origin.
            const Vec3 near =
                c.origin - c.direction * (dot(c.origin, c.direction) / dot(c.direction, c.direction));
            const auto terms =
                static_cast<double>(size_of_terms(c.quadric, point) + size_of_terms(c.quadric, near));
            const double unit = k_epsilon * (terms + length(gradient) * length(c.origin));
            const double error = std::fabs(ends[i] - t) * std::fabs(dot(gradient, c.direction)) / unit;
            worst = std::max(worst, error);
            EXPECT_LT(error, 4) << "case " << number << ", crossing " << i;
        }
        // f far before the first crossing.
        if (!ends.empty()) {
            const Vec3 before = c.origin + c.direction * (ends[0] - 1e3 / length(c.direction));
            const Vec3 g = to_vec(OfQuadric::gradient(quadric.p, triple_of<double>(before)));
            const double f = (dot(g, before) + dot(c.quadric.linear, before)) / 2 + c.quadric.constant;
            EXPECT_EQ(is_inside, f < 0) << "case " << number;
        }
    }
    EXPECT_GT(crossings, 100);
    EXPECT_GT(misses, 15);
    std::printf("    %d crossings, %d misses, at most %.2f eps\n", crossings, misses, worst);
}

TEST(QuadricCrossings, WhereARootIsMissing) {
    using Ends = std::pair<std::vector<double>, bool>;
    const PackedQuadric cylinder({{1, 0, 1}, {}, {}, -1});
    EXPECT_EQ(cylinder.crossings({0.5, 7, 0}, {0, 1, 0}), Ends({}, true)) << "within it, along the axis";
    EXPECT_EQ(cylinder.crossings({1.5, 7, 0}, {0, 1, 0}), Ends({}, false)) << "beside it";
    const PackedQuadric paraboloid({{1, 0, 1}, {}, {0, -1, 0}, 0});
    EXPECT_EQ(paraboloid.crossings({1, 5, 0}, {0, -1, 0}), Ends({4}, true)) << "f rises";
    EXPECT_EQ(paraboloid.crossings({1, -5, 0}, {0, 1, 0}), Ends({6}, false)) << "f falls";
    const PackedQuadric cone({{1, -1, 1}, {}, {}, 0});
    EXPECT_EQ(cone.crossings({0, 5, 0}, {0, 1, 0}), Ends({-5, -5}, true)) << "through the apex";
    EXPECT_EQ(cone.crossings({0.5, 5, 0}, {0, -1, 0}), Ends({4.5, 5.5}, true)) << "along the axis";
    EXPECT_EQ(cone.crossings({5, 1, 0}, {-1, 0, 0}), Ends({4, 6}, false)) << "across it";
    const PackedQuadric half({{}, {}, {0, 2, 0}, -4});
    EXPECT_EQ(half.crossings({0, 5, 0}, {0, -1, 0}), Ends({3}, false)) << "a plane";
    EXPECT_EQ(half.crossings({0, 1, 0}, {1, 0, 0}), Ends({}, true)) << "below it";
    EXPECT_EQ(half.normal({3, 2, 0}), (Vec3{0, 1, 0}));
    EXPECT_EQ(cone.normal({0, 0, 0}), (Vec3{0, 1, 0})) << "the apex has none";
}

}  // namespace
}  // namespace glint::test
