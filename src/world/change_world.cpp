// SPDX-License-Identifier: Apache-2.0
// Replaces parts of a World; all other parts are shared.
#include <fmt/format.h>

#include "base/fp_environment.h"
#include "base/status.h"
#include "scene/mistakes.h"
#include "world/appearance/interiors.h"
#include "world/appearance/prepare_sky.h"
#include "world/appearance/shading.h"
#include "world/geometry/edit_index.h"
#include "world/prepare_camera.h"
#include "world/world.h"

namespace glint {
namespace {

// The World after change(its parts), if the given values are valid.
template <class Change>
Result<World> changed(const World& world, std::vector<Mistake> mistakes, const Change& change) {
    if (!mistakes.empty()) return invalid_scene(to_diagnostics(std::move(mistakes), {}));
    World copy = world;
    WorldParts& parts = WorldAccess::own(copy);
    change(parts);
    set_interiors(parts);
    return copy;
}

// body() makes the result.
template <class Body> Result<World> change_world(const Body& body) {
    const auto run = [&]() -> Result<World> {
        const DefaultFpEnvironment environment;
        return body();
    };
    return result_of(run, " while changing the World");
}

// The error for an invalid material index.
Status no_material(std::uint32_t index, std::uint32_t count) {
    return invalid_argument(
        fmt::format("there is no material {}: the scene has {}", std::uint64_t{index} + 1, count));
}

Status check_texture(const WorldParts& parts, const Material& material, std::size_t index) {
    if (material.texture == k_none || material.texture < parts.textures->size()) return {};
    return invalid_argument(fmt::format("material {}: there is no texture {}: the scene has {}", index + 1,
                                        std::uint64_t{material.texture} + 1, parts.textures->size()));
}

// The first shape whose material index is `materials` or larger, except the default material; k_none if
// there is none.
std::uint32_t first_shape_beyond(const WorldParts& parts, std::size_t materials) {
    const std::uint32_t last = parts.scene_materials();
    std::uint32_t first = k_none;
    for (std::uint32_t slot = 0; slot < parts.geometry->count; ++slot) {
        const std::uint32_t row = (*parts.slot_material)[slot];
        if (row < last && row >= materials && parts.geometry->shape_index[slot] < first)
            first = parts.geometry->shape_index[slot];
    }
    return first;
}

// Moves the default material to its new row when the length of the table changes.
void move_default_material(WorldParts& parts, std::size_t materials) {
    const std::uint32_t from = parts.scene_materials(), to = static_cast<std::uint32_t>(materials);
    for (std::uint32_t& row : parts.slot_material.own())
        if (row == from) row = to;
}

// Sets a material's row in the second table, which it creates where needed.
void set_extended(WorldParts& parts, std::uint32_t index, const Material& material) {
    const ExtendedFields uses = extended_fields_of(material);
    if (parts.extended->empty() && uses == 0) return;
    std::vector<double>& table = parts.extended.own();
    if (table.empty()) {
        table.resize((std::size_t{parts.scene_materials()} + 1) * k_extended_values);
        for (std::size_t row = 0; row < table.size(); row += k_extended_values)
            pack_extended(Material{}, table.data() + row);
    }
    pack_extended(material, table.data() + std::size_t{index} * k_extended_values);
    // Fields that no material uses any more remain in the set: they add nothing to the picture.
    parts.extended_uses |= uses;
}

}  // namespace

Result<World> with_lights(const World& world, std::span<const Light> lights) {
    return change_world([&]() -> Result<World> {
        Scene given;
        given.lights.assign(lights.begin(), lights.end());
        return changed(world, find_mistakes(given, ScenePart::lights),
                       [&](WorldParts& parts) { set_lights(prepare_lights(lights), parts); });
    });
}

Result<World> with_camera(const World& world, const Camera& camera) {
    return change_world([&]() -> Result<World> {
        Scene given;
        given.camera = camera;
        return changed(world, find_mistakes(given, ScenePart::camera), [&](WorldParts& parts) {
            parts.scene_camera = camera;
            parts.camera = prepare_camera(camera, parts.settings);
        });
    });
}

Result<World> with_background(const World& world, Color background) {
    return change_world([&]() -> Result<World> {
        Scene given;
        given.background = background;
        return changed(world, find_mistakes(given, ScenePart::background),
                       [&](WorldParts& parts) { parts.background = background; });
    });
}

Result<World> with_fog(const World& world, const std::optional<Fog>& fog) {
    return change_world([&]() -> Result<World> {
        Scene given;
        given.fog = fog;
        return changed(world, find_mistakes(given, ScenePart::background),
                       [&](WorldParts& parts) { set_fog(parts, fog); });
    });
}

Result<World> with_gradient(const World& world, const std::optional<BackgroundGradient>& gradient) {
    return change_world([&]() -> Result<World> {
        Scene given;
        given.gradient = gradient;
        return changed(world, find_mistakes(given, ScenePart::background),
                       [&](WorldParts& parts) { set_gradient(gradient, parts); });
    });
}

Result<World> with_occlusion(const World& world, const std::optional<Occlusion>& occlusion) {
    return change_world([&]() -> Result<World> {
        Scene given;
        given.occlusion = occlusion;
        return changed(world, find_mistakes(given, ScenePart::background),
                       [&](WorldParts& parts) { set_occlusion(occlusion, parts); });
    });
}

Result<World> with_rules(const World& world, const Conventions& conventions, const RenderSettings& settings) {
    return change_world([&]() -> Result<World> {
        const WorldParts& now = world.parts();
        if (conventions.cones != now.conventions.cones && now.geometry->has_cones)
            return invalid_argument("cones: a World has the scene's cones or not: prepare() the scene anew");
        Scene given;
        given.conventions = conventions;
        given.settings = settings;
        return changed(world, find_mistakes(given, ScenePart::settings), [&](WorldParts& parts) {
            parts.conventions = conventions;
            parts.settings = settings;
            parts.camera = prepare_camera(parts.scene_camera, settings);
        });
    });
}

Result<World> with_material(const World& world, std::uint32_t index, const Material& material) {
    return change_world([&]() -> Result<World> {
        const std::uint32_t count = world.parts().scene_materials();
        if (index >= count) return no_material(index, count);
        if (Status wrong = check_texture(world.parts(), material, index); !wrong.ok()) return wrong;
        return changed(world, find_mistakes(material, index), [&](WorldParts& parts) {
            pack_material(material, parts.materials.own().data() + std::size_t{index} * k_material_values);
            set_extended(parts, index, material);
            set_texture_uses(parts);
            set_color_factors(parts);
            if (parts.no_shadow->empty() && material.casts_shadow) return;
            std::vector<std::uint8_t>& no_shadow = parts.no_shadow.own();
            no_shadow.resize(std::size_t{count} + 1);
            no_shadow[index] = material.casts_shadow ? 0 : 1;
        });
    });
}

Result<World> with_materials(const World& world, std::span<const Material> materials) {
    return change_world([&]() -> Result<World> {
        const WorldParts& now = world.parts();
        if (materials.size() < now.scene_materials()) {
            const std::uint32_t shape = first_shape_beyond(now, materials.size());
            if (shape != k_none)
                return invalid_argument(fmt::format("shape {} has a material that is not among the {} given",
                                                    std::uint64_t{shape} + 1, materials.size()));
        }
        for (std::size_t i = 0; i < materials.size(); ++i) {
            if (Status wrong = check_texture(now, materials[i], i); !wrong.ok()) return wrong;
        }
        Scene given;
        given.materials.assign(materials.begin(), materials.end());
        return changed(world, find_mistakes(given, ScenePart::materials), [&](WorldParts& parts) {
            if (materials.size() != parts.scene_materials()) move_default_material(parts, materials.size());
            parts.materials = pack_materials(materials);
            parts.no_shadow = find_no_shadow(materials);
            ExtendedMaterials extended = pack_extended_materials(materials);
            parts.extended = std::move(extended.table);
            parts.extended_uses = extended.uses;
            set_texture_uses(parts);
            set_color_factors(parts);
        });
    });
}

Result<World> with_shape_colors(const World& world, std::span<const ShapeColor> colors) {
    return change_world([&]() -> Result<World> {
        const std::uint32_t count = world.parts().geometry->scene_shapes;
        if (colors.size() > count)
            return invalid_argument(
                fmt::format("{} colors of shapes: the scene has {} shapes", colors.size(), count));
        return changed(world, find_mistakes(colors),
                       [&](WorldParts& parts) { set_colors(parts, colors, 0); });
    });
}

Status assign_material(World& world, std::span<const std::uint32_t> shapes, std::uint32_t material) {
    const auto body = [&]() -> Status {
        const WorldParts& now = world.parts();
        const std::uint32_t count = now.scene_materials();
        if (material != k_none && material >= count) return no_material(material, count);
        for (const std::uint32_t shape : shapes) {
            if (shape >= now.geometry->scene_shapes)
                return invalid_argument(fmt::format("there is no shape {}: the scene has {}",
                                                    std::uint64_t{shape} + 1, now.geometry->scene_shapes));
        }
        if (shapes.empty()) return {};
        std::vector<bool> wanted;  // where nothing says where a shape is
        if (!now.geometry->edit_index) {
            wanted.resize(now.geometry->scene_shapes);
            for (const std::uint32_t shape : shapes) wanted[shape] = true;
        }
        WorldParts& parts = WorldAccess::own(world);
        std::vector<std::uint32_t>& rows = parts.slot_material.own();
        const std::uint32_t row = material == k_none ? count : material;
        const PackedGeometry& geometry = *parts.geometry;
        if (const auto& index = geometry.edit_index) {
            for (const std::uint32_t shape : shapes)
                for (const std::uint32_t slot : index->slots_of(shape))
                    if (!geometry.has_own_material(slot)) rows[slot] = row;
        } else {
            for (std::uint32_t slot = 0; slot < geometry.count; ++slot)
                if (wanted[geometry.shape_index[slot]] && !geometry.has_own_material(slot)) rows[slot] = row;
        }
        set_interiors(parts);
        return {};
    };
    return result_of(body, " while assigning a material");
}

}  // namespace glint
