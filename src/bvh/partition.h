// SPDX-License-Identifier: Apache-2.0
#pragma once
// Parting a range of items in two, in place, on several threads.
#include <span>

#include "bvh/bins.h"

namespace glint {

/// The two ranges that the split parts the range into; reorders items. The order does not depend on threads.
/// Neither is empty.
struct SplitRanges {
    ItemRange left, right;
};
SplitRanges partition(std::span<BvhItem> items, const ItemRange& range, const Binning& binning,
                      const Split& split, int threads);

/// The range in two halves as it stands.
SplitRanges halve(std::span<const BvhItem> items, const ItemRange& range);

/// The items of the first one's class, and the others.
SplitRanges partition_by_class(std::span<BvhItem> items, const ItemRange& range);

/// Items in one go; larger ranges are parted in pieces of so many, whatever the number of threads.
inline constexpr std::size_t k_chunk = 16384;

}  // namespace glint
