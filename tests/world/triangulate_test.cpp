// SPDX-License-Identifier: Apache-2.0
// Triangulation of polygons: the same area, on the same side, without overlap.
#include "world/geometry/triangulate.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "geometry/random_values.h"

namespace glint::test {
namespace {

Vec3 area_of(const Triangle& t) {
    return cross(t.vertices[1] - t.vertices[0], t.vertices[2] - t.vertices[0]) * 0.5;
}

/// Triangulates, and checks the count, the total area, and that no triangle is reversed.
void expect_triangles(const std::vector<Vec3>& polygon, Vec3 area) {
    std::vector<Triangle> triangles;
    triangulate(polygon, triangles);
    ASSERT_EQ(triangles.size(), polygon.size() - 2);
    Vec3 sum{0, 0, 0};
    double size = 0;
    for (const Triangle& t : triangles) {
        sum = sum + area_of(t);
        size += length(area_of(t));
        EXPECT_GE(dot(area_of(t), area), -1e-12 * dot(area, area)) << "a triangle is turned over";
    }
    const double whole = length(area);
    EXPECT_NEAR(length(sum - area), 0, 1e-9 * whole);
    EXPECT_NEAR(size, whole, 1e-9 * whole);
}

// Stars with any radii: all of their boundary is visible from the middle.
std::vector<Vec3> star(Random& random, int corners, Vec3 at, Vec3 n, double* area) {
    const Vec3 x = perpendicular(random, n), y = cross(n, x);
    std::vector<Vec3> polygon;
    std::vector<double> radius;
    *area = 0;
    for (int i = 0; i < corners; ++i) {
        const double r = random.uniform(0.1, 1), angle = 2 * M_PI * i / corners;
        polygon.push_back(at + x * (r * std::cos(angle)) + y * (r * std::sin(angle)));
        if (i > 0) *area += 0.5 * r * radius.back() * std::sin(2 * M_PI / corners);
        radius.push_back(r);
    }
    *area += 0.5 * radius.front() * radius.back() * std::sin(2 * M_PI / corners);
    return polygon;
}

TEST(Triangulate, StarsInEveryPlane) {
    Random random(121);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 n = i % 4 == 0 ? axis_direction(random) : unit_direction(random);
        double area = 0;
        const auto polygon = star(random, 3 + below(random, 40), point_in_cube(random, 5), n, &area);
        expect_triangles(polygon, n * area);
    }
}

TEST(Triangulate, GearsAndCombs) {
    // As in the gears of the standard procedural databases, and deep teeth.
    std::vector<Vec3> gear, comb;
    for (int i = 0; i < 144; ++i) {
        const double r = i % 4 < 2 ? 1 : 0.8, angle = 2 * M_PI * i / 144;
        gear.push_back({r * std::cos(angle), 3, -r * std::sin(angle)});
    }
    double area = 0;
    for (int i = 0; i < 144; ++i) area += cross(gear[i], gear[(i + 1) % 144]).y * 0.5;
    expect_triangles(gear, {0, area, 0});
    for (int i = 0; i < 50; ++i) {
        comb.push_back({2.0 * i, 0, 0});
        comb.push_back({2.0 * i + 1, 0, 0});
        comb.push_back({2.0 * i + 1, 10, 0});
        comb.push_back({2.0 * i + 2, 10, 0});
    }
    comb.push_back({100, -1, 0});
    comb.push_back({0, -1, 0});
    // The reversed order is counter-clockwise.
    std::vector<Vec3> turned(comb.rbegin(), comb.rend());
    double comb_area = 0;
    for (std::size_t i = 0; i < turned.size(); ++i)
        comb_area += cross(turned[i], turned[(i + 1) % turned.size()]).z * 0.5;
    ASSERT_GT(comb_area, 0);
    expect_triangles(turned, {0, 0, comb_area});
}

TEST(Triangulate, InvalidPolygonsTerminate) {
    // Polygons that cross themselves, on one line, on one point, with repeated vertices: n - 2 triangles,
    // quickly.
    Random random(122);
    const auto start = std::chrono::steady_clock::now();
    const int n = static_cast<int>(k_max_polygon_vertices);
    for (int kind = 0; kind < 6; ++kind) {
        std::vector<Vec3> polygon;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * M_PI * i / n;
            switch (kind) {
                case 0:
                    polygon.push_back(point_in_cube(random, 1));
                    break;
                case 1:
                    polygon.push_back({double(i), 0, 0});
                    break;
                case 2:
                    polygon.push_back({1, 2, 3});
                    break;
                case 3:
                    polygon.push_back({std::cos(7 * angle), std::sin(7 * angle), 0});
                    break;
                case 4:
                    polygon.push_back({std::cos(angle), std::sin(2 * angle), 0});
                    break;
                default:
                    polygon.push_back(
                        {i % 2 ? std::cos(angle) : 0.3 * std::cos(5 * angle), std::sin(angle * (i % 3)), 0});
            }
        }
        std::vector<Triangle> triangles;
        triangulate(polygon, triangles);
        EXPECT_EQ(triangles.size(), static_cast<std::size_t>(n - 2));
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_LT(seconds.count(), 60);
}

}  // namespace
}  // namespace glint::test
