// SPDX-License-Identifier: Apache-2.0
#pragma once
// A hash of bytes, to recognise files that have changed.
#include <string>
#include <string_view>

namespace glint {

/// 32 hexadecimal digits: XXH3, 128 bits, in its canonical form, which is the same on all machines.
std::string hash_of(std::string_view bytes);

}  // namespace glint
