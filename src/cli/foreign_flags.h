// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace glint::cli {

/// Whether a command has an option ("--size") or an argument ("SCENE") of this name.
using HasOption = std::function<bool(const std::string&)>;

/// If the arguments of `command` hold flags of POV-Ray, Tachyon or other renderers: an answer that names
/// glint's own, flag by flag, and the whole command as glint says it. A flag for which the command has no
/// option is answered so; a command that reads no scene and no picture has no answers.
std::optional<std::string> answer_foreign_flags(std::span<const std::string> arguments,
                                                std::string_view command, const HasOption& has_option);

}  // namespace glint::cli
