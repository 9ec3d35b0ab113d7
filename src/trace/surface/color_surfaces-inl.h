// SPDX-License-Identifier: Apache-2.0
// The stage that finds the material and the color of the surfaces.
#if defined(GLINT_TRACE_COLOR_SURFACES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_COLOR_SURFACES_INL_H_
#undef GLINT_TRACE_COLOR_SURFACES_INL_H_
#else
#define GLINT_TRACE_COLOR_SURFACES_INL_H_
#endif

#include <optional>

#include "trace/batches.h"
#include "trace/columns.h"
#include "world/appearance/appearance.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Writes the values of the hits' materials with the colors of their shapes, meshes' vertices or textures,
/// and those of the second table with the alpha of textures and the emission that these color. Consecutive
/// hits of one surface share a row if its color is the same everywhere.
inline void write_colored_rows(const WorldParts& world, SurfaceBatch& surfaces) {
    surfaces.colored_rows.resize(std::size_t{k_batch_size} * k_material_values);
    const bool fades = world.has_extended_points();
    if (fades) surfaces.faded_rows.resize(std::size_t{k_batch_size} * k_extended_values);
    std::uint32_t* rows = surfaces.colored_row.data();
    std::uint32_t row = 0;
    for (int h = 0; h < surfaces.count; ++h) {
        const SurfaceId id = surfaces.surface(h);
        if (h == 0 || world.has_point_colors() || id != surfaces.surface(h - 1)) {
            if (h > 0) ++row;
            const Vec3 point = vec3_at(surfaces.point, h);
            const std::optional<TextureSample> texture = surface_texture(world, id, point);
            write_surface_values(world, id, &point, texture,
                                 surfaces.colored_rows.data() + std::size_t{row} * k_material_values);
            if (fades)
                write_extended_values(world, id, texture,
                                      surfaces.faded_rows.data() + std::size_t{row} * k_extended_values);
        }
        rows[h] = row;
    }
    std::fill_n(rows + surfaces.count, k_ray_padding, row);
    surfaces.rows = surfaces.colored_rows.data();
    surfaces.row = rows;
    if (fades) {
        surfaces.extended = surfaces.faded_rows.data();
        surfaces.extended_row = rows;
    }
}

/// Finds the material of each surface, and the values of materials that lighting reads.
inline void color_surfaces(const WorldParts& world, SurfaceBatch& surfaces) {
    const int count = surfaces.count;
    if (count == 0) return;
    std::uint32_t* const materials = surfaces.material.data();
    for (int h = 0; h < count; h += lane_count<double>()) {
        const bool same = all_same(surfaces.slot.data() + h);
        for (int k = 0; k < lane_count<double>(); ++k)
            materials[h + k] = same && k > 0 ? materials[h] : material_row(world, surfaces.surface(h + k));
    }
    // Vectors may extend past the last surface, because groups start at any index.
    std::fill_n(materials + count, k_ray_padding, materials[count - 1]);
    surfaces.rows = world.materials->data();
    surfaces.row = materials;
    surfaces.extended = world.extended->data();
    surfaces.extended_row = materials;
    if (world.has_surface_colors()) write_colored_rows(world, surfaces);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
