#pragma once
#include <optional>
#include <span>
#include <string>

namespace glint::cli {

/// If the arguments hold flags of POV-Ray or Tachyon: an answer that names glint's own, flag by flag, and the
/// whole command as glint says it.
std::optional<std::string> answer_foreign_flags(std::span<const std::string> arguments);

}  // namespace glint::cli
