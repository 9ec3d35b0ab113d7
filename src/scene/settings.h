// SPDX-License-Identifier: Apache-2.0
#pragma once
// The table of settings (conventions and render settings) inside this module.
#include "glint/scene.h"

namespace glint {

/// The handedness of the camera's right, up and forward in a source's scenes. either: both are usual
/// (POV-Ray: left-handed by default, right-handed by `right` in exported models). right_unless_povray: right,
/// or left in a file that POV-Ray renders with the same right vector (CSC 473).
enum class Handedness : std::uint8_t { right, left, either, right_unless_povray };

/// The conventions and render settings of a named profile, as data.
struct Profile {
    std::string_view name;
    Conventions conventions;
    RenderSettings settings;
    Handedness handedness = Handedness::right;
};

/// All profiles, in the order of profile_names().
std::span<const Profile> profiles();

}  // namespace glint
