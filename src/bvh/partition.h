// SPDX-License-Identifier: Apache-2.0
#pragma once
// Partitions a range of items in place, on several threads.
#include <span>

#include "bvh/bins.h"

namespace glint {

/// The two ranges of a split; reorders the items. The order does not depend on threads. Neither range is
/// empty.
struct SplitRanges {
    ItemRange left, right;
};
SplitRanges partition(std::span<BvhItem> items, const ItemRange& range, const Binning& binning,
                      const Split& split, int threads);

/// Two halves of the range, in the present order.
SplitRanges halve(std::span<const BvhItem> items, const ItemRange& range);

/// The items of the first item's class, and all others.
SplitRanges partition_by_class(std::span<BvhItem> items, const ItemRange& range);

/// Items per chunk; larger ranges are partitioned in chunks of this size for any number of threads.
inline constexpr std::size_t k_chunk = 16384;

}  // namespace glint
