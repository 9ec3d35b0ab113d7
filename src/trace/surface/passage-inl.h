// SPDX-License-Identifier: Apache-2.0
// The indices of refraction on both sides of a surface, and the objects that a ray is inside behind it.
#if defined(GLINT_TRACE_PASSAGE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_PASSAGE_INL_H_
#undef GLINT_TRACE_PASSAGE_INL_H_
#else
#define GLINT_TRACE_PASSAGE_INL_H_
#endif

#include <algorithm>

#include "lighting/glass-inl.h"
#include "trace/batches.h"
#include "trace/surface/material-inl.h"
#include "world/appearance/appearance.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// n1 / n2 of a ray through a surface, and the objects that it is inside after that.
struct Passage {
    double ratio = 1, inside = 0;
};

/// inside: RayFields::interiors, the word of the set and, times 2^32, 20 bits of the word of the object that
/// was entered last. A ray travels in that object (POV-Ray, measured). Of more than two objects, the order is
/// not known; ratio is 1 then.
GLINT_SMALL Passage pass_surface(const WorldParts& world, SurfaceId id, double inside) {
    const auto both = static_cast<std::uint64_t>(inside);
    const std::uint32_t unbent = world.interiors.unbent;
    const std::uint32_t set = static_cast<std::uint32_t>(both) ^ unbent,
                        last = static_cast<std::uint32_t>(both >> 32);
    const std::uint32_t own = interior_word(world, id), rest = set ^ own;
    const auto mark = [](std::uint32_t word) { return word >> 12; };
    const auto inside_of = [&](std::uint32_t top) {
        return static_cast<double>(std::uint64_t{rest ^ unbent} | std::uint64_t{rest != 0 ? top : 0} << 32);
    };
    if (!refracts(world, id)) return {1, inside_of(last)};
    const double ior = world.material(material_row(world, id))[k_ior];
    if (set == 0) return {1 / ior, inside_of(mark(own))};
    if (rest == 0) return {ior, inside_of(0)};
    if (const auto* const around = only_refracting(world, set))
        return {around->ior / ior, inside_of(mark(own))};
    const auto* const around = only_refracting(world, rest);
    if (around == nullptr || last != mark(own)) return {1, inside_of(last)};
    return {ior / around->ior, inside_of(mark(rest))};
}

/// n1 / n2 of the rays through those surfaces of a vector whose bits are set; 1 of the others, and of those
/// that do not refract (Material::refracts).
GLINT_SMALL Doubles index_ratios(const WorldParts& world, const SurfaceBatch& surfaces, int h,
                                 std::uint32_t of) noexcept {
    alignas(k_ray_alignment) double ratios[lane_count<double>()];
    std::fill_n(ratios, lane_count<double>(), 1.0);
    for (; of != 0; of &= of - 1) {
        const int k = __builtin_ctz(of);
        const double inside = surfaces.tracked ? surfaces.interiors[static_cast<std::size_t>(h + k)] : 0;
        ratios[k] = pass_surface(world, surfaces.surface(h + k), inside).ratio;
    }
    return load(ratios);
}

/// F of Fresnel's equations (Material::mirror_fresnel), by the cosine of the angle between ray and normal.
GLINT_SMALL Doubles surface_reflectance(const WorldParts& world, const MaterialLanes& material,
                                        const SurfaceBatch& surfaces, int h, const Doubles& cosine) noexcept {
    const Doubles ior = material.value(k_ior);
    Doubles ratio = select(load(surfaces.behind.data() + h) > Doubles(0), ior, Doubles(1) / ior);
    if (world.uses<&Material::refracts>()) {
        const auto refracts = ExtendedLanes(material).value<&Material::refracts>() > Doubles(0);
        const std::uint32_t hits = first_bits(number::min(surfaces.count - h, lane_count<double>()));
        ratio = select(refracts, index_ratios(world, surfaces, h, to_bits(refracts) & hits), ratio);
    }
    return fresnel_reflectance(cosine, ratio);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
