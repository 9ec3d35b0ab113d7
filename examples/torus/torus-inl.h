// SPDX-License-Identifier: Apache-2.0
// The torus: packing, bounds, hit, normal. A shape added to glint (docs/adding_a_shape.md).
#if defined(GLINT_GEOMETRY_TORUS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_TORUS_INL_H_
#undef GLINT_GEOMETRY_TORUS_INL_H_
#else
#define GLINT_GEOMETRY_TORUS_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct TorusGeometry : GeometryTraits {
    static constexpr int k_values = 2;  // radius of the ring, radius of the tube

    static void pack(const Torus& torus, double* p) { p[0] = torus.radius, p[1] = torus.tube; }
    static bool is_open(const Torus&) { return false; }
    static void bounds(const Torus& torus, Vec3& lo, Vec3& hi) {
        const double out = torus.radius + torus.tube;
        lo = {-out, -torus.tube, -out}, hi = {out, torus.tube, out};
    }

    /// A point is on the torus where (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2): along the ray a polynomial of
    /// degree 4. Between the roots of its derivative it is monotone, so that bisection finds its first root
    /// and cannot miss one; the derivative's roots are found the same way between those of the second, which
    /// are known.
    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const T big = p[0], small = p[1], out = big + small;
        // s runs from -1 to 1 within the ball around the torus, whatever the ray's length.
        const Roots<T> ball = closest_approach(ray.origin, ray.direction, out);
        const T half = max(ball.h, T(1e-300));
        const Vector3<T> q = ray.origin + ray.direction * ball.b, d = ray.direction * half;
        const T a = dot(d, d), b = T(2) * dot(q, d), c = dot(q, q) + big * big - small * small;
        const T f = T(4) * big * big;
        const T k[5] = {c * c - f * (q.x * q.x + q.z * q.z),
                        T(2) * (b * c) - f * (T(2) * (q.x * d.x + q.z * d.z)),
                        b * b + T(2) * (a * c) - f * (d.x * d.x + d.z * d.z), T(2) * (a * b), a * a};
        const T k1[4] = {k[1], T(2) * k[2], T(3) * k[3], T(4) * k[4]};

        const T first = min(max((t_min - ball.b) / half, T(-1)), T(1));
        // k1'' = 0 at middle -+ reach.
        const T middle = -(k1[2] / (T(3) * k1[3]));
        const T square = middle * middle - k1[1] / (T(3) * k1[3]);
        const T reach = sqrt(max(square, T(0)));
        const T bends[4] = {first, min(max(middle - reach, first), T(1)),
                            min(max(middle + reach, first), T(1)), T(1)};
        T turns[5] = {first, T(0), T(0), T(0), T(1)};
        for (int i = 0; i < 3; ++i) turns[i + 1] = bisect<3>(k1, bends[i], bends[i + 1]);
        T from = T(1), to = T(1);
        auto found = from < to;
        for (int i = 3; i >= 0; --i) {
            const auto crosses = opposite(value<4>(k, turns[i]), value<4>(k, turns[i + 1]));
            from = select(crosses, turns[i], from);
            to = select(crosses, turns[i + 1], to);
            found = found || crosses;
        }
        const T t = ball.b + half * bisect<4>(k, from, to);
        return {ball.real && found && t > t_min, t};
    }

    /// The normal points away from the tube's centre circle.
    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T> point) {
        const T in = T(1) - p[0] / sqrt(point.x * point.x + point.z * point.z);
        return normalize(Vector3<T>{point.x * in, point.y, point.z * in});
    }

  private:
    template <int degree, class T> static HWY_INLINE T value(const T* k, T s) {
        T sum = k[degree];
        for (int i = degree - 1; i >= 0; --i) sum = sum * s + k[i];
        return sum;
    }
    template <class T> static HWY_INLINE auto opposite(T a, T b) {
        return (a < T(0) && b >= T(0)) || (a >= T(0) && b < T(0));
    }
    /// The root between two ends of opposite signs; without a sign change, the second end.
    template <int degree, class T> static HWY_INLINE T bisect(const T* k, T from, T to) {
        const T at_from = value<degree>(k, from);
        const auto crosses = opposite(at_from, value<degree>(k, to));
        from = select(crosses, from, to);
        for (int i = 0; i < 52; ++i) {
            const T middle = (from + to) * T(0.5);
            const auto beyond = opposite(at_from, value<degree>(k, middle));
            to = select(beyond, middle, to);
            from = select(beyond, from, middle);
        }
        return to;
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
