// SPDX-License-Identifier: Apache-2.0
#include "cli/input_file.h"

#include <cerrno>
#include <utility>

#include "cli/failure.h"
#include "cli/overwriting.h"
#include "journal/hash.h"
#include "os/files.h"

namespace glint::cli {
namespace {

constexpr std::size_t k_max_read = std::size_t{1} << 30;  // for a pipe or a device, which may never end

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ > os::k_standard_error) os::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }

  private:
    int number_;
};

// Reads to the end; returns an error message, or an empty string.
std::string read_all(int descriptor, bool binary, std::string& text) {
    constexpr std::size_t step = 1 << 16;
    for (;;) {
        const std::size_t size = text.size();
        if (size >= k_max_read) return "is longer than 1 GiB; only a regular file may be longer";
        text.resize(size + step);
        const std::ptrdiff_t count = os::read(descriptor, text.data() + size, step);
        text.resize(size + static_cast<std::size_t>(count > 0 ? count : 0));
        if (count < 0) return reason_of(errno);
        // The readers report text that contains NUL, with its place. More input is not needed.
        if (count == 0 || (!binary && text.find('\0', size) != std::string::npos)) return {};
    }
}

}  // namespace

std::optional<InputFile> InputFile::open(const std::string& path, std::string& why, bool binary) {
    return open(path, why, binary, false);
}

std::optional<InputFile> InputFile::open_own(const std::string& path, std::string& why) {
    return open(path, why, true, true);
}

std::optional<InputFile> InputFile::open_named(const std::string& path, const FileReach& reach,
                                               std::string& why) {
    const NamedFile named = open_named_file(path, reach, why);
    if (named.descriptor < 0) return std::nullopt;
    const Descriptor file(named.descriptor);
    note_input(file.number());
    InputFile input;
    if (input.map(file.number(), named.size)) return input;
    auto text = read_named_file(named, why);
    if (!text) return std::nullopt;
    return of_text(std::move(*text));
}

bool InputFile::map(int descriptor, std::size_t size) {
    if (size == 0) return false;
    mapped_ = os::map(descriptor, size);
    mapped_size_ = mapped_ == nullptr ? 0 : size;
    return mapped_ != nullptr;
}

std::optional<InputFile> InputFile::open(const std::string& path, std::string& why, bool binary,
                                         bool is_own) {
    const Descriptor file(path == "-" ? os::k_standard_input : os::open_to_read(path));
    const os::FileInfo about = file.number() < 0 ? os::FileInfo() : os::info_of(file.number());
    if (about.kind == os::FileKind::none && errno != EISDIR) {
        why = reason_of(errno);
        return std::nullopt;
    }
    if (about.kind == os::FileKind::none || about.kind == os::FileKind::folder) {
        why = "is a folder";
        return std::nullopt;
    }
    if (!is_own) note_input(file.number());
    InputFile input;
    if (path != "-" && about.kind == os::FileKind::regular &&
        input.map(file.number(), static_cast<std::size_t>(about.size)))
        return input;
    why = read_all(file.number(), binary, input.read_);
    if (!why.empty()) return std::nullopt;
    return input;
}

InputFile InputFile::of_text(std::string text) {
    InputFile input;
    input.read_ = std::move(text);
    return input;
}

InputFile::InputFile(InputFile&& other) noexcept
    : mapped_(std::exchange(other.mapped_, nullptr)),
      mapped_size_(std::exchange(other.mapped_size_, 0)),
      read_(std::move(other.read_)) {}

InputFile& InputFile::operator=(InputFile&& other) noexcept {
    std::swap(mapped_, other.mapped_);
    std::swap(mapped_size_, other.mapped_size_);
    std::swap(read_, other.read_);
    return *this;
}

InputFile::~InputFile() {
    if (mapped_ != nullptr) os::unmap(mapped_, mapped_size_);
}

std::string_view InputFile::text() const {
    return mapped_ != nullptr ? std::string_view(static_cast<const char*>(mapped_), mapped_size_) : read_;
}

void InputFile::release() const {
    if (mapped_ != nullptr) os::release(mapped_, mapped_size_);
}

std::optional<InputFile> TextReader::open(const std::string& path, const FileReach& reach, std::string& why) {
    return reach.is_users ? InputFile::open(path, why) : InputFile::open_named(path, reach, why);
}

Result<std::string> FileSources::read(std::string_view name, std::string_view from) {
    const auto unreadable = [](std::string why) { return Status{ErrorCode::io, std::move(why), {}}; };
    std::string first_why = "no such file";
    bool is_first = true;
    for (const std::string& path : included_paths(name, from, folders_)) {
        try {
            std::string why;
            const std::optional<InputFile> file = reader_.open(path, reach_, why);
            if (file) {
                hashes_.emplace_back(path, hash_of(file->text()));
                return std::string(file->text());
            }
            if (is_first) first_why = std::move(why);
            is_first = false;
        } catch (const Failure& e) {
            failure_ = std::current_exception();
            return unreadable(e.what());
        }
    }
    return unreadable(std::move(first_why));
}

void FileSources::rethrow() const {
    if (failure_) std::rethrow_exception(failure_);
}

}  // namespace glint::cli
