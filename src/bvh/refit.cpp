// SPDX-License-Identifier: Apache-2.0
#include "bvh/refit.h"

#include <algorithm>

#include "base/huge_pages.h"
#include "base/parallel_for.h"

namespace glint {
namespace {

constexpr std::size_t k_nodes_a_task = 256;

// Unused children have empty boxes.
Aabb node_box(const BvhNode& node) {
    Aabb box;
    for (int a = 0; a < 3; ++a) {
        box.lo[a] = *std::min_element(node.lo[a], node.lo[a] + k_bvh_width);
        box.hi[a] = *std::max_element(node.hi[a], node.hi[a] + k_bvh_width);
    }
    return box;
}

bool same(const Aabb& a, const Aabb& b) {
    return std::equal(a.lo, a.lo + 3, b.lo) && std::equal(a.hi, a.hi + 3, b.hi);
}

// Calls visit(first node, last node) for chunks of the nodes.
template <class Visit> void for_nodes(std::size_t count, int threads, const Visit& visit) {
    parallel_for((count + k_nodes_a_task - 1) / k_nodes_a_task, threads, [&](std::size_t task) {
        visit(task * k_nodes_a_task, std::min(count, (task + 1) * k_nodes_a_task));
    });
}

}  // namespace

double half_area(const Aabb& b) {
    if (b.empty()) return 0;
    const double x = static_cast<double>(b.hi[0]) - b.lo[0], y = static_cast<double>(b.hi[1]) - b.lo[1],
                 z = static_cast<double>(b.hi[2]) - b.lo[2];
    return x * y + y * z + z * x;
}

Aabb child_box(const BvhNode& node, int c) {
    return {{node.lo[0][c], node.lo[1][c], node.lo[2][c]}, {node.hi[0][c], node.hi[1][c], node.hi[2][c]}};
}

void set_child_box(BvhNode& node, int c, const Aabb& box) {
    for (int a = 0; a < 3; ++a) node.lo[a][c] = box.lo[a], node.hi[a][c] = box.hi[a];
}

std::vector<std::uint32_t> find_parents(const Bvh& bvh) {
    std::vector<std::uint32_t> parents(bvh.nodes.size());
    for (std::uint32_t n = 0; n < bvh.nodes.size(); ++n) {
        for (std::uint32_t c = 0; c < k_bvh_width; ++c) {
            const BvhChild child = bvh.nodes[n].child[c];
            if (!child.is_none() && !child.is_leaf()) parents[child.index()] = n * k_bvh_width + c;
        }
    }
    return parents;
}

BvhLinks find_links(const Bvh& bvh, std::uint32_t items) {
    BvhLinks links;
    resize_in_huge_pages(links.leaf, items);
    links.parent.resize(bvh.nodes.size());
    for (std::size_t n = 0; n < bvh.nodes.size(); ++n) {
        for (int c = 0; c < k_bvh_width; ++c) {
            const BvhChild child = bvh.nodes[n].child[c];
            const std::uint32_t number =
                static_cast<std::uint32_t>(n) * k_bvh_width + static_cast<std::uint32_t>(c);
            if (child.is_none()) continue;
            if (child.is_leaf()) {
                std::fill_n(links.leaf.begin() + child.first(), child.count(), number);
            } else {
                links.parent[child.index()] = number;
            }
        }
    }
    return links;
}

BvhCost find_cost(const Bvh& bvh) {
    BvhCost cost;
    for (const BvhNode& node : bvh.nodes) {
        for (int c = 0; c < k_bvh_width; ++c) cost.areas += half_area(child_box(node, c));
    }
    cost.root = half_area(bvh.bounds);
    return cost;
}

void refit_child(Bvh& bvh, std::span<const std::uint32_t> parent, std::uint32_t number, const Aabb& box) {
    for (Aabb next = box;;) {
        const std::uint32_t at = number / k_bvh_width;
        set_child_box(bvh.nodes[at], static_cast<int>(number % k_bvh_width), next);
        next = node_box(bvh.nodes[at]);
        if (at == 0) {
            bvh.bounds = next;
            return;
        }
        number = parent[at];
    }
}

void refit_item(Bvh& bvh, const BvhLinks& links, std::uint32_t item, const LeafBounds& bounds,
                BvhCost& cost) {
    std::uint32_t number = links.leaf[item];
    const BvhChild leaf = bvh.nodes[number / k_bvh_width].child[number % k_bvh_width];
    Aabb box = bounds(leaf.first(), leaf.count());
    for (;;) {
        const std::uint32_t at = number / k_bvh_width;
        BvhNode& node = bvh.nodes[at];
        const auto c = static_cast<int>(number % k_bvh_width);
        const Aabb old = child_box(node, c);
        if (same(old, box)) return;
        set_child_box(node, c, box);
        cost.areas += half_area(box) - half_area(old);
        box = node_box(node);
        if (at == 0) break;
        number = links.parent[at];
    }
    bvh.bounds = box;
    cost.root = half_area(box);
}

void refit_all(Bvh& bvh, const LeafBounds& bounds, int threads) {
    if (bvh.nodes.empty()) return;
    for_nodes(bvh.nodes.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) {
            BvhNode& node = bvh.nodes[n];
            for (int c = 0; c < k_bvh_width; ++c) {
                const BvhChild child = node.child[c];
                if (child.is_leaf()) set_child_box(node, c, bounds(child.first(), child.count()));
            }
        }
    });
    // Children come after their parents.
    for (std::size_t n = bvh.nodes.size(); n-- > 0;) {
        BvhNode& node = bvh.nodes[n];
        for (int c = 0; c < k_bvh_width; ++c) {
            const BvhChild child = node.child[c];
            if (!child.is_none() && !child.is_leaf())
                set_child_box(node, c, node_box(bvh.nodes[child.index()]));
        }
    }
    bvh.bounds = node_box(bvh.nodes[0]);
}

}  // namespace glint
