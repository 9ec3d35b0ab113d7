// SPDX-License-Identifier: Apache-2.0
// What was measured of POV-Ray: a quadratic spline is, from its second point on, between two points the
// parabola in equal steps through them and the one before; a cubic spline, from the second to the last point
// but one, has at each point half the difference of its neighbours as derivative; a bezier spline has four
// points for each curve. Each of these is cut into halves until it is nearly straight.
#include "formats/povray/curves.h"

#include <algorithm>

namespace glint::povray {
namespace {

constexpr double k_sine = 0.0022;  // of a piece's ends to its chord
constexpr int k_most_cuts = 11, k_least_cuts = 2;

FlatPoint operator+(FlatPoint a, FlatPoint b) { return {a.x + b.x, a.y + b.y}; }
FlatPoint operator-(FlatPoint a, FlatPoint b) { return {a.x - b.x, a.y - b.y}; }
FlatPoint operator*(FlatPoint a, double s) { return {a.x * s, a.y * s}; }
double dot(FlatPoint a, FlatPoint b) { return a.x * b.x + a.y * b.y; }

using Bezier = std::array<FlatPoint, 4>;

bool is_straight(const Bezier& c) {
    const FlatPoint chord = c[3] - c[0];
    for (std::size_t i = 0; i < 3; ++i) {
        const FlatPoint side = c[i + 1] - c[i];
        const double across = side.x * chord.y - side.y * chord.x;
        const double size = dot(side, side);
        if (size > 0 &&
            !(dot(side, chord) > 0 && across * across <= k_sine * k_sine * size * dot(chord, chord)))
            return false;
    }
    return true;
}

void add_pieces(const Bezier& c, int cuts, FlatLoop& to) {
    if (cuts == k_most_cuts || (cuts >= k_least_cuts && is_straight(c))) {
        to.push_back(c[3]);
        return;
    }
    const FlatPoint a = (c[0] + c[1]) * 0.5, m = (c[1] + c[2]) * 0.5, b = (c[2] + c[3]) * 0.5;
    const FlatPoint am = (a + m) * 0.5, mb = (m + b) * 0.5, middle = (am + mb) * 0.5;
    add_pieces({c[0], a, am, middle}, cuts + 1, to);
    add_pieces({middle, mb, b, c[3]}, cuts + 1, to);
}

}  // namespace

void add_curve(const FlatLoop& points, std::size_t first, std::size_t end, Spline spline,
               const std::function<bool(std::uint64_t)>& spend, FlatLoop& to) {
    const bool is_bezier = spline == Spline::bezier;
    const std::size_t count = spline == Spline::linear ? 2 : spline == Spline::quadratic ? 3 : 4;
    to.push_back(points[first + (spline == Spline::quadratic || spline == Spline::cubic ? 1 : 0)]);
    for (std::size_t i = first; i + count <= end; i += is_bezier ? 4 : 1) {
        const FlatPoint* p = &points[i];
        const std::size_t before = to.size();
        if (spline == Spline::linear) {
            to.push_back(p[1]);
        } else if (is_bezier) {
            add_pieces({p[0], p[1], p[2], p[3]}, 0, to);
        } else {
            const FlatPoint from = p[1] + (p[2] - p[0]) * (1.0 / 6);
            const FlatPoint until = spline == Spline::cubic
                                        ? p[2] - (p[3] - p[1]) * (1.0 / 6)
                                        : p[2] * 0.5 + p[1] * (2.0 / 3) - p[0] * (1.0 / 6);
            add_pieces({p[1], from, until, p[2]}, 0, to);
        }
        if (!spend(to.size() - before)) return;
    }
}

}  // namespace glint::povray
