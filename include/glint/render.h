// SPDX-License-Identifier: Apache-2.0
#pragma once
// World -> Image.
#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glint/diagnostic.h"
#include "glint/export.h"
#include "glint/image.h"
#include "glint/layers.h"
#include "glint/scene.h"
#include "glint/world.h"

namespace glint {

struct RayCounts {
    std::uint64_t camera = 0, shadow = 0, mirror = 0, transmitted = 0;
    std::uint64_t cut = 0;  ///< mirror and glass rays beyond k_max_sample_rays, which were not traced
    std::uint64_t total() const { return camera + shadow + mirror + transmitted; }
};

struct RenderOptions {
    int threads = 0;                 ///< 0 = one a processor
    std::string isa = {};            ///< one of isa_names(); empty: the best
    std::optional<Crop> crop = {};   ///< only this part of the picture; the Image has the crop's size
    std::vector<Layer> layers = {};  ///< what else is wanted, each once
    /// Called from any thread, now and then, with the fraction done (0 to 1). Must not throw.
    std::function<void(double)> progress = {};
    const std::atomic<bool>* cancel = nullptr;  ///< looked at between tiles
};

struct RenderResult {
    std::optional<Image> image;      ///< absent if cancelled or an error
    std::vector<LayerImage> layers;  ///< in the order of RenderOptions::layers; empty if there is no image
    bool cancelled = false;
    std::string error;  ///< "no such instruction set 'avx9'", "out of memory: ..."; empty if none
    RayCounts rays;
    std::string isa;  ///< what was used
    int threads = 0;
};

/// Draws the picture. The same bits for any threads, instruction set and crop. Never throws.
GLINT_API RenderResult render(const World& world, const RenderOptions& options = {});

/// The instruction sets this machine has and this build knows, best first. x86-64: "avx512", "avx2", "sse4",
/// "scalar"; arm64: "neon", "scalar"; the browser build: "scalar".
GLINT_API std::vector<std::string> isa_names();

}  // namespace glint
