// SPDX-License-Identifier: Apache-2.0
#pragma once
// The arguments of `glint render`.
#include <optional>
#include <string>

#include "cli/picture_arguments.h"
#include "cli/scene_arguments.h"

namespace glint::cli {

struct RenderArguments {
    SceneArguments scene;
    PictureArguments picture;
    NumberArguments numbers;
    std::optional<std::string> aov;
    std::string output, crop, isa, stats, part;
    bool resume = false, strict = false, show = false, quiet = false;
    bool keeps_size = false;      ///< the picture has the whole's size, with black around the crop
    bool hides_warnings = false;  ///< of the scene
    int threads = 0;
};

/// What `glint render` does with these arguments. Throws Failure.
int render_picture(RenderArguments& arguments);

}  // namespace glint::cli
