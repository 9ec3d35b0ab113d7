#pragma once
// Scene -> World -> Image.
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glint/diagnostic.h"
#include "glint/export.h"
#include "glint/image.h"
#include "glint/layers.h"
#include "glint/scene.h"

namespace glint {

/// A scene prepared for tracing: shapes packed by kind, the hierarchy over them, materials, lights, camera.
/// Immutable; any number of threads may render from it. It does not refer to the Scene it was made from.
class World;

struct WorldDeleter {
    GLINT_API void operator()(const World* world) const;
};
using WorldPtr = std::unique_ptr<const World, WorldDeleter>;

struct PrepareResult {
    WorldPtr world;                       ///< null if the scene has errors or memory ran out
    std::vector<Diagnostic> diagnostics;  ///< what validate() says
};

/// Validates and prepares. threads: 0 = one a processor. Never throws.
GLINT_API PrepareResult prepare(const Scene& scene, int threads = 0);

/// Bytes of a prepared World, by part.
struct WorldMemory {
    std::size_t shapes = 0;     ///< the shapes' parameters
    std::size_t boxes = 0;      ///< the shapes' own boxes
    std::size_t indices = 0;    ///< which shape of the scene it is, and its material
    std::size_t hierarchy = 0;  ///< the nodes over the boxes
    std::size_t materials = 0;  ///< and lights
    std::size_t packed = 0;     ///< how many shapes these are: the scene's, polygons as their triangles
    std::size_t total() const { return shapes + boxes + indices + hierarchy + materials; }
    /// Bytes of a packed shape, its part of the hierarchy included; 0 if there are none.
    double each() const {
        return packed == 0 ? 0 : static_cast<double>(total() - materials) / static_cast<double>(packed);
    }
};
GLINT_API WorldMemory memory(const World& world);

/// The box around all bounded shapes; min > max if there are none.
struct Bounds {
    Vec3 min, max;
};
GLINT_API Bounds bounds(const World& world);

struct RayCounts {
    std::uint64_t camera = 0, shadow = 0, mirror = 0, transmitted = 0;
    std::uint64_t cut = 0;  ///< mirror and glass rays beyond k_max_sample_rays, which were not traced
    std::uint64_t total() const { return camera + shadow + mirror + transmitted; }
};

struct RenderOptions {
    int threads = 0;            ///< 0 = one a processor
    std::string isa;            ///< one of isa_names(); empty: the best
    std::optional<Crop> crop;   ///< only this part of the picture; the Image has the crop's size
    std::vector<Layer> layers;  ///< what else is wanted, each once
    /// Called from any thread, now and then, with the fraction done (0 to 1). Must not throw.
    std::function<void(double)> progress;
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
