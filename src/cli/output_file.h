// SPDX-License-Identifier: Apache-2.0
#pragma once
// Writing files that appear whole or not at all.
#include <cstdint>
#include <span>
#include <string>

namespace glint::cli {

/// Where a file's bytes go, found out before the work begins.
class OutputFile {
  public:
    /// Where the option `option` writes; "-" is standard output. Throws Failure if nothing can be written
    /// there as far as one can tell without writing, or of usage if that would overwrite (overwriting.h).
    OutputFile(const std::string& option, std::string path);

    /// True for "-" and /dev/stdout.
    bool is_standard_output() const { return standard_output_; }
    /// True for what has no name of its own to choose a format by: standard output, devices, pipes.
    bool is_stream() const { return direct_; }

    /// Writes the bytes. A regular file gets them by a temporary file in its folder that takes its place when
    /// complete; pipes and devices get them directly. Throws Failure, and then there is no new file and an
    /// old one is as it was.
    void write(std::span<const std::uint8_t> bytes) const;

  private:
    void write_directly(std::span<const std::uint8_t> bytes) const;
    void replace(std::span<const std::uint8_t> bytes) const;

    std::string path_;    // as the user named it
    std::string target_;  // with symbolic links followed
    bool standard_output_ = false, direct_ = false;
};

}  // namespace glint::cli
