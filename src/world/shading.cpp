// SPDX-License-Identifier: Apache-2.0
#include "world/shading.h"

#include "math/transform.h"

namespace glint {
namespace {

constexpr double k_min_direction = 1e-15;  // minimum length of a light's direction

}  // namespace

void pack_material(const Material& m, double* row) {
    for (const Color& c : {m.ambient, m.diffuse, m.specular, m.color, m.mirror_tint, m.transmission_tint}) {
        *row++ = c.r, *row++ = c.g, *row++ = c.b;
    }
    *row++ = m.shininess, *row++ = m.mirror, *row++ = m.transmission, *row++ = m.ior;
}

std::vector<double> pack_materials(std::span<const Material> materials) {
    std::vector<double> table((materials.size() + 1) * k_material_values);
    double* row = table.data();
    for (const Material& m : materials) pack_material(m, row), row += k_material_values;
    pack_material(Material{}, row);
    return table;
}

PreparedLights prepare_lights(std::span<const Light> lights) {
    PreparedLights prepared;
    for (const Light& light : lights) {
        if (light.is_ambient()) {
            prepared.ambient = prepared.ambient + light.color;
            continue;
        }
        prepared.lights.push_back(light);
        Vec3& to_light = prepared.lights.back().to_light;
        // The squares of shorter vectors underflow.
        if (light.has_direction() && length(to_light) < k_min_direction)
            to_light = normalize(to_light) * k_min_direction;
    }
    return prepared;
}

}  // namespace glint
