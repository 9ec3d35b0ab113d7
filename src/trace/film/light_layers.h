// SPDX-License-Identifier: Apache-2.0
#pragma once
// The layers that show one light, or no light: each tile is rendered once more for each.
#include <optional>
#include <vector>

#include "trace/kernels.h"

namespace glint {

class LightLayers {
  public:
    /// wanted: valid layers, of which those of lights are taken.
    LightLayers(const WorldParts& world, const std::vector<Layer>& wanted);

    /// Renders a tile of each. picture: the job of the picture's tile, which has just been rendered with this
    /// scratch. values: where the layers' tiles are written, like TileJob::rgb.
    void render_tile(const Kernels& kernels, const TileJob& picture, const std::vector<float*>& values,
                     TileScratch& scratch) const;

  private:
    std::vector<std::optional<WorldParts>> worlds_;  // none: the layer is black
};

}  // namespace glint
