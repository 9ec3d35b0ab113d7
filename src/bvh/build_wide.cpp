// SPDX-License-Identifier: Apache-2.0
// Cuts the binary tree into wide nodes and leaves with the lowest expected cost (Ylitie, Karras and Laine
// 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", section 3.1).
#include <cstddef>

#include "base/huge_pages.h"
#include "base/parallel_for.h"
#include "bvh/binary_tree.h"

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

struct Reference {
    std::uint32_t tree, node;
};

// Writes wide nodes, depth first. Without a destination it only counts them.
class Writer {
  public:
    Writer(const std::vector<BinaryTree>& trees, BvhNode* to, std::uint32_t next)
        : trees_(trees), to_(to), next_(next) {}

    // Wide nodes of other trees are written by other calls; see links().
    std::uint32_t write(Reference root) {
        const std::uint32_t index = next_++;
        std::array<Reference, k_bvh_width> children;
        int count = 0;
        const BinaryNode& node = at(root);
        if (node.is_leaf) {
            children[count++] = root;  // the top root is always a node
        } else {
            split(root, node.roots, children, count);
        }
        if (to_ != nullptr) fill(to_[index], children, count);
        for (int c = 0; c < count; ++c) {
            const BinaryNode& n = at(children[c]);
            BvhChild child = BvhChild::leaf(n.first, n.count);
            if (!n.is_leaf) {
                if (children[c].tree == root.tree) {
                    child = BvhChild::node(write(children[c]));
                } else {
                    links_.push_back({children[c], index, c});
                }
            }
            if (to_ != nullptr) to_[index].child[c] = child;
        }
        return index;
    }
    std::uint32_t next() const { return next_; }

    struct Link {
        Reference root;
        std::uint32_t parent;
        int child;
    };
    const std::vector<Link>& links() const { return links_; }

  private:
    const BinaryNode& at(Reference r) const { return trees_[r.tree][r.node]; }

    void split(Reference r, int roots, std::array<Reference, k_bvh_width>& children, int& count) const {
        const BinaryNode& n = at(r);
        const int left = static_cast<int>(n.left_roots_of(roots));
        gather({r.tree, n.left}, left, children, count);
        gather({r.tree, n.left + 1}, roots - left, children, count);
    }
    void gather(Reference r, int roots, std::array<Reference, k_bvh_width>& children, int& count) const {
        if (at(r).is_link) r = {at(r).left, 0};
        if (roots < at(r).least_split) {
            children[count++] = r;
        } else {
            split(r, roots, children, count);
        }
    }

    void fill(BvhNode& node, const std::array<Reference, k_bvh_width>& children, int count) const {
        for (int c = 0; c < k_bvh_width; ++c) {
            const Aabb box = c < count ? at(children[c]).box : Aabb{};
            for (int a = 0; a < 3; ++a) {
                node.lo[a][c] = box.lo[a];
                node.hi[a][c] = box.hi[a];
            }
            node.child[c] = BvhChild::none();
        }
    }

    const std::vector<BinaryTree>& trees_;
    BvhNode* to_;
    std::uint32_t next_;
    std::vector<Link> links_;
};

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

std::vector<BvhNode> make_wide(const std::vector<BinaryTree>& trees, int threads) {
    const Reference root{trees[0][0].is_link ? trees[0][0].left : 0, 0};
    Writer top(trees, nullptr, 0);
    top.write(root);
    const auto& links = top.links();
    std::vector<std::uint32_t> start(links.size() + 1);
    parallel_for(links.size(), threads, [&](std::size_t i) {
        Writer counter(trees, nullptr, 0);
        counter.write(links[i].root);
        start[i] = counter.next();
    });
    std::uint32_t next = top.next();
    for (std::uint32_t& s : start) {
        const std::uint32_t count = s;
        s = next;
        next += count;
    }
    std::vector<BvhNode> nodes;
    resize_in_huge_pages(nodes, next);
    Writer(trees, nodes.data(), 0).write(root);
    parallel_for(links.size(), threads, [&](std::size_t i) {
        Writer(trees, nodes.data(), start[i]).write(links[i].root);
        nodes[links[i].parent].child[links[i].child] = BvhChild::node(start[i]);
    });
    return nodes;
}

}  // namespace glint
