// SPDX-License-Identifier: Apache-2.0
#include "bvh/partition.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/parallel_for.h"

namespace glint {
namespace {

Float4 where(Int4 mask, Float4 yes, Float4 no) {
    return reinterpret_cast<Float4>((reinterpret_cast<Int4>(yes) & mask) |
                                    (reinterpret_cast<Int4>(no) & ~mask));
}

struct ChunkSplit {
    std::size_t left = 0;  // the number of left items
    Box4 left_centroids, right_centroids;
};

// Every item is swapped with the first right one, which avoids a branch that would be mispredicted.
ChunkSplit partition_chunk(std::span<BvhItem> items, const Binning& binning, const Split& split) {
    ChunkSplit ranges;
    const Box4 none;
    std::size_t left = 0;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const BvhItem item = items[i];
        const Float4 c = centroid(item);
        const std::int32_t is_left = binning.bin(c)[split.axis] < split.bin ? -1 : 0;
        const Int4 mask{is_left, is_left, is_left, is_left};
        ranges.left_centroids.add(where(mask, c, none.lo), where(mask, c, none.hi));
        ranges.right_centroids.add(where(mask, none.lo, c), where(mask, none.hi, c));
        items[i] = items[left];
        items[left] = item;
        left -= static_cast<std::size_t>(static_cast<std::ptrdiff_t>(is_left));
    }
    ranges.left = left;
    return ranges;
}

// Ranges of items on the wrong side; the k-th item of one list is swapped with the k-th of the other.
struct Run {
    std::size_t first, count;
};
void exchange(std::span<BvhItem> items, const std::vector<Run>& a, const std::vector<Run>& b,
              std::size_t from, std::size_t to) {
    const auto seek = [](const std::vector<Run>& runs, std::size_t k) {
        std::size_t r = 0;
        while (r < runs.size() && k >= runs[r].count) k -= runs[r++].count;
        return std::pair(r, k);
    };
    auto [run_a, at_a] = seek(a, from);
    auto [run_b, at_b] = seek(b, from);
    while (from < to) {
        const std::size_t n = std::min({to - from, a[run_a].count - at_a, b[run_b].count - at_b});
        const auto first = items.begin() + static_cast<std::ptrdiff_t>(a[run_a].first + at_a);
        std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(n),
                         items.begin() + static_cast<std::ptrdiff_t>(b[run_b].first + at_b));
        from += n;
        if ((at_a += n) == a[run_a].count) ++run_a, at_a = 0;
        if ((at_b += n) == b[run_b].count) ++run_b, at_b = 0;
    }
}

ItemRange bounds_of(std::span<const BvhItem> items, std::uint32_t first, std::uint32_t count) {
    ItemRange range{first, count, {}, {}};
    for (const BvhItem& item : items.subspan(first, count)) {
        range.box.add(load3(item.lo), load3(item.hi));
        const Float4 c = centroid(item);
        range.centroids.add(c, c);
    }
    return range;
}

}  // namespace

SplitRanges partition(std::span<BvhItem> all, const ItemRange& range, const Binning& binning,
                      const Split& split, int threads) {
    const std::span<BvhItem> items = all.subspan(range.first, range.count);
    ChunkSplit whole;
    if (items.size() <= k_chunk) {
        whole = partition_chunk(items, binning, split);
    } else {
        std::vector<ChunkSplit> chunks((items.size() + k_chunk - 1) / k_chunk);
        const auto chunk_size = [&](std::size_t c) { return std::min(k_chunk, items.size() - c * k_chunk); };
        parallel_for(chunks.size(), threads, [&](std::size_t c) {
            chunks[c] = partition_chunk(items.subspan(c * k_chunk, chunk_size(c)), binning, split);
        });
        for (const ChunkSplit& c : chunks) {
            whole.left += c.left;
            whole.left_centroids.add(c.left_centroids);
            whole.right_centroids.add(c.right_centroids);
        }
        // Right items before the border and left items after it: both numbers are equal.
        std::vector<Run> right_runs, left_runs;
        std::size_t misplaced = 0;
        for (std::size_t c = 0; c < chunks.size(); ++c) {
            const std::size_t begin = c * k_chunk, border = begin + chunks[c].left,
                              end = begin + chunk_size(c);
            const std::size_t right_end = std::min(end, whole.left), left_begin = std::max(begin, whole.left);
            if (border < right_end) {
                right_runs.push_back({border, right_end - border});
                misplaced += right_end - border;
            }
            if (left_begin < border) left_runs.push_back({left_begin, border - left_begin});
        }
        parallel_for((misplaced + k_chunk - 1) / k_chunk, threads, [&](std::size_t c) {
            exchange(items, right_runs, left_runs, c * k_chunk, std::min(misplaced, (c + 1) * k_chunk));
        });
    }
    const auto left = static_cast<std::uint32_t>(whole.left);
    return {{range.first, left, split.left, whole.left_centroids},
            {range.first + left, range.count - left, split.right, whole.right_centroids}};
}

SplitRanges halve(std::span<const BvhItem> items, const ItemRange& range) {
    const std::uint32_t left = range.count / 2;
    return {bounds_of(items, range.first, left), bounds_of(items, range.first + left, range.count - left)};
}

SplitRanges partition_by_class(std::span<BvhItem> items, const ItemRange& range) {
    const auto begin = items.begin() + range.first;
    const std::uint32_t item_class = begin->item_class;
    const auto middle = std::stable_partition(
        begin, begin + range.count, [&](const BvhItem& item) { return item.item_class == item_class; });
    const auto left = static_cast<std::uint32_t>(middle - begin);
    return {bounds_of(items, range.first, left), bounds_of(items, range.first + left, range.count - left)};
}

}  // namespace glint
