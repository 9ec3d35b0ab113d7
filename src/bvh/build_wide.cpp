// SPDX-License-Identifier: Apache-2.0
// Cuts the binary tree into wide nodes and leaves with the lowest expected cost (Ylitie, Karras and Laine
// 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", section 3.1).
#include <cstddef>

#include "base/huge_pages.h"
#include "base/parallel_for.h"
#include "bvh/cuts.h"

namespace glint {
namespace {

// The penalty of a node with few items, which wastes memory; with a single item it is nearly this much.
constexpr float k_emptiness_cost = 6;

float node_cost(std::uint32_t items) {
    if (items >= k_bvh_width) return 1;
    const float missing = 1 - static_cast<float>(items) / k_bvh_width;
    return 1 + k_emptiness_cost * missing * missing;
}

float leaf_cost(const LeafCost& c, std::uint32_t count) {
    const auto lanes = static_cast<std::uint32_t>(c.lanes);
    const std::uint32_t blocks = (count + lanes - 1) / lanes;
    return c.leaf + c.block * static_cast<float>(blocks) + c.item * static_cast<float>(count);
}

// Writes the wide nodes of the top tree, depth first. Without a destination it only counts them.
class Writer {
  public:
    Writer(const Cuts& cuts, BvhNode* to) : cuts_(cuts), to_(to) {}

    // Those of condensed trees are copied by other calls; see links().
    std::uint32_t write(Reference root) {
        const std::uint32_t index = next_++;
        const Children children = cuts_.children(root);
        if (to_ != nullptr) to_[index] = cuts_.wide_node(children);
        for (int c = 0; c < children.count; ++c) {
            const BinaryNode& n = cuts_.at(children.at[c]);
            BvhChild child = BvhChild::leaf(n.first, n.count);
            if (!n.is_leaf) {
                if (children.at[c].tree == 0) {
                    child = BvhChild::node(write(children.at[c]));
                } else {
                    links_.push_back({children.at[c].tree, n.first, index, c});
                }
            }
            if (to_ != nullptr) to_[index].child[c] = child;
        }
        return index;
    }
    std::uint32_t next() const { return next_; }

    struct Link {
        std::uint32_t tree, wide;  // a wide node of a condensed tree
        std::uint32_t parent;
        int child;
    };
    const std::vector<Link>& links() const { return links_; }

  private:
    const Cuts& cuts_;
    BvhNode* to_;
    std::uint32_t next_ = 0;
    std::vector<Link> links_;
};

// Copies a wide node and all below it, depth first, to to[next] and the following ones; returns its index.
// Without a destination it only counts them.
std::uint32_t copy_nodes(const std::vector<BvhNode>& from, std::uint32_t node, BvhNode* to,
                         std::uint32_t& next) {
    const std::uint32_t index = next++;
    if (to != nullptr) to[index] = from[node];
    for (int c = 0; c < k_bvh_width; ++c) {
        const BvhChild child = from[node].child[c];
        if (child.is_none()) break;
        if (child.is_leaf()) continue;
        const std::uint32_t copied = copy_nodes(from, child.index(), to, next);
        if (to != nullptr) to[index].child[c] = BvhChild::node(copied);
    }
    return index;
}

// Larger than any number of roots: the subtree always becomes one root.
constexpr std::uint8_t k_never_split = k_bvh_width + 1;

}  // namespace

void choose_cut(BinaryNode& node, float area, std::uint32_t item_class, std::span<const LeafCost> costs,
                CutCosts& result) {
    node.roots = 1;
    node.least_split = k_never_split;
    node.is_leaf = true;
    result.roots = 1;
    result.item_class = item_class;
    result.cost[0] = area * leaf_cost(costs[item_class], node.count);
}

void choose_cut(BinaryNode& node, float area, const CutCosts& left, const CutCosts& right,
                std::span<const LeafCost> costs, CutCosts& result) {
    const int roots = left.roots + right.roots < k_bvh_width ? left.roots + right.roots : k_bvh_width;
    std::array<float, k_bvh_width> best;  // [i - 1]: cost of i roots used for the children
    node.left_roots = 0;
    for (int i = 2; i <= roots; ++i) {
        const int from = i - right.roots > 1 ? i - right.roots : 1;
        const int to = i - 1 < left.roots ? i - 1 : left.roots;
        float least = left.cost[from - 1] + right.cost[i - from - 1];
        int least_at = from;
        for (int k = from + 1; k <= to; ++k) {
            const float cost = left.cost[k - 1] + right.cost[i - k - 1];
            if (cost < least) least = cost, least_at = k;
        }
        best[i - 1] = least;
        node.left_roots |= static_cast<std::uint64_t>(least_at) << 4 * (i - 1);
    }
    float one = area * node_cost(node.count) + best[roots - 1];
    node.is_leaf = false;
    result.item_class = left.item_class == right.item_class ? left.item_class : CutCosts::k_mixed;
    if (result.item_class != CutCosts::k_mixed) {
        const LeafCost& c = costs[result.item_class];
        if (node.count <= static_cast<std::uint32_t>(c.most)) {
            const float as_leaf = area * leaf_cost(c, node.count);
            if (as_leaf <= one) one = as_leaf, node.is_leaf = true;
        }
    }
    // best[] does not increase with i, because left's and right's costs do not.
    result.cost[0] = one;
    node.least_split = k_never_split;
    for (int i = 2; i <= roots; ++i) {
        if (best[i - 1] < one && node.least_split == k_never_split)
            node.least_split = static_cast<std::uint8_t>(i);
        result.cost[i - 1] = best[i - 1] < one ? best[i - 1] : one;
    }
    result.roots = roots;
    node.roots = static_cast<std::uint8_t>(roots);
}

std::vector<BvhNode> make_wide(const std::vector<Subtree>& subtrees, int threads) {
    const Cuts cuts(subtrees);
    const BinaryNode& top_root = cuts.at({0, 0});
    const Reference root{top_root.is_link ? top_root.left : 0, 0};
    const bool is_copied = root.tree != 0 && !cuts.at(root).is_leaf;
    Writer top(cuts, nullptr);
    if (!is_copied) top.write(root);
    std::vector<Writer::Link> links = top.links();
    if (is_copied) links.push_back({root.tree, cuts.at(root).first, 0, -1});
    std::vector<std::uint32_t> start(links.size() + 1);
    parallel_for(links.size(), threads, [&](std::size_t i) {
        copy_nodes(subtrees[links[i].tree].nodes, links[i].wide, nullptr, start[i]);
    });
    std::uint32_t next = top.next();
    for (std::uint32_t& s : start) {
        const std::uint32_t count = s;
        s = next;
        next += count;
    }
    std::vector<BvhNode> nodes;
    resize_in_huge_pages(nodes, next, threads);
    if (!is_copied) Writer(cuts, nodes.data()).write(root);
    parallel_for(links.size(), threads, [&](std::size_t i) {
        const Writer::Link& link = links[i];
        if (link.child >= 0) nodes[link.parent].child[link.child] = BvhChild::node(start[i]);
        std::uint32_t at = start[i];
        copy_nodes(subtrees[link.tree].nodes, link.wide, nodes.data(), at);
    });
    return nodes;
}

}  // namespace glint
