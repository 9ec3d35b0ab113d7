// SPDX-License-Identifier: Apache-2.0
// What only the whole scene decides.
#include <algorithm>

#include "formats/povray/clip.h"
#include "formats/povray/scene_builder.h"

namespace glint::povray {

// What is cut and casts no shadow stays whole if it is outside the picture.
void SceneBuilder::check_clips() {
    const auto& all = scene_.materials;
    const bool has_mirrors = refracts_light() || std::any_of(all.begin(), all.end(),
                                                             [](const Material& m) { return m.mirror > 0; });
    for (const UncutShape& uncut : clips_) {
        if (stream_.failed()) return;
        if (!has_mirrors && !is_seen(*uncut.clip, scene_)) continue;
        const bool is_cut = uncut.has_inside &&
                            std::all_of(uncut.objects.begin(), uncut.objects.end(),
                                        [](const ClipObject& clip) { return encloses_space(*clip.object); });
        if (is_cut) {
            cut(uncut);
        } else {
            report(uncut.clip->missing);
        }
    }
}

void SceneBuilder::finish(const Token& scene_at) {
    check_parallel_lights();
    check_no_reflection();
    check_clips();
    check_size(scene_at);
    check_bailout();
    use_interiors();
    check_refraction();
    check_fading();
    if (scene_.fog && media_attenuation_)
        report({"media_attenuation", "of a light in fog", *media_attenuation_});
}

// `no_reflection` matters only where something reflects.
void SceneBuilder::check_no_reflection() {
    const auto& all = scene_.materials;
    const auto is_mirror = [](const Material& m) { return m.mirror > 0 || m.mirror_min > 0; };
    if (no_reflection_ && (refracts_light() || std::any_of(all.begin(), all.end(), is_mirror)))
        report({"no_reflection", "", *no_reflection_});
}

}  // namespace glint::povray
