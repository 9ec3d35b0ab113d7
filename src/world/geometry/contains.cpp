// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/contains.h"

#include <vector>

#include "geometry/kinds-inl.h"
#include "world/geometry/mesh_crossings.h"
#include "world/geometry/packed_values-inl.h"

namespace glint {
namespace {

struct ShapeContains {
    const ShapeClass& shapes;
    std::uint32_t slot;
    HWY_NAMESPACE::Vector3<double> point;
    bool result = false;
    template <class Geometry> void visit() {
        if constexpr (Geometry::k_crossings > 0) {
            double p[Geometry::k_values];
            HWY_NAMESPACE::broadcast_values<Geometry::k_values>(shapes, slot, p);
            result = Geometry::contains(p, point);
        }
    }
};

// A mesh that is an operand of a solid is closed.
bool mesh_contains(const PackedGeometry& geometry, std::uint32_t slot, Vec3 point) {
    const std::vector<MeshCrossing> crossings = find_mesh_crossings(geometry, slot, point, {1, 0, 0});
    std::size_t behind = 0;
    while (behind < crossings.size() && crossings[behind].t <= 0) ++behind;
    return behind % 2 != 0;
}

class SolidContains {
  public:
    SolidContains(const PackedGeometry& geometry, const PackedSolid& solid, Vec3 point)
        : geometry_(geometry), solid_(solid), point_(point) {}

    // Of the operand or combination that begins at the next item.
    bool next() {
        const SolidItem item = solid_.items[at_++];
        if (item.kind == SolidItem::Kind::operand)
            return contains(geometry_, solid_.slots[item.operand], point_);
        const bool first = next();
        bool any = false, all = true;
        while (solid_.items[at_].kind != SolidItem::Kind::end) {
            const bool part = next();
            any = any || part;
            all = all && part;
        }
        ++at_;
        switch (item.operation) {
            case SolidOperation::merge:
            case SolidOperation::unite:
                return first || any;
            case SolidOperation::difference:
                return first && !any;
            case SolidOperation::inverse:
                return !first;
            case SolidOperation::clip:
                return first;
            default:  // intersection
                return first && all;
        }
    }

  private:
    const PackedGeometry& geometry_;
    const PackedSolid& solid_;
    Vec3 point_;
    std::size_t at_ = 0;
};

}  // namespace

bool contains(const PackedGeometry& geometry, std::uint32_t slot, Vec3 point) {
    const ShapeClass& shapes = geometry.class_of(slot);
    if (shapes.kind == ShapeKind::solid) {
        const auto solid = static_cast<std::size_t>(shapes.value(0, slot));
        return SolidContains(geometry, geometry.solids[solid], point).next();
    }
    if (shapes.kind == ShapeKind::mesh)
        return geometry.operand_of(slot) != nullptr && mesh_contains(geometry, slot, point);
    if (geometry.is_open(geometry.surface_of(slot)) && shapes.kind != ShapeKind::plane) return false;
    ShapeContains test{shapes, slot, {point.x, point.y, point.z}};
    HWY_NAMESPACE::visit_geometry(shapes.kind, shapes.transformed, test);
    return test.result;
}

}  // namespace glint
