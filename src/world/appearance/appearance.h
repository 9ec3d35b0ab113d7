// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a World's materials, colors and conventions say about a surface.
#include <algorithm>
#include <array>

#include "world/geometry/mesh_surface.h"
#include "world/world.h"

namespace glint {

/// The row of the surface's material in WorldParts::materials.
inline std::uint32_t material_row(const WorldParts& world, SurfaceId id) {
    return (*world.slot_material)[id.slot];
}

/// The texture of the surface at a point; nothing without one, or where its picture is not.
inline std::optional<TextureSample> surface_texture(const WorldParts& world, SurfaceId id, Vec3 point) {
    const PreparedTexture* const texture = world.texture_of(material_row(world, id));
    if (texture == nullptr) return {};
    if (texture->over != k_none)
        return sample_layers(*world.geometry, *world.textures, world.index_of(*texture), id, point);
    const std::optional<TexturePlace> place = texture_place(*world.geometry, *texture, id, point);
    if (!place) return {};
    return sample_texture(*texture, *place);
}

/// The surface's own color at a point: that of the mesh's vertices, else the shape's; not set if there is
/// none. point: nullptr for the largest color of the mesh's triangle.
inline ShapeColor own_color(const WorldParts& world, SurfaceId id, const Vec3* point) {
    if (world.slot_color->empty()) return {};
    if (world.geometry->has_mesh_colors) {
        const ShapeColor color = point != nullptr ? mesh_color(*world.geometry, id, *point)
                                                  : brightest_mesh_color(*world.geometry, id);
        if (color.is_set()) return color;
    }
    const float* c = world.slot_color->data() + 3 * std::size_t{id.slot};
    return {c[0], c[1], c[2]};
}

/// The colors of a surface that are multiples of one color.
struct SurfaceColors {
    Color color, ambient, diffuse;
};

/// Replaces the color of a material's values, as with_color() does.
inline void replace_color(const WorldParts& world, std::uint32_t row, const SurfaceColors& colors,
                          double* values) {
    const double* factors = world.color_factors->data() + std::size_t{row} * k_color_factors;
    const auto channels = [](Color c) { return std::array<double, 3>{c.r, c.g, c.b}; };
    const std::array<double, 3> of[k_color_factors] = {channels(colors.ambient), channels(colors.diffuse),
                                                       channels(colors.color)};
    for (std::size_t c = 0; c < 3; ++c) {
        values[k_color + c] = of[2][c];
        for (std::size_t i = 0; i < k_color_factors; ++i) {  // of k_ambient, k_diffuse and k_specular
            if (factors[i] == factors[i]) values[3 * i + c] = factors[i] * of[i][c];
        }
    }
}

/// Writes the k_material_values of a surface: its material's row, with its own_color() and a texture, if it
/// has one. Without a point, the color is the largest of the mesh's triangle.
inline void write_surface_values(const WorldParts& world, SurfaceId id, const Vec3* point,
                                 const std::optional<TextureSample>& texture, double* to) {
    const std::uint32_t row = material_row(world, id);
    std::copy_n(world.material(row), k_material_values, to);
    const ShapeColor color = own_color(world, id, point);
    if (color.is_set()) replace_color(world, row, {color.color(), color.color(), color.color()}, to);
    if (!texture) return;
    if (world.texture_of(row)->mix == TextureMix::replace)
        return replace_color(world, row, {texture->color, texture->ambient, texture->diffuse}, to);
    const auto multiply = [to](int k, Color by) {
        to[k] *= by.r;
        to[k + 1] *= by.g;
        to[k + 2] *= by.b;
    };
    multiply(k_color, texture->color);
    multiply(k_ambient, texture->ambient);
    multiply(k_diffuse, texture->diffuse);
}
/// With the largest color of a mesh's triangle, and a white texture.
inline std::array<double, k_material_values> surface_values(const WorldParts& world, SurfaceId id) {
    std::array<double, k_material_values> values{};
    write_surface_values(world, id, nullptr, {}, values.data());
    return values;
}

/// Whether rays through the surface are refracted (Material::refracts).
inline bool refracts(const WorldParts& world, SurfaceId id) {
    return world.uses<&Material::refracts>() &&
           world.extended_row(material_row(world, id))[k_extended_value<&Material::refracts>] > 0;
}

/// The word of the object to which the surface belongs (Interiors); 0: it changes nothing for rays inside.
inline std::uint32_t interior_word(const WorldParts& world, SurfaceId id) {
    const bool bends = refracts(world, id);
    if (!bends && !world.interiors.without_fog) return 0;
    std::uint32_t number = world.geometry->shape_of(id);
    if (!world.extended->empty()) {
        const double* const values = world.extended_row(material_row(world, id));
        if (!bends && values[k_extended_value<&Material::hollow>] > 0) return 0;
        const double interior = values[k_extended_value<&Material::interior>];
        if (interior > 0) number = 0x80000000u | static_cast<std::uint32_t>(interior);
    }
    return lowbias32(number + 1);
}

/// The refracting object that is the only one of a set (Interiors), or null: there is none, or several.
inline const Interiors::Refracting* only_refracting(const WorldParts& world, std::uint32_t set) {
    const auto& all = world.interiors.refracting;
    const auto at =
        std::lower_bound(all.begin(), all.end(), set,
                         [](const Interiors::Refracting& a, std::uint32_t b) { return a.word < b; });
    return at != all.end() && at->word == set ? &*at : nullptr;
}

/// Whether a ray has no fog, by its RayFields::interiors. Only one hollow object that refracts is known.
inline bool is_outside_fog(const WorldParts& world, double interiors) {
    if (!world.interiors.without_fog || !(interiors > 0)) return false;
    if (!world.interiors.has_hollow) return true;
    const auto set = static_cast<std::uint32_t>(static_cast<std::uint64_t>(interiors));
    const Interiors::Refracting* const only = only_refracting(world, set);
    return only == nullptr || !only->hollow;
}

/// Whether the conventions flip the surface's normal towards the incoming ray.
inline bool flips_normal(const WorldParts& world, SurfaceId id) {
    const Facing facing = world.conventions.facing;
    return facing == Facing::all || facing == Facing::winding ||
           (facing == Facing::open && world.geometry->is_open(id));
}

/// The normal of the surface at a point, flipped towards a ray of this direction if the conventions say so.
inline Vec3 facing_normal(const WorldParts& world, SurfaceId id, Vec3 point, Vec3 incoming) {
    const SurfaceNormals normals = surface_normals(*world.geometry, id, point);
    const bool by_winding = world.conventions.facing == Facing::winding;
    const bool behind = dot(by_winding ? normals.face : normals.shading, incoming) > 0;
    return behind && flips_normal(world, id) ? -normals.shading : normals.shading;
}

/// Whether a row's material lets its surfaces block light, apart from transparent ones.
inline bool casts_shadow_by_row(const WorldParts& world, std::uint32_t row) {
    return world.no_shadow->empty() || (*world.no_shadow)[row] == 0;
}

/// Whether the conventions and the material let the surface block light.
inline bool casts_shadow(const WorldParts& world, SurfaceId id) {
    const std::uint32_t row = material_row(world, id);
    const Conventions& rules = world.conventions;
    if (!casts_shadow_by_row(world, row)) return false;
    if (rules.transparent_shadow != TransparentShadow::opaque && world.is_transparent(row)) return false;
    return rules.glass_shadow != GlassShadow::none || !(world.material(row)[k_transmission] > 0);
}

/// With colors_shadows(): whether the surface, which does not block light, colors it.
inline bool colors_light(const WorldParts& world, SurfaceId id) {
    const std::uint32_t row = material_row(world, id);
    return world.is_transparent(row) && casts_shadow_by_row(world, row);
}

/// The part of a surface's opacity that its texture leaves.
inline double texture_opacity(const WorldParts& world, SurfaceId id,
                              const std::optional<TextureSample>& texture) {
    return texture ? world.texture_of(material_row(world, id))->opacity(texture->alpha) : 1;
}

/// Whether the surface is one-sided, and a ray of this direction meets its back (Material::one_sided).
inline bool is_seen_through(const WorldParts& world, SurfaceId id, Vec3 point, Vec3 direction) {
    if (!world.uses<&Material::one_sided>()) return false;
    const std::uint32_t row = material_row(world, id);
    return world.extended_row(row)[k_extended_value<&Material::one_sided>] > 0 &&
           !(world.material(row)[k_transmission] > 0) &&
           dot(surface_normals(*world.geometry, id, point).face, direction) > 0;
}

/// Whether the surface has a hole at a point (TextureAlpha::mask).
inline bool has_hole_at(const WorldParts& world, SurfaceId id, Vec3 point) {
    const PreparedTexture* const texture = world.texture_of(material_row(world, id));
    return texture != nullptr && texture->has_holes() &&
           texture_opacity(world, id, surface_texture(world, id, point)) == 0;
}

/// Whether a ray of this direction passes the surface at a point as if there were none.
inline bool is_hole(const WorldParts& world, SurfaceId id, Vec3 point, Vec3 direction) {
    return world.has_holes && (is_seen_through(world, id, point, direction) || has_hole_at(world, id, point));
}

/// Writes the k_extended_values of a surface: its material's row, with the transparency of a texture, if it
/// has one, and its emission with TextureMix::multiply_all.
inline void write_extended_values(const WorldParts& world, SurfaceId id,
                                  const std::optional<TextureSample>& texture, double* to) {
    const std::uint32_t row = material_row(world, id);
    std::copy_n(world.extended_row(row), k_extended_values, to);
    if (texture && world.texture_of(row)->mix == TextureMix::multiply_all) {
        const double channels[3] = {texture->color.r, texture->color.g, texture->color.b};
        for (int c = 0; c < 3; ++c) to[k_extended_value<&Material::emission> + c] *= channels[c];
    }
    const double opacity = texture_opacity(world, id, texture);
    if (opacity == 1) return;
    to[k_extended_value<&Material::filter>] *= opacity;
    double& transmit = to[k_extended_value<&Material::transmit>];
    transmit = faded_transmit(transmit, opacity);
}

/// A light whose factor is below this in every channel counts as blocked.
inline constexpr double k_min_filter = 0x1p-10;

/// The factor of light that passes a transparent surface: transmit + filter * color.
inline Color shadow_factor(const WorldParts& world, SurfaceId id, Vec3 point) {
    const std::optional<TextureSample> texture = surface_texture(world, id, point);
    double values[k_extended_values], look[k_material_values];
    write_extended_values(world, id, texture, values);
    const double filter = values[k_extended_value<&Material::filter>],
                 transmit = values[k_extended_value<&Material::transmit>];
    if (filter == 0) return {transmit, transmit, transmit};
    write_surface_values(world, id, &point, texture, look);
    const double* const color = look + k_color;
    return {transmit + filter * color[0], transmit + filter * color[1], transmit + filter * color[2]};
}

/// Whether the surface blocks light at a point by itself: also a transparent one that lets nothing through
/// there.
inline bool blocks_light(const WorldParts& world, SurfaceId id, Vec3 point) {
    if (casts_shadow(world, id)) return true;
    if (!world.colors_shadows() || !colors_light(world, id)) return false;
    const Color factor = shadow_factor(world, id, point);
    return factor.r < k_min_filter && factor.g < k_min_filter && factor.b < k_min_filter;
}

}  // namespace glint
