// SPDX-License-Identifier: Apache-2.0
// Where lines enter and leave a closed mesh: for the operands of solids.
#if defined(GLINT_WORLD_MESH_CROSSINGS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_WORLD_MESH_CROSSINGS_INL_H_
#undef GLINT_WORLD_MESH_CROSSINGS_INL_H_
#else
#define GLINT_WORLD_MESH_CROSSINGS_INL_H_
#endif

#include <utility>
#include <vector>

#include "base/sort_stably.h"
#include "bvh/traverse-inl.h"
#include "world/geometry/mesh_crossings.h"
#include "world/geometry/mesh_triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Up to a vector of lines in the coordinates of a mesh, of which each tests a vector of triangles. Triangles
/// are projected along the line, as by TriangleGeometry::hit.
class MeshLines {
  public:
    MeshLines(const PackedGeometry& mesh, std::vector<MeshCrossing>* to)
        : triangles_(mesh.classes.front()), numbers_(mesh.element), to_(to) {}

    void add(const Ray<double>& line) {
        const auto along = TriangleGeometry::AxisPermutation<double>::of(line.direction);
        const int axis = along.along_x ? 0 : along.along_y ? 1 : 2;
        const auto sheared = TriangleGeometry::shear_ray(line, along);
        lines_[count_++] = {line.direction, sheared, axis};
    }

    /// Of the triangles of a leaf.
    void visit(int line, std::uint32_t first, std::uint32_t count) {
        for (std::uint32_t s = 0; s < count; s += lane_count<double>()) {
            Doubles p[TriangleGeometry::k_values], t;
            load_values<TriangleGeometry::k_values>(triangles_, first + s, p);
            std::uint32_t bits = crossed(lines_[line], p, t) &
                                 first_bits(number::min(static_cast<int>(count - s), lane_count<double>()));
            if (bits == 0) continue;
            alignas(64) double at[lane_count<double>()];
            store(t, at);
            for (; bits != 0; bits &= bits - 1) {
                const auto lane = static_cast<std::uint32_t>(__builtin_ctz(bits));
                to_[line].push_back({at[lane], numbers_[first + s + lane]});
            }
        }
    }

  private:
    using Point = Vector3<Doubles>;
    struct Line {
        Vector3<double> direction;
        TriangleGeometry::ShearedRay<double> sheared;
        int axis;
    };

    // A bit for each triangle that the line crosses.
    static HWY_INLINE std::uint32_t crossed(const Line& line, const Doubles* p, Doubles& t) {
        const auto lanes = [](const Vector3<double>& v) HWY_ATTR {
            return Point{Doubles(v.x), Doubles(v.y), Doubles(v.z)};
        };
        const TriangleGeometry::UniformPermutation<Doubles> permute{line.axis};
        const Point origin = lanes(line.sheared.origin), direction = lanes(line.direction);
        const Doubles shear_x(line.sheared.shear_x), shear_y(line.sheared.shear_y), start(line.sheared.start);
        const auto projected = [&](const Doubles* vertex) HWY_ATTR {
            const Point v = permute(vector3(vertex) - origin);
            return Point{v.x - shear_x * v.z, v.y - shear_y * v.z, v.z};
        };
        const Point a = projected(p), b = projected(p + 3), c = projected(p + 6);
        const std::uint32_t ab = left_edges(a, b), bc = left_edges(b, c), ca = left_edges(c, a);
        const std::uint32_t crossed = (ab & bc & ca) | ~(ab | bc | ca);
        if ((crossed & first_bits(lane_count<double>())) == 0) return 0;
        const Point n = SmoothTriangleGeometry::face_normal(p);
        t = start + dot(vector3(p) - origin, n) / dot(direction, n);
        // In the plane of the triangle, but for rounding errors.
        const Doubles at_corner = start + a.z / permute(direction).z;
        t = select(abs(t) < Doubles(1e300), t, at_corner);
        return crossed;
    }

    // The edges on whose left the line passes: of an edge and the opposite one it is always one. A line
    // through an edge passes it as if it were moved by a small distance along x, and by a much smaller one
    // along y (Edelsbrunner and Mücke, Simulation of Simplicity, 1990). Two rounded products that differ are
    // in the right order.
    static HWY_INLINE std::uint32_t left_edges(const Point& from, const Point& to) {
        const Doubles left = from.x * to.y, right = from.y * to.x;
        const auto is_below = (to.y < from.y) || (to.y == from.y && from.x < to.x);
        return to_bits(right < left || (left == right && is_below));
    }

    const ShapeClass& triangles_;
    const std::vector<std::uint32_t>& numbers_;  // by slot
    std::vector<MeshCrossing>* to_;              // by line
    Line lines_[lane_count<double>()];
    int count_ = 0;
};

/// As find_mesh_crossings(), of up to a vector of lines.
HWY_NOINLINE inline void find_crossings_of_mesh(const PackedGeometry& geometry, std::uint32_t slot,
                                                const Ray<double>* lines, int count,
                                                std::vector<MeshCrossing>* to) {
    const ShapeClass& shapes = geometry.class_of(slot);
    const PackedGeometry& mesh = mesh_of(geometry, shapes, slot).geometry;
    if (mesh.bvh.nodes.empty()) return;
    double p[MeshGeometry::k_values];
    broadcast_values<MeshGeometry::k_values>(shapes, slot, p);
    constexpr int size = lane_count<double>() + k_ray_padding;
    alignas(64) double columns[8][size] = {};
    MeshLines tests(mesh, to);
    for (int i = 0; i < count; ++i) {
        const Ray<double> line = AffineMap::to_object(p, lines[i]);
        const double values[] = {line.origin.x,    line.origin.y,    line.origin.z, line.direction.x,
                                 line.direction.y, line.direction.z, -k_infinity,   k_infinity};
        for (int k = 0; k < 8; ++k) columns[k][i] = values[k];
        tests.add(line);
    }
    const RaySpan span{columns[0], columns[1], columns[2], columns[3],
                       columns[4], columns[5], columns[6], columns[7]};
    SlabRays slab_rays;
    prepare_rays(span, count, slab_rays);
    for (int i = 0; i < count; ++i) {
        traverse_ray(mesh.bvh, slab_rays, i, BvhChild::node(0), tests);
        // One more where a vertex is within rounding errors of the line.
        if (to[i].size() % 2 != 0) to[i].pop_back();
        const auto less = [](const MeshCrossing& a, const MeshCrossing& b) {
            return a.t != b.t ? a.t < b.t : a.triangle < b.triangle;
        };
        if (to[i].size() == 2) {
            if (less(to[i][1], to[i][0])) std::swap(to[i][0], to[i][1]);
        } else {
            sort_stably(to[i], less);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
