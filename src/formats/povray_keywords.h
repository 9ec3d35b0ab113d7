// SPDX-License-Identifier: Apache-2.0
#pragma once
// Keywords of POV-Ray's language that are not in CSC 473's part of it.
#include <string_view>

namespace glint {

/// The purpose of a block, an item or a modifier of POV-Ray's language: "a solid made of others"; empty for
/// other words.
std::string_view povray_meaning(std::string_view word);

/// True for the words after `#` in POV-Ray's language: declare, macro, include, ...
bool is_povray_directive(std::string_view word);

}  // namespace glint
