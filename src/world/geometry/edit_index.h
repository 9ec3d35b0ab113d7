// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finds a scene's shapes in a geometry, to edit a few of them.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/one_at_a_time.h"
#include "bvh/refit.h"
#include "world/geometry/packed_geometry.h"

namespace glint {

/// Depends on how the geometry was built, but on no box, so it stays valid after edits.
struct EditIndex {
    std::vector<std::uint32_t>
        first;  // by shape: the position of its first entry in `slots`; one more at the end
    std::vector<std::uint32_t> slots;  // sorted by shape, then by element
    BvhLinks links;
    BvhCost built_cost;  // when the hierarchy was built or spliced

    std::span<const std::uint32_t> slots_of(std::uint32_t shape) const {
        return std::span(slots).subspan(first[shape], first[shape + 1] - first[shape]);
    }
    std::size_t bytes() const {
        return sizeof(std::uint32_t) *
               (first.capacity() + slots.capacity() + links.leaf.capacity() + links.parent.capacity());
    }
};

/// For a geometry that has not been refitted.
EditIndex make_edit_index(const PackedGeometry& geometry);

/// The index of a geometry, shared with all its copies. The first edit of any of them makes it.
class SharedEditIndex {
  public:
    /// Can be called from any thread. geometry: not yet refitted.
    std::shared_ptr<const EditIndex> get(const PackedGeometry& geometry);

  private:
    OneAtATime calls_;
    std::shared_ptr<const EditIndex> index_;
};

}  // namespace glint
