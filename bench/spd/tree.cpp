// SPDX-License-Identifier: Apache-2.0
// A tree by Aono and Kunii's method (IEEE CG&A, May 1984): 2^(size + 1) - 1 cones, each with a sphere at its
// end, on a field.
#include "databases.h"

namespace spd {

namespace {

// A similarity: rotated axes of equal length, and an origin.
struct Frame {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin;
    Vec3 turn(Vec3 p) const { return x * p.x + y * p.y + z * p.z; }
};

Frame branch(double angle, double divergence, double contraction) {
    const auto place = [&](Vec3 axis) {
        return rotate(rotate(axis, {1, 0, 0}, angle * M_PI / 180), {0, 0, 1}, divergence * M_PI / 180) *
               contraction;
    };
    return {place({1, 0, 0}), place({0, 1, 0}), place({0, 0, 1}), {0, 0, 1}};
}

void grow(SceneWriter& out, const Frame (&branches)[2], const Frame& frame, double scale, int depth) {
    constexpr double k_taper = 0.67, k_width = 0.15;
    const double radius = scale * k_width;
    const Vec3 end = frame.origin + frame.z;
    out.cone(frame.origin, radius, end, radius * k_taper);
    out.sphere(end, radius * k_taper);
    if (depth == 0) return;
    for (const Frame& b : branches) {
        const Frame next{frame.turn(b.x), frame.turn(b.y), frame.turn(b.z),
                         frame.origin + frame.turn(b.origin)};
        grow(out, branches, next, scale * k_taper, depth - 1);
    }
}

}  // namespace

void write_tree(SceneWriter& out, int size) {
    View view{.from = {4.5, 0.4, 2}, .at = {0, 0, 1.5}};
    view.lights = {{-5, 5, 50},   {30, -30, 30}, {-40, -30, 20}, {10, 30, 40},
                   {-30, 40, 10}, {50, 25, 20},  {-10, -60, 30}};
    out.begin(view);
    out.surface({.color = {0.2, 0.7, 0.2}});
    const Vec3 field[] = {{50, 50, 0}, {-50, 50, 0}, {-50, -50, 0}, {50, -50, 0}};
    out.polygon(field);
    out.surface({.color = {0.55, 0.4, 0.2}});
    const Frame branches[2] = {branch(40, 90, 0.65), branch(25, 230, 0.7)};
    grow(out, branches, Frame{}, 1, size);
}

}  // namespace spd
