// SPDX-License-Identifier: Apache-2.0
#include "compare/scene_renderer.h"

#include <algorithm>
#include <array>
#include <functional>

#include "compare/render_scene.h"
#include "compare/shape_shares.h"

namespace glint {
namespace {

constexpr std::size_t k_max_moved_shapes = 1000;  // of a scene whose spheres are moved

// Shapes without a material get one of the scene's, so that faults of materials reach them.
void name_default_material(Scene& scene) {
    const auto index = static_cast<std::uint32_t>(scene.materials.size());
    bool used = false;
    for (Shape& shape : scene.shapes) {
        if (shape.material != k_none) continue;
        shape.material = index;
        used = true;
    }
    if (used) scene.materials.emplace_back();
}

void remove_shapes(Scene& scene, std::vector<std::uint32_t> indices) {
    std::sort(indices.begin(), indices.end(), std::greater<>());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    scene.shape_texts = {};  // by index
    for (const std::uint32_t index : indices) {
        scene.shapes.erase(scene.shapes.begin() + index);
        if (index < scene.shape_colors.size()) scene.shape_colors.erase(scene.shape_colors.begin() + index);
    }
}

void drop_shapes(Scene& scene) {
    scene.shapes = {};
    scene.shape_colors = {};
    scene.transforms = {};
    scene.polygon_vertices = {};
    scene.meshes = {};
    scene.solids = {};
    scene.parameters = {};
    scene.shape_texts = {};
}

}  // namespace

SceneRenderer::SceneRenderer(const Scene& scene, std::int32_t width, std::int32_t height,
                             const CauseOptions& options)
    : scene_{scene, {}}, options_(options) {
    Scene& named = scene_.shading;
    named.settings.width = width;
    named.settings.height = height;
    name_default_material(named);
    if (Result<World> prepared = prepare(named, {.threads = options_.threads})) world_ = *std::move(prepared);
    if (named.shapes.size() <= k_max_moved_shapes) with_shapes_ = named;
    drop_shapes(named);
}

ByteRule SceneRenderer::rule(const Scene& scene) const {
    return options_.as_floats ? ByteRule{} : scene.conventions.byte_rule();
}

const std::vector<bool>& SceneRenderer::background(const PixelGrid& grid) const {
    const auto known = backgrounds_.find(grid.step);
    if (known != backgrounds_.end()) return known->second;
    return backgrounds_.emplace(grid.step, background_pixels(*this, grid)).first->second;
}

bool SceneRenderer::is_cancelled() const { return options_.cancel.is_set(); }

std::optional<RenderedScene> SceneRenderer::render(const FaultyScene& faulty, const PixelGrid& grid) const {
    World world = *world_;
    Scene moved;
    const bool is_new = !faulty.reshape.empty() || !faulty.missing.empty();
    const bool is_moved = !faulty.spheres.empty() || is_new;
    if (is_moved && !with_shapes_) return std::nullopt;
    if (is_moved) moved = *with_shapes_;
    for (const auto reshape : faulty.reshape) reshape(moved);
    for (const SphereChange& change : faulty.spheres) {
        Sphere& sphere = moved.get<Sphere>()[moved.shapes[change.shape].index];
        sphere.center = sphere.center + change.by;
        sphere.radius = sphere.radius * change.radius_factor;
        if (is_new) continue;
        const std::array shapes{change.shape};
        const Result<ShapeEdit> edit = edit_shapes(world, moved, shapes);
        if (!edit || *edit == ShapeEdit::none) return std::nullopt;
    }
    if (is_new) {
        remove_shapes(moved, faulty.missing);
        Result<World> prepared = prepare(moved, {.threads = options_.threads});
        if (!prepared) return std::nullopt;
        world = *std::move(prepared);
    }
    Scene shading = faulty.shading;
    set_grid(shading, grid);
    Result<Rendering> result = render_scene(world, shading, faulty.fault, options_.threads, options_.cancel);
    if (!result) return std::nullopt;
    RenderedScene rendered{std::move(result->image), {}};
    rendered.bytes = to_bytes(rendered.image, options_.threads, rule(shading));
    return rendered;
}

}  // namespace glint
