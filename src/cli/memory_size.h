// SPDX-License-Identifier: Apache-2.0
#pragma once
// --max-memory SIZE.
#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace glint::cli {

/// Bytes: a whole number above 0, with K, M, G or T for powers of 1024. Nothing if it is none.
std::optional<std::uint64_t> parse_memory_size(std::string_view text);

/// Adds --max-memory SIZE; 0 if it is not given.
void add_memory_argument(CLI::App& command, std::uint64_t& bytes, const std::string& description);

}  // namespace glint::cli
