// SPDX-License-Identifier: Apache-2.0
// Renders a tile with the samples that the settings ask for.
#if defined(GLINT_TRACE_TILE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_TILE_INL_H_
#undef GLINT_TRACE_TILE_INL_H_
#else
#define GLINT_TRACE_TILE_INL_H_
#endif

#include "trace/adaptive_tile-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

void render_tile(const WorldParts& world, const TileJob& job, TileScratch& s) {
    if (world.settings.is_adaptive()) return render_adaptive_tile(world, job, s);
    render_uniform_tile(world, job, world.settings.samples, s);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
