// SPDX-License-Identifier: Apache-2.0
// The single-precision filters never reject a hit of the double-precision formula.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/ray_cases.h"
#include "glint/shapes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/filter_test.cpp"
#include <hwy/foreach_target.h>

#include "geometry/cone-inl.h"
#include "geometry/cylinder-inl.h"
#include "geometry/sphere-inl.h"
#include "geometry/triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

// columns: the shape's values, origin, direction. may[i]: the filter's result; count is a multiple of 16.
template <class Geometry>
HWY_INLINE void filter_columns(const std::vector<float>* columns, std::size_t count, std::uint8_t* may) {
    constexpr int n = Geometry::k_values;
    for (std::size_t i = 0; i < count; i += lane_count<float>()) {
        Floats v[n + 6];
        for (int c = 0; c < n + 6; ++c) v[c] = load(columns[c].data() + i);
        const auto filter = Geometry::template Filter<Floats>::of(v, vector3(v + n));
        const std::uint32_t bits = to_bits(filter.may_hit(vector3(v + n + 3)));
        for (int k = 0; k < lane_count<float>(); ++k) may[i + k] = bits >> k & 1;
    }
}
void filter_spheres(const std::vector<float>* columns, std::size_t count, std::uint8_t* may) {
    filter_columns<SphereGeometry>(columns, count, may);
}
void filter_triangles(const std::vector<float>* columns, std::size_t count, std::uint8_t* may) {
    filter_columns<TriangleGeometry>(columns, count, may);
}

