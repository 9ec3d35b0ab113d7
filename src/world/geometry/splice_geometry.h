// SPDX-License-Identifier: Apache-2.0
#pragma once
// Takes shapes out of a packed geometry and puts others in, without building its hierarchy again.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/huge_pages.h"
#include "bvh/rays.h"
#include "glint/scene.h"
#include "world/geometry/packed_geometry.h"

namespace glint {

/// Slots that have kept their values: `count` of them, from `from` in the old geometry to `to` in the new
/// one.
struct SlotRun {
    std::uint32_t from = 0, to = 0, count = 0;
};

struct SplicedGeometry {
    PackedGeometry geometry;
    std::vector<SlotRun> runs;
    std::vector<std::uint32_t> added;  // the slots of the shapes that were put in

    /// An array by slot, padded, of the first `slots` ones, with `each` values a slot. Zeros for the shapes
    /// that were put in.
    template <class T>
    std::vector<T> move_slots(const std::vector<T>& old, std::size_t slots, std::size_t each = 1) const {
        std::vector<T> values;
        resize_in_huge_pages(values, (slots + k_ray_padding) * each);
        for (const SlotRun& run : runs)
            if (run.to < slots)
                std::copy_n(old.data() + run.from * each, run.count * each, &values[run.to * each]);
        return values;
    }
};

/// removed: indices of the shapes in the old scene; added: in `scene`; both sorted, without repetitions. The
/// others must be the same, in the same order. Nothing if the geometry must be built again: for polygons and
/// meshes that are put in, if there are solids, if no bounded shape is left or was there, and if the
/// hierarchy would become too deep.
std::optional<SplicedGeometry> splice_geometry(const PackedGeometry& old, const Scene& scene, bool cones,
                                               std::span<const std::uint32_t> removed,
                                               std::span<const std::uint32_t> added);

}  // namespace glint
