// SPDX-License-Identifier: Apache-2.0
#pragma once
// The hierarchy: wide nodes over boxes. It stores boxes and leaves, not shapes. A leaf is a range of items
// of one class.
#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

#include "glint/callback.h"
#include "math/aabb.h"

namespace glint {

inline constexpr int k_bvh_width = 16;      // children per node
inline constexpr int k_leaf_size = 16;      // maximum items per leaf
inline constexpr int k_bvh_max_depth = 80;  // guaranteed by the builder
inline constexpr std::uint32_t k_bvh_max_items = 1u << 27;

/// A reference to a node, or to a leaf: items [first, first + count) in leaf order.
struct BvhChild {
    std::uint32_t bits;  // uninitialised by default: a traversal stack has thousands
    static BvhChild none() { return {0}; }
    static BvhChild node(std::uint32_t index) { return {index}; }
    static BvhChild leaf(std::uint32_t first, std::uint32_t count) {
        return {0x80000000u | (count - 1) << 27 | first};
    }
    bool is_none() const { return bits == 0; }
    bool is_leaf() const { return (bits & 0x80000000u) != 0; }
    std::uint32_t index() const { return bits; }
    std::uint32_t first() const { return bits & (k_bvh_max_items - 1); }
    std::uint32_t count() const { return (bits >> 27 & 15u) + 1; }
};
static_assert(k_leaf_size <= 16);

/// The children's boxes by coordinate. An unused child has the index of the root, which is never a child.
struct alignas(64) BvhNode {
    float lo[3][k_bvh_width];
    float hi[3][k_bvh_width];
    BvhChild child[k_bvh_width];
};

struct Bvh {
    std::vector<BvhNode> nodes;  // nodes[0] is the root; empty if there are no items
    Aabb bounds;
};

/// An item as the builder needs it: its box (finite, not empty), the caller's index, and its class.
struct alignas(16) BvhItem {
    float lo[3];
    std::uint32_t item;
    float hi[3];
    std::uint32_t item_class;  // items of different classes never share a leaf
};

/// The cost of intersecting a leaf of n items of one class, relative to the cost of a node:
/// leaf + block ceil(n / lanes) + item n.
struct LeafCost {
    float leaf = 0;
    float block = 1;
    float item = 0;
    int lanes = 8;
    int most = 8;  // maximum items, at most k_leaf_size
};

/// Sorts the items into leaf order and returns the hierarchy over them: a binary tree built with the
/// surface-area heuristic and binning (Wald 2007), cut into wide nodes (Ylitie, Karras and Laine 2017).
/// costs[c] is the cost of class c. The result does not depend on threads. At most k_bvh_max_items items.
/// cancel: checked at intervals; the result of a cancelled build is unusable. Throws std::bad_alloc.
Bvh build_bvh(std::vector<BvhItem>& items, std::span<const LeafCost> costs, int threads,
              CancelFlag cancel = {});

}  // namespace glint
