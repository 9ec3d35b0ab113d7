// SPDX-License-Identifier: Apache-2.0
#pragma once
// Words of POV-Ray's own language that CSC 473's part of it has not.
#include <string_view>

namespace glint {

/// What a block, an item or a modifier of POV-Ray's language is for, "a solid made of others"; empty for any
/// other word.
std::string_view povray_meaning(std::string_view word);

/// True for what follows `#` in POV-Ray's language: declare, macro, include, ...
bool is_povray_directive(std::string_view word);

}  // namespace glint
