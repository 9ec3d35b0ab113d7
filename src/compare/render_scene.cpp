// SPDX-License-Identifier: Apache-2.0
#include "compare/render_scene.h"

#include <algorithm>

#include "world/world.h"

namespace glint {
namespace {

Result<Rendering> render(const Result<World>& world, int threads, CancelFlag cancel) {
    if (!world) return Status(world);
    RenderOptions options;
    options.threads = threads;
    options.cancel = cancel;
    return render(*world, options);
}

// Of the number and the use of alpha that the World's have.
void set_textures(World& world, const std::vector<Texture>& textures) {
    const std::vector<PreparedTexture>& now = *world.parts().textures;
    if (std::equal(now.begin(), now.end(), textures.begin(), textures.end())) return;
    WorldAccess::own(world).textures = prepare_textures(textures);
}

Result<World> with_shading(const World& world, const Scene& scene) {
    Result<World> changed = with_lights(world, scene.lights);
    if (changed) changed = with_materials(*changed, scene.materials);
    if (changed) changed = with_background(*changed, scene.background);
    if (changed) changed = with_fog(*changed, scene.fog);
    if (changed) changed = with_gradient(*changed, scene.gradient);
    if (changed) changed = with_occlusion(*changed, scene.occlusion);
    if (changed) changed = with_camera(*changed, scene.camera);
    if (changed) changed = with_rules(*changed, scene.conventions, scene.settings);
    if (changed) set_textures(*changed, scene.textures);
    return changed;
}

}  // namespace

Result<Rendering> render_scene(const Scene& scene, int threads, CancelFlag cancel) {
    return render(prepare(scene, {.threads = threads, .cancel = cancel}), threads, cancel);
}

Result<Rendering> render_scene(const World& world, const Scene& shading, TracerFault fault, int threads,
                               CancelFlag cancel) {
    Result<World> changed = with_shading(world, shading);
    if (changed && fault != TracerFault::none) WorldAccess::own(*changed).fault = fault;
    return render(changed, threads, cancel);
}

}  // namespace glint
