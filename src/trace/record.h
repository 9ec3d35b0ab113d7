// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the stages of a tile of one pixel write down of it (trace/record-inl.h), for explain().
#include <cstddef>
#include <vector>

#include "glint/explain.h"

namespace glint {

struct TileRecord {
    /// Light numbers are the World's, and a default material has the number after the last.
    std::vector<ExplainedRay> rays;
    int sample = 0;        // at hand
    int only = -1;         // the sample that is written down; -1: all
    bool is_full = false;  // of all samples there were too many rays

    /// Whether sample number `next` is written down.
    bool begin(int next) {
        sample = next;
        is_full = is_full || (only < 0 && rays.size() > k_max_explained_rays);
        return !is_full && (only < 0 || only == next);
    }

    struct SpawnedRay {
        int ray;  // it leaves this one's hit
        bool transmitted;
    };
    std::vector<SpawnedRay> spawned;  // branches that were traced, in the order of their rays
    std::size_t arrived = 0;          // the first of these whose ray has not come

    std::vector<std::size_t> batch;  // the rays of the hits of the batch at hand
    ExplainedHit& hit(int h) { return *rays[batch[static_cast<std::size_t>(h)]].hit; }
};

}  // namespace glint
