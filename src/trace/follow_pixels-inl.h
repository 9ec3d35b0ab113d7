// SPDX-License-Identifier: Apache-2.0
// Traces the rays of pixels without lighting them, and records the surfaces.
#if defined(GLINT_TRACE_FOLLOW_PIXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_FOLLOW_PIXELS_INL_H_
#undef GLINT_TRACE_FOLLOW_PIXELS_INL_H_
#else
#define GLINT_TRACE_FOLLOW_PIXELS_INL_H_
#endif

#include "trace/uniform_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

void make_pixel_rays(const WorldParts& world, const PixelList& pixels, RayBatch& rays) {
    make_listed_camera_rays(world, pixels, SampleIndex{}, rays);
}

void follow_pixels(const WorldParts& world, TileScratch& s, SurfaceRecord& found) {
    s.surface_record = &found;
    s.first_hits.wanted = false;
    trace_samples(world, TileJob{}, &s.pixels, 1, s);
    s.surface_record = nullptr;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
