// SPDX-License-Identifier: Apache-2.0
#pragma once
// viewable() in pieces, for layers that are not in memory as a whole.
#include <limits>
#include <span>

#include "glint/layers.h"

namespace glint {

class LayerPreview {
  public:
    explicit LayerPreview(Layer layer) : layer_(layer) {}
    /// Whether colors depend on the range of all values: then scan() comes before convert().
    bool needs_scan() const { return layer_ == Layer::depth || layer_ == Layer::position; }
    /// Takes note of the values of some pixels; whole rows.
    void scan(std::span<const float> values);
    /// The colors of some pixels, whole rows: 3 floats a pixel.
    void convert(std::span<const float> values, float* rgb) const;

  private:
    // The smallest and the largest finite value.
    struct Range {
        float least = std::numeric_limits<float>::max(), greatest = std::numeric_limits<float>::lowest();
        void add(float value);
        // Maps the value to 0 to 1.
        float place(float value) const;
    };
    const Layer layer_;
    Range ranges_[3];
};

}  // namespace glint
