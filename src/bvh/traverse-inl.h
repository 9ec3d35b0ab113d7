// Walking the hierarchy with a beam.
#if defined(GLINT_BVH_TRAVERSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_BVH_TRAVERSE_INL_H_
#undef GLINT_BVH_TRAVERSE_INL_H_
#else
#define GLINT_BVH_TRAVERSE_INL_H_
#endif

#include "bvh/beam-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Calls leaf.visit(first, count) for every leaf whose box some ray of the beam may meet before its t_max,
/// nearest first when `ordered`. visit may shrink the beam's t_max; the walk ends when no ray has anything
/// left to find.
template <bool ordered, class Leaf> HWY_INLINE void traverse(const Bvh& bvh, Beam& beam, Leaf& leaf) {
    if (bvh.nodes.empty()) return;
    struct Entry {
        BvhChild child;
        float entry;
    };
    Entry stack[k_bvh_max_depth * (k_bvh_width - 1) + 1];
    int top = 0;
    stack[top++] = {BvhChild::node(0), -std::numeric_limits<float>::infinity()};
    while (top > 0) {
        const Entry next = stack[--top];
        // Also true once every ray is done: most_t_max is then -infinity.
        if (next.entry > beam.most_t_max) continue;
        if (next.child.is_leaf()) {
            leaf.visit(next.child.first(), next.child.count());
            if (beam.most_t_max < beam.least_t_min) return;
            continue;
        }
        const BvhNode& node = bvh.nodes[next.child.index()];
        alignas(64) float entries[k_bvh_width];
        std::uint32_t met = 0;
        for (int c = 0; c < k_bvh_width; c += lane_count<float>()) {
            const Slab slab = node_slab(beam, node, c);
            const auto meets = slab.entry <= slab.exit && slab.entry <= Floats(beam.most_t_max) &&
                               slab.exit >= Floats(beam.least_t_min);
            store(slab.entry, entries + c);
            met |= to_bits(meets) << c;
        }
        const int base = top;
        for (; met != 0; met &= met - 1) {
            const int c = __builtin_ctz(met);
            if (node.child[c].is_none()) continue;  // a beam of mixed directions meets empty boxes too
            const Entry entry{node.child[c], entries[c]};
            int at = top++;
            if constexpr (ordered) {
                // Insertion sort: the nearest ends on top.
                for (; at > base && stack[at - 1].entry < entry.entry; --at) stack[at] = stack[at - 1];
            }
            stack[at] = entry;
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
