// SPDX-License-Identifier: Apache-2.0
#pragma once
// Bytes as text (RFC 4648).
#include <cstdint>
#include <span>
#include <string>

namespace glint {

/// With `=` at the end, without line breaks.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace glint
