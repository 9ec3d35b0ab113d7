// SPDX-License-Identifier: Apache-2.0
// The triangle, flat or with vertex normals: packing, bounds, hit, normal.
#if defined(GLINT_GEOMETRY_TRIANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_TRIANGLE_INL_H_
#undef GLINT_GEOMETRY_TRIANGLE_INL_H_
#else
#define GLINT_GEOMETRY_TRIANGLE_INL_H_
#endif

#include <array>

#include "geometry/ray-inl.h"
#include "geometry/traits.h"
#include "glint/shapes.h"
#include "math/transform.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The normal is on the counter-clockwise side: (b - a) × (c - a).
struct TriangleGeometry : GeometryTraits {
    static constexpr int k_values = 9;  // a, b, c
    static constexpr int k_bounds_values = 9;
    static constexpr bool k_stores_box = false;
    static constexpr bool k_bakes_transform = true;
    static constexpr bool k_filtered = true;
    static constexpr bool k_shares_filter = true;
    static constexpr bool k_sheared = true;
    static constexpr bool k_cheap = true;

    static void pack(const Triangle& triangle, double* p) {
        for (const Vec3& v : triangle.vertices) *p++ = v.x, *p++ = v.y, *p++ = v.z;
    }
    static Triangle apply_transform(const Triangle& triangle, const Affine& world_from_object,
                                    const Affine&) {
        Triangle out;
        for (int i = 0; i < 3; ++i)
            out.vertices[i] = transform_point(world_from_object, triangle.vertices[i]);
        // A mirroring map reverses the winding; swapping two vertices keeps the front side.
        if (determinant(world_from_object) < 0) std::swap(out.vertices[1], out.vertices[2]);
        return out;
    }
    static bool is_open(const Triangle&) { return true; }
    static void bounds(const Triangle& triangle, Vec3& lo, Vec3& hi) {
        double p[k_values];
        pack(triangle, p);
        const auto box = packed_bounds(p);
        lo = {box.lo.x, box.lo.y, box.lo.z}, hi = {box.hi.x, box.hi.y, box.hi.z};
    }
    /// The bounds from the packed values. Boxes of triangles are not stored, to save memory.
    template <class T> struct PackedBounds { Vector3<T> lo, hi; };
    template <class T> static HWY_INLINE PackedBounds<T> packed_bounds(const T* p) {
        const auto least = [&](int k) HWY_ATTR { return min(min(p[k], p[k + 3]), p[k + 6]); };
        const auto most = [&](int k) HWY_ATTR { return max(max(p[k], p[k + 3]), p[k + 6]); };
        return {{least(0), least(1), least(2)}, {most(0), most(1), most(2)}};
    }

    /// A ray prepared for the formula. origin: the point of its line that is nearest to the world's origin,
    /// at t = start, so that distance does not reduce precision. shear_x, shear_y: shear the direction onto
    /// its major axis (0 to 2).
    template <class T> struct ShearedRay {
        static constexpr int k_values = 6;
        Vector3<T> origin;
        T start, shear_x, shear_y;
    };
    template <class T, class Permutation>
    static HWY_INLINE ShearedRay<T> shear_ray(const Ray<T>& ray, const Permutation& permute) {
        const Vector3<T> d = ray.direction, along = permute(d);
        const T start = -(dot(ray.origin, d) / dot(d, d));
        return {ray.origin + d * start, start, along.x / along.z, along.y / along.z};
    }
    /// Permutes the axes so that the ray's major axis becomes z.
    template <class T> struct AxisPermutation {
        decltype(T() < T()) along_x, along_y;
        static HWY_INLINE AxisPermutation of(const Vector3<T>& d) {
            return {(abs(d.x) > abs(d.y)) && (abs(d.x) > abs(d.z)), abs(d.y) > abs(d.z)};
        }
        HWY_INLINE Vector3<T> operator()(const Vector3<T>& v) const {
            return select_vector3(along_x, Vector3<T>{v.y, v.z, v.x},
                                  select_vector3(along_y, Vector3<T>{v.z, v.x, v.y}, v));
        }
    };
    /// The same if all rays have the same major axis.
    template <class T> struct UniformPermutation {
        int axis;
        HWY_INLINE Vector3<T> operator()(const Vector3<T>& v) const {
            return axis == 0 ? Vector3<T>{v.y, v.z, v.x} : axis == 1 ? Vector3<T>{v.z, v.x, v.y} : v;
        }
    };

