// SPDX-License-Identifier: Apache-2.0
// Rays and solids for every instruction set. They are separate from hit_kernels.cpp so that glint-core.wasm
// can be linked without them (src/wasm/left_out.cpp).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/hits/solids.cpp"
#include <hwy/foreach_target.h>  // must precede the other includes

#include "trace/hits/intersect-inl.h"
#include "trace/hits/solids-inl.h"
#include "trace/kernels.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

void operand_intervals(const PackedGeometry& geometry, std::uint32_t slot, Vec3 origin, Vec3 direction,
                       std::vector<double>& to) {
    to.clear();
    const ShapeClass& shapes = geometry.class_of(slot);
    if (shapes.kind == ShapeKind::mesh) {
        for (const MeshCrossing& crossing : find_mesh_crossings(geometry, slot, origin, direction))
            to.push_back(crossing.t);
        return;
    }
    const auto lanes = [](Vec3 v) HWY_ATTR {
        return Vector3<Doubles>{Doubles(v.x), Doubles(v.y), Doubles(v.z)};
    };
    const Ray<Doubles> ray{lanes(origin), lanes(direction)};
    Crossing<Doubles> found[k_max_intervals];
    OperandCrossings of{shapes, slot, ray, found};
    of.find();
    for (int k = 0; k < of.count; ++k) {
        alignas(64) double lane[lane_count<double>()];
        store(found[k].enter, lane);
        to.push_back(lane[0]);
        store(found[k].exit, lane);
        to.push_back(lane[0]);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();
