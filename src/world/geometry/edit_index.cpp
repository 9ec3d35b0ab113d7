// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/edit_index.h"

#include <algorithm>

#include "base/huge_pages.h"

namespace glint {

double PackedGeometry::expected_built_cost() const {
    if (built_cost > 0) return built_cost;
    return edit_index ? edit_index->built_cost.expected() : find_cost(bvh).expected();
}

EditIndex make_edit_index(const PackedGeometry& geometry) {
    EditIndex index;
    resize_in_huge_pages(index.first, std::size_t{geometry.scene_shapes} + 1);
    for (std::uint32_t slot = 0; slot < geometry.count; ++slot) ++index.first[geometry.shape_index[slot] + 1];
    for (std::size_t i = 0; i < geometry.scene_shapes; ++i) index.first[i + 1] += index.first[i];
    resize_in_huge_pages(index.slots, geometry.count);
    for (std::uint32_t slot = 0; slot < geometry.count; ++slot)
        index.slots[index.first[geometry.shape_index[slot]] + geometry.element_of(slot)] = slot;
    index.links = find_links(geometry.bvh, geometry.bounded);
    index.built_cost = find_cost(geometry.bvh);
    return index;
}

std::shared_ptr<const EditIndex> SharedEditIndex::get(const PackedGeometry& geometry) {
    std::shared_ptr<const EditIndex> index;
    calls_.run([&] {
        if (!index_) index_ = std::make_shared<const EditIndex>(make_edit_index(geometry));
        index = index_;
    });
    return index;
}

}  // namespace glint