    /// Projects the vertices along the ray; the ray passes all three edges on the same side (Woop, Benthin
    /// and Wald, Watertight Ray/Triangle Intersection, 2013). A vertex has the same projection in all its
    /// triangles, and the difference of two rounded products has the right sign or is 0: a mesh has no gaps
    /// at its edges and vertices.
    template <class T, class Permutation>
    static HWY_INLINE Hit<T> hit_sheared(const T* p, const ShearedRay<T>& sheared, const Vector3<T>& d,
                                         const Permutation& permute, T t_min) {
        const auto shear = [&](const T* vertex) HWY_ATTR {
            const Vector3<T> v = permute(vector3(vertex) - sheared.origin);
            return Vector3<T>{v.x - sheared.shear_x * v.z, v.y - sheared.shear_y * v.z, v.z};
        };
        const Vector3<T> a = shear(p), b = shear(p + 3), c = shear(p + 6);
        const auto side = [](const Vector3<T>& from, const Vector3<T>& to)
                              HWY_ATTR { return from.x * to.y - from.y * to.x; };
        const T u = side(b, c), v = side(c, a), w = side(a, b);
        const T zero(0);
        const auto inside =
            ((u >= zero) && (v >= zero) && (w >= zero)) || ((u <= zero) && (v <= zero) && (w <= zero));
        if (!any(inside)) return {inside, zero};
        const Vector3<T> n = cross(vector3(p + 3) - vector3(p), vector3(p + 6) - vector3(p));
        // A ray in the plane gives NaN or infinity: no hit.
        const T t = sheared.start + dot(vector3(p) - sheared.origin, n) / dot(d, n);
        return {inside && (t > t_min) && (t < T(1e300)), t};
    }
    template <class T> static HWY_INLINE Hit<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const auto permute = AxisPermutation<T>::of(ray.direction);
        return hit_sheared(p, shear_ray(ray, permute), ray.direction, permute, t_min);
    }

    /// In single precision: false only if `hit` in double is false. The ray passes the three edges on the
    /// same side if the volumes that it spans with them have one sign. With u = 2^-24 and M the largest
    /// coordinate of a vertex plus that of the origin, the error of a vertex relative to the origin is below
    /// 2.1 u M, of a cross product 12.5 u M^2, of a volume, for a direction of at most about 1, 62 u M^2. The
    /// test allows for twice that, and for products so small that they lose precision.
    template <class F> struct Filter {
        static constexpr float k_tiny = 1e-37f;
        Vector3<F> ab, bc, ca;
        F slack;
        static HWY_INLINE Filter of(const F* p, const Vector3<F>& o) {
            const Vector3<F> a = vector3(p) - o, b = vector3(p + 3) - o, c = vector3(p + 6) - o;
            const F m =
                max(max_abs(vector3(p)), max(max_abs(vector3(p + 3)), max_abs(vector3(p + 6)))) + max_abs(o);
            return {cross(a, b), cross(b, c), cross(c, a), m * m * F(0x1p-17f) + F(k_tiny)};
        }
        /// For rays with a common origin: computed in double, then rounded to float. With N the largest sum
        /// of a cross product's magnitudes, rounding it, the direction and the dot product changes a volume
        /// by less than 7 u N, much less than 62 u M^2 for small, distant triangles. The error of double,
        /// here and in `hit`, is below 2^-43 M^2. The test allows for twice the first, 8 times the second.
        static HWY_INLINE Filter from_one_origin(const F* p, const Vector3<F>& o) {
            const Vector3<F> a = vector3(p) - o, b = vector3(p + 3) - o, c = vector3(p + 6) - o;
            const Filter f{cross(a, b), cross(b, c), cross(c, a), F(0)};
            const auto parts = [](const Vector3<F>& n) HWY_ATTR { return abs(n.x) + abs(n.y) + abs(n.z); };
            const F n = max(parts(f.ab), max(parts(f.bc), parts(f.ca)));
            const F m =
                max(max_abs(vector3(p)), max(max_abs(vector3(p + 3)), max_abs(vector3(p + 6)))) + max_abs(o);
            const F lost = n * F(0x1p-20) + m * m * F(0x1p-40) + F(1e-37);
            return {f.ab, f.bc, f.ca,
                    select(n < F(1e36), lost, F(k_infinity))};  // not for values beyond float
        }
        HWY_INLINE auto may_hit(const Vector3<F>& d) const {
            const F u = dot(d, bc), v = dot(d, ca), w = dot(d, ab);
            // A NaN may hit.
            return !((min(u, min(v, w)) < -slack) && (max(u, max(v, w)) > slack));
        }
        /// False only if may_hit is false for all directions within [lo, hi], because rounding is monotone.
        HWY_INLINE auto some_may_hit(const Vector3<F>& lo, const Vector3<F>& hi) const {
            const auto least = [&](const Vector3<F>& n) HWY_ATTR {
                return min(lo.x * n.x, hi.x * n.x) + min(lo.y * n.y, hi.y * n.y) +
                       min(lo.z * n.z, hi.z * n.z);
            };
            const auto most = [&](const Vector3<F>& n) HWY_ATTR {
                return max(lo.x * n.x, hi.x * n.x) + max(lo.y * n.y, hi.y * n.y) +
                       max(lo.z * n.z, hi.z * n.z);
            };
            return !((min(most(bc), min(most(ca), most(ab))) < -slack) &&
                     (max(least(bc), max(least(ca), least(ab))) > slack));
        }
    };

    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T>) {
        return normalize(cross(vector3(p + 3) - vector3(p), vector3(p + 6) - vector3(p)));
    }
};

