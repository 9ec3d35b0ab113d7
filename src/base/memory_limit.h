// SPDX-License-Identifier: Apache-2.0
#pragma once
// Limits of the memory that a function takes (max_memory of its options).
#include <cstdint>
#include <string>
#include <string_view>

#include "glint/result.h"

namespace glint {

/// "384 MiB": three digits, or the bytes below 1 KiB.
std::string memory_text(std::uint64_t bytes);

/// An error if more bytes are needed than allowed. doing: "comparing the pictures".
Status memory_fault(std::uint64_t needed, std::uint64_t allowed, std::string_view doing);

}  // namespace glint
