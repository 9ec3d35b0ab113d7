// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene that is rendered many times, each time with another fault.
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "compare/pixel_grid.h"
#include "glint/compare.h"
#include "glint/world.h"
#include "world/tracer_fault.h"

namespace glint {

struct RenderedScene {
    Image image;
    BytePicture bytes;
};

/// A sphere with another centre or radius.
struct SphereChange {
    std::uint32_t shape = 0;  ///< into Scene::shapes
    Vec3 by{0, 0, 0};
    double radius_factor = 1;
};

/// What faults change: a scene whose shapes are ignored, its spheres, its other shapes, and the kernels.
struct FaultyScene {
    Scene shading;
    std::vector<SphereChange> spheres = {};
    std::vector<std::uint32_t> missing = {};     ///< into Scene::shapes: not drawn
    std::vector<void (*)(Scene&)> reshape = {};  ///< changes of a scene with shapes
    TracerFault fault = TracerFault::none;

    /// Whether a scene with these shapes, all of them and unchanged, has all faults.
    bool has_all_in_shading() const {
        return spheres.empty() && missing.empty() && reshape.empty() && fault == TracerFault::none;
    }
};

/// Puts a fault into a scene.
using FaultEdit = std::function<void(FaultyScene&)>;
using RenderFaulty = std::function<std::optional<Image>(const FaultyScene&)>;
/// The picture of a scene with a fault.
using MakePicture = std::function<std::optional<Image>(const FaultyScene&, const RenderFaulty&)>;

class SceneRenderer {
  public:
    /// The scene at this size. Throws bad_alloc.
    SceneRenderer(const Scene& scene, std::int32_t width, std::int32_t height, const CauseOptions& options);

    bool is_prepared() const { return world_.has_value(); }
    /// The scene without its shapes, each of which had a material.
    const FaultyScene& scene() const { return scene_; }
    /// With its shapes; nothing if they are too many to be moved.
    const std::optional<Scene>& with_shapes() const { return with_shapes_; }
    const World& world() const { return *world_; }
    /// Nothing if it cannot be rendered, or the search was cancelled.
    std::optional<RenderedScene> render(const FaultyScene& faulty, const PixelGrid& grid) const;
    /// background_pixels() of these pixels. Not for several threads at once.
    const std::vector<bool>& background(const PixelGrid& grid) const;
    bool is_cancelled() const;
    int threads() const { return options_.threads; }
    /// The rule by which a rendered picture becomes the bytes that are compared.
    ByteRule rule(const Scene& scene) const;

  private:
    FaultyScene scene_;
    std::optional<Scene> with_shapes_;
    std::optional<World> world_;
    const CauseOptions& options_;
    mutable std::map<std::int32_t, std::vector<bool>> backgrounds_;  // by the step of the grid
};

}  // namespace glint
