// SPDX-License-Identifier: Apache-2.0
// Traversal of the hierarchy for any hit, by up to 64 rays that need not be coherent. At each node, the rays
// that are still active test the children either one child with a vector of rays, or one ray with a vector of
// children, whichever takes fewer vectors: many coherent rays share a child, few or incoherent ones do not.
#if defined(GLINT_BVH_TRAVERSE_ANY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_BVH_TRAVERSE_ANY_INL_H_
#undef GLINT_BVH_TRAVERSE_ANY_INL_H_
#else
#define GLINT_BVH_TRAVERSE_ANY_INL_H_
#endif

#include <bit>

#include "bvh/ray_packet-inl.h"
#include "bvh/traverse-inl.h"
#include "simd/bit_matrix-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The children that ray i intersects before its t_max.
HWY_INLINE std::uint32_t children_met_by_ray(const SlabRays& rays, int i, const BvhNode& node) {
    const SlabRay ray(rays, i);
    const float(*const sides[2])[k_bvh_width] = {node.lo, node.hi};
    const float *near[3], *far[3];
    for (int a = 0; a < 3; ++a) {
        // By the sign bit, without a branch, which would often be mispredicted.
        const auto backward = std::bit_cast<std::uint32_t>(rays.near_inverse[a][i]) >> 31;
        near[a] = sides[backward][a], far[a] = sides[1 - backward][a];
    }
    std::uint32_t met = 0;
    for (int c = 0; c < k_bvh_width; c += lane_count<float>()) {
        const float* const near_here[3] = {near[0] + c, near[1] + c, near[2] + c};
        const float* const far_here[3] = {far[0] + c, far[1] + c, far[2] + c};
        const Slab slab = ray.meet(near_here, far_here);
        met |= to_bits(meets(slab, Floats(rays.t_min[i]), Floats(rays.t_max[i]))) << c;
    }
    return met;
}

/// The number of vectors of rays of a packet in which some are active.
HWY_INLINE int active_vectors(std::uint64_t active) {
    int count = 0;
    for (int r = 0; r < 64; r += lane_count<float>())
        count += (active >> r & first_bits(lane_count<float>())) != 0;
    return count;
}

/// Calls leaf.visit(packet, active, first, count), or leaf.visit_rays(packet, active, first, count) for few
/// rays, for every leaf whose box some rays of the packet intersect before their t_max: those set in
/// `active`. The visit sets the t_max of rays that are finished to -infinity.
template <class Leaf> HWY_INLINE void traverse_any(const Bvh& bvh, RayPacket& packet, Leaf& leaf) {
    struct Visit {
        BvhChild child;
        std::uint64_t active;
    };
    constexpr int lanes = lane_count<float>();
    TraversalStack<Visit> visits;
    BitMatrix children;
    std::uint64_t unfinished = packet.unfinished();
    visits.push({BvhChild::node(0), unfinished});
    while (!visits.empty()) {
        const Visit next = visits.pop();
        const std::uint64_t active = next.active & unfinished;
        if (active == 0) continue;
        const int rays = __builtin_popcountll(active), vectors = active_vectors(active);
        if (next.child.is_leaf()) {
            // Measured: a vector of rays is faster if more than half of its lanes are active.
            if (2 * rays > lanes * vectors)
                leaf.visit(packet, active, next.child.first(), next.child.count());
            else
                leaf.visit_rays(packet, active, next.child.first(), next.child.count());
            unfinished = packet.unfinished();
            continue;
        }
        const BvhNode& node = bvh.nodes[next.child.index()];
        const int vectors_by_ray = rays * (k_bvh_width / lanes);
        if (vectors_by_ray > vectors) {
            alignas(64) float entries[k_bvh_width];
            std::uint32_t met = children_met(packet, node, entries);
            if (vectors_by_ray > vectors * __builtin_popcount(met)) {
                for (; met != 0; met &= met - 1) {
                    const int c = __builtin_ctz(met);
                    const float lo[3] = {node.lo[0][c], node.lo[1][c], node.lo[2][c]};
                    const float hi[3] = {node.hi[0][c], node.hi[1][c], node.hi[2][c]};
                    const std::uint64_t rays_of_child = rays_that_meet(packet, active, lo, hi);
                    if (rays_of_child != 0) visits.push({node.child[c], rays_of_child});
                }
                continue;
            }
        }
        std::uint32_t met = 0;
        for (std::uint64_t bits = active; bits != 0; bits &= bits - 1) {
            const int r = __builtin_ctzll(bits);
            const std::uint32_t met_by_ray = children_met_by_ray(packet.rays, packet.first + r, node);
            children.row[r] = static_cast<std::uint16_t>(met_by_ray);
            met |= met_by_ray;
        }
        for (; met != 0; met &= met - 1) {
            const int c = __builtin_ctz(met);
            visits.push({node.child[c], children.column(c) & active});
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
