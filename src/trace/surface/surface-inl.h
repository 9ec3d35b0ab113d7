// SPDX-License-Identifier: Apache-2.0
// The surfaces as the formulas of lighting and of ray origins take them.
#if defined(GLINT_TRACE_SURFACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SURFACE_INL_H_
#undef GLINT_TRACE_SURFACE_INL_H_
#else
#define GLINT_TRACE_SURFACE_INL_H_
#endif

#include "geometry/ray_offset-inl.h"
#include "trace/batches.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The surface points of a vector of hits, for the formulas of lighting and of ray origins.
HWY_INLINE SurfacePoint<Doubles> surface_at(const SurfaceBatch& surfaces, int h) {
    return {load_vector3(surfaces.point, h), load_vector3(surfaces.normal, h),
            load_vector3(surfaces.incoming, h), load(surfaces.magnitude.data() + h)};
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
