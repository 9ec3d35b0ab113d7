// SPDX-License-Identifier: Apache-2.0
// The stage that absorbs light in glass (Beer's law).
#if defined(GLINT_TRACE_ABSORPTION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_ABSORPTION_INL_H_
#undef GLINT_TRACE_ABSORPTION_INL_H_
#else
#define GLINT_TRACE_ABSORPTION_INL_H_
#endif

#include "lighting/glass-inl.h"
#include "trace/batches.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Beer's law: multiplies the weights of rays that came through glass by the transmittance of the glass. If
/// the ray hits the inside of glass, that is its medium, otherwise the glass that it entered before. Rays
/// that miss are not attenuated: they have left through an open surface, and their distance in glass is
/// unknown.
inline void apply_beer_law(const WorldParts& world, SurfaceBatch& surfaces) {
    const double k = world.conventions.beer;
    if (!(k > 0)) return;
    const auto value = [&](std::uint32_t material, int which) { return world.material(material)[which]; };
    for (int i = 0; i < surfaces.count; ++i) {
        const auto h = static_cast<std::size_t>(i);
        const std::uint32_t material = surfaces.material[h];
        const bool from_inside = surfaces.behind[h] > 0 && value(material, k_transmission) > 0;
        const std::uint32_t medium = from_inside ? material : static_cast<std::uint32_t>(surfaces.medium[h]);
        if (medium == k_none) continue;
        const auto& d = surfaces.incoming;
        const double distance = surfaces.hit_t[h] * length(Vector3<double>{d[0][h], d[1][h], d[2][h]});
        for (int c = 0; c < 3; ++c)
            surfaces.weight[c][h] *= beer(value(medium, k_transmission_tint + c), k, distance);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
