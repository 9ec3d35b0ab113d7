// SPDX-License-Identifier: Apache-2.0
#include "bvh/splice.h"

#include <utility>

namespace glint {
namespace {

constexpr auto k_most = static_cast<std::uint32_t>(LeafCost{}.most);  // items of a leaf, as when it is built

std::uint32_t number_of(std::uint32_t node, int child) {
    return node * k_bvh_width + static_cast<std::uint32_t>(child);
}

int free_child(const BvhNode& node) {
    for (int c = 0; c < k_bvh_width; ++c)
        if (node.child[c].is_none()) return c;
    return -1;
}

void extend(BvhNode& node, int c, const Aabb& by) {
    Aabb box = child_box(node, c);
    box.add(by);
    set_child_box(node, c, box);
}

// The child whose box grows least, the smaller one of equals; -1: the node has none.
int find_nearest(const BvhNode& node, const Aabb& box) {
    int best = -1;
    double best_growth = 0, best_area = 0;
    for (int c = 0; c < k_bvh_width; ++c) {
        if (node.child[c].is_none()) continue;
        Aabb both = child_box(node, c);
        const double area = half_area(both);
        both.add(box);
        const double growth = half_area(both) - area;
        if (best >= 0 && (growth > best_growth || (growth == best_growth && area >= best_area))) continue;
        best = c, best_growth = growth, best_area = area;
    }
    return best;
}

}  // namespace

BvhSplice::BvhSplice(Bvh& bvh, std::uint32_t items, std::function<std::uint32_t(std::uint32_t)> class_of)
    : bvh_(bvh), items_(items), class_of_(std::move(class_of)), links_(find_links(bvh, items)) {}

BvhSplice::Leaf& BvhSplice::leaf_of(BvhChild child) {
    const auto [at, is_unknown] = leaves_.try_emplace(child.first());
    if (is_unknown) at->second = {class_of_(child.first()), child.first() + child.count(), {}};
    return at->second;
}

void BvhSplice::remove(std::uint32_t item) {
    const std::uint32_t number = links_.leaf[item];
    BvhChild& child = bvh_.nodes[number / k_bvh_width].child[number % k_bvh_width];
    leaf_of(child);
    if (child.count() > 1) {
        child = BvhChild::leaf(child.first(), child.count() - 1);
    } else {
        child = BvhChild::none();
        changed_.push_back(number);
    }
}

bool BvhSplice::add_leaf(std::uint32_t node, int child, const Aabb& box, std::uint32_t item_class,
                         std::uint32_t number) {
    const std::uint32_t first = items_ + new_leaves_;
    if (first >= k_bvh_max_items) return false;
    ++new_leaves_;
    bvh_.nodes[node].child[child] = BvhChild::leaf(first, 1);
    set_child_box(bvh_.nodes[node], child, box);
    leaves_[first] = {item_class, Leaf::k_new, {number}};
    return true;
}

bool BvhSplice::insert(const Aabb& box, std::uint32_t item_class, std::uint32_t number) {
    std::uint32_t at = 0;
    for (int depth = 1; depth < k_bvh_max_depth; ++depth) {
        const int c = find_nearest(bvh_.nodes[at], box);
        if (c < 0) return add_leaf(at, 0, box, item_class, number);
        const BvhChild child = bvh_.nodes[at].child[c];
        if (!child.is_leaf()) {
            extend(bvh_.nodes[at], c, box);
            at = child.index();
            continue;
        }
        Leaf& leaf = leaf_of(child);
        if (leaf.item_class == item_class && child.count() < k_most) {
            bvh_.nodes[at].child[c] = BvhChild::leaf(child.first(), child.count() + 1);
            extend(bvh_.nodes[at], c, box);
            leaf.added.push_back(number);
            return true;
        }
        if (const int free = free_child(bvh_.nodes[at]); free >= 0)
            return add_leaf(at, free, box, item_class, number);
        // A node for this leaf and the new one.
        const auto added = static_cast<std::uint32_t>(bvh_.nodes.size());
        BvhNode& both = bvh_.nodes.emplace_back();
        for (int i = 0; i < k_bvh_width; ++i) {
            set_child_box(both, i, Aabb{});
            both.child[i] = BvhChild::none();
        }
        BvhNode& node = bvh_.nodes[at];
        both.child[0] = child;
        set_child_box(both, 0, child_box(node, c));
        node.child[c] = BvhChild::node(added);
        extend(node, c, box);
        return add_leaf(added, 1, box, item_class, number);
    }
    return false;
}

void BvhSplice::renumber(const std::function<std::uint32_t(std::uint32_t)>& first) {
    std::vector<bool> is_changed(std::size_t{items_} + new_leaves_);
    for (const auto& [old_first, leaf] : leaves_) is_changed[old_first] = true;
    for (std::uint32_t n = 0; n < bvh_.nodes.size(); ++n) {
        for (int c = 0; c < k_bvh_width; ++c) {
            BvhChild& child = bvh_.nodes[n].child[c];
            if (!child.is_leaf()) continue;
            if (is_changed[child.first()]) changed_.push_back(number_of(n, c));
            child = BvhChild::leaf(first(child.first()), child.count());
        }
    }
}

void BvhSplice::refit(const LeafBounds& bounds) {
    const std::vector<std::uint32_t> parents = find_parents(bvh_);
    for (const std::uint32_t number : changed_) {
        const BvhChild child = bvh_.nodes[number / k_bvh_width].child[number % k_bvh_width];
        if (child.is_none()) {
            refit_child(bvh_, parents, number, Aabb{});
        } else if (child.is_leaf()) {  // else a leaf below it is in the list
            refit_child(bvh_, parents, number, bounds(child.first(), child.count()));
        }
    }
}

}  // namespace glint
