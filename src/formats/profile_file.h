// SPDX-License-Identifier: Apache-2.0
#pragma once
// A user's profile: `key = value` lines.
#include "formats/load_state.h"

namespace glint {

/// Applies the lines of the text to the scene, with origin `file`. `profile = NAME` sets every key first.
void read_profile_file(LoadState& reading, const ReadText& text);

/// "no setting is called 'foo'; did you mean `...`?", or, for an existing key, the message of set_setting().
std::string set_named_setting(Scene& scene, std::string_view key, std::string_view value,
                              SettingOrigin origin);

/// Sets the profile. Returns an error message or an empty string.
std::string set_named_profile(Scene& scene, std::string_view name);

}  // namespace glint