/// A triangle whose vertex normals are interpolated by the point's barycentric coordinates.
struct SmoothTriangleGeometry : TriangleGeometry {
    static constexpr int k_values = 18;  // a, b, c, and their normals

    static void pack(const SmoothTriangle& triangle, double* p) {
        for (const Vec3& v : triangle.vertices) *p++ = v.x, *p++ = v.y, *p++ = v.z;
        for (const Vec3& v : triangle.normals) {
            const Vec3 n = glint::normalize(v);
            *p++ = n.x, *p++ = n.y, *p++ = n.z;
        }
    }
    static SmoothTriangle apply_transform(const SmoothTriangle& triangle, const Affine& world_from_object,
                                          const Affine& object_from_world) {
        SmoothTriangle out;
        for (int i = 0; i < 3; ++i) {
            out.vertices[i] = transform_point(world_from_object, triangle.vertices[i]);
            out.normals[i] = transform_normal(object_from_world, triangle.normals[i]);
        }
        // As of a flat triangle: the front side moves with the triangle.
        if (determinant(world_from_object) < 0) {
            std::swap(out.vertices[1], out.vertices[2]);
            std::swap(out.normals[1], out.normals[2]);
        }
        return out;
    }
    static bool is_open(const SmoothTriangle&) { return true; }
    static void bounds(const SmoothTriangle& triangle, Vec3& lo, Vec3& hi) {
        TriangleGeometry::bounds({{triangle.vertices[0], triangle.vertices[1], triangle.vertices[2]}}, lo,
                                 hi);
    }

    /// The normal of the plane, of any length. It decides from which side a ray comes by winding.
    template <class T> static HWY_INLINE Vector3<T> face_normal(const T* p) {
        return cross(vector3(p + 3) - vector3(p), vector3(p + 6) - vector3(p));
    }
    /// The point's barycentric coordinates, times the square of the face normal's length.
    template <class T> static HWY_INLINE std::array<T, 3> areas(const T* p, Vector3<T> point) {
        const Vector3<T> a = vector3(p) - point, b = vector3(p + 3) - point, c = vector3(p + 6) - point;
        const Vector3<T> n = face_normal(p);
        return {dot(cross(b, c), n), dot(cross(c, a), n), dot(cross(a, b), n)};
    }
    template <class T> static HWY_INLINE Vector3<T> normal(const T* p, Vector3<T> point) {
        const auto [u, v, w] = areas(p, point);
        return normalize(vector3(p + 9) * u + vector3(p + 12) * v + vector3(p + 15) * w);
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
