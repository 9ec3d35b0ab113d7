// SPDX-License-Identifier: Apache-2.0
// Scene -> World.
#include "base/catch_exceptions.h"
#include "base/fp_environment.h"
#include "scene/mistakes.h"
#include "world/failure.h"
#include "world/pack_shapes.h"
#include "world/prepare_camera.h"
#include "world/shading.h"
#include "world/world.h"

namespace glint {

WorldResult prepare(const Scene& scene, const PrepareOptions& options) {
    WorldResult result;
    const std::string failure = catch_exceptions([&] {
        const DefaultFpEnvironment environment;
        result.diagnostics = validate(scene);
        if (has_errors(result.diagnostics)) return;
        auto geometry = pack_shapes(scene, scene.conventions.cones, options);
        if (!geometry) {
            result.cancelled = true;
            return;
        }
        WorldParts parts;
        parts.slot_material = find_slot_materials(scene, *geometry, scene.materials.size(), options.threads);
        parts.geometry = std::move(*geometry);
        parts.materials = pack_materials(scene.materials);
        PreparedLights lights = prepare_lights(scene.lights);
        parts.lights = std::move(lights.lights);
        parts.ambient = lights.ambient;
        parts.background = scene.background;
        parts.scene_camera = scene.camera;
        parts.camera = prepare_camera(scene.camera, scene.settings);
        parts.conventions = scene.conventions;
        parts.settings = scene.settings;
        result.world = WorldAccess::make(std::move(parts));
        if (options.progress) options.progress(1);
    });
    if (!failure.empty()) {
        result.world.reset();
        result.diagnostics.push_back(failure_diagnostic(failure + " while preparing the scene"));
    }
    return result;
}

}  // namespace glint
