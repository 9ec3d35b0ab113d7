// SPDX-License-Identifier: Apache-2.0
#pragma once
// Curves of channel values, for all pixels of a picture.
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "image/quantize.h"

namespace glint {

inline std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(quantize(value, 255)); }

/// The bytes of a monotonic curve from [0, 1]. Where those at both ends of an interval are equal, so are all
/// between them; then the curve need not be computed.
class ByteCurve {
  public:
    /// Throws bad_alloc.
    explicit ByteCurve(std::function<double(double)> curve) : curve_(std::move(curve)) {
        for (int i = 0; i <= k_intervals; ++i)
            at_ends_.push_back(to_byte(curve_(static_cast<double>(i) / k_intervals)));
    }

    /// The byte of curve(v), v clamped to 0 to 1.
    std::uint8_t operator()(double v) const {
        if (v <= 0) return at_ends_.front();
        if (v >= 1) return at_ends_.back();
        if (std::isnan(v)) return to_byte(curve_(v));
        const auto i = static_cast<std::size_t>(v * k_intervals);
        return at_ends_[i] == at_ends_[i + 1] ? at_ends_[i] : to_byte(curve_(v));
    }

  private:
    static constexpr int k_intervals = 4096;

    std::function<double(double)> curve_;
    std::vector<std::uint8_t> at_ends_;
};

}  // namespace glint
