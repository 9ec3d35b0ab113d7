// SPDX-License-Identifier: Apache-2.0
#include "bvh/binary_tree.h"
#include "bvh/bvh.h"

namespace glint {

Bvh build_bvh(std::vector<BvhItem>& items, std::span<const LeafCost> costs, int threads, CancelFlag cancel) {
    Bvh bvh;
    if (items.empty()) return bvh;
    const std::vector<BinaryTree> trees = build_binary(items, costs, threads, cancel);
    if (trees.empty()) return bvh;
    bvh.bounds = trees[0][0].box;
    bvh.nodes = make_wide(trees, threads);
    return bvh;
}

}  // namespace glint
