// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace glint::cli {

/// If the arguments hold flags of POV-Ray, Tachyon or other renderers: an answer that names glint's own, flag
/// by flag, and the whole command as glint says it. `command`: the command that the first argument names;
/// empty if it names none, and then `render` is proposed.
std::optional<std::string> answer_foreign_flags(std::span<const std::string> arguments,
                                                std::string_view command);

}  // namespace glint::cli
