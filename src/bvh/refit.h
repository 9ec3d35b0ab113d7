// SPDX-License-Identifier: Apache-2.0
#pragma once
// New boxes for a hierarchy whose items have moved. Its nodes and leaves stay what they are.
#include <cstdint>
#include <functional>
#include <vector>

#include "bvh/bvh.h"

namespace glint {

/// Where items and nodes hang: child c of node n is number n k_bvh_width + c.
struct BvhLinks {
    std::vector<std::uint32_t> leaf;    // by item: the child that is its leaf
    std::vector<std::uint32_t> parent;  // by node: the child that it is; the root's means nothing
};
/// Of a hierarchy whose leaves refer to items below `items`.
BvhLinks find_links(const Bvh& bvh, std::uint32_t items);

/// The surface-area heuristic's cost of a ray that meets the hierarchy's box: how many nodes and leaves it
/// meets, as expected. 0 of an empty hierarchy.
struct BvhCost {
    double areas = 0;  // the sum of half the areas of all boxes
    double root = 0;   // the root's
    double expected() const { return root > 0 ? areas / root : 0; }
};
BvhCost find_cost(const Bvh& bvh);

/// The box of an item.
using ItemBox = std::function<Aabb(std::uint32_t item)>;

/// After an item's box has changed: the boxes above it. Keeps `cost` up to date.
void refit_item(Bvh& bvh, const BvhLinks& links, std::uint32_t item, const ItemBox& box, BvhCost& cost);
/// After any boxes have changed: all of them.
void refit_all(Bvh& bvh, const ItemBox& box, int threads);

}  // namespace glint
