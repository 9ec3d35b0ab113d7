// SPDX-License-Identifier: Apache-2.0
// The quartic: packing, crossings, normal.
#if defined(GLINT_GEOMETRY_QUARTIC_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_QUARTIC_INL_H_
#undef GLINT_GEOMETRY_QUARTIC_INL_H_
#else
#define GLINT_GEOMETRY_QUARTIC_INL_H_
#endif

#include <algorithm>

#include "geometry/ray-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"
#include "math/aabb.h"
#include "math/quartic_value.h"
#include "simd/polynomial-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct QuarticGeometry : GeometryTraits {
    static constexpr int k_values = std::size(k_quartic_terms);
    static constexpr int k_crossings = 6;
    static constexpr bool k_bounded = false;
    static constexpr bool k_only_operand = true;

    static void pack(const Quartic& quartic, double* p) { std::copy_n(quartic.coefficients, k_values, p); }
    static bool is_open(const Quartic&) { return false; }
    static void bounds(const Quartic&, Vec3& lo, Vec3& hi) {
        lo = {-k_endless, -k_endless, -k_endless};
        hi = {k_endless, k_endless, k_endless};
    }

    /// f along the line q + s d, by Horner's rule for each coordinate.
    template <class T>
    static GLINT_SMALL HWY_NOINLINE Polynomial<T> along(const T* p, const Vector3<T>& q,
                                                        const Vector3<T>& d) noexcept {
        Polynomial<T> f;
        for (int i = 0; i <= 4; ++i) {
            Polynomial<T> of_yz;
            for (int j = 0; j <= i; ++j) {
                Polynomial<T> of_z;
                for (int k = 0; k <= j; ++k) add(of_z, q.z, d.z, Polynomial<T>(*p++));
                add(of_yz, q.y, d.y, of_z);
            }
            add(f, q.x, d.x, of_yz);
        }
        return f;
    }

    static bool contains(const double* p, const Vector3<double>& point) {
        return quartic_value(p, {point.x, point.y, point.z}) < 0;
    }

    /// s is the distance from the point of the line that is nearest to the origin of the shape's coordinates,
    /// so that the distance of the ray's origin does not reduce precision. Roots beyond s = -1 and 1 are
    /// those of the reversed polynomial, whose argument is -1 / s, also if the degree is less than 4 along
    /// this line, or almost. Those beyond 2^40 are not found.
    template <class T>
    static GLINT_SMALL HWY_NOINLINE void crossings(const T* p, const Ray<T>& ray, Crossing<T>* to) noexcept {
        const T speed = T(1) / length(ray.direction);
        const Vector3<T> d = ray.direction * speed;
        const T start = -dot(ray.origin, d);
        const Polynomial<T> near = along(p, ray.origin + d * start, d);
        Polynomial<T> far;
        for (int i = 0; i <= 4; ++i) far.c[4 - i] = i % 2 == 0 ? near.c[i] : -near.c[i];
        const T first = far.value(T(k_end)), last = far.value(T(-k_end));
        const T below = near.value(T(-1)), above = near.value(T(1));
        for (int k = 0; k < 3; ++k) to[k] = {};
        to[0].enter = select(first <= T(0), T(-k_infinity), to[0].enter);
        T count(0);  // of intervals that are complete
        const auto visit = [&](const Polynomial<T>& f, int side, double from, const T& start_value,
                               double end, const T& end_value) HWY_ATTR {
            const auto may = may_have_root(f, from < 0 ? -1 : 1) || are_opposite(start_value, end_value);
            if (!any(may)) return;
            T value = start_value;
            T at[5] = {T(from), T(0), T(0), T(0), T(end)};
            find_monotone_parts(f, at);
            for (int i = 0; i < 4; ++i) {
                const T next = i == 3 ? end_value : f.value(at[i + 1]);
                const auto crosses = may && are_opposite(value, next);
                if (any(crosses)) {
                    const T root = monotone_root(f, at[i], at[i + 1], value);
                    const T t = (start + (side == 0 ? root : T(side) / abs(root))) * speed;
                    const auto leaves = crosses && next > T(0), enters = and_not(crosses, leaves);
                    for (int k = 0; k < 3; ++k) {
                        const auto is_this = abs(count - T(k)) < T(0.5);
                        to[k].enter = select(enters && is_this, t, to[k].enter);
                        to[k].exit = select(leaves && is_this, t, to[k].exit);
                    }
                    count = select(leaves, count + T(1), count);
                }
                value = next;
            }
        };
        visit(far, -1, k_end, first, 1, below);
        visit(near, 0, -1, below, 0, near.c[0]);
        visit(near, 0, 0, near.c[0], 1, above);
        visit(far, 1, -1, above, -k_end, last);
        for (int k = 0; k < 3; ++k)
            to[k].exit = select(last <= T(0) && abs(count - T(k)) < T(0.5), T(k_infinity), to[k].exit);
    }

    /// Where the gradient is 0, there is no normal: the y axis is used.
    template <class T>
    static GLINT_SMALL HWY_NOINLINE Vector3<T> normal(const T* p, const Vector3<T>& point) noexcept {
        const T zero(0), one(1);
        const Vector3<T> n{along(p, point, Vector3<T>{one, zero, zero}).c[1],
                           along(p, point, Vector3<T>{zero, one, zero}).c[1],
                           along(p, point, Vector3<T>{zero, zero, one}).c[1]};
        const T size = max_abs(n);
        return select_vector3(size > zero, normalize(n / size), Vector3<T>{zero, one, zero});
    }

  private:
    static constexpr double k_end = 0x1p-40;

    // to (q + s d) + next.
    template <class T> static HWY_INLINE void add(Polynomial<T>& to, T q, T d, const Polynomial<T>& next) {
        to.multiply(q, d);
        for (int i = 0; i <= 4; ++i) to.c[i] = to.c[i] + next.c[i];
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
