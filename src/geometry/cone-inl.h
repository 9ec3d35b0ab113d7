// The finite cone, whole or truncated, open or capped: packing, bounds, hit, normal.
#if defined(GLINT_GEOMETRY_CONE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_CONE_INL_H_
#undef GLINT_GEOMETRY_CONE_INL_H_
#else
#define GLINT_GEOMETRY_CONE_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "glint/shapes.h"
#include "math/extent.h"
#include "math/transform.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

struct ConeGeometry {
    static constexpr int k_values =
        10;  // from, unit axis, height, radius at from, growth of the radius a unit, caps (0 or 1)
    static constexpr bool k_bounded = true;
    static constexpr bool k_takes_maps = false;
    static constexpr bool k_filtered = false;

    static void pack(const Cone& c, double* p) {
        const Vec3 axis = c.to - c.from;
        const double height = glint::length(axis);
        const Vec3 a = glint::normalize(axis);
        p[0] = c.from.x, p[1] = c.from.y, p[2] = c.from.z;
        p[3] = a.x, p[4] = a.y, p[5] = a.z;
        p[6] = height, p[7] = c.from_radius, p[8] = (c.to_radius - c.from_radius) / height,
        p[9] = c.caps ? 1 : 0;
    }
    static bool open(const Cone& c) { return !c.caps; }
    static void bounds(const Cone& c, Vec3& lo, Vec3& hi) {
        const Vec3 axis = glint::normalize(c.to - c.from);
        Extent extent;
        extent.add_disc(c.from, axis, c.from_radius);
        extent.add_disc(c.to, axis, c.to_radius);
        lo = extent.lo, hi = extent.hi;
    }

    /// |across(t)|^2 = r(t)^2 with r(t) = r_0 + k along(t), about the ray's closest approach to the middle of
    /// the axis, so that distance costs no digits. The roots as q / a and c / q: a may be 0, for a ray
    /// parallel to the side.
    template <class T> static HWY_INLINE Candidate<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const Triple<T> axis = triple(p + 3), d = ray.direction;
        const T height = p[6], base = p[7], growth = p[8];
        const Triple<T> to_origin = ray.origin - triple(p);
        const T start = -(dot(to_origin - axis * (height * T(0.5)), d) / dot(d, d));
        const Triple<T> q = to_origin + d * start;
        const T q_along = dot(q, axis), d_along = dot(d, axis);
        const Triple<T> q_across = q - axis * q_along, d_across = d - axis * d_along;
        const T q_radius = base + growth * q_along, d_radius = growth * d_along;

        const T a = dot(d_across, d_across) - d_radius * d_radius;
        const T b = dot(q_across, d_across) - q_radius * d_radius;
        const T c = dot(q_across, q_across) - q_radius * q_radius;
        const T discriminant = b * b - a * c;
        const T root = sqrt(max(discriminant, T(0)));
        const T sum = -(b + select(b < T(0), -root, root));
        const T first = sum / a, second = c / sum;

        const T none = T(1e300);
        T best = none;
        const auto consider = [&](T s, decltype(s < s) ok) HWY_ATTR {
            const T t = start + s;
            best = select(ok && (t > t_min) && (t < best), t, best);
        };
        const auto within = [&](T s) HWY_ATTR {
            const T along = q_along + d_along * s;
            return (along >= T(0)) && (along <= height);
        };
        const auto real = discriminant >= T(0);
        consider(first, real && within(first));
        consider(second, real && within(second));

        const auto capped = p[9] > T(0);
        if (any(capped)) {
            const auto on_disc = [&](T s, T radius) HWY_ATTR {
                const Triple<T> across = q_across + d_across * s;
                return dot(across, across) <= radius * radius;
            };
            const T bottom = -q_along / d_along, top = (height - q_along) / d_along;
            consider(bottom, capped && on_disc(bottom, base));
            consider(top, capped && on_disc(top, base + growth * height));
        }
        return {best < none, best};
    }

    /// A point nearer to a cap's plane than to the lateral surface belongs to the cap.
    template <class T> static HWY_INLINE Triple<T> normal(const T* p, Triple<T> point) {
        const Triple<T> q = point - triple(p), axis = triple(p + 3);
        const T along = dot(q, axis);
        const Triple<T> across = q - axis * along;
        const T distance = length(across);
        const Triple<T> outward = across / distance - axis * p[8];
        // The apex has no normal: the axis stands in.
        const Triple<T> tip = axis * select(p[8] < T(0), T(1), T(-1));
        const Triple<T> lateral = select_triple(distance > T(0), normalize(outward), tip);
        const T to_bottom = abs(along), to_top = abs(p[6] - along);
        const auto on_cap = (p[9] > T(0)) && (min(to_bottom, to_top) < abs(distance - (p[7] + p[8] * along)));
        return select_triple(on_cap, select_triple(to_bottom < to_top, -axis, axis), lateral);
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
