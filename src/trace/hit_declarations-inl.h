// SPDX-License-Identifier: Apache-2.0
// What a tile asks of the hit kernels, which are compiled in a file of their own (hit_kernels.cpp).
#if defined(GLINT_TRACE_HIT_DECLARATIONS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_HIT_DECLARATIONS_INL_H_
#undef GLINT_TRACE_HIT_DECLARATIONS_INL_H_
#else
#define GLINT_TRACE_HIT_DECLARATIONS_INL_H_
#endif

#include "simd/lanes-inl.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// See Kernels::nearest_hit and Kernels::any_hit (trace/kernels.h).
void nearest_hit(const WorldParts& world, const RaySpan& rays, int count, int packet, double* t,
                 std::uint32_t* slot);
void any_hit(const WorldParts& world, const RaySpan& rays, int count, int packet, std::uint8_t* occluded);

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
