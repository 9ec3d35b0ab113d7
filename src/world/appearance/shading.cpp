// SPDX-License-Identifier: Apache-2.0
#include "world/appearance/shading.h"

#include <algorithm>
#include <limits>

#include "base/huge_pages.h"
#include "base/parallel_chunks.h"
#include "bvh/rays.h"
#include "math/elementary.h"
#include "math/frame.h"
#include "math/number.h"
#include "math/transform.h"
#include "scene/material_color.h"

namespace glint {
namespace {

constexpr double k_min_direction = 1e-15;           // minimum length of a light's direction
constexpr double k_radians = 0x1.1df46a2529d39p-6;  // pi / 180

void prepare_spot(PreparedLight& light) {
    light.unit_axis = normalize(light.axis);
    // Rounding makes cosines below -1: they are within 180 degrees, too.
    const double inner_cosine = light.inner_angle < 180 ? cos_degrees(light.inner_angle) : -2;
    light.spot_cone = {inner_cosine, cos_degrees(light.outer_angle), light.inner_angle * k_radians,
                       light.outer_angle * k_radians, light.tightness};
}

void prepare_area(PreparedLight& light) {
    AreaGrid& area = light.area;
    area.is_parallelogram = light.is_parallelogram();
    area.is_disc = light.is_disc();
    area.columns = light.samples_u;
    area.rows = light.samples_v;
    area.center = light.position;
    area.jitter = light.jitter;
    area.circular = light.circular;
    area.oriented = light.is_parallelogram() && light.oriented;
    area.adaptive = light.adaptive;
    area.x = light.side_u, area.y = light.side_v;
    if (light.is_spot()) return;  // prepare_spot() has set the axis
    light.unit_axis = light.is_parallelogram()
                          ? normalize(cross(normalize(light.side_u), normalize(light.side_v)))
                      : light.is_disc() ? normalize(light.axis)
                                        : Vec3{0, 0, 1};
    if (!light.has_radius()) return;
    const Frame frame(light.unit_axis);
    area.x = frame.x * light.radius, area.y = frame.y * light.radius, area.z = frame.z * light.radius;
}

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

ExtendedFields extended_fields_of(const Material& material) {
    ExtendedFields uses = 0;
    for (std::size_t i = 0; i < k_extended_fields.size(); ++i) {
        visit_field(k_extended_fields[i], material, [&](const auto&, const auto& value) {
            visit_field(k_extended_fields[i], Material{}, [&](const auto&, const auto& usual) {
                if constexpr (std::is_same_v<decltype(value), decltype(usual)>) {
                    if (numbers_of(value) != numbers_of(usual)) uses |= ExtendedFields{1} << i;
                }
            });
        });
    }
    return uses;
}

void pack_extended(const Material& material, double* row) {
    for (const ItemField<Material>& field : k_extended_fields) {
        visit_field(field, material, [&](const auto&, const auto& value) {
            for (const double number : numbers_of(value)) *row++ = number;
        });
    }
}

ExtendedMaterials pack_extended_materials(std::span<const Material> materials) {
    ExtendedMaterials packed;
    for (const Material& m : materials) packed.uses |= extended_fields_of(m);
    if (packed.uses == 0) return packed;
    packed.table.resize((materials.size() + 1) * k_extended_values);
    double* row = packed.table.data();
    for (const Material& m : materials) pack_extended(m, row), row += k_extended_values;
    pack_extended(Material{}, row);
    return packed;
}

std::vector<std::uint8_t> find_no_shadow(std::span<const Material> materials) {
    std::vector<std::uint8_t> rows;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (materials[i].casts_shadow) continue;
        rows.resize(materials.size() + 1);  // the default material casts a shadow
        rows[i] = 1;
    }
    return rows;
}

std::vector<double> find_color_factors(std::span<const double> materials) {
    std::vector<double> factors;
    factors.reserve(materials.size() / k_material_values * k_color_factors);
    for (const double* row = materials.data(); row != materials.data() + materials.size();
         row += k_material_values) {
        const auto color = [&](int k) { return Color{row[k], row[k + 1], row[k + 2]}; };
        for (const double factor :
             find_color_factors(color(k_color), {color(k_ambient), color(k_diffuse), color(k_specular)}))
            factors.push_back(factor);
    }
    return factors;
}

std::vector<float> find_slot_colors(std::span<const ShapeColor> colors, const PackedGeometry& geometry,
                                    int threads) {
    std::vector<float> columns;
    if (!geometry.has_mesh_colors &&
        std::none_of(colors.begin(), colors.end(), [](const ShapeColor& c) { return c.is_set(); }))
        return columns;
    resize_in_huge_pages(columns, 3 * (std::size_t{geometry.count} + k_ray_padding), threads);
    parallel_chunks(geometry.count, threads, [&](std::size_t slot) {
        const std::uint32_t shape = geometry.shape_index[slot];
        const bool has_color =
            shape < colors.size() && !geometry.has_own_material(static_cast<std::uint32_t>(slot));
        const ShapeColor color = has_color ? colors[shape] : ShapeColor{};
        float* to = columns.data() + 3 * slot;
        to[0] = color.r, to[1] = color.g, to[2] = color.b;
    });
    return columns;
}

void set_colors(WorldParts& parts, std::span<const ShapeColor> colors, int threads) {
    parts.slot_color = find_slot_colors(colors, *parts.geometry, threads);
    set_color_factors(parts);
}

void set_texture_uses(WorldParts& parts) {
    parts.has_alpha_textures = parts.has_emission_textures = false;
    parts.has_holes = parts.uses<&Material::one_sided>();
    for (std::uint32_t row = 0; row < parts.scene_materials(); ++row) {
        const PreparedTexture* const texture = parts.texture_of(row);
        if (texture == nullptr) continue;
        parts.has_alpha_textures = parts.has_alpha_textures || texture->has_alpha();
        parts.has_holes = parts.has_holes || texture->has_holes();
        parts.has_emission_textures = parts.has_emission_textures || texture->mix == TextureMix::multiply_all;
    }
    if (parts.has_alpha_textures) parts.extended_uses |= k_extended_field<&Material::transmit>;
}

void set_color_factors(WorldParts& parts) {
    if (parts.has_surface_colors()) {
        parts.color_factors = find_color_factors(*parts.materials);
    } else if (!parts.color_factors->empty()) {
        parts.color_factors = std::vector<double>();
    }
}

PreparedLights prepare_lights(std::span<const Light> lights) {
    PreparedLights prepared;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Light& light = lights[i];
        if (light.is_ambient()) {
            prepared.ambient_lights.push_back({static_cast<std::uint32_t>(i), light.color});
            prepared.ambient = prepared.ambient + light.color;
            continue;
        }
        PreparedLight& added = prepared.lights.emplace_back();
        static_cast<Light&>(added) = light;
        added.index = static_cast<std::uint32_t>(i);
        if (light.is_spot()) prepare_spot(added);
        if (light.is_area()) prepare_area(added);
        Vec3& to_light = added.to_light;
        // The squares of shorter vectors underflow.
        if (light.has_direction() && length(to_light) < k_min_direction)
            to_light = normalize(to_light) * k_min_direction;
    }
    return prepared;
}

void set_lights(PreparedLights lights, WorldParts& parts) {
    parts.lights = std::move(lights.lights);
    parts.ambient_lights = std::move(lights.ambient_lights);
    parts.ambient = lights.ambient;
}

}  // namespace glint
