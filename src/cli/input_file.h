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

#include "cli/file_policy.h"
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

    /// The same for a file that another file names (file_policy.h).
    static std::optional<InputFile> open_named(const std::string& path, const FileReach& reach,
                                               std::string& why);

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
    bool map(int descriptor, std::size_t size);
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
    /// As InputFile::open, or open_named if the user does not name it.
    virtual std::optional<InputFile> open(const std::string& path, const FileReach& reach, std::string& why);
    std::optional<InputFile> open(const std::string& path, std::string& why) {
        return open(path, {.is_users = true}, why);
    }
};

/// Files that scenes include, relative to the file that includes them, else in one of the folders.
class FileSources : public Sources {
  public:
    /// The reader must outlive this.
    explicit FileSources(TextReader& reader, std::vector<std::string> folders, FileReach reach)
        : reader_(reader), folders_(std::move(folders)), reach_(std::move(reach)) {}
    Result<std::string> read(std::string_view name, std::string_view from) override;

    /// Name and hash (journal/hash.h) of each text that was read, in the order of reading.
    const std::vector<std::pair<std::string, std::string>>& hashes() const { return hashes_; }

    /// Throws the Failure that opening a file caused; it cannot pass through the library.
    void rethrow() const;

  private:
    TextReader& reader_;
    std::vector<std::string> folders_;
    FileReach reach_;
    std::exception_ptr failure_;
    std::vector<std::pair<std::string, std::string>> hashes_;
};

}  // namespace glint::cli
