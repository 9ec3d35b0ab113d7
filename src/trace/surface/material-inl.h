// SPDX-License-Identifier: Apache-2.0
// The materials of a vector of hits.
#if defined(GLINT_TRACE_MATERIAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_MATERIAL_INL_H_
#undef GLINT_TRACE_MATERIAL_INL_H_
#else
#define GLINT_TRACE_MATERIAL_INL_H_
#endif

#include "simd/vec3-inl.h"
#include "trace/batches.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The numbers at column k of each lane's row. same: all lanes have the same row.
HWY_INLINE Doubles table_value(const double* table, const std::uint32_t* rows, bool same, int columns,
                               int k) {
    if (same)
        return Doubles(
            table[std::size_t{rows[0]} * static_cast<std::size_t>(columns) + static_cast<std::size_t>(k)]);
    return gather(table + k, GatherIndices(rows, static_cast<std::uint32_t>(columns)));
}

/// The values of the materials of a vector of hits. If all lanes have the same row, its values are read once.
struct MaterialLanes {
    const double* base;
    const std::uint32_t* index;
    bool same;
    const std::uint32_t* material;  // the rows in the World's tables
    const double* extended;         // of SurfaceBatch
    const std::uint32_t* extended_index;

    HWY_INLINE MaterialLanes(const SurfaceBatch& surfaces, int h)
        : base(surfaces.rows),
          index(surfaces.row + h),
          same(all_same(surfaces.row + h)),
          material(surfaces.material.data() + h),
          extended(surfaces.extended),
          extended_index(surfaces.extended_row + h) {}

    HWY_INLINE Doubles value(int k) const { return table_value(base, index, same, k_material_values, k); }
    HWY_INLINE Vector3<Doubles> color(int k) const { return {value(k), value(k + 1), value(k + 2)}; }
};

/// The values of the same materials in the second table, which must exist.
struct ExtendedLanes {
    const double* base;
    const std::uint32_t* index;
    bool same;

    HWY_INLINE explicit ExtendedLanes(const MaterialLanes& material)
        : base(material.extended), index(material.extended_index), same(all_same(material.extended_index)) {}

    template <auto Member> HWY_INLINE Doubles value() const { return column(k_extended_value<Member>); }
    template <auto Member> HWY_INLINE Vector3<Doubles> color() const {
        constexpr int k = k_extended_value<Member>;
        return {column(k), column(k + 1), column(k + 2)};
    }

  private:
    HWY_INLINE Doubles column(int k) const { return table_value(base, index, same, k_extended_values, k); }
};

/// The transparency of the same materials (Material::filter, transmit). Only in scenes that have it
/// (WorldParts::has_transparency).
struct TransparencyLanes {
    Doubles filter, transmit;
    Vector3<Doubles> color;

    HWY_INLINE explicit TransparencyLanes(const MaterialLanes& material)
        : filter(ExtendedLanes(material).value<&Material::filter>()),
          transmit(ExtendedLanes(material).value<&Material::transmit>()),
          color(material.color(k_color)) {}

    HWY_INLINE LaneMask<double> is_transparent() const {
        return filter > Doubles(0) || transmit > Doubles(0);
    }
    /// The factor of what is seen through the surface.
    HWY_INLINE Vector3<Doubles> through() const {
        return {transmit + filter * color.x, transmit + filter * color.y, transmit + filter * color.z};
    }
    HWY_INLINE Doubles opacity(OpacityRule rule) const {
        const Doubles tinted =
            rule == OpacityRule::whole ? filter : filter * max(max(color.x, color.y), color.z);
        return max(Doubles(1) - transmit - tinted, Doubles(0));
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
