// SPDX-License-Identifier: Apache-2.0
#pragma once
// Reading scene files: regular files are mapped, anything else is read up to a limit.
#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "glint/load.h"

namespace glint::cli {

/// The text of a file, kept as long as this lives.
class InputFile {
  public:
    /// Opens and reads `path` ("-": standard input). `why` says what is wrong ("no such file") if nothing is
    /// returned. `binary`: NUL bytes are expected (else reading a pipe stops at the first). Throws Failure of
    /// usage if the command would overwrite the file (overwriting.h).
    static std::optional<InputFile> open(const std::string& path, std::string& why, bool binary = false);

    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&& other) noexcept;
    ~InputFile();

    std::string_view text() const;

  private:
    InputFile() = default;
    void* mapped_ = nullptr;
    std::size_t mapped_size_ = 0;
    std::string read_;  // when not mapped
};

/// Files that scenes include, relative to the file that names them.
class FileSources : public Sources {
  public:
    Result<std::string> read(std::string_view name, std::string_view from) override;

    /// Throws the Failure that a file ended in, which cannot pass through the library.
    void rethrow() const;

  private:
    std::exception_ptr failure_;
};

}  // namespace glint::cli
