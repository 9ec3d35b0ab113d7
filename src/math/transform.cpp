// SPDX-License-Identifier: Apache-2.0
#include "math/transform.h"

#include "math/elementary.h"

namespace glint {

Vec3 transform_vector(const Affine& map, Vec3 v) {
    const auto& m = map.m;
    return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
            m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
}

Vec3 transform_point(const Affine& map, Vec3 p) {
    return transform_vector(map, p) + Vec3{map.m[0][3], map.m[1][3], map.m[2][3]};
}

Vec3 transform_normal(const Affine& object_from_world, Vec3 n) {
    const auto& m = object_from_world.m;
    return {m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z, m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
            m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z};
}

Affine compose(const Affine& outer, const Affine& inner) {
    Affine out;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            double sum = column == 3 ? outer.m[row][3] : 0;
            for (int k = 0; k < 3; ++k) sum += outer.m[row][k] * inner.m[k][column];
            out.m[row][column] = sum;
        }
    }
    return out;
}

double determinant(const Affine& map) {
    const auto& m = map.m;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// The sum of the magnitudes that determinant() adds and subtracts; a bound for its rounding errors.
static double determinant_terms(const Affine& map) {
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
        const int c1 = (c + 1) % 3, c2 = (c + 2) % 3;
        sum += number::abs(map.m[0][c]) *
               (number::abs(map.m[1][c1] * map.m[2][c2]) + number::abs(map.m[1][c2] * map.m[2][c1]));
    }
    return sum;
}

std::optional<Affine> inverse(const Affine& map) {
    const auto& m = map.m;
    const double d = determinant(map);
    constexpr double k_rounding = 0x1p-49;
    if (!(number::abs(d) > k_rounding * determinant_terms(map))) return std::nullopt;
    Affine out;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            // The cofactor of the transposed element; cyclic indices carry its sign.
            const int r1 = (column + 1) % 3, r2 = (column + 2) % 3, c1 = (row + 1) % 3, c2 = (row + 2) % 3;
            out.m[row][column] = (m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]) / d;
        }
    }
    const Vec3 t = transform_vector(out, {m[0][3], m[1][3], m[2][3]});
    out.m[0][3] = -t.x, out.m[1][3] = -t.y, out.m[2][3] = -t.z;
    for (const auto& row : out.m) {
        for (const double value : row) {
            if (!(value - value == 0)) return std::nullopt;  // infinite or not a number
        }
    }
    return out;
}

Affine translation(Vec3 by) { return {{{1, 0, 0, by.x}, {0, 1, 0, by.y}, {0, 0, 1, by.z}}}; }

Affine scaling(Vec3 by) { return {{{by.x, 0, 0, 0}, {0, by.y, 0, 0}, {0, 0, by.z, 0}}}; }

Affine rotation_x(double degrees) {
    const double c = cos_degrees(degrees), s = sin_degrees(degrees);
    return {{{1, 0, 0, 0}, {0, c, -s, 0}, {0, s, c, 0}}};
}

Affine rotation_y(double degrees) {
    const double c = cos_degrees(degrees), s = sin_degrees(degrees);
    return {{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}}};
}

Affine rotation_z(double degrees) {
    const double c = cos_degrees(degrees), s = sin_degrees(degrees);
    return {{{c, -s, 0, 0}, {s, c, 0, 0}, {0, 0, 1, 0}}};
}

}  // namespace glint
