// SPDX-License-Identifier: Apache-2.0
#pragma once
// The binary tree that the wide one is made from, and how it is best cut into wide nodes.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/bvh.h"
#include "bvh/float4.h"

namespace glint {

/// The least cost of a subtree given as at most i roots (wide nodes and leaves), for i = 1 to `roots`.
struct CutCosts {
    std::array<float, k_bvh_width + 4> cost;  // cost[i - 1]; the rest is not read for its value
    int roots = 1;                            // its lowest nodes' number, at most k_bvh_width
    std::uint32_t item_class = 0;
    static constexpr std::uint32_t k_mixed = ~0u;  // item_class: several
};

/// A node of the binary tree. Its children are `left` and left + 1; a lowest one has none.
struct BinaryNode {
    Aabb box;
    std::uint32_t first = 0, count = 0;  // items, in leaf order
    std::uint32_t left = 0;              // 0: none. Of a link: the tree it stands for
    std::uint8_t roots = 1;              // CutCosts::roots
    std::uint8_t least_split = 0;        // given that many roots or more, they are spent on the children
    bool is_leaf = false;                // as one root: a leaf or a wide node
    bool is_link = false;                // stands for the first node of another tree
    std::uint64_t left_roots = 0;        // of i roots, how many are the left child's: 4 bits at 4 (i - 1)
    std::uint32_t left_roots_of(int i) const {
        return static_cast<std::uint32_t>(left_roots >> 4 * (i - 1) & 15);
    }
};
using BinaryTree = std::vector<BinaryNode>;

/// The first tree is the top one, whose links stand for the others. None if it was cancelled.
std::vector<BinaryTree> build_binary(std::span<BvhItem> items, std::span<const LeafCost> costs, int threads,
                                     const std::atomic<bool>* cancel);

/// Chooses how the node's subtree is best cut, from its children's costs. `area` is its box's.
void choose_cut(BinaryNode& node, float area, const CutCosts& left, const CutCosts& right,
                std::span<const LeafCost> costs, CutCosts& result);
/// The same for a lowest node, whose items are of the class given.
void choose_cut(BinaryNode& node, float area, std::uint32_t item_class, std::span<const LeafCost> costs,
                CutCosts& result);

/// The wide nodes of the trees so cut.
std::vector<BvhNode> make_wide(const std::vector<BinaryTree>& trees, int threads);

}  // namespace glint
