// SPDX-License-Identifier: Apache-2.0
#include "trace/film/light_layers.h"

#include <algorithm>

#include "world/appearance/light_alone.h"

namespace glint {
namespace {

void fill_black(const TileJob& job) {
    for (int y = 0; y < job.height; ++y)
        std::fill_n(job.rgb + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(job.row_pixels),
                    3 * job.width, 0.0f);
}

}  // namespace

LightLayers::LightLayers(const WorldParts& world, const std::vector<Layer>& wanted) {
    for (const Layer layer : wanted)
        if (is_light_layer(layer)) worlds_.push_back(world_of_layer(world, layer));
}

void LightLayers::render_tile(const Kernels& kernels, const TileJob& picture,
                              const std::vector<float*>& values, TileScratch& scratch) const {
    TileJob job = picture;
    job.layers = nullptr;
    // Pixels with the same samples as in the picture: otherwise the sum would differ from it.
    job.same_refinement = true;
    for (std::size_t i = 0; i < worlds_.size(); ++i) {
        job.rgb = values[i];
        if (worlds_[i]) {
            kernels.render_tile(*worlds_[i], job, scratch);
        } else {
            fill_black(job);
        }
    }
}

}  // namespace glint
