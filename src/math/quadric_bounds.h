// SPDX-License-Identifier: Apache-2.0
#pragma once
// The box of an ellipsoid.
#include "glint/shapes.h"
#include "math/aabb.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {

/// The box of the inside of f = x.A x + b.x + c. It is finite if A is positive definite: with the middle
/// m = -A^-1 b / 2 and the depth d = -f(m), the inside is (x - m).A (x - m) < d, which reaches
/// sqrt(d (A^-1)_ii) from the middle along axis i. Other quadrics, and those so flat that rounding errors
/// count, have the box of a shape without ends.
inline void quadric_bounds(const Quadric& quadric, Vec3& lo, Vec3& hi) {
    constexpr double k_least = 1e-6;   // of the determinant, with squares of 1
    constexpr double k_room = 1e-8;    // relative; rounding errors of the reach are below it
    constexpr double k_error = 2e-15;  // those of other numbers, in units of their terms
    hi = {k_endless, k_endless, k_endless};
    lo = -hi;
    const Vec3 a = quadric.squares, b = quadric.linear * 0.5;
    if (!(a.x > 0 && a.y > 0 && a.z > 0)) return;
    // In coordinates that are scaled so that the squares are 1.
    const Vec3 s{1 / number::sqrt(a.x), 1 / number::sqrt(a.y), 1 / number::sqrt(a.z)};
    const double xy = quadric.products.x / 2 * s.x * s.y, xz = quadric.products.y / 2 * s.x * s.z,
                 yz = quadric.products.z / 2 * s.y * s.z;
    const Vec3 row_x{1 - yz * yz, xz * yz - xy, xy * yz - xz}, row_y{row_x.y, 1 - xz * xz, xy * xz - yz},
        row_z{row_x.z, row_y.z, 1 - xy * xy};
    const double determinant = row_x.x + xy * row_x.y + xz * row_x.z;
    if (!(determinant > k_least && row_x.x > 0 && row_y.y > 0 && row_z.z > 0)) return;
    const Vec3 linear{b.x * s.x, b.y * s.y, b.z * s.z};
    const Vec3 m = Vec3{dot(row_x, linear), dot(row_y, linear), dot(row_z, linear)} * (-1 / determinant);
    // The rows have errors of some 2^-53, which the determinant divides.
    const double sum = number::abs(linear.x) + number::abs(linear.y) + number::abs(linear.z);
    const double middle_error = k_error * sum / determinant;
    const double depth = number::max(-(dot(m, linear) + quadric.constant), 0.0) + sum * middle_error +
                         number::abs(quadric.constant) * k_error;
    if (!(depth < 1e200)) return;
    const auto set = [&](double middle, double inverse, double scale, double& low, double& high) {
        const double half = number::sqrt(depth * inverse / determinant) * (1 + k_room) + middle_error;
        low = number::max((middle - half) * scale, low);
        high = number::min((middle + half) * scale, high);
    };
    set(m.x, row_x.x, s.x, lo.x, hi.x);
    set(m.y, row_y.y, s.y, lo.y, hi.y);
    set(m.z, row_z.z, s.z, lo.z, hi.z);
}

}  // namespace glint
