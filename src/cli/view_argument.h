// SPDX-License-Identifier: Apache-2.0
#pragma once
// --view front|iso|X,Y,Z.
#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "glint/vec.h"

namespace glint::cli {

/// The direction from a mesh to the eye, of LoadOptions::view: `front`, which is (0, 0, 1), `iso`, (1, 1, 1),
/// or three numbers X,Y,Z that are not all 0. Nothing if it is none of these.
std::optional<Vec3> parse_view(std::string_view text);

/// "expected front, iso or X,Y,Z, ..., found 'text'".
std::string view_message(std::string_view text);

/// Adds --view.
void add_view_argument(CLI::App& command, std::optional<Vec3>& view);

}  // namespace glint::cli
