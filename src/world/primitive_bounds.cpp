#include "world/primitive_bounds.h"

#include "geometry/triangle-inl.h"

namespace glint {
namespace {

using namespace HWY_NAMESPACE;

Vec3 vec_of(const float* p) { return {p[0], p[1], p[2]}; }

}  // namespace

Bounds primitive_bounds(const World& world, std::uint32_t slot) {
    if (slot < world.boxed) {
        return {{world.box_lo[0][slot], world.box_lo[1][slot], world.box_lo[2][slot]},
                {world.box_hi[0][slot], world.box_hi[1][slot], world.box_hi[2][slot]}};
    }
    const ShapeClass& triangles = world.class_of(slot);
    double p[9];  // the vertices, which any kind of triangle begins with
    for (int k = 0; k < 9; ++k) p[k] = triangles.column(k)[slot - triangles.first];
    const auto [lo, hi] = TriangleGeometry::sides(p);
    const Aabb box = padded_box({lo.x, lo.y, lo.z}, {hi.x, hi.y, hi.z});
    return {vec_of(box.lo), vec_of(box.hi)};
}

}  // namespace glint
