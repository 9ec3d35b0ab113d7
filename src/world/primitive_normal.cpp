// SPDX-License-Identifier: Apache-2.0
#include "geometry/kinds-inl.h"
#include "world/packed_geometry.h"

namespace glint {
namespace {

using namespace HWY_NAMESPACE;

struct NormalOf {
    const ShapeClass& shapes;
    std::uint32_t item;
    Vector3<double> point, normal;
    template <class Geometry> void visit() {
        double p[Geometry::k_values];
        for (int k = 0; k < Geometry::k_values; ++k) p[k] = shapes.column(k)[item];
        normal = Geometry::normal(p, point);
    }
};

}  // namespace

Vec3 primitive_normal(const PackedGeometry& geometry, std::uint32_t slot, Vec3 point) {
    const ShapeClass& shapes = geometry.class_of(slot);
    NormalOf of{shapes, slot - shapes.first, {point.x, point.y, point.z}, {}};
    visit_geometry(shapes.kind, shapes.transformed, of);
    return {of.normal.x, of.normal.y, of.normal.z};
}

}  // namespace glint
