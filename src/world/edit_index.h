// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where a scene's shapes are in a geometry, so that a few of them can be edited.
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/one_at_a_time.h"
#include "bvh/refit.h"
#include "world/packed_geometry.h"

namespace glint {

/// It depends on how the geometry was built and on no box: edits leave it valid.
struct EditIndex {
    std::vector<std::uint32_t>
        first;  // by shape: the place in `slots` of its first; one more closes the list
    std::vector<std::uint32_t> slots;  // shape by shape, in the order of its pieces
    BvhLinks links;
    BvhCost built_cost;  // when the hierarchy was built

    std::span<const std::uint32_t> slots_of(std::uint32_t shape) const {
        return std::span(slots).subspan(first[shape], first[shape + 1] - first[shape]);
    }
    std::size_t bytes() const {
        return sizeof(std::uint32_t) *
               (first.capacity() + slots.capacity() + links.leaf.capacity() + links.parent.capacity());
    }
};

/// Of a geometry that was not refitted yet.
EditIndex make_edit_index(const PackedGeometry& geometry);

/// The index that a built geometry and all its copies share, whichever of them is edited first.
class SharedEditIndex {
  public:
    /// From any thread. geometry: not refitted yet.
    std::shared_ptr<const EditIndex> get(const PackedGeometry& geometry);

  private:
    OneAtATime calls_;
    std::shared_ptr<const EditIndex> index_;
};

}  // namespace glint
