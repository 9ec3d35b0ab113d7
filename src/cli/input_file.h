// SPDX-License-Identifier: Apache-2.0
#pragma once
// Reading scene files: regular files are mapped, others are read up to a limit.
#include <cstddef>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glint/load.h"

namespace glint::cli {

/// The text of a file; it exists as long as this object.
class InputFile {
  public:
    /// Opens and reads `path` ("-": standard input). If nothing is returned, `why` holds the reason ("no such
    /// file"). `binary`: NUL bytes are expected; otherwise, reading a pipe stops at the first one. Throws
    /// Failure (usage error) if the command would overwrite the file (overwriting.h).
    static std::optional<InputFile> open(const std::string& path, std::string& why, bool binary = false);

    /// The same for a file that the command itself wrote, and may write over.
    static std::optional<InputFile> open_own(const std::string& path, std::string& why);

    /// A text that is no file of this machine.
    static InputFile of_text(std::string text);

    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&& other) noexcept;
    ~InputFile();

    std::string_view text() const;
    /// Gives back the memory of what was read; text() stays valid, and is read from the file again.
    void release() const;

  private:
    InputFile() = default;
    static std::optional<InputFile> open(const std::string& path, std::string& why, bool binary, bool is_own);
    void* mapped_ = nullptr;
    std::size_t mapped_size_ = 0;
    std::string read_;  // if not mapped
};

/// Opens the files that a scene is read from.
class TextReader {
  public:
    TextReader() = default;
    virtual ~TextReader() = default;
    TextReader(const TextReader&) = delete;
    TextReader& operator=(const TextReader&) = delete;
    /// As InputFile::open. included: another text names it, and it must be a regular file.
    virtual std::optional<InputFile> open(const std::string& path, bool included, std::string& why);
};

/// Files that scenes include, relative to the file that includes them, else in one of the folders.
class FileSources : public Sources {
  public:
    /// The reader must outlive this.
    explicit FileSources(TextReader& reader, std::vector<std::string> folders = {})
        : reader_(reader), folders_(std::move(folders)) {}
    Result<std::string> read(std::string_view name, std::string_view from) override;

    /// Name and hash (journal/hash.h) of each text that was read, in the order of reading.
    const std::vector<std::pair<std::string, std::string>>& hashes() const { return hashes_; }

    /// Throws the Failure that opening a file caused; it cannot pass through the library.
    void rethrow() const;

  private:
    TextReader& reader_;
    std::vector<std::string> folders_;
    std::exception_ptr failure_;
    std::vector<std::pair<std::string, std::string>> hashes_;
};

}  // namespace glint::cli
