// SPDX-License-Identifier: Apache-2.0
// A World with other shading: what is not given is shared.
#include <fmt/format.h>

#include "base/catch_exceptions.h"
#include "base/fp_environment.h"
#include "scene/mistakes.h"
#include "world/edit_index.h"
#include "world/failure.h"
#include "world/prepare_camera.h"
#include "world/shading.h"
#include "world/world.h"

namespace glint {
namespace {

// The World after change(its parts), if there are no mistakes in what is given.
template <class Change>
WorldResult changed(const World& world, std::vector<Mistake> mistakes, const Change& change) {
    WorldResult result;
    result.diagnostics = to_diagnostics(std::move(mistakes), {});
    if (has_errors(result.diagnostics)) return result;
    World copy = world;
    change(WorldAccess::own(copy));
    result.world = std::move(copy);
    return result;
}

// body() makes the result.
template <class Body> WorldResult guarded(const Body& body) {
    WorldResult result;
    const std::string failure = catch_exceptions([&] {
        const DefaultFpEnvironment environment;
        result = body();
    });
    if (!failure.empty()) {
        result.world.reset();
        result.diagnostics.push_back(failure_diagnostic(failure + " while changing the World"));
    }
    return result;
}

WorldResult error(std::string message) { return {{}, {failure_diagnostic(std::move(message))}, false}; }

// The first shape that refers to a material of the table beyond the first `materials` ones, the default one
// apart; k_none if there is none.
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

// The table gets another length: the default material has another row.
void move_default_material(WorldParts& parts, std::size_t materials) {
    const std::uint32_t from = parts.scene_materials(), to = static_cast<std::uint32_t>(materials);
    for (std::uint32_t& row : parts.slot_material.own())
        if (row == from) row = to;
}

}  // namespace

WorldResult with_lights(const World& world, std::span<const Light> lights) {
    return guarded([&] {
        Scene given;
        given.lights.assign(lights.begin(), lights.end());
        return changed(world, find_mistakes(given, ScenePart::lights), [&](WorldParts& parts) {
            PreparedLights prepared = prepare_lights(lights);
            parts.lights = std::move(prepared.lights);
            parts.ambient = prepared.ambient;
        });
    });
}

WorldResult with_camera(const World& world, const Camera& camera) {
    return guarded([&] {
        Scene given;
        given.camera = camera;
        return changed(world, find_mistakes(given, ScenePart::camera), [&](WorldParts& parts) {
            parts.scene_camera = camera;
            parts.camera = prepare_camera(camera, parts.settings);
        });
    });
}

WorldResult with_background(const World& world, Color background) {
    return guarded([&] {
        Scene given;
        given.background = background;
        return changed(world, find_mistakes(given, ScenePart::background),
                       [&](WorldParts& parts) { parts.background = background; });
    });
}

WorldResult with_rules(const World& world, const Conventions& conventions, const RenderSettings& settings) {
    return guarded([&] {
        const WorldParts& now = world.parts();
        if (conventions.cones != now.conventions.cones && now.geometry->has_cones)
            return error("cones: a World has the scene's cones or not: prepare() the scene anew");
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

WorldResult with_material(const World& world, std::uint32_t index, const Material& material) {
    return guarded([&] {
        const std::uint32_t count = world.parts().scene_materials();
        if (index >= count)
            return error(
                fmt::format("there is no material {}: the scene has {}", std::uint64_t{index} + 1, count));
        return changed(world, find_mistakes(material, index), [&](WorldParts& parts) {
            pack_material(material, parts.materials.own().data() + std::size_t{index} * k_material_values);
        });
    });
}

WorldResult with_materials(const World& world, std::span<const Material> materials) {
    return guarded([&] {
        const WorldParts& now = world.parts();
        if (materials.size() < now.scene_materials()) {
            const std::uint32_t shape = first_shape_beyond(now, materials.size());
            if (shape != k_none)
                return error(fmt::format("shape {} has a material that is not among the {} given",
                                         std::uint64_t{shape} + 1, materials.size()));
        }
        Scene given;
        given.materials.assign(materials.begin(), materials.end());
        return changed(world, find_mistakes(given, ScenePart::materials), [&](WorldParts& parts) {
            if (materials.size() != parts.scene_materials()) move_default_material(parts, materials.size());
            parts.materials = pack_materials(materials);
        });
    });
}

std::vector<Diagnostic> assign_material(World& world, std::span<const std::uint32_t> shapes,
                                        std::uint32_t material) {
    std::vector<Diagnostic> diagnostics;
    const auto error = [&](std::string message) {
        diagnostics.push_back(failure_diagnostic(std::move(message)));
    };
    const std::string failure = catch_exceptions([&] {
        const WorldParts& now = world.parts();
        const std::uint32_t count = now.scene_materials();
        if (material != k_none && material >= count)
            return error(
                fmt::format("there is no material {}: the scene has {}", std::uint64_t{material} + 1, count));
        for (const std::uint32_t shape : shapes) {
            if (shape >= now.geometry->scene_shapes)
                return error(fmt::format("there is no shape {}: the scene has {}", std::uint64_t{shape} + 1,
                                         now.geometry->scene_shapes));
        }
        if (shapes.empty()) return;
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
                for (const std::uint32_t slot : index->slots_of(shape)) rows[slot] = row;
            return;
        }
        for (std::uint32_t slot = 0; slot < geometry.count; ++slot)
            if (wanted[geometry.shape_index[slot]]) rows[slot] = row;
    });
    if (!failure.empty()) error(failure + " while assigning a material");
    return diagnostics;
}

}  // namespace glint
