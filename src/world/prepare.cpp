// SPDX-License-Identifier: Apache-2.0
// Scene to World.
#include "world/prepare.h"

#include "base/fp_environment.h"
#include "base/status.h"
#include "world/appearance/interiors.h"
#include "world/appearance/prepare_sky.h"
#include "world/appearance/shading.h"
#include "world/geometry/pack_shapes.h"
#include "world/prepare_camera.h"
#include "world/world.h"

namespace glint {
namespace {

// Of a scene without errors. diagnostics: its warnings.
Result<World> prepare_valid(const Scene& scene, std::vector<Diagnostic> diagnostics,
                            const PrepareOptions& options) {
    auto geometry = pack_shapes(scene, scene.conventions.cones, options);
    if (!geometry) return cancelled();
    WorldParts parts;
    parts.slot_material = find_slot_materials(scene, *geometry, scene.materials.size(), options.threads);
    parts.geometry = std::move(*geometry);
    parts.materials = pack_materials(scene.materials);
    parts.no_shadow = find_no_shadow(scene.materials);
    ExtendedMaterials extended = pack_extended_materials(scene.materials);
    parts.extended = std::move(extended.table);
    parts.extended_uses = extended.uses;
    parts.textures = prepare_textures(scene.textures);
    set_texture_uses(parts);
    set_colors(parts, scene.shape_colors, options.threads);
    set_lights(prepare_lights(scene.lights), parts);
    parts.background = scene.background;
    set_fog(parts, scene.fog);
    set_gradient(scene.gradient, parts);
    set_occlusion(scene.occlusion, parts);
    parts.scene_camera = scene.camera;
    parts.camera = prepare_camera(scene.camera, scene.settings);
    parts.conventions = scene.conventions;
    parts.settings = scene.settings;
    set_interiors(parts);
    Result<World> result(WorldAccess::make(std::move(parts)), std::move(diagnostics));
    if (options.progress) options.progress(1);
    return result;
}

constexpr const char* k_while = " while preparing the scene";

}  // namespace

Result<World> prepare(const Scene& scene, const PrepareOptions& options) {
    const auto body = [&]() -> Result<World> {
        const DefaultFpEnvironment environment;
        std::vector<Diagnostic> diagnostics = validate(scene);
        if (has_errors(diagnostics)) return invalid_scene(std::move(diagnostics));
        return prepare_valid(scene, std::move(diagnostics), options);
    };
    return result_of(body, k_while);
}

Result<World> prepare(const ValidatedScene& scene, const PrepareOptions& options) {
    const auto body = [&] {
        const DefaultFpEnvironment environment;
        return prepare_valid(*scene, scene.warnings(), options);
    };
    return result_of(body, k_while);
}

}  // namespace glint
