#pragma once
// How a command ends before its end.
#include <stdexcept>
#include <string>

namespace glint::cli {

// Exit codes.
inline constexpr int k_done = 0, k_bad_input = 1, k_usage = 2, k_interrupted = 130;

/// A command's end with a message for standard error; thrown by commands, caught by main.
class Failure : public std::runtime_error {
  public:
    Failure(int code, const std::string& message) : std::runtime_error(message), code_(code) {}
    int code() const { return code_; }

  private:
    int code_;
};

}  // namespace glint::cli
