// SPDX-License-Identifier: Apache-2.0
// Traversal of the hierarchy for the nearest hits, by a packet or by one ray.
#if defined(GLINT_BVH_TRAVERSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_BVH_TRAVERSE_INL_H_
#undef GLINT_BVH_TRAVERSE_INL_H_
#else
#define GLINT_BVH_TRAVERSE_INL_H_
#endif

#include "bvh/ray_packet-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The nodes to visit, the next one on top. Uninitialised, because it has thousands of entries.
template <class StackEntry> class TraversalStack {
  public:
    bool empty() const { return top_ == 0; }
    HWY_INLINE const StackEntry& pop() { return stack_[--top_]; }
    int size() const { return top_; }
    HWY_INLINE void push(const StackEntry& visit) { stack_[top_++] = visit; }
    /// Pushes below the entries from `base` on that are nearer: the nearest stays on top.
    HWY_INLINE void push_ordered(const StackEntry& visit, int base) {
        int at = top_++;
        for (; at > base && stack_[at - 1].is_nearer_than(visit); --at) stack_[at] = stack_[at - 1];
        stack_[at] = visit;
    }

  private:
    StackEntry stack_[k_bvh_max_depth * (k_bvh_width - 1) + 1];
    int top_ = 0;
};

/// A child and its entry as a sortable integer (ordered_bits).
struct KeyedChild {
    std::int64_t key;
    HWY_INLINE KeyedChild(BvhChild child, std::int32_t entry)
        : key(entry * (std::int64_t{1} << 32) + child.bits) {}
    KeyedChild() {}  // uninitialised: see TraversalStack. NOLINT(modernize-use-equals-default)
    BvhChild child() const { return {static_cast<std::uint32_t>(key)}; }
    std::int32_t entry() const { return static_cast<std::int32_t>(key >> 32); }
    bool is_nearer_than(const KeyedChild& other) const { return key < other.key; }
};

/// Sorts two children by distance. Uses no branch, which would often be mispredicted, and neither min nor
/// max, for which g++ 12 would use vectors.
HWY_INLINE void sort(KeyedChild& a, KeyedChild& b) {
    const std::int64_t swapped = (a.key ^ b.key) & -static_cast<std::int64_t>(b.key < a.key);
    a.key ^= swapped;
    b.key ^= swapped;
}

/// Pushes the intersected children, the nearest last, except the nearest one, which is returned. met is not
/// 0.
HWY_INLINE BvhChild push_all_but_nearest(const BvhNode& node, std::uint32_t met, const std::int32_t* entries,
                                         TraversalStack<KeyedChild>& visits) {
    const auto first_met = [&]() HWY_ATTR {
        const int c = __builtin_ctz(met);
        return KeyedChild(node.child[c], entries[c]);
    };
    KeyedChild nearest = first_met();
    met &= met - 1;
    if (met == 0) return nearest.child();
    KeyedChild second = first_met();
    met &= met - 1;
    sort(nearest, second);
    for (const int base = visits.size(); met != 0; met &= met - 1) {
        KeyedChild another = first_met();
        sort(second, another);
        sort(nearest, second);
        visits.push_ordered(another, base);
    }
    visits.push(second);
    return nearest.child();
}

