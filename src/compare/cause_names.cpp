// SPDX-License-Identifier: Apache-2.0
#include "compare/cause_names.h"

#include <algorithm>

#include "compare/picture_causes.h"
#include "compare/scene_faults.h"

namespace glint {
namespace {

std::vector<std::string_view> collect() {
    // Those that are not rows of the tables of faults: composed, counted by item, or fitted.
    std::vector<std::string_view> names = {
        "abs-cosine",         "normals-reversed",   "not-normalized",     "shadow-black",
        "anti-aliasing",      "area-light-samples", "light-alone",        "light-missing",
        "light-scaled",       "reflections-fewer",  "shifted-half-pixel", "shifted-one-pixel",
        "shadows-soft",       "camera-moved",       "camera-turned",      "field-of-view-scaled",
        "fog-color",          "light-moved",        "material-color",     "shape-missing",
        "shape-moved",        "shape-scaled",       "spot-turned",        "shadow-of-another-light",
        "light-maximum",      "tone-curve",         "mirrors-show-less",  "mirror-part-not-mixed",
        "local-color-clamped"};
    for (const auto faults :
         {lighting_faults(), light_kind_faults(), tracing_faults(), medium_faults(), texture_faults(),
          camera_faults(), kernel_faults(), shape_faults(), mixed_up_faults()}) {
        for (const SceneFault& fault : faults) {
            for (const std::string_view name : {fault.name, fault.scaled}) {
                if (!name.empty()) names.push_back(name);
            }
        }
    }
    for (const PictureCause& cause : picture_causes()) names.emplace_back(cause.name);
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

}  // namespace

const std::vector<std::string_view>& cause_names() {
    static const std::vector<std::string_view> names = collect();
    return names;
}

}  // namespace glint
