// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/triangulate.h"

#include <cstdint>

#include "math/number.h"

namespace glint {
namespace {

struct Point {
    double x, y;
};

// Twice the signed area of a triangle: > 0 if counter-clockwise.
double area(Point a, Point b, Point c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool inside(Point p, Point a, Point b, Point c) {
    return area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0;
}

// Newell's normal: correct for concave polygons and those that are not exactly flat.
Vec3 newell_normal(std::span<const Vec3> v) {
    Vec3 n{0, 0, 0};
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Vec3 a = v[i], b = v[(i + 1) % v.size()];
        n = n + Vec3{(a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y)};
    }
    return n;
}

// Projects the polygon into the coordinate plane in which it is largest, counter-clockwise.
std::vector<Point> project(std::span<const Vec3> v) {
    const Vec3 n = newell_normal(v);
    const double x = number::abs(n.x), y = number::abs(n.y), z = number::abs(n.z);
    std::vector<Point> points;
    points.reserve(v.size());
    for (const Vec3& p : v) {
        if (z >= x && z >= y) {
            points.push_back(n.z < 0 ? Point{p.y, p.x} : Point{p.x, p.y});
        } else if (x >= y) {
            points.push_back(n.x < 0 ? Point{p.z, p.y} : Point{p.y, p.z});
        } else {
            points.push_back(n.y < 0 ? Point{p.x, p.z} : Point{p.z, p.x});
        }
    }
    return points;
}

class EarClipper {
  public:
    EarClipper(std::span<const Vec3> vertices, std::vector<Triangle>& out)
        : vertices_(vertices), points_(project(vertices)), out_(out) {
        for (std::uint32_t i = 0; i < vertices.size(); ++i) left_.push_back(i);
    }

    void run() {
        std::size_t at = 0, misses = 0;
        while (left_.size() > 3) {
            // No ear in a whole round, or too many steps: the polygon crosses itself. Cut a corner anyway, or
            // the loop would not end.
            if (steps_ > k_max_steps || misses >= left_.size() || is_ear(at)) {
                cut(at);
                misses = 0;
                if (at >= left_.size()) at = 0;
            } else {
                at = (at + 1) % left_.size();
                ++misses;
            }
        }
        cut(1);
    }

  private:
    std::uint32_t before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
    std::uint32_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

    // A convex corner whose triangle contains no reflex corner.
    bool is_ear(std::size_t i) {
        const Point a = points_[before(i)], b = points_[left_[i]], c = points_[after(i)];
        if (!(area(a, b, c) > 0)) return false;
        for (std::size_t k = 0; k < left_.size(); ++k) {
            ++steps_;
            const std::uint32_t other = left_[k];
            if (other == before(i) || other == left_[i] || other == after(i)) continue;
            if (area(points_[before(k)], points_[other], points_[after(k)]) > 0) continue;
            const Point p = points_[other];
            const auto same = [&](Point q) { return p.x == q.x && p.y == q.y; };
            if (!same(a) && !same(b) && !same(c) && inside(p, a, b, c)) return false;
        }
        return true;
    }

    void cut(std::size_t i) {
        out_.push_back({{vertices_[before(i)], vertices_[left_[i]], vertices_[after(i)]}});
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
    }

    // Far more than a polygon of 4096 corners needs; one that crosses itself would take a minute.
    static constexpr std::size_t k_max_steps = std::size_t{1} << 25;

    std::span<const Vec3> vertices_;
    std::vector<Point> points_;
    std::vector<std::uint32_t> left_;
    std::size_t steps_ = 0;
    std::vector<Triangle>& out_;
};

}  // namespace

void triangulate(std::span<const Vec3> vertices, std::vector<Triangle>& out) {
    if (vertices.size() == 3) {
        out.push_back({{vertices[0], vertices[1], vertices[2]}});
    } else {
        EarClipper(vertices, out).run();
    }
}

}  // namespace glint
