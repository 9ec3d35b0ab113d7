// SPDX-License-Identifier: Apache-2.0
// The stages of worlds with a fault (world/tracer_fault.h) for every instruction set. They are separate from
// kernels.cpp so that glint-core.wasm can be linked without them (src/wasm/left_out.cpp).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "trace/faults.cpp"
#include <hwy/foreach_target.h>  // must precede the other includes

#include "trace/hits/faulty_hits-inl.h"
#include "trace/lighting/direct_lighting-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

void sample_light_with_fault(const WorldParts& world, const PreparedLight& light, const LightRules& rules,
                             const SurfaceBatch& surfaces, LightSampleBatch& samples,
                             ShadowRayBatch& shadow_rays) {
    sample_light_by(FaultyLightRules{rules}, world, light, surfaces, samples, shadow_rays);
}

void add_light_with_fault(const WorldParts& world, const PreparedLight& light, const LightRules& rules,
                          const SurfaceBatch& surfaces, const LightSampleBatch& samples,
                          const HighlightBatch& highlights, RadianceBatch& radiance) {
    add_light_by(FaultyLightRules{rules}, world, light, surfaces, samples, highlights, radiance);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();
