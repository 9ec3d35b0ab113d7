// SPDX-License-Identifier: Apache-2.0
// Nearest-hit and any-hit queries: divides rays into packets, which traverse the hierarchy together.
// trace/hits/hit_rule-inl.h defines a hit.
#if defined(GLINT_TRACE_HIT_KERNELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_HIT_KERNELS_INL_H_
#undef GLINT_TRACE_HIT_KERNELS_INL_H_
#else
#define GLINT_TRACE_HIT_KERNELS_INL_H_
#endif

#include "bvh/traverse-inl.h"
#include "bvh/traverse_any-inl.h"
#include "trace/hits/instances-inl.h"
#include "trace/hits/intersect-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The rays of the span from index `first`.
HWY_INLINE RaySpan from(const RaySpan& r, int first) {
    return {r.ox + first, r.oy + first, r.oz + first,    r.dx + first,
            r.dy + first, r.dz + first, r.t_min + first, r.t_max + first};
}

void nearest_hit(const WorldParts& world, const RaySpan& rays, int count, int packet, HitColumns hits) {
    for (int i = 0; i < count; ++i) hits.set(i, rays.t_max[i], {});
    for (int first = 0; first < count; first += SlabRays::k_max_rays) {
        const RaySpan chunk = from(rays, first);
        trace_chunk<false>(world, *world.geometry, k_none, chunk,
                           number::min(SlabRays::k_max_rays, count - first), packet, hits.from(first),
                           nullptr, false, {chunk, nullptr});
    }
}

/// The number of rays from `first` on, at most `most`, with its direction.
HWY_INLINE int count_parallel(const RaySpan& rays, int first, int most) {
    const Doubles x(rays.dx[first]), y(rays.dy[first]), z(rays.dz[first]);
    for (int n = 0; n < most; n += lane_count<double>()) {
        const int i = first + n;
        const auto same = load(rays.dx + i) == x && load(rays.dy + i) == y && load(rays.dz + i) == z;
        const auto other = and_not(first_lanes<double>(most - n), same);
        if (any(other)) return n + __builtin_ctz(to_bits(other));
    }
    return most;
}

void any_hit(const WorldParts& world, const RaySpan& rays, int count, int packet, std::uint8_t* occluded) {
    double t[SlabRays::k_size];
    for (int first = 0, n = 0; first < count; first += n) {
        const int most = number::min(SlabRays::k_max_rays, count - first);
        // Parallel rays become a chunk of their own, unless they are few.
        n = count_parallel(rays, first, most);
        const bool parallel = n >= k_min_packet_size;
        if (!parallel) n = most;
        for (int i = 0; i < n; ++i) {
            t[i] = rays.t_max[first + i];
            occluded[first + i] = 0;
        }
        const RaySpan chunk = from(rays, first);
        trace_chunk<true>(world, *world.geometry, k_none, chunk, n, packet, {t, nullptr, nullptr},
                          occluded + first, parallel, {chunk, nullptr});
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
