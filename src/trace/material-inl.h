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

/// The values of each lane's material. If all lanes have the same material, its values are read once.
struct MaterialLanes {
    const double* base;
    const std::uint32_t* index;
    bool same;

    HWY_INLINE MaterialLanes(const WorldParts& world, const std::uint32_t* material)
        : base(world.materials->data()), index(material), same(all_same(material)) {}

    HWY_INLINE Doubles value(int k) const {
        if (same)
            return Doubles(base[std::size_t{index[0]} * k_material_values + static_cast<std::size_t>(k)]);
        return gather(base + k, GatherIndices(index, k_material_values));
    }
    HWY_INLINE Vector3<Doubles> color(int k) const { return {value(k), value(k + 1), value(k + 2)}; }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
