// SPDX-License-Identifier: Apache-2.0
#pragma once
// Reads the cuts of the binary tree: which of its nodes are the children of a wide node.
#include <array>
#include <cstdint>
#include <span>

#include "bvh/binary_tree.h"

namespace glint {

/// A binary node.
struct Reference {
    std::uint32_t tree, node;
};

struct Children {
    std::array<Reference, k_bvh_width> at;
    int count = 0;
};

class Cuts {
  public:
    explicit Cuts(std::span<const Subtree> subtrees) : subtrees_(subtrees) {}

    const BinaryNode& at(Reference r) const { return subtrees_[r.tree].tree[r.node]; }

    /// The children of the wide node that a binary node becomes.
    Children children(Reference r) const {
        Children children;
        if (at(r).is_leaf) {
            children.at[0] = r;
            children.count = 1;
        } else {
            split(r, at(r).roots, children);
        }
        return children;
    }

    /// A wide node with these boxes and without children.
    BvhNode wide_node(const Children& children) const {
        BvhNode node;
        for (int c = 0; c < k_bvh_width; ++c) {
            const Aabb box = c < children.count ? at(children.at[c]).box : Aabb{};
            for (int a = 0; a < 3; ++a) {
                node.lo[a][c] = box.lo[a];
                node.hi[a][c] = box.hi[a];
            }
            node.child[c] = BvhChild::none();
        }
        return node;
    }

  private:
    void split(Reference r, int roots, Children& children) const {
        const BinaryNode& n = at(r);
        const int left = static_cast<int>(n.left_roots_of(roots));
        gather({r.tree, n.left}, left, children);
        gather({r.tree, n.left + 1}, roots - left, children);
    }
    void gather(Reference r, int roots, Children& children) const {
        if (at(r).is_link) r = {at(r).left, 0};
        if (roots < at(r).least_split) {
            children.at[children.count++] = r;
        } else {
            split(r, roots, children);
        }
    }

    std::span<const Subtree> subtrees_;
};

}  // namespace glint
