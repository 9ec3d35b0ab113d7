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

int operand_intervals(const PackedGeometry& geometry, std::uint32_t slot, Vec3 origin, Vec3 direction,
                      double* to) {
    const auto lanes = [](Vec3 v) HWY_ATTR {
        return Vector3<Doubles>{Doubles(v.x), Doubles(v.y), Doubles(v.z)};
    };
    const Ray<Doubles> ray{lanes(origin), lanes(direction)};
    const ShapeClass& shapes = geometry.class_of(slot);
    Crossing<Doubles> found[k_max_intervals];
    OperandCrossings of{shapes, slot, ray, found};
    visit_geometry(shapes.kind, shapes.transformed, of);
    for (int k = 0; k < of.count; ++k) {
        alignas(64) double lane[lane_count<double>()];
        store(found[k].enter, lane);
        *to++ = lane[0];
        store(found[k].exit, lane);
        *to++ = lane[0];
    }
    return of.count;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();
