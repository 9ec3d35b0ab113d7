// SPDX-License-Identifier: Apache-2.0
// What only the whole scene decides.
#include <algorithm>

#include "formats/povray/clip.h"
#include "formats/povray/scene_builder.h"

namespace glint::povray {

// Clips are no error if they cut only what is outside the picture, and what is cut casts no shadow.
void SceneBuilder::check_clips() {
    const auto& all = scene_.materials;
    const bool has_mirrors = std::any_of(
        all.begin(), all.end(), [](const Material& m) { return m.mirror > 0 || m.transmission > 0; });
    for (const auto& clip : clips_) {
        if (has_mirrors || is_seen(*clip, scene_)) report(clip->missing);
    }
}

void SceneBuilder::finish(const Token& scene_at) {
    check_parallel_lights();
    check_no_reflection();
    check_glass();
    check_clips();
    check_size(scene_at);
    check_bailout();
    use_interiors();
}

// `no_reflection` matters only where something reflects.
void SceneBuilder::check_no_reflection() {
    const auto reflects = [](const Material& m) {
        return m.mirror > 0 || m.mirror_min > 0 || m.transmission > 0;
    };
    if (no_reflection_ && std::any_of(scene_.materials.begin(), scene_.materials.end(), reflects))
        report({"no_reflection", "", *no_reflection_});
}

}  // namespace glint::povray
