// SPDX-License-Identifier: Apache-2.0
#pragma once
// How explanations name what is in a scene.
#include <cstdint>
#include <string>
#include <string_view>

#include "glint/scene.h"

namespace glint {

/// "line 7", or "balls.glint:7" if it is an included file's; empty if the place is unknown.
std::string line_text(const Scene& scene, SourcePlace place);

/// 'light 2 ("lamp", line 7)', counted from 1 among all of its kind.
std::string item_text(const Scene& scene, std::string_view kind, std::uint32_t index, const ItemTexts& texts);

/// The same of a shape: 'sphere 2 ("ball", line 7)'.
std::string shape_text(const Scene& scene, std::uint32_t shape);

/// With a capital first letter.
std::string capitalized(std::string text);

}  // namespace glint
