// SPDX-License-Identifier: Apache-2.0
#include "bvh/bins.h"

namespace glint {

namespace {

// Few items get few bins, because the sweep over the bins would otherwise cost more than the items.
int bins_for(std::uint32_t count) { return count <= 8 ? 6 : count <= 64 ? 8 : k_bins; }

// Smaller ranges of centroids count as one point, because their reciprocal would not be finite.
constexpr float k_min_size = 1e-36f;

}  // namespace

Binning::Binning(const ItemRange& range) : lo(range.centroids.lo), scale{}, bins(bins_for(range.count)) {
    const Float4 size = range.centroids.hi - range.centroids.lo;
    // Slightly less than the number of bins, so that the last centroid falls into the last bin.
    for (int a = 0; a < 3; ++a)
        scale[a] = size[a] > k_min_size ? static_cast<float>(bins) * (1 - 0x1p-20f) / size[a] : 0;
}

Bins::Bins(int bins) : bins_(bins) {
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < bins; ++b) {
            box_[a][b] = Box4{};
            count_[a][b] = 0;
        }
    }
}

void Bins::add(std::span<const BvhItem> items, const Binning& binning) {
    for (const BvhItem& item : items) {
        const Float4 lo = load3(item.lo), hi = load3(item.hi);
        const Int4 bin = binning.bin(lo * 0.5f + hi * 0.5f);
        for (int a = 0; a < 3; ++a) {
            box_[a][bin[a]].add(lo, hi);
            ++count_[a][bin[a]];
        }
    }
}

void Bins::add(const Bins& other) {
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < bins_; ++b) {
            box_[a][b].add(other.box_[a][b]);
            count_[a][b] += other.count_[a][b];
        }
    }
}

Split Bins::best_split(float area_scale) const {
    Split best;
    float best_cost = 0;
    for (int axis = 0; axis < 3; ++axis) {
        std::array<float, k_bins> right_cost;
        Box4 grown;
        std::uint32_t items = 0;
        for (int b = bins_ - 1; b > 0; --b) {
            grown.add(box_[axis][b]);
            items += count_[axis][b];
            right_cost[b] = items == 0 ? 0 : half_area(grown, area_scale) * static_cast<float>(items);
        }
        const std::uint32_t all = items + count_[axis][0];
        if (items == 0) continue;  // all items are in one bin
        grown = Box4{};
        items = 0;
        for (int b = 1; b < bins_; ++b) {
            grown.add(box_[axis][b - 1]);
            items += count_[axis][b - 1];
            if (items == 0) continue;
            if (items == all) break;
            const float cost = half_area(grown, area_scale) * static_cast<float>(items) + right_cost[b];
            if (best.axis >= 0 && cost >= best_cost) continue;
            best.axis = axis;
            best.bin = b;
            best_cost = cost;
        }
    }
    if (best.axis >= 0) {
        best.left = box(best.axis, 0, best.bin);
        best.right = box(best.axis, best.bin, bins_);
    }
    return best;
}

Box4 Bins::box(int axis, int from, int to) const {
    Box4 all;
    for (int b = from; b < to; ++b) all.add(box_[axis][b]);
    return all;
}

}  // namespace glint
