// SPDX-License-Identifier: Apache-2.0
#pragma once
// The identifiers of POV-Ray's own include files that exported scenes use, as texts in its language.
#include <string>
#include <string_view>

namespace glint::povray {

/// The folder of Debian's package povray-includes.
inline constexpr std::string_view k_system_folder = "/usr/share/povray-3.7/include/";

struct StandardInclude {
    std::string text;          ///< empty: glint has none of this name
    bool is_complete = false;  ///< it has every identifier of POV-Ray's file
};

/// The text for `#include "name"`.
StandardInclude standard_include(std::string_view name);

}  // namespace glint::povray
