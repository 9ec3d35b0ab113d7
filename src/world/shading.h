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
/// Writes one row of the table.
void pack_material(const Material& material, double* row);

struct PreparedLights {
    std::vector<PreparedLight> lights;  // all but the ambient ones, in scene order
    Color ambient{0, 0, 0};             // the sum of the ambient lights
};
PreparedLights prepare_lights(std::span<const Light> lights);

}  // namespace glint
