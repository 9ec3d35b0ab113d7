// SPDX-License-Identifier: Apache-2.0
#pragma once
// Updates the boxes of a hierarchy after items have moved. The tree itself does not change.
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "bvh/bvh.h"

namespace glint {

/// The parents of items and nodes: child c of node n has the number n k_bvh_width + c.
struct BvhLinks {
    std::vector<std::uint32_t> leaf;    // by item: the number of its leaf
    std::vector<std::uint32_t> parent;  // by node: its number as a child; unused for the root
};
/// For a hierarchy whose leaves refer to items below `items`.
BvhLinks find_links(const Bvh& bvh, std::uint32_t items);
/// Those of nodes alone.
std::vector<std::uint32_t> find_parents(const Bvh& bvh);

Aabb child_box(const BvhNode& node, int c);
void set_child_box(BvhNode& node, int c, const Aabb& box);
/// Half the surface area in double precision; 0 if empty.
double half_area(const Aabb& box);

/// The cost by the surface-area heuristic: the expected number of nodes and leaves that a ray visits if it
/// intersects the root's box. 0 for an empty hierarchy.
struct BvhCost {
    double areas = 0;  // the sum of half the surface areas of all boxes
    double root = 0;   // of the root
    double expected() const { return root > 0 ? areas / root : 0; }
};
BvhCost find_cost(const Bvh& bvh);

/// The bounds of items [first, first + count) of a leaf.
using LeafBounds = std::function<Aabb(std::uint32_t first, std::uint32_t count)>;

/// Sets the box of a child, by its number, and updates all boxes above it.
void refit_child(Bvh& bvh, std::span<const std::uint32_t> parent, std::uint32_t number, const Aabb& box);
/// Updates the boxes above one item whose box has changed. Keeps `cost` up to date.
void refit_item(Bvh& bvh, const BvhLinks& links, std::uint32_t item, const LeafBounds& bounds, BvhCost& cost);
/// Updates all boxes. bounds is called from several threads.
void refit_all(Bvh& bvh, const LeafBounds& bounds, int threads);

}  // namespace glint
