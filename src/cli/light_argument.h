// SPDX-License-Identifier: Apache-2.0
#pragma once
// A light as users name it.
#include <cstdint>
#include <string>

#include "glint/scene.h"

namespace glint::cli {

/// Finds a light by its name, or by its number in the scene, counted from 1. option: whose value it is, for
/// the message of the Failure that is thrown if there is no such light, which lists the lights.
std::uint32_t find_light(const std::string& option, const std::string& text, const Scene& scene);

}  // namespace glint::cli
