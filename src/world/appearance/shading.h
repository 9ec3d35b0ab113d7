// SPDX-License-Identifier: Apache-2.0
#pragma once
// Materials and lights as a World stores them.
#include <span>
#include <vector>

#include "world/world.h"

namespace glint {

/// The table of materials; the default material is last.
std::vector<double> pack_materials(std::span<const Material> materials);
/// WorldParts::extended and extended_uses.
struct ExtendedMaterials {
    std::vector<double> table;
    ExtendedFields uses = 0;
};
ExtendedMaterials pack_extended_materials(std::span<const Material> materials);
/// WorldParts::no_shadow.
std::vector<std::uint8_t> find_no_shadow(std::span<const Material> materials);
/// WorldParts::color_factors of a table of materials.
std::vector<double> find_color_factors(std::span<const double> materials);
/// WorldParts::slot_color. colors: by shape, as Scene::shape_colors.
std::vector<float> find_slot_colors(std::span<const ShapeColor> colors, const PackedGeometry& geometry,
                                    int threads);
/// Sets WorldParts::has_alpha_textures, and counts such textures as uses of Material::transmit; sets
/// WorldParts::has_emission_textures.
void set_texture_uses(WorldParts& parts);
/// Sets WorldParts::color_factors.
void set_color_factors(WorldParts& parts);
/// Gives the World's shapes these colors.
void set_colors(WorldParts& parts, std::span<const ShapeColor> colors, int threads);
/// Writes one row of the table.
void pack_material(const Material& material, double* row);

struct PreparedLights {
    std::vector<PreparedLight> lights;  // all but the ambient ones, in scene order
    std::vector<AmbientLight> ambient_lights;
    Color ambient{0, 0, 0};  // the sum of the ambient lights
};
PreparedLights prepare_lights(std::span<const Light> lights);
/// Gives the World these lights.
void set_lights(PreparedLights lights, WorldParts& parts);

}  // namespace glint
