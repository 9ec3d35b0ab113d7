// SPDX-License-Identifier: Apache-2.0
// The quadric: packing, crossings, normal.
#if defined(GLINT_GEOMETRY_QUADRIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_QUADRIC_INL_H_
#undef GLINT_GEOMETRY_QUADRIC_INL_H_
#else
#define GLINT_GEOMETRY_QUADRIC_INL_H_
#endif

#include <algorithm>

#include "geometry/ray-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"
#include "math/quadric_bounds.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct QuadricGeometry : GeometryTraits {
    static constexpr int k_values = 10;  // the coefficients, in their order
    static constexpr int k_crossings = 4;
    static constexpr bool k_bounded = false;
    static constexpr bool k_bakes_transform = true;
    static constexpr bool k_only_operand = true;

    static void pack(const Quadric& quadric, double* p) {
        for (const Vec3& v : {quadric.squares, quadric.products, quadric.linear})
            *p++ = v.x, *p++ = v.y, *p++ = v.z;
        *p = quadric.constant;
    }
    /// f of the point's object coordinates, which are affine in those of the world.
    static Quadric apply_transform(const Quadric& quadric, const Affine&, const Affine& object_from_world) {
        const Vec3 a = quadric.squares, b = quadric.products * 0.5, c = quadric.linear * 0.5;
        const double q[4][4] = {{a.x, b.x, b.y, c.x},
                                {b.x, a.y, b.z, c.y},
                                {b.y, b.z, a.z, c.z},
                                {c.x, c.y, c.z, quadric.constant}};
        double m[4][4] = {{}, {}, {}, {0, 0, 0, 1}}, r[4][4];
        for (int i = 0; i < 3; ++i) std::copy_n(object_from_world.m[i], 4, m[i]);
        for (int i = 0; i < 4; ++i) {
            for (int j = i; j < 4; ++j) {
                r[i][j] = 0;
                for (int k = 0; k < 4; ++k) {
                    for (int l = 0; l < 4; ++l) r[i][j] += q[k][l] * (m[k][i] * m[l][j]);
                }
            }
        }
        return {{r[0][0], r[1][1], r[2][2]},
                {2 * r[0][1], 2 * r[0][2], 2 * r[1][2]},
                {2 * r[0][3], 2 * r[1][3], 2 * r[2][3]},
                r[3][3]};
    }
    static bool is_open(const Quadric&) { return false; }
    static void bounds(const Quadric& quadric, Vec3& lo, Vec3& hi) { quadric_bounds(quadric, lo, hi); }

    /// The gradient of f.
    template <class T> static HWY_INLINE Vector3<T> gradient(const T* p, const Vector3<T>& q) {
        return gradient_of_squares(p, q) + vector3(p + 6);
    }
    /// The gradient of the terms of degree 2.
    template <class T> static HWY_INLINE Vector3<T> gradient_of_squares(const T* p, const Vector3<T>& q) {
        return {T(2) * p[0] * q.x + p[3] * q.y + p[4] * q.z, T(2) * p[1] * q.y + p[3] * q.x + p[5] * q.z,
                T(2) * p[2] * q.z + p[4] * q.x + p[5] * q.y};
    }

    static bool contains(const double* p, const Vector3<double>& point) {
        return dot(gradient_of_squares(p, point), point) * 0.5 + dot(vector3(p + 6), point) + p[9] < 0;
    }

    /// Along the ray, f = a s^2 + 2 b s + c with s = t - start: relative to the point nearest to the origin
    /// of the shape's coordinates, so that distance does not reduce precision. The roots are sum / a and
    /// c / sum: a may be 0 (a line parallel to the axis of a paraboloid). The roots are those of
    /// coefficients that differ by a few rounding errors (Higham, Accuracy and Stability of Numerical
    /// Algorithms, 1.8): f is within 2^-50 of 0 there, in units of the sum of its terms' magnitudes at the
    /// root and at the nearest point, and of its gradient times the distance of the ray's origin
    /// (tests/geometry/quadric_test.cpp: 1.4 times 2^-52).
    template <class T> static HWY_INLINE void crossings(const T* p, const Ray<T>& ray, Crossing<T>* to) {
        const Vector3<T> d = ray.direction;
        const T start = -(dot(ray.origin, d) / dot(d, d)), infinity(k_infinity);
        const Vector3<T> q = ray.origin + d * start, linear = vector3(p + 6);
        const Vector3<T> of_d = gradient_of_squares(p, d), of_q = gradient_of_squares(p, q);
        const T a = dot(of_d, d) * T(0.5), b = (dot(of_q, d) + dot(linear, d)) * T(0.5);
        const T c = dot(of_q, q) * T(0.5) + dot(linear, q) + p[9];
        const T discriminant = b * b - a * c;
        const auto real = discriminant >= T(0), opens = a > T(0), closes = a < T(0);
        const T root = sqrt(max(discriminant, T(0)));
        const T sum = -(b + select(b < T(0), -root, root));
        const T first = sum / a, second = select(abs(sum) > T(0), c / sum, first);
        const T low = start + min(first, second), high = start + max(first, second), single = start + second;
        // Between the roots where f grows with the distance; before and beyond them where it falls.
        // Without a term of degree 2, on one side of the only root.
        const auto falls = b<T(0), rises = b> T(0), inside = c < T(0);
        const T flat_enter = select(falls, single, select(rises || inside, -infinity, infinity));
        const T flat_exit = select(rises, single, select(falls || inside, infinity, -infinity));
        to[0].enter = select(opens, select(real, low, infinity), select(closes, -infinity, flat_enter));
        to[0].exit = select(opens, select(real, high, -infinity),
                            select(closes, select(real, low, infinity), flat_exit));
        to[1].enter = select(closes && real, high, infinity);
        to[1].exit = select(closes && real, infinity, -infinity);
    }

    /// The apex of a cone has no normal: the y axis is used.
    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, const Vector3<T>& point) {
        const Vector3<T> n = gradient(p, point);
        const T size = max_abs(n);
        const Vector3<T> unit = n / size;
        return select_vector3(size > T(0), normalize(unit), Vector3<T>{T(0), T(1), T(0)});
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
