// SPDX-License-Identifier: Apache-2.0
#include "bvh/binary_tree.h"
#include "bvh/bvh.h"

namespace glint {

Bvh build_bvh(std::vector<BvhItem>& items, std::span<const LeafCost> costs, int threads, CancelFlag cancel) {
    Bvh bvh;
    if (items.empty()) return bvh;
    const std::vector<Subtree> subtrees = build_binary(items, costs, threads, cancel);
    if (subtrees.empty()) return bvh;
    bvh.bounds = subtrees[0].tree[0].box;
    bvh.nodes = make_wide(subtrees, threads);
    return bvh;
}

}  // namespace glint
