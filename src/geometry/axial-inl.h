// SPDX-License-Identifier: Apache-2.0
// Shared by cylinders and cones: an axis with a height, and discs at its ends.
#if defined(GLINT_GEOMETRY_AXIAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_AXIAL_INL_H_
#undef GLINT_GEOMETRY_AXIAL_INL_H_
#else
#define GLINT_GEOMETRY_AXIAL_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "math/extent.h"
#include "math/transform.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Packs from, unit axis and height as values 0 to 6, and returns the height.
inline double pack_axis(Vec3 from, Vec3 to, double* p) {
    const Vec3 axis = to - from, a = glint::normalize(axis);
    p[0] = from.x, p[1] = from.y, p[2] = from.z;
    p[3] = a.x, p[4] = a.y, p[5] = a.z;
    return p[6] = glint::length(axis);
}

inline void axial_bounds(Vec3 from, Vec3 to, double from_radius, double to_radius, Vec3& lo, Vec3& hi) {
    const Vec3 axis = glint::normalize(to - from);
    Extent extent;
    extent.add_disc(from, axis, from_radius);
    extent.add_disc(to, axis, to_radius);
    lo = extent.lo, hi = extent.hi;
}

/// A ray split into components along and across the axis, and its smallest valid t > t_min. Parameters s are
/// measured from t = start.
template <class T> struct AxialRay {
    T height, t_min, start;
    T q_along, d_along;
    Vector3<T> q_across, d_across;
    T best = T(1e300);

    /// q: the ray's point at s = 0, relative to the start of the axis.
    HWY_INLINE AxialRay(Vector3<T> axis, T axis_height, Vector3<T> q, Vector3<T> d, T from, T least)
        : height(axis_height),
          t_min(least),
          start(from),
          q_along(dot(q, axis)),
          d_along(dot(d, axis)),
          q_across(q - axis * q_along),
          d_across(d - axis * d_along) {}

    template <class M> HWY_INLINE void consider(T s, M ok) {
        const T t = start + s;
        best = select(ok && (t > t_min) && (t < best), t, best);
    }
    /// Considers a point of the side; it is valid if it is between the ends.
    template <class M> HWY_INLINE void consider_side(T s, M ok) {
        const T along = q_along + d_along * s;
        consider(s, ok && (along >= T(0)) && (along <= height));
    }
    /// Considers the discs at the ends, if caps is above 0.
    HWY_INLINE void consider_caps(T caps, T from_radius, T to_radius) {
        const auto capped = caps > T(0);
        if (!any(capped)) return;
        consider_disc(-q_along / d_along, from_radius, capped);
        consider_disc((height - q_along) / d_along, to_radius, capped);
    }
    HWY_INLINE Hit<T> hit() const { return {best < T(1e300), best}; }

  private:
    template <class M> HWY_INLINE void consider_disc(T s, T radius, M ok) {
        const Vector3<T> across = q_across + d_across * s;
        consider(s, ok && (dot(across, across) <= radius * radius));
    }
};

/// In single precision: false only if no ray's line comes within `radius` of the axis' line. n = a x d is
/// perpendicular to both, and q.n / |n| is their distance. With u = 2^-24, M the coordinates of origin and
/// axis, and a direction of at most about 1, the error of q.n is below 54 u M, that of radius |n| below 28 u
/// radius; the test allows for twice that.
template <class F> struct AxialFilter {
    Vector3<F> q, axis;
    F radius, slack;
    static HWY_INLINE AxialFilter around(const F* p, const Vector3<F>& o, F most_radius) {
        const F m = max_abs(o) + max_abs(vector3(p));
        return {o - vector3(p), vector3(p + 3), most_radius * F(1 + 0x1p-20f),
                (m + most_radius) * F(0x1p-17f)};
    }
    HWY_INLINE auto may_hit(const Vector3<F>& d) const {
        const Vector3<F> n = cross(axis, d);
        const F beyond = abs(dot(q, n)) - slack;
        // A NaN may hit; so may values so near that their squares lose precision.
        return !((beyond > F(1e-18f)) && (beyond * beyond > (radius * radius) * dot(n, n)));
    }
};

/// Whether a point is between the ends, and within the radius there; growth: of the radius, per unit.
inline bool is_within_axial(const double* p, const Vector3<double>& point, double radius, double growth) {
    const Vector3<double> q = point - vector3(p), axis = vector3(p + 3);
    const double along = dot(q, axis), there = radius + growth * along;
    const Vector3<double> across = q - axis * along;
    return along > 0 && along < p[6] && dot(across, across) < there * there;
}

/// The normal of a point that is `along` the axis and `off` the side: that of a cap if there are caps and one
/// is nearer.
template <class T>
HWY_INLINE Vector3<T> side_or_cap(Vector3<T> side, Vector3<T> axis, T height, T along, T off, T caps) {
    const T to_bottom = abs(along), to_top = abs(height - along);
    const auto on_cap = (caps > T(0)) && (min(to_bottom, to_top) < abs(off));
    return select_vector3(on_cap, select_vector3(to_bottom < to_top, -axis, axis), side);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
