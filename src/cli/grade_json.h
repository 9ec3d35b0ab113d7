// SPDX-License-Identifier: Apache-2.0
#pragma once
// Parts of the outputs of `glint grade`, shared by pictures and rubrics.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "glint/compare.h"

namespace glint::cli {

/// "perhaps shadows-missing (87%)".
std::string cause_text(const Cause& cause);
/// "12 pixels are NaN or infinite". They count as 0 in the figures and would look like a fault of the
/// lighting.
std::string not_finite_text(std::uint64_t pixels);

nlohmann::ordered_json cause_json(const Cause& cause);
/// Indented, with a newline. Bytes that are not UTF-8 are replaced.
std::string dumped(const nlohmann::ordered_json& json);

}  // namespace glint::cli