/// Traverses the subtree of a child with the prepared ray i: calls leaf.visit(i, first, count) for every leaf
/// whose box the ray intersects before its t_max, nearest first. visit may reduce t_max.
template <class Leaf>
HWY_INLINE void traverse_ray(const Bvh& bvh, const SlabRays& rays, int i, BvhChild next, Leaf& leaf) {
    // The positions of the near and far planes in a node.
    int near_at[3], far_at[3];
    for (int a = 0; a < 3; ++a) {
        near_at[a] = (rays.near_inverse[a][i] > 0 ? 0 : 3 * k_bvh_width) + a * k_bvh_width;
        far_at[a] = (rays.near_inverse[a][i] > 0 ? 3 * k_bvh_width : 0) + a * k_bvh_width;
    }
    TraversalStack<KeyedChild> visits;
    float t_max = rays.t_max[i];
    for (;;) {
        if (next.is_leaf()) {
            leaf.visit(i, next.first(), next.count());
            t_max = rays.t_max[i];
            if (t_max < rays.t_min[i]) return;
        } else {
            // Loaded again for each node: kept in registers, the vectors would be saved around each leaf.
            const SlabRay ray(rays, i);
            const Floats t_min(rays.t_min[i]);
            const BvhNode& node = bvh.nodes[next.index()];
            const float* planes = node.lo[0];
            alignas(64) std::int32_t entries[k_bvh_width];
            std::uint32_t met = 0;
            for (int c = 0; c < k_bvh_width; c += lane_count<float>()) {
                const float* near[3] = {planes + near_at[0] + c, planes + near_at[1] + c,
                                        planes + near_at[2] + c};
                const float* far[3] = {planes + far_at[0] + c, planes + far_at[1] + c,
                                       planes + far_at[2] + c};
                const Slab slab = ray.meet(near, far);
                store_ordered_bits(slab.entry, entries + c);
                met |= to_bits(meets(slab, t_min, Floats(t_max))) << c;
            }
            if (met != 0) {
                next = push_all_but_nearest(node, met, entries, visits);
                continue;
            }
        }
        const std::int32_t limit = ordered_bits(t_max);
        do {
            if (visits.empty()) return;
            const KeyedChild top = visits.pop();
            next = top.child();
            if (!(top.entry() > limit)) break;
        } while (true);
    }
}

/// If fewer rays of a packet are active, they continue one by one.
inline constexpr int k_min_packet_size = 8;

/// Calls leaf.visit(packet, active, first, count) for every leaf whose box some rays of the packet intersect
/// before their t_max: those set in `active`; nearest first. If few rays are active, they continue one by
/// one. visit may reduce t_max of rays (and then updates the packet's).
template <class Leaf> HWY_INLINE void traverse_packet(const Bvh& bvh, RayPacket& packet, Leaf& leaf) {
    struct StackEntry {
        BvhChild child;
        float entry;
        std::uint64_t active;
        bool is_nearer_than(const StackEntry& other) const { return entry < other.entry; }
    };
    TraversalStack<StackEntry> visits;
    visits.push({BvhChild::node(0), -std::numeric_limits<float>::infinity(), packet.all()});
    while (!visits.empty()) {
        const StackEntry next = visits.pop();
        // Also true if every ray is finished: max_t_max is then -infinity.
        if (next.entry > packet.max_t_max) continue;
        if (__builtin_popcountll(next.active) < k_min_packet_size) {
            for (std::uint64_t bits = next.active; bits != 0; bits &= bits - 1) {
                const int i = packet.first + __builtin_ctzll(bits);
                if (next.entry > packet.rays.t_max[i]) continue;
                traverse_ray(bvh, packet.rays, i, next.child, leaf);
            }
            packet.update_t_max();
            continue;
        }
        if (next.child.is_leaf()) {
            leaf.visit(packet, next.active, next.child.first(), next.child.count());
            continue;
        }
        const BvhNode& node = bvh.nodes[next.child.index()];
        alignas(64) float entries[k_bvh_width];
        std::uint32_t met = children_met(packet, node, entries);
        const int base = visits.size();
        for (; met != 0; met &= met - 1) {
            const int c = __builtin_ctz(met);
            const float lo[3] = {node.lo[0][c], node.lo[1][c], node.lo[2][c]};
            const float hi[3] = {node.hi[0][c], node.hi[1][c], node.hi[2][c]};
            const std::uint64_t active = rays_that_meet(packet, next.active, lo, hi);
            if (active == 0) continue;
            visits.push_ordered({node.child[c], entries[c], active}, base);
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
