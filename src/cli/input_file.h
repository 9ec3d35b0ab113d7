// SPDX-License-Identifier: Apache-2.0
#pragma once
// Reading scene files: regular files are mapped, others are read up to a limit.
#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "glint/load.h"

namespace glint::cli {

/// The text of a file; it exists as long as this object.
class InputFile {
  public:
    /// Opens and reads `path` ("-": standard input). If nothing is returned, `why` holds the reason ("no such
    /// file"). `binary`: NUL bytes are expected; otherwise, reading a pipe stops at the first one. Throws
    /// Failure (usage error) if the command would overwrite the file (overwriting.h).
    static std::optional<InputFile> open(const std::string& path, std::string& why, bool binary = false);

    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&& other) noexcept;
    ~InputFile();

    std::string_view text() const;

  private:
    InputFile() = default;
    void* mapped_ = nullptr;
    std::size_t mapped_size_ = 0;
    std::string read_;  // if not mapped
};

/// Files that scenes include, relative to the file that includes them.
class FileSources : public Sources {
  public:
    Result<std::string> read(std::string_view name, std::string_view from) override;

    /// Throws the Failure that opening a file caused; it cannot pass through the library.
    void rethrow() const;

  private:
    std::exception_ptr failure_;
};

}  // namespace glint::cli
