// SPDX-License-Identifier: Apache-2.0
// The torus: packing, bounds, hit, normal.
#if defined(GLINT_GEOMETRY_TORUS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_TORUS_INL_H_
#undef GLINT_GEOMETRY_TORUS_INL_H_
#else
#define GLINT_GEOMETRY_TORUS_INL_H_
#endif

#include "geometry/torus_ray-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"
#include "math/extent.h"
#include "math/transform.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct TorusGeometry : GeometryTraits {
    static constexpr int k_values = 8;  // center, unit axis, radius, radius of the tube
    static constexpr int k_crossings = 4;

    static void pack(const Torus& torus, double* p) {
        const Vec3 axis = glint::normalize(torus.axis);
        p[0] = torus.center.x, p[1] = torus.center.y, p[2] = torus.center.z;
        p[3] = axis.x, p[4] = axis.y, p[5] = axis.z;
        p[6] = torus.radius, p[7] = torus.tube;
    }
    static bool is_open(const Torus&) { return false; }
    static void bounds(const Torus& torus, Vec3& lo, Vec3& hi) {
        Extent extent;
        extent.add_disc(torus.center, glint::normalize(torus.axis), torus.radius);
        const Vec3 tube{torus.tube, torus.tube, torus.tube};
        lo = extent.lo - tube, hi = extent.hi + tube;
    }

    /// The function that is 0 on the surface is, along the ray, of degree 4 and has at most three extrema.
    /// Between two of them it is monotone; the signs at the extrema tell where the roots are.
    template <class T> struct Line {
        Roots<T> ball;  // with some room around the torus: s runs from -1 to 1 in it, whatever the distance
        TorusRay<T> ray;
        T at[5], value[5];  // of the extrema, between the ends, which are outside

        HWY_INLINE Line(const T* p, const Roots<T>& room, const Ray<T>& of)
            : ball(room),
              ray(vector3(p + 3), p[6], p[7], of.origin - vector3(p) + of.direction * ball.b,
                  of.direction * ball.h),
              at{T(-1), T(0), T(0), T(0), T(1)},
              value{T(1), T(0), T(0), T(0), T(1)} {
            ray.find_extrema(at);
            for (int i = 1; i < 4; ++i) {
                at[i] = min(max(at[i], T(-1)), T(1));
                value[i] = ray.value(at[i]);
            }
        }
        static HWY_INLINE Roots<T> room(const T* p, const Ray<T>& of) {
            return closest_approach(of.origin - vector3(p), of.direction, (p[6] + p[7]) * T(1 + 0x1p-16));
        }
        /// Whether there is a root between extrema i and i + 1.
        HWY_INLINE auto crosses(int i) const { return ball.real && are_opposite(value[i], value[i + 1]); }
        /// The t of the root between s = from and to; inner: the value within the tube.
        HWY_INLINE T root(T from, T to, T inner) const { return ball.b + ball.h * ray.root(from, to, inner); }
    };

    /// Only the first root is computed.
    // Not inline: the kernels call it from a dozen places, and a torus takes much longer than the call.
    template <class T> static HWY_NOINLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) noexcept {
        const Roots<T> ball = Line<T>::room(p, ray);
        if (!any(ball.real)) return {ball.real, ball.b};
        const Line<T> line(p, ball, ray);
        const T start = (t_min - ball.b) / ball.h;
        T t = ball.b, next = line.ray.first_bracket(line.at, line.value, start);
        auto valid = t < t;
        // Of a ray that starts at the surface, the first root may be its start. A root's bits do not depend
        // on t_min, so that a ray that goes on from a root does not find that again.
        for (int attempt = 0; attempt < 4; ++attempt) {
            T from = T(1), to = T(1), inner = T(0), place = T(4);
            for (int i = 3; i >= 0; --i) {
                const auto crosses = line.crosses(i) && T(i) >= next;
                from = select(crosses, line.at[i], from);
                to = select(crosses, line.at[i + 1], to);
                inner = select(crosses, min(line.value[i], line.value[i + 1]), inner);
                place = select(crosses, T(i), place);
            }
            const auto found = and_not(place < T(4), valid);
            if (!any(found)) break;
            t = select(found, line.root(from, to, inner), t);
            valid = valid || (found && t > t_min && t < T(1e300));
            next = place + T(1);
        }
        return {valid, t};
    }

    /// The signs alternate from outside to outside: a line has as many entries as exits, two at most.
    template <class T>
    static HWY_NOINLINE void crossings(const T* p, const Ray<T>& ray, Crossing<T>* to) noexcept {
        to[0] = to[1] = {};
        const Roots<T> ball = Line<T>::room(p, ray);
        if (!any(ball.real)) return;
        const Line<T> line(p, ball, ray);
        auto entered = ball.b < ball.b, left = entered;
        for (int i = 0; i < 4; ++i) {
            const auto crosses = line.crosses(i);
            if (!any(crosses)) continue;
            const T t = line.root(line.at[i], line.at[i + 1], min(line.value[i], line.value[i + 1]));
            const auto enters = crosses && line.value[i] > T(0), leaves = and_not(crosses, enters);
            to[1].enter = select(enters && entered, t, to[1].enter);
            to[0].enter = select(and_not(enters, entered), t, to[0].enter);
            to[1].exit = select(leaves && left, t, to[1].exit);
            to[0].exit = select(and_not(leaves, left), t, to[0].exit);
            entered = entered || enters;
            left = left || leaves;
        }
    }

    /// Within one of the two tubes that the plane of the axis and the point has.
    static bool contains(const double* p, const Vector3<double>& point) {
        const Vector3<double> q = point - vector3(p), axis = vector3(p + 3);
        const double along = dot(q, axis), from_axis = length(q - axis * along);
        const auto is_within = [&](double across) { return across * across + along * along < p[7] * p[7]; };
        return is_within(from_axis - p[6]) != is_within(from_axis + p[6]);
    }

    /// The normal points away from the tube's center circle. Of a torus that intersects itself, the part of
    /// the surface around the center belongs to the far side of that circle, and its normal points to the
    /// center.
    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T> point) {
        const Vector3<T> q = point - vector3(p), axis = vector3(p + 3);
        const T along = dot(q, axis);
        const Vector3<T> across = q - axis * along;
        const T from_axis = length(across);
        const auto is_near = dot(q, q) + p[6] * p[6] >= p[7] * p[7];
        const Vector3<T> side = select_vector3(is_near, across * (T(1) - p[6] / from_axis) + axis * along,
                                               across * -(T(1) + p[6] / from_axis) - axis * along);
        // Where the surface meets the axis, it has no normal: the axis is used.
        const Vector3<T> tip = axis * select(along < T(0), T(-1), T(1));
        return select_vector3(from_axis > T(0), normalize(side), tip);
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
