// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene object of RT2.
#include <string_view>

#include "formats/load_state.h"
#include "formats/parser.h"

namespace glint {

inline constexpr Field k_epfl_scene_fields[] = {{"name"},    {"camera"}, {"materials"}, {"lights"},
                                                {"spheres"}, {"planes"}, {"cylinders"}};

/// Reads the scene object at the parser's token into the scene of `reading`. False if there is none.
bool read_epfl_scene(LoadState& reading, const ReadText& text, Parser& parser);

}  // namespace glint
