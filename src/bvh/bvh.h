#pragma once
// The hierarchy: wide nodes over boxes. It knows boxes and leaves, not shapes. A leaf is a run of items of one class.
#include <cstdint>
#include <span>
#include <vector>

#include "math/aabb.h"

namespace glint {

inline constexpr int k_bvh_width = 16;      // children a node
inline constexpr int k_leaf_size = 8;       // items a leaf, at most
inline constexpr int k_bvh_max_depth = 80;  // the builder keeps to it
inline constexpr std::uint32_t k_bvh_max_items = 1u << 27;

/// A reference to a node, or to a leaf: items [first, first + count) of Bvh::order.
struct BvhChild {
    std::uint32_t bits = 0;
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

/// The children's boxes by coordinate. An unused child refers to the root, which is nobody's child.
struct alignas(64) BvhNode {
    float lo[3][k_bvh_width];
    float hi[3][k_bvh_width];
    BvhChild child[k_bvh_width];
};

struct Bvh {
    std::vector<BvhNode> nodes;        // nodes[0] is the root; empty if there are no items
    std::vector<std::uint32_t> order;  // leaf order -> item; items of one class are together within a leaf
    Aabb bounds;
};

/// Builds by the surface-area heuristic over binned centroids (Wald 2007), then joins binary nodes into wide ones.
/// boxes are not empty and finite; item_class[i] (any number) separates items that may not share a leaf.
/// The result does not depend on threads. At most k_bvh_max_items items. Throws std::bad_alloc.
Bvh build_bvh(std::span<const Aabb> boxes, std::span<const std::uint8_t> item_class, int threads);

}  // namespace glint
