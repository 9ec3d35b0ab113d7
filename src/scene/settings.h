// SPDX-License-Identifier: Apache-2.0
#pragma once
// The table of settings (conventions and render settings) inside this module.
#include "glint/scene.h"

namespace glint {

/// The conventions and render settings of a named profile, as data.
struct Profile {
    std::string_view name;
    Conventions conventions;
    RenderSettings settings;
    bool left_handed = false;  ///< handedness of the camera's right, up and forward
};

/// All profiles, in the order of profile_names().
std::span<const Profile> profiles();

}  // namespace glint
