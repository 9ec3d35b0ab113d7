// SPDX-License-Identifier: Apache-2.0
// The materials of a vector of hits.
#if defined(GLINT_TRACE_MATERIAL_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_MATERIAL_INL_H_
#undef GLINT_TRACE_MATERIAL_INL_H_
#else
#define GLINT_TRACE_MATERIAL_INL_H_
#endif

#include "simd/vec3-inl.h"
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

/// The values of each lane's material. If all lanes have the same material, its values are read once.
struct MaterialLanes {
    const double* base;
    const std::uint32_t* index;
    bool same;

    HWY_INLINE MaterialLanes(const WorldParts& world, const std::uint32_t* material)
        : base(world.materials->data()), index(material), same(all_same(material)) {}

    HWY_INLINE Doubles value(int k) const { return table_value(base, index, same, k_material_values, k); }
    HWY_INLINE Vector3<Doubles> color(int k) const { return {value(k), value(k + 1), value(k + 2)}; }
};

/// The values of the same materials in the second table, which must exist.
struct ExtendedLanes {
    const double* base;
    const std::uint32_t* index;
    bool same;

    HWY_INLINE ExtendedLanes(const WorldParts& world, const MaterialLanes& material)
        : base(world.extended->data()), index(material.index), same(material.same) {}

    template <auto Member> HWY_INLINE Doubles value() const { return column(k_extended_value<Member>); }
    template <auto Member> HWY_INLINE Vector3<Doubles> color() const {
        constexpr int k = k_extended_value<Member>;
        return {column(k), column(k + 1), column(k + 2)};
    }

  private:
    HWY_INLINE Doubles column(int k) const { return table_value(base, index, same, k_extended_values, k); }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
