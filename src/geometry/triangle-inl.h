// The triangle, flat or with vertex normals: packing, bounds, hit, normal.
#if defined(GLINT_GEOMETRY_TRIANGLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_GEOMETRY_TRIANGLE_INL_H_
#undef GLINT_GEOMETRY_TRIANGLE_INL_H_
#else
#define GLINT_GEOMETRY_TRIANGLE_INL_H_
#endif

#include "geometry/ray-inl.h"
#include "glint/shapes.h"
#include "math/extent.h"
#include "math/transform.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Its normal is that of the counter-clockwise side: (b - a) × (c - a).
struct TriangleGeometry {
    static constexpr int k_values = 9;  // a, b, c
    static constexpr bool k_bounded = true;
    static constexpr bool k_takes_maps = true;
    static constexpr bool k_filtered = false;

    static void pack(const Triangle& triangle, double* p) {
        for (const Vec3& v : triangle.vertices) *p++ = v.x, *p++ = v.y, *p++ = v.z;
    }
    static Triangle mapped(const Triangle& triangle, const Affine& world_from_object, const Affine&) {
        Triangle out;
        for (int i = 0; i < 3; ++i)
            out.vertices[i] = transform_point(world_from_object, triangle.vertices[i]);
        // A mirroring map turns the vertices' sense; the front stays the front, as with every other shape.
        if (determinant(world_from_object) < 0) std::swap(out.vertices[1], out.vertices[2]);
        return out;
    }
    static bool open(const Triangle&) { return true; }
    static void bounds(const Triangle& triangle, Vec3& lo, Vec3& hi) {
        Extent extent;
        for (const Vec3& v : triangle.vertices) extent.add(v);
        lo = extent.lo, hi = extent.hi;
    }

    /// The vertices are seen along the ray, sheared into the plane across the axis it mostly follows; the ray
    /// passes on one side of all three edges (Woop, Benthin and Wald, Watertight Ray/Triangle Intersection,
    /// 2013). A vertex has the same place for all its triangles, and a difference of two rounded products has
    /// the right sign or is 0, so that a mesh has no gap at its edges and vertices. From the point of the
    /// ray's line that is nearest to the world's origin, so that a distant ray costs no digits.
    template <class T> static HWY_INLINE Candidate<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        const Triple<T> d = ray.direction;
        const T start = -(dot(ray.origin, d) / dot(d, d));
        const Triple<T> origin = ray.origin + d * start;
        const auto along_x = (abs(d.x) > abs(d.y)) && (abs(d.x) > abs(d.z)), along_y = abs(d.y) > abs(d.z);
        const auto turned = [&](const Triple<T>& v) HWY_ATTR {
            return select_triple(along_x, Triple<T>{v.y, v.z, v.x},
                                 select_triple(along_y, Triple<T>{v.z, v.x, v.y}, v));
        };
        const Triple<T> along = turned(d);
        const T shear_x = along.x / along.z, shear_y = along.y / along.z;
        const auto seen = [&](const T* vertex) HWY_ATTR {
            const Triple<T> v = turned(triple(vertex) - origin);
            return Triple<T>{v.x - shear_x * v.z, v.y - shear_y * v.z, v.z};
        };
        const Triple<T> a = seen(p), b = seen(p + 3), c = seen(p + 6);
        const auto side = [](const Triple<T>& from, const Triple<T>& to)
                              HWY_ATTR { return from.x * to.y - from.y * to.x; };
        const T u = side(b, c), v = side(c, a), w = side(a, b);
        const T zero(0);
        const auto inside =
            ((u >= zero) && (v >= zero) && (w >= zero)) || ((u <= zero) && (v <= zero) && (w <= zero));
        const Triple<T> n = cross(triple(p + 3) - triple(p), triple(p + 6) - triple(p));
        // A ray within the plane gives NaN or infinity: no hit.
        const T t = start + dot(triple(p) - origin, n) / dot(d, n);
        return {inside && (t > t_min) && (t < T(1e300)), t};
    }

    template <class T> static HWY_INLINE Triple<T> normal(const T* p, Triple<T>) {
        return normalize(cross(triple(p + 3) - triple(p), triple(p + 6) - triple(p)));
    }
};

/// As the triangle, with the vertices' normals mixed by the point's barycentric coordinates.
struct SmoothTriangleGeometry {
    static constexpr int k_values = 18;  // a, b, c, and their normals
    static constexpr bool k_bounded = true;
    static constexpr bool k_takes_maps = true;
    static constexpr bool k_filtered = false;

    static void pack(const SmoothTriangle& triangle, double* p) {
        for (const Vec3& v : triangle.vertices) *p++ = v.x, *p++ = v.y, *p++ = v.z;
        for (const Vec3& v : triangle.normals) {
            const Vec3 n = glint::normalize(v);
            *p++ = n.x, *p++ = n.y, *p++ = n.z;
        }
    }
    static SmoothTriangle mapped(const SmoothTriangle& triangle, const Affine& world_from_object,
                                 const Affine& object_from_world) {
        SmoothTriangle out;
        for (int i = 0; i < 3; ++i) {
            out.vertices[i] = transform_point(world_from_object, triangle.vertices[i]);
            out.normals[i] = transform_normal(object_from_world, triangle.normals[i]);
        }
        return out;
    }
    static bool open(const SmoothTriangle&) { return true; }
    static void bounds(const SmoothTriangle& triangle, Vec3& lo, Vec3& hi) {
        TriangleGeometry::bounds({{triangle.vertices[0], triangle.vertices[1], triangle.vertices[2]}}, lo,
                                 hi);
    }

    template <class T> static HWY_INLINE Candidate<T> hit(const T* p, const Ray<T>& ray, T t_min) {
        return TriangleGeometry::hit(p, ray, t_min);
    }

    template <class T> static HWY_INLINE Triple<T> normal(const T* p, Triple<T> point) {
        const Triple<T> a = triple(p) - point, b = triple(p + 3) - point, c = triple(p + 6) - point;
        const Triple<T> n = cross(triple(p + 3) - triple(p), triple(p + 6) - triple(p));
        const T u = dot(cross(b, c), n), v = dot(cross(c, a), n), w = dot(cross(a, b), n);
        return normalize(triple(p + 9) * u + triple(p + 12) * v + triple(p + 15) * w);
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
