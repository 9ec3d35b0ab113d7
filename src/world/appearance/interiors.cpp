// SPDX-License-Identifier: Apache-2.0
// The objects that contain the camera, for fog that is outside of objects.
#include "world/appearance/interiors.h"

#include <algorithm>
#include <array>
#include <span>

#include "geometry/kinds-inl.h"
#include "math/number.h"
#include "world/appearance/appearance.h"
#include "world/geometry/packed_values-inl.h"

namespace glint {
namespace {

using namespace HWY_NAMESPACE;

// Whether a closed shape or a half-space contains a point: the first surface that a ray from inside meets is
// met from behind. Any direction meets a closed shape, convex or not; one of two opposite ones meets the
// boundary of a half-space.
class Contains {
  public:
    Contains(const ShapeClass& shapes, std::uint32_t slot, Vec3 point)
        : shapes_(shapes), slot_(slot), point_(point) {}
    bool result() const { return result_; }
    template <class Geometry> void visit() {
        // A mesh may be open, so that nothing is inside.
        if constexpr (Geometry::k_has_formula && !Geometry::k_only_operand) test<Geometry>();
    }

  private:
    template <class Geometry> void test() {
        double p[Geometry::k_values];
        broadcast_values<Geometry::k_values>(shapes_, slot_, p);
        const Vector3<double> origin{point_.x, point_.y, point_.z};
        for (const double side : {1.0, -1.0}) {
            const Vector3<double> d{0.36 * side, 0.48 * side, 0.8 * side};
            const auto hit = Geometry::hit(p, HWY_NAMESPACE::Ray<double>{origin, d}, 0.0);
            if (!hit.valid) continue;
            result_ = dot(Geometry::normal(p, origin + d * hit.t), d) > 0;
            return;
        }
    }

    const ShapeClass& shapes_;
    std::uint32_t slot_;
    Vec3 point_;
    bool result_ = false;
};

// What the camera rays start from: a point, or a rectangle.
struct CameraOrigins {
    std::array<Vec3, 4> points;
    std::size_t count = 1;
    explicit CameraOrigins(const PreparedCamera& camera) : points{camera.position} {
        if (camera.projection != Projection::orthographic) return;
        const Vec3 x = camera.right * 0.5, y = camera.up * 0.5, at = camera.position;
        points = {at - x - y, at - x + y, at + x - y, at + x + y};
        count = 4;
    }
    std::span<const Vec3> all() const { return {points.data(), count}; }
    // Whether the box of the points meets a shape's.
    bool meet(const PackedGeometry& geometry, std::uint32_t slot) const {
        for (int a = 0; a < 3; ++a) {
            double low = k_infinity, high = -k_infinity;
            for (const Vec3 point : all()) {
                const double p[] = {point.x, point.y, point.z};
                low = number::min(low, p[a]);
                high = number::max(high, p[a]);
            }
            if (!(geometry.box_lo[a][slot] <= high && low <= geometry.box_hi[a][slot])) return false;
        }
        return true;
    }
};

bool contains(const ShapeClass& shapes, std::uint32_t slot, Vec3 point) {
    Contains test(shapes, slot, point);
    visit_geometry(shapes.kind, shapes.transformed, test);
    return test.result();
}

void find_camera_interiors(const WorldParts& parts, FogInteriors& found) {
    const PackedGeometry& geometry = *parts.geometry;
    const CameraOrigins origins(parts.camera);
    for (const ShapeClass& shapes : geometry.classes) {
        if (shapes.first >= geometry.first_operand()) break;
        const bool is_space = shapes.kind == ShapeKind::plane, is_convex = shapes.kind != ShapeKind::torus;
        for (std::uint32_t item = 0; item < shapes.count; ++item) {
            const std::uint32_t slot = shapes.first + item;
            if (slot < geometry.boxed && !origins.meet(geometry, slot)) continue;
            if (geometry.is_open(geometry.surface_of(slot)) && !is_space) continue;
            std::size_t inside = 0;
            for (const Vec3 point : origins.all()) inside += contains(shapes, slot, point);
            // The corners of a rectangle are within a convex shape only if all of it is.
            if (inside == origins.count && (is_convex || origins.count == 1)) {
                found.camera ^= interior_word(parts, geometry.surface_of(slot));
            } else if (inside > 0 || (origins.count > 1 && !is_space)) {
                found.cutting.push_back(slot);
            }
        }
    }
}

bool has_glass(const WorldParts& parts) {
    for (std::size_t at = k_transmission; at < parts.materials->size(); at += k_material_values) {
        if ((*parts.materials)[at] > 0) return true;
    }
    return false;
}

}  // namespace

void find_interiors(WorldParts& parts) {
    FogInteriors& found = parts.interiors;
    find_camera_interiors(parts, found);
    found.tracked =
        found.camera != 0 || !found.cutting.empty() || parts.has_transparency() || has_glass(parts);
}

std::uint32_t camera_interiors_at(const WorldParts& parts, Vec3 origin) {
    const PackedGeometry& geometry = *parts.geometry;
    std::uint32_t interiors = parts.interiors.camera;
    for (const std::uint32_t slot : parts.interiors.cutting) {
        const auto holds = [&](const ShapeClass& shapes) {
            return shapes.first <= slot && slot - shapes.first < shapes.count;
        };
        const auto shapes = std::find_if(geometry.classes.begin(), geometry.classes.end(), holds);
        if (contains(*shapes, slot, origin)) interiors ^= interior_word(parts, geometry.surface_of(slot));
    }
    return interiors;
}

}  // namespace glint
