// SPDX-License-Identifier: Apache-2.0
#pragma once
// Files that are written completely or not at all.
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "output/file_in_progress.h"

namespace glint::cli {

/// Whether a path is that of standard output: "-", /dev/stdout or /dev/fd/1.
bool is_standard_output(const std::string& path);

/// The destination of a file's bytes; checked before the work begins.
class OutputFile {
  public:
    /// The destination of the option `option`; "-" is standard output. Throws Failure if the checks show that
    /// nothing can be written there, and a usage error if it would overwrite a file (overwriting.h).
    OutputFile(const std::string& option, std::string path);

    /// By the function of this name.
    bool is_standard_output() const { return standard_output_; }
    /// True for standard output, devices and pipes: their names do not choose a format.
    bool is_stream() const { return direct_; }

    /// Writes the bytes. A regular file is written to a temporary file in the same folder, which replaces it
    /// when complete; pipes and devices are written directly. Throws Failure;
    /// then no new file exists, and an old one is unchanged.
    void write(std::span<const std::uint8_t> bytes) const;

    /// The same in pieces: those of a regular file go to the temporary file, others are kept in memory until
    /// the end. This object must outlive it. Its functions throw Failure.
    std::unique_ptr<FileInProgress> begin() const;

    /// The regular file that write() replaces, with links followed.
    const std::string& target() const { return target_; }

  private:
    class Replacement;
    class Direct;
    void write_directly(std::span<const std::uint8_t> bytes) const;

    std::string path_;    // as the user named it
    std::string target_;  // with symbolic links followed
    bool standard_output_ = false, direct_ = false;
};

/// A name for a temporary file in the folder of `target`, which no other process uses.
std::string temporary_beside(const std::string& target);

}  // namespace glint::cli
