// SPDX-License-Identifier: Apache-2.0
#pragma once
// The binary tree from which the wide one is made, and its optimal cut into wide nodes.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/bvh.h"
#include "bvh/float4.h"
#include "glint/callback.h"

namespace glint {

/// The minimum cost of a subtree with at most i roots (wide nodes and leaves), for i = 1 to `roots`.
struct CutCosts {
    std::array<float, k_bvh_width + 4> cost;  // cost[i - 1]; further entries are unused
    int roots = 1;                            // the number of its lowest nodes, at most k_bvh_width
    std::uint32_t item_class = 0;
    static constexpr std::uint32_t k_mixed = ~0u;  // item_class: several classes
};

/// A node of the binary tree. Its children are `left` and left + 1; a lowest node has none.
struct BinaryNode {
    Aabb box;
    std::uint32_t first = 0, count = 0;  // items, in leaf order
    std::uint32_t left = 0;              // 0: none; in a link, the index of its tree
    std::uint8_t roots = 1;              // CutCosts::roots
    std::uint8_t least_split = 0;        // with at least this many roots, the subtree is split
    bool is_leaf = false;                // with one root: a leaf, not a wide node
    bool is_link = false;                // replaced by the first node of another tree
    std::uint64_t left_roots = 0;        // the left child's number of i roots: 4 bits at 4 (i - 1)
    std::uint32_t left_roots_of(int i) const {
        return static_cast<std::uint32_t>(left_roots >> 4 * (i - 1) & 15);
    }
};
using BinaryTree = std::vector<BinaryNode>;

/// A part of the tree that was built on one thread. After condense(), `tree` has only the nodes that a cut
/// above may split, and `nodes` all wide nodes below them; `first` of a node that is no leaf is then its wide
/// node. The wide nodes' children are counted from the first of `nodes`.
struct Subtree {
    BinaryTree tree;
    std::vector<BvhNode> nodes;
};

/// The first tree is the top; its links stand for the other trees, which are condensed. Empty if the build
/// was cancelled.
std::vector<Subtree> build_binary(std::span<BvhItem> items, std::span<const LeafCost> costs, int threads,
                                  CancelFlag cancel);

/// Chooses the optimal cut of the node's subtree from its children's costs. `area`: of the node's box.
void choose_cut(BinaryNode& node, float area, const CutCosts& left, const CutCosts& right,
                std::span<const LeafCost> costs, CutCosts& result);
/// The same for a lowest node with items of the given class.
void choose_cut(BinaryNode& node, float area, std::uint32_t item_class, std::span<const LeafCost> costs,
                CutCosts& result);

/// Replaces most binary nodes of a finished subtree by wide nodes, which take a tenth of their memory.
void condense(Subtree& subtree);

/// The wide nodes that result from the cuts.
std::vector<BvhNode> make_wide(const std::vector<Subtree>& subtrees, int threads);

}  // namespace glint
