// SPDX-License-Identifier: Apache-2.0
// The stage that records the surfaces of a range of rays, for check().
#if defined(GLINT_TRACE_RECORD_SURFACES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_RECORD_SURFACES_INL_H_
#undef GLINT_TRACE_RECORD_SURFACES_INL_H_
#else
#define GLINT_TRACE_RECORD_SURFACES_INL_H_
#endif

#include "simd/vec3-inl.h"
#include "trace/batches.h"
#include "trace/surface_record.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The surfaces must be those of the range's hits (collect_hits()).
inline void record_surfaces(const WorldParts& world, const RayBatch& rays, const HitBatch& hits,
                            RayRange range, const SurfaceBatch& surfaces, SurfaceRecord& record) {
    std::vector<SurfaceHit>& found = record[static_cast<std::size_t>(rays.generation)];
    int h = 0;
    for (int i = range.begin; i < range.end; ++i) {
        if (!hits.surface(i).exists()) continue;
        const auto at = static_cast<std::size_t>(h);
        SurfaceHit& hit = found.emplace_back();
        hit.surface = hits.surface(i);
        hit.shape = world.geometry->shape_of(hit.surface);
        hit.material = surfaces.material[at];
        hit.point = vec3_at(surfaces.point, h);
        hit.normal = vec3_at(surfaces.normal, h);
        hit.incoming = vec3_at(surfaces.incoming, h);
        hit.origin = vec3_at(rays.origin, hits.first + i);
        hit.t = hits.t[static_cast<std::size_t>(i)];
        hit.ray = static_cast<std::size_t>(surfaces.target[at]) % std::size_t{k_layer_stride};
        hit.magnitude = surfaces.magnitude[at];
        hit.behind = surfaces.behind[at] > 0;
        ++h;
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
