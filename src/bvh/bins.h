// SPDX-License-Identifier: Apache-2.0
#pragma once
// Bins of items along the three axes, and the best split (Wald 2007).
#include <array>
#include <cstdint>
#include <span>

#include "bvh/bvh.h"
#include "bvh/float4.h"

namespace glint {

inline constexpr int k_bins = 16;  // maximum per axis

/// Items [first, first + count), their bounds and the bounds of their centroids.
struct ItemRange {
    std::uint32_t first = 0, count = 0;
    Box4 box, centroids;
};

inline Float4 centroid(const BvhItem& item) { return load3(item.lo) * 0.5f + load3(item.hi) * 0.5f; }

/// The bin of a centroid, for each axis.
struct Binning {
    Float4 lo, scale;
    int bins;

    explicit Binning(const ItemRange& range);
    Int4 bin(Float4 c) const { return __builtin_convertvector((c - lo) * scale, Int4); }
};

/// Items whose bin along `axis` is below `bin` go left. axis < 0: no split is possible.
struct Split {
    int axis = -1, bin = 0;
    Box4 left, right;
};

class Bins {
  public:
    explicit Bins(int bins);
    void add(std::span<const BvhItem> items, const Binning& binning);
    void add(const Bins& other);
    /// The split with the lowest expected cost. area_scale: see half_area().
    Split best_split(float area_scale) const;

  private:
    Box4 box(int axis, int from, int to) const;

    int bins_;
    Box4 box_[3][k_bins];
    std::uint32_t count_[3][k_bins];
};

}  // namespace glint
