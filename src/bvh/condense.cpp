// SPDX-License-Identifier: Apache-2.0
// Replaces the binary nodes of a finished subtree by wide nodes.
#include <cstddef>
#include <utility>

#include "bvh/cuts.h"

namespace glint {
namespace {

class Condenser {
  public:
    explicit Condenser(const Subtree& subtree)
        : tree_(subtree.tree), cuts_({&subtree, 1}), wide_(tree_.size(), k_none) {}

    Subtree run() {
        keep(0);
        // The cut above may give the subtree any number of roots.
        for (int roots = 1; roots <= tree_[0].roots; ++roots) visit(0, 0, roots);
        return std::move(condensed_);
    }

  private:
    static constexpr std::uint32_t k_none = ~0u;

    void keep(std::uint32_t node) {
        condensed_.tree.push_back(tree_[node]);
        condensed_.tree.back().left = 0;
    }

    // node: of the whole tree; kept: the same one in the condensed tree.
    void visit(std::uint32_t node, std::uint32_t kept, int roots) {
        const BinaryNode& n = tree_[node];
        if (roots < n.least_split) {
            if (!n.is_leaf) condensed_.tree[kept].first = wide(node);
            return;
        }
        if (condensed_.tree[kept].left == 0) {
            condensed_.tree[kept].left = static_cast<std::uint32_t>(condensed_.tree.size());
            keep(n.left);
            keep(n.left + 1);
        }
        const std::uint32_t left = condensed_.tree[kept].left;
        const int left_roots = static_cast<int>(n.left_roots_of(roots));
        visit(n.left, left, left_roots);
        visit(n.left + 1, left + 1, roots - left_roots);
    }

    // The index of the wide node that a binary node becomes, which is the same below any cut.
    std::uint32_t wide(std::uint32_t node) {
        if (wide_[node] != k_none) return wide_[node];
        const auto index = static_cast<std::uint32_t>(condensed_.nodes.size());
        wide_[node] = index;
        const Children children = cuts_.children({0, node});
        condensed_.nodes.push_back(cuts_.wide_node(children));
        for (int c = 0; c < children.count; ++c) {
            const BinaryNode& n = cuts_.at(children.at[c]);
            const BvhChild child =
                n.is_leaf ? BvhChild::leaf(n.first, n.count) : BvhChild::node(wide(children.at[c].node));
            condensed_.nodes[index].child[c] = child;
        }
        return index;
    }

    const BinaryTree& tree_;
    Cuts cuts_;
    Subtree condensed_;
    std::vector<std::uint32_t> wide_;  // by binary node
};

}  // namespace

void condense(Subtree& subtree) { subtree = Condenser(subtree).run(); }

}  // namespace glint
