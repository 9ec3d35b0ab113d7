// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where a scene's shapes are in a geometry, so that a few of them can be edited.
#include <cstdint>
#include <span>
#include <vector>

#include "bvh/refit.h"
#include "world/packed_geometry.h"

namespace glint {

/// It depends on how the geometry was built and on no box: edits leave it valid.
struct EditIndex {
    std::vector<std::uint32_t>
        first;  // by shape: the place in `slots` of its first; one more closes the list
    std::vector<std::uint32_t> slots;  // shape by shape, in the order of its pieces
    BvhLinks links;
    double built_cost = 0;  // BvhCost::expected() when the hierarchy was built

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

}  // namespace glint
