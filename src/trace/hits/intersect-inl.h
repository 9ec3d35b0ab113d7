// SPDX-License-Identifier: Apache-2.0
// The stages that intersect rays with shapes: nearest hits, and the occlusion of shadow rays. The kernels are
// compiled separately, in hit_kernels.cpp and faults.cpp.
#if defined(GLINT_TRACE_INTERSECT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_INTERSECT_INL_H_
#undef GLINT_TRACE_INTERSECT_INL_H_
#else
#define GLINT_TRACE_INTERSECT_INL_H_
#endif

#include "simd/lanes-inl.h"
#include "trace/batches.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// See Kernels::operand_intervals.
void operand_intervals(const PackedGeometry& geometry, std::uint32_t slot, Vec3 origin, Vec3 direction,
                       std::vector<double>& to);

/// See Kernels::nearest_hit and Kernels::any_hit (trace/kernels.h).
void nearest_hit(const WorldParts& world, const RaySpan& rays, int count, int packet, HitColumns hits);
void any_hit(const WorldParts& world, const RaySpan& rays, int count, int packet, std::uint8_t* occluded);

/// Replaces the nearest hits of a stream by those of the world's fault, which is of hits
/// (faulty_hits-inl.h).
void put_faulty_hits(const WorldParts& world, const RayBatch& rays, HitBatch& hits);

/// Finds the nearest hits of a stream: of the rays from index `first`, at most k_stream_size.
inline void intersect(const WorldParts& world, const RayBatch& rays, int first, HitBatch& hits) {
    hits.first = first;
    hits.count = number::min(k_stream_size, rays.count - first);
    nearest_hit(world, rays.span(first), hits.count, k_packet_size, hits.columns());
}

/// The surfaces along a ray that are counted or skipped, at most.
inline constexpr int k_max_steps = 4096;

/// Finds the nearest hits of the stepped rays.
inline void intersect_steps(const WorldParts& world, SteppedRays& steps) {
    nearest_hit(world, steps.span(), steps.count, k_packet_size, steps.hits());
}

/// Determines which shadow rays are occluded.
inline void intersect_shadow(const WorldParts& world, ShadowRayBatch& shadow_rays) {
    any_hit(world, shadow_rays.span(), shadow_rays.count, k_packet_size, shadow_rays.occluded.data());
}

/// Whether all rays of the stream miss.
inline bool all_missed(const HitBatch& hits) {
    for (int i = 0; i < hits.count; i += lane_count<double>()) {
        const auto hit = load(hits.t.data() + i) < Doubles(k_infinity);
        if (any(hit && first_lanes<double>(hits.count - i))) return false;
    }
    return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
