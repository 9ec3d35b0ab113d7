// SPDX-License-Identifier: Apache-2.0
#pragma once
// Takes items out of a hierarchy and puts others in, without building it again.
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "bvh/bvh.h"
#include "bvh/refit.h"

namespace glint {

/// All removals come first, then all insertions, renumber() and refit(). Until renumber(), leaves keep the
/// first item that they had, even if it has been removed.
class BvhSplice {
  public:
    /// For a hierarchy over items below `items`, which is not empty. class_of: of an item. It and `bvh` must
    /// outlive this object.
    BvhSplice(Bvh& bvh, std::uint32_t items, std::function<std::uint32_t(std::uint32_t)> class_of);

    void remove(std::uint32_t item);
    /// number: the caller's. false: the hierarchy would become too deep or too large, and is unusable.
    bool insert(const Aabb& box, std::uint32_t item_class, std::uint32_t number);

    /// New items that are in one leaf, in order.
    struct Leaf {
        std::uint32_t item_class = 0;
        std::uint32_t end = k_new;         // of the leaf's old items; k_new: it has none
        std::vector<std::uint32_t> added;  // their numbers
        static constexpr std::uint32_t k_new = 0xffffffff;
    };
    /// The leaves that have changed, by their old first items; those that are new follow.
    const std::map<std::uint32_t, Leaf>& leaves() const { return leaves_; }

    /// first: the new first item of the leaf with an old first item, or of a new leaf.
    void renumber(const std::function<std::uint32_t(std::uint32_t)>& first);
    /// Updates the boxes. bounds: of items by their new numbers.
    void refit(const LeafBounds& bounds);

  private:
    Leaf& leaf_of(BvhChild child);
    bool add_leaf(std::uint32_t node, int child, const Aabb& box, std::uint32_t item_class,
                  std::uint32_t number);

    Bvh& bvh_;
    const std::uint32_t items_;
    const std::function<std::uint32_t(std::uint32_t)> class_of_;
    BvhLinks links_;  // before the first change
    std::map<std::uint32_t, Leaf> leaves_;
    std::uint32_t new_leaves_ = 0;
    std::vector<std::uint32_t> changed_;  // children whose boxes are to be updated
};

}  // namespace glint
