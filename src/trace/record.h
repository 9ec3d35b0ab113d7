// SPDX-License-Identifier: Apache-2.0
#pragma once
// The data that the stages of a one-pixel tile record (trace/record-inl.h), for explain().
#include <cstddef>
#include <optional>
#include <vector>

#include "glint/explain.h"
#include "world/geometry/surface_id.h"

namespace glint {

struct TileRecord {
    /// The index of the default material follows the last one.
    std::vector<ExplainedRay> rays;
    int sample = 0;        // the current sample
    int only = -1;         // the sample to record; -1: all
    bool is_full = false;  // the rays of all samples exceed k_max_explained_rays

    /// With adaptive sampling: why the pixel has several samples, or one.
    std::optional<SampleDifference> difference;
    bool refined = false;
    void decide(const SampleDifference& found, bool has_several) {
        difference = found;
        refined = has_several;
        if (!refined && only > 0) only = 0;
    }

    /// Starts sample number `next`. Returns whether it is to be recorded.
    bool begin(int next) {
        sample = next;
        is_full = is_full || (only < 0 && rays.size() > k_max_explained_rays);
        return !is_full && (only < 0 || only == next);
    }

    struct SpawnedRay {
        int ray;  // the ray whose hit it starts from
        bool transmitted, straight;
    };
    std::vector<SpawnedRay> spawned;  // the secondary rays that were traced, in the order of their rays
    std::size_t arrived = 0;          // the first of them that has not been recorded

    struct ShadowStep {
        int ray;  // in the ShadowRayBatch
        SurfaceId surface;
        double t;
        Color factor, fade;
    };
    std::vector<ShadowStep> shadow_steps;  // the transparent surfaces on the shadow rays of the current light
    struct SampleStep {
        int sample, surface;
        ShadowStep step;
    };
    std::vector<SampleStep> sample_steps;  // likewise, of a light that shines from its centre
    struct SkyRay {
        std::size_t ray;  // whose hit it starts from; of sky_rays: the surface's number in the stream
        Vec3 origin, direction;
        double t_min, t_max;
    };
    std::vector<SkyRay> sky_rays;     // the occlusion samples of the current stream that are blocked
    std::vector<SkyRay> blocked_sky;  // those of the recorded hits

    std::vector<std::size_t> batch;  // the rays of the hits in the current batch
    ExplainedHit& hit(int h) { return *rays[batch[static_cast<std::size_t>(h)]].hit; }
};

}  // namespace glint
