// SPDX-License-Identifier: Apache-2.0
#pragma once
// The keys of a log (docs/formats/trace_log.md).
#include <cstdint>
#include <span>
#include <string_view>

#include "diagnose/trace_log.h"

namespace glint {

/// What a key does, besides giving a quantity its value.
enum class KeyUse : std::uint8_t {
    none,
    size,
    rows,
    colors,
    pixel,
    ray,
    light,
    miss,
    shape,
    end,
    visible,
    color,
    diffuse,
    specular
};

struct LogKey {
    std::string_view name;  ///< in small letters, without `_`, `.`, `*` and `-`
    KeyUse use;
    Quantity quantity = Quantity::origin;
};

std::span<const LogKey> log_keys();
/// The key with this name, or null.
const LogKey* find_key(std::string_view name);
/// The key that a word is most likely a misspelling of, or an empty view.
std::string_view nearest_key(std::string_view name);

}  // namespace glint
