// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scene to World: geometry, which takes time to build and is shared, and shading, which can be replaced in
// microseconds.
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "glint/callback.h"
#include "glint/export.h"
#include "glint/result.h"
#include "glint/scene.h"

namespace glint {

struct WorldParts;

/// A Scene prepared for tracing: its geometry (packed shapes and the hierarchy over them), materials, lights,
/// background, camera, conventions and settings. A World does not refer to the Scene it was made from.
///
/// It is a value. Copies share their parts, so that copying costs as much as copying a shared_ptr. Changes to
/// a World do not affect its copies, and any number of threads may render a copy while the original changes.
class World {
  public:
    /// A World without shapes and lights, with default settings; also the state after a move.
    World() = default;
    GLINT_API World(const World& other) noexcept;
    World(World&& other) noexcept : parts_(std::exchange(other.parts_, nullptr)) {}
    World& operator=(World other) noexcept {
        std::swap(parts_, other.parts_);
        return *this;
    }
    GLINT_API ~World();

    /// For use in the library; WorldParts is defined in a header that is not installed.
    GLINT_API const WorldParts& parts() const;

  private:
    friend class WorldAccess;
    struct Shared;
    Shared* parts_ = nullptr;  // counts the Worlds that refer to it
};

struct PrepareOptions {
    int threads = 0;  ///< 0: one per processor
    /// Called on the calling thread, at intervals, with the fraction done (0 to 1). Must not throw.
    Function<void(double)> progress = {};
    CancelFlag cancel = {};  ///< checked at intervals
};

/// Validates and prepares the scene. The diagnostics are those of validate(). Never throws.
GLINT_API Result<World> prepare(const Scene& scene, const PrepareOptions& options = {});

// The same World with one part replaced. Each function validates only its arguments, shares all
// other parts with `world`, and gives the same bits as prepare() for the changed scene. Never
// throw.

/// Replaces the lights: all of Scene::lights, ambient ones included.
GLINT_API Result<World> with_lights(const World& world, std::span<const Light> lights);
GLINT_API Result<World> with_camera(const World& world, const Camera& camera);
GLINT_API Result<World> with_background(const World& world, Color background);
GLINT_API Result<World> with_fog(const World& world, const std::optional<Fog>& fog);
GLINT_API Result<World> with_gradient(const World& world, const std::optional<BackgroundGradient>& gradient);
GLINT_API Result<World> with_occlusion(const World& world, const std::optional<Occlusion>& occlusion);
/// Replaces conventions and settings, and prepares the camera again, which depends on the picture's aspect
/// ratio. An error if `cones` differs and the scene has cones: the geometry contains them or not, which needs
/// prepare().
GLINT_API Result<World> with_rules(const World& world, const Conventions& conventions,
                                   const RenderSettings& settings);
/// Replaces material `index` of the scene.
GLINT_API Result<World> with_material(const World& world, std::uint32_t index, const Material& material);
/// Replaces all materials of the scene. There must be at least as many as the shapes refer to. If their
/// number differs from before, this takes a pass over all shapes.
GLINT_API Result<World> with_materials(const World& world, std::span<const Material> materials);

/// Replaces the colors of all shapes, as Scene::shape_colors; an error if there are more colors than
/// shapes. Takes a pass over all shapes.
GLINT_API Result<World> with_shape_colors(const World& world, std::span<const ShapeColor> colors);

// Changes to shapes. They are made in place if no other World shares the geometry. Otherwise the geometry is
// copied first, which takes milliseconds for a million shapes, and the other Worlds keep the old one. After
// an error `world` is unchanged. Never throw.

/// Assigns a material to shapes. shapes: indices in Scene::shapes; material: the index in Scene::materials,
/// or k_none.
GLINT_API Status assign_material(World& world, std::span<const std::uint32_t> shapes, std::uint32_t material);

/// What edit_shapes() or splice_shapes() did to the hierarchy. none: nothing, because no shape was given.
/// refitted: updated the boxes of its nodes. rebuilt: built a new one. spliced: put shapes in and took others
/// out.
enum class ShapeEdit : std::uint8_t { none, refitted, rebuilt, spliced };

/// Updates the parameters, transforms, materials and colors of shapes from `scene`. changed: their indices
/// in Scene::shapes. All other shapes must be those of the World; other parts of the scene are not read. The
/// hierarchy is refitted. It is rebuilt if a shape's kind changes, or whether it has a transform, or the
/// number of a polygon's triangles; if the number of shapes differs, in which case all shapes are taken from
/// the scene; and if the expected cost of a ray (surface-area heuristic) exceeds k_max_refit_cost times its
/// value after the build. Pictures have the same bits either way. The first edit of a World makes an index of
/// its shapes.
GLINT_API Result<ShapeEdit> edit_shapes(World& world, const Scene& scene,
                                        std::span<const std::uint32_t> changed,
                                        const PrepareOptions& options = {});
inline constexpr double k_max_refit_cost = 1.5;

/// Takes shapes out of the World and puts others in. removed: their indices in Scene::shapes before; added:
/// in `scene`. All other shapes must be those of the World, in the same order, and keep their materials;
/// other parts of the scene are not read. The packed shapes are copied, and few leaves of the hierarchy
/// change. It is rebuilt, and all shapes are taken from the scene, if more than 1 of 8 shapes change; for
/// polygons and meshes that are put in; and as by edit_shapes() if the expected cost becomes too high.
/// Pictures have the same bits either way. An error if the numbers of shapes do not fit.
GLINT_API Result<ShapeEdit> splice_shapes(World& world, const Scene& scene,
                                          std::span<const std::uint32_t> removed,
                                          std::span<const std::uint32_t> added,
                                          const PrepareOptions& options = {});

/// Points origin + t direction for t_min < t < t_max.
struct Ray {
    Vec3 origin, direction;                          ///< any length except 0; it scales t
    double t_min = 0, t_max = __builtin_huge_val();  // infinity, without <limits>
};

struct RayHit {
    double t = 0;                  ///< of the hit; t_max if there is none
    std::uint32_t shape = k_none;  ///< the index in Scene::shapes; k_none if there is no hit
    Vec3 normal{0, 0, 0};          ///< the shape's own unit normal, regardless of the convention `facing`
};

/// The nearest hit of each ray; of shapes hit at the same t, the first in the scene. A ray with a NaN in its
/// origin or direction hits nothing. threads: 0: one per processor. Never throws.
GLINT_API Result<std::vector<RayHit>> nearest_hits(const World& world, std::span<const Ray> rays,
                                                   int threads = 0);
/// Whether each ray hits a shape that casts shadows by the World's conventions: 1 or 0. Never throws.
GLINT_API Result<std::vector<std::uint8_t>> occluded(const World& world, std::span<const Ray> rays,
                                                     int threads = 0);

/// The memory of a prepared World in bytes, by part.
struct WorldMemory {
    std::size_t shapes = 0;     ///< the shapes' parameters
    std::size_t boxes = 0;      ///< the bounds of single shapes
    std::size_t indices = 0;    ///< indices of shapes and materials
    std::size_t hierarchy = 0;  ///< the nodes over the boxes
    std::size_t colors = 0;     ///< the colors of shapes that have their own
    std::size_t materials = 0;  ///< and lights
    std::size_t packed = 0;     ///< the number of packed shapes; each triangle of a polygon counts
    std::size_t total() const { return shapes + boxes + indices + hierarchy + colors + materials; }
    /// Bytes per packed shape, including its part of the hierarchy; 0 if there are none.
    double each() const {
        return packed == 0 ? 0 : static_cast<double>(total() - materials) / static_cast<double>(packed);
    }
};
GLINT_API WorldMemory memory_usage(const World& world);

/// The bounds of all bounded shapes; min > max if there are none. Planes, and quadrics, quartics and solids
/// without ends are not bounded.
struct Bounds {
    Vec3 min, max;
};
GLINT_API Bounds scene_bounds(const World& world);

}  // namespace glint
