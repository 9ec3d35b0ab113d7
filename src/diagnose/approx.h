// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers with a bound of their error: what a program in single precision may compute instead, from values
// that were printed with few digits. Errors are added up to the first order.
#include <algorithm>
#include <cmath>

#include "glint/vec.h"
#include "math/elementary.h"

namespace glint {

/// A value, and how far another computation of it may be away without a mistake.
struct Approx {
    double v = 0, e = 0;

    constexpr Approx() = default;
    constexpr Approx(double value, double error = 0) : v(value), e(error) {}  // NOLINT: intended conversion
};

/// The rounding error of one operation, relative to its result: single precision, rounded either way.
inline constexpr double k_single_rounding = 0x1p-23;

inline Approx rounded(double v, double e) { return {v, e + k_single_rounding * std::fabs(v)}; }
inline Approx operator-(Approx a) { return {-a.v, a.e}; }
inline Approx operator+(Approx a, Approx b) { return rounded(a.v + b.v, a.e + b.e); }
inline Approx operator-(Approx a, Approx b) { return rounded(a.v - b.v, a.e + b.e); }
inline Approx operator*(Approx a, Approx b) {
    return rounded(a.v * b.v, std::fabs(a.v) * b.e + std::fabs(b.v) * a.e + a.e * b.e);
}
inline Approx operator/(Approx a, Approx b) {
    const double q = a.v / b.v, least = std::fabs(b.v) - b.e;
    return rounded(q, least > 0 ? (a.e + std::fabs(q) * b.e) / least : std::fabs(q) + a.e);
}
inline Approx max(Approx a, Approx b) { return {b.v > a.v ? b.v : a.v, std::max(a.e, b.e)}; }
inline Approx min(Approx a, Approx b) { return -max(-a, -b); }
inline Approx abs(Approx a) { return {std::fabs(a.v), a.e}; }
inline Approx sqrt(Approx a) {
    const double v = std::max(a.v, 0.0), root = std::sqrt(v);
    // The difference to the root of v + e, which is defined where v is below e, too.
    return rounded(root, v > 2 * a.e ? a.e / (2 * std::sqrt(v - a.e)) : std::sqrt(v + a.e));
}
/// x^y for x >= 0; y is exact.
inline Approx pow(Approx x, double y) {
    const double v = glint::pow(std::max(x.v, 0.0), y);
    const double above = glint::pow(std::max(x.v + x.e, 0.0), y);
    const double below = glint::pow(std::max(x.v - x.e, 0.0), y);
    // Few programs have the last bits of a power.
    return rounded(v, std::max(std::fabs(above - v), std::fabs(v - below)) + 4 * k_single_rounding * v);
}

inline bool is_finite(Approx a) { return std::isfinite(a.v) && std::isfinite(a.e); }

/// Whether two values may be the same.
inline bool agree(Approx a, Approx b, double slack = 0) { return std::fabs(a.v - b.v) <= a.e + b.e + slack; }

struct ApproxVec {
    Approx x, y, z;

    ApproxVec() = default;
    ApproxVec(Approx a, Approx b, Approx c) : x(a), y(b), z(c) {}
    ApproxVec(Vec3 v) : x(v.x), y(v.y), z(v.z) {}   // NOLINT: intended conversion
    ApproxVec(Color c) : x(c.r), y(c.g), z(c.b) {}  // NOLINT: intended conversion
    Vec3 value() const { return {x.v, y.v, z.v}; }
    double error() const { return std::max({x.e, y.e, z.e}); }
};

inline bool is_finite(const ApproxVec& a) { return is_finite(a.x) && is_finite(a.y) && is_finite(a.z); }
inline ApproxVec operator-(const ApproxVec& a) { return {-a.x, -a.y, -a.z}; }
inline ApproxVec operator+(const ApproxVec& a, const ApproxVec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline ApproxVec operator-(const ApproxVec& a, const ApproxVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// By component: of colors.
inline ApproxVec operator*(const ApproxVec& a, const ApproxVec& b) {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
inline ApproxVec operator*(const ApproxVec& a, Approx s) { return {a.x * s, a.y * s, a.z * s}; }
inline ApproxVec operator/(const ApproxVec& a, Approx s) { return {a.x / s, a.y / s, a.z / s}; }
inline Approx dot(const ApproxVec& a, const ApproxVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Approx length(const ApproxVec& a) { return sqrt(dot(a, a)); }
/// Of the zero vector: the zero vector.
inline ApproxVec unit(const ApproxVec& a) {
    const Approx size = length(a);
    return size.v > 0 ? a / size : a;
}
/// A vector that is about of unit length may be used as it is, or be normalised first.
inline ApproxVec about_unit(const ApproxVec& a) {
    ApproxVec u = unit(a);
    const double off = std::fabs(length(a).v - 1);
    if (off < 1e-2)
        for (Approx* c : {&u.x, &u.y, &u.z}) c->e += off;
    return u;
}
/// L mirrored at a unit vector N: 2 N (N.L) - L.
inline ApproxVec mirrored(const ApproxVec& l, const ApproxVec& n) { return n * (Approx(2) * dot(n, l)) - l; }
inline ApproxVec clamped(const ApproxVec& c) {
    const auto one = [](Approx a) { return min(max(a, Approx(0)), Approx(1)); };
    return {one(c.x), one(c.y), one(c.z)};
}
inline bool agree(const ApproxVec& a, const ApproxVec& b, double slack = 0) {
    return agree(a.x, b.x, slack) && agree(a.y, b.y, slack) && agree(a.z, b.z, slack);
}

}  // namespace glint