void filter_cylinders(const std::vector<float>* columns, std::size_t count, std::uint8_t* may) {
    filter_columns<CylinderGeometry>(columns, count, may);
}
void filter_cones(const std::vector<float>* columns, std::size_t count, std::uint8_t* may) {
    filter_columns<ConeGeometry>(columns, count, may);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {
HWY_EXPORT(filter_spheres);
HWY_EXPORT(filter_triangles);
HWY_EXPORT(filter_cylinders);
HWY_EXPORT(filter_cones);
namespace test {
namespace {

namespace plain = HWY_NAMESPACE;

constexpr int k_blocks = 500 * k_more_cases;
constexpr std::size_t k_block = 1024;  // 10 million cases in all

// The largest component is 1, like that of the directions that filters receive.
Vec3 scaled_to_1(Vec3 d) {
    return d / number::max(number::max(number::abs(d.x), number::abs(d.y)), number::abs(d.z));
}

// Rays to points of the triangle and of its plane; half of them within 2^-k of an edge. Some start in it.
Case<Triangle> random_triangle(Random& random) {
    Case<Triangle> c;
    const double size = log_uniform(random, 1e-4, 1e4);
    const Vec3 where = point_in_cube(random, chance(random, 0.5) ? size : log_uniform(random, 1e-3, 1e6));
    for (Vec3& v : c.shape.vertices) v = where + point_in_cube(random, size);
    double u = random.uniform(-0.5, 1.5), v = random.uniform(-0.5, 1.5);
    if (chance(random, 0.5)) u = std::ldexp(chance(random, 0.7) ? 1.0 : -1.0, -3 - below(random, 50));
    if (chance(random, 0.3)) v = 1 - u;
    const Vec3 a = c.shape.vertices[0], b = c.shape.vertices[1], e = c.shape.vertices[2];
    const Vec3 target = a + (b - a) * u + (e - a) * v;
    Vec3 d = chance(random, 0.2) ? axis_direction(random) : unit_direction(random);
    if (chance(random, 0.1)) d = normalize(b - a + d * 1e-6);  // nearly in the plane
    c.origin = target - d * (chance(random, 0.2) ? 0 : log_uniform(random, 1e-3 * size, 1e6));
    c.direction = scaled_to_1(d);
    return c;
}

// Rays that pass the axis at r (1 +- 2^-k), or nearer; some nearly along it. Thin ones, thick ones, discs.
struct AxialCase {
    Vec3 from, to;
    double radius;
    Vec3 origin, direction;
};
AxialCase random_axial(Random& random) {
    AxialCase c;
    const double size = log_uniform(random, 1e-4, 1e4);
    c.from = point_in_cube(random, chance(random, 0.5) ? size : log_uniform(random, 1e-3, 1e6));
    const Vec3 axis = chance(random, 0.2) ? axis_direction(random) : unit_direction(random);
    c.to = c.from + axis * size;
    c.radius = size * log_uniform(random, 1e-3, 1e2);
    Vec3 d = chance(random, 0.2) ? axis_direction(random) : unit_direction(random);
    if (chance(random, 0.1)) d = normalize(axis + d * log_uniform(random, 1e-9, 1e-1));
    Vec3 aside = cross(axis, d);
    aside = length(aside) > 1e-12 ? normalize(aside) : perpendicular(random, d);
    double closest = c.radius * random.uniform(0, 1.2);
    if (chance(random, 0.5))
        closest = c.radius * (1 + std::ldexp(chance(random, 0.8) ? -1.0 : 1.0, -3 - below(random, 50)));
    const Vec3 target = c.from + axis * (size * random.uniform(0, 1)) + aside * closest;
    c.origin = target - d * (chance(random, 0.2) ? 0 : log_uniform(random, 1e-3 * size, 1e6));
    c.direction = scaled_to_1(d);
    return c;
}
Case<Cylinder> random_cylinder(Random& random) {
    const AxialCase c = random_axial(random);
    return {{c.from, c.to, c.radius, chance(random, 0.5)}, c.origin, c.direction};
}
Case<Cone> random_cone(Random& random) {
    const AxialCase c = random_axial(random);
    const double other = c.radius * random.uniform(0, 1);
    const bool turned = chance(random, 0.5);
    return {{c.from, c.to, turned ? other : c.radius, turned ? c.radius : other, chance(random, 0.5)},
            c.origin,
            c.direction};
}

// Returns the fractions of hits and of rejections.
template <class Geometry, class Shape, class Lanes>
std::pair<double, double> run_cases(Case<Shape> (*random_case)(Random&), Lanes&& filter_lanes) {
    constexpr int n = Geometry::k_values;
    Random random(41);
    std::vector<float> columns[n + 6];
    for (auto& c : columns) c.resize(k_block);
    std::vector<Case<Shape>> cases(k_block);
    std::vector<std::uint8_t> may(k_block);
    long long hits = 0, rejected = 0, total = 0;
    for (int block = 0; block < k_blocks; ++block) {
        for (std::size_t i = 0; i < k_block; ++i) {
            const Case<Shape> c = cases[i] = random_case(random);
            double values[n + 6];
            Geometry::pack(c.shape, values);
            const double ray[6] = {c.origin.x,    c.origin.y,    c.origin.z,
                                   c.direction.x, c.direction.y, c.direction.z};
            std::copy_n(ray, 6, values + n);
            for (int k = 0; k < n + 6; ++k) columns[k][i] = static_cast<float>(values[k]);
        }
        filter_lanes(columns, k_block, may.data());
        for (std::size_t i = 0; i < k_block; ++i) {
            float p[n + 6];
            for (int k = 0; k < n + 6; ++k) p[k] = columns[k][i];
            const auto filter = Geometry::template Filter<float>::of(p, plain::vector3(p + n));
            EXPECT_EQ(filter.may_hit(plain::vector3(p + n + 3)), may[i] != 0) << "lanes and float differ";
            double exact[n];
            Geometry::pack(cases[i].shape, exact);
            const Vec3 o = cases[i].origin, d = cases[i].direction;
            const bool hit =
                Geometry::hit(exact, plain::Ray<double>{{o.x, o.y, o.z}, {d.x, d.y, d.z}}, -1e300).valid;
            ++total;
            hits += hit;
            rejected += !may[i];
            EXPECT_TRUE(may[i] || !hit)
                << "block " << block << " case " << i << ": the filter rejected a hit";
        }
        if (::testing::Test::HasFailure()) break;
    }
    return {static_cast<double>(hits) / static_cast<double>(total),
            static_cast<double>(rejected) / static_cast<double>(total)};
}

TEST(SphereFilter, NeverRejectsAHit) {
    const auto [hits, rejected] = run_cases<plain::SphereGeometry>(random_sphere, [](auto... a) {
        HWY_DYNAMIC_DISPATCH(filter_spheres)(a...);
    });
    EXPECT_GT(hits, 0.25);
    EXPECT_GT(rejected, 0.02);  // and it does reject
}

TEST(TriangleFilter, NeverRejectsAHit) {
    const auto [hits, rejected] = run_cases<plain::TriangleGeometry>(random_triangle, [](auto... a) {
        HWY_DYNAMIC_DISPATCH(filter_triangles)(a...);
    });
    EXPECT_GT(hits, 0.15);
    EXPECT_GT(rejected, 0.1);
}

TEST(CylinderFilter, NeverRejectsAHit) {
    const auto [hits, rejected] = run_cases<plain::CylinderGeometry>(random_cylinder, [](auto... a) {
        HWY_DYNAMIC_DISPATCH(filter_cylinders)(a...);
    });
    EXPECT_GT(hits, 0.25);
    EXPECT_GT(rejected, 0.02);
}

TEST(ConeFilter, NeverRejectsAHit) {
    const auto [hits, rejected] = run_cases<plain::ConeGeometry>(random_cone, [](auto... a) {
        HWY_DYNAMIC_DISPATCH(filter_cones)(a...);
    });
    EXPECT_GT(hits, 0.1);
    EXPECT_GT(rejected, 0.02);
}

// The filter for rays with a common origin, as in a packet: computed in double, then rounded.
plain::TriangleGeometry::Filter<float> one_origin_filter(const Triangle& triangle, const Vec3& origin) {
    double p[9];
    plain::TriangleGeometry::pack(triangle, p);
    const auto f =
        plain::TriangleGeometry::Filter<double>::from_one_origin(p, {origin.x, origin.y, origin.z});
    const auto narrow = [](const plain::Vector3<double>& v) {
        return plain::Vector3<float>{static_cast<float>(v.x), static_cast<float>(v.y),
                                     static_cast<float>(v.z)};
    };
    return {narrow(f.ab), narrow(f.bc), narrow(f.ca), static_cast<float>(f.slack)};
}
plain::Vector3<float> narrow_direction(const Vec3& d) {
    return {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
}

TEST(TriangleFilter, ForACommonOriginNeverRejectsAHit) {
    Random random(44);
    int hits = 0, rejected = 0;
    constexpr int cases = k_blocks * 100;
    for (int i = 0; i < cases; ++i) {
        const auto c = random_triangle(random);
        const Vec3 o = c.origin, d = c.direction;
        double p[9];
        plain::TriangleGeometry::pack(c.shape, p);
        const bool hit =
            plain::TriangleGeometry::hit(p, plain::Ray<double>{{o.x, o.y, o.z}, {d.x, d.y, d.z}}, -1e300)
                .valid;
        const bool may = one_origin_filter(c.shape, o).may_hit(narrow_direction(d));
        ASSERT_TRUE(may || !hit) << "case " << i << ": the filter rejected a hit";
        hits += hit;
        rejected += !may;
    }
    EXPECT_GT(hits, cases * 15 / 100);
    EXPECT_GT(rejected, cases / 10);
}

TEST(TriangleFilter, ForACommonOriginRejectsMissesOfSmallDistantTriangles) {
    // At a tenth of its size, which is a ten-thousandth of its distance.
    Random random(45);
    int rejected = 0;
    constexpr int cases = 10000;
    for (int i = 0; i < cases; ++i) {
        const Vec3 where = point_in_cube(random, 10), d = unit_direction(random);
        const Vec3 across = perpendicular(random, d) * 1e-3, up = cross(d, across);
        const Vec3 o = where - across * 0.1 + up * 0.3 - d * 10;
        rejected += !one_origin_filter({{where, where + across, where + up}}, o).may_hit(narrow_direction(d));
    }
    EXPECT_GT(rejected, cases * 9 / 10);
}

TEST(TriangleFilter, RejectsMostMisses) {
    // Rays that pass a triangle at a tenth of its size, from within 100 of it.
    Random random(43);
    const auto f = [](double x) { return static_cast<float>(x); };
    int rejected = 0;
    constexpr int cases = 10000;
    for (int i = 0; i < cases; ++i) {
        const Vec3 where = point_in_cube(random, 10), d = unit_direction(random);
        const Vec3 across = perpendicular(random, d), up = cross(d, across);
        const Vec3 a = where, b = where + across, c = where + up;
        const Vec3 o = where - across * 0.1 + up * 0.3 - d * random.uniform(0, 100);
        const float p[9] = {f(a.x), f(a.y), f(a.z), f(b.x), f(b.y), f(b.z), f(c.x), f(c.y), f(c.z)};
        const auto filter = plain::TriangleGeometry::Filter<float>::of(p, {f(o.x), f(o.y), f(o.z)});
        rejected += !filter.may_hit({f(d.x), f(d.y), f(d.z)});
    }
    EXPECT_GT(rejected, cases * 9 / 10);
}

TEST(SphereFilter, RejectsMostMisses) {
    // Rays past a unit sphere at twice its radius, from within 100 of it: the typical use.
    Random random(42);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 d = unit_direction(random), c = point_in_cube(random, 100);
        const Vec3 o = c + perpendicular(random, d) * 2 - d * random.uniform(-100, 100);
        const auto f = [](double x) { return static_cast<float>(x); };
        const float p[4] = {f(c.x), f(c.y), f(c.z), 1};
        const auto filter = plain::SphereGeometry::Filter<float>::of(p, {f(o.x), f(o.y), f(o.z)});
        ASSERT_FALSE(filter.may_hit({f(d.x), f(d.y), f(d.z)}));
    }
}

}  // namespace
}  // namespace test
}  // namespace glint
#endif
