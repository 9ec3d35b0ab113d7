// SPDX-License-Identifier: Apache-2.0
#include "cli/input_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "cli/failure.h"
#include "cli/overwriting.h"
#include "journal/hash.h"

namespace glint::cli {
namespace {

constexpr std::size_t k_max_read = std::size_t{1} << 30;  // for a pipe or a device, which may never end

class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ > 2) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int number() const { return number_; }

  private:
    int number_;
};

std::string reason(int error) { return error == ENOENT ? "no such file" : std::strerror(error); }

// Reads to the end; returns an error message, or an empty string.
std::string read_all(int descriptor, bool binary, std::string& text) {
    constexpr std::size_t step = 1 << 16;
    for (;;) {
        const std::size_t size = text.size();
        if (size >= k_max_read) return "is longer than 1 GiB; only a regular file may be longer";
        text.resize(size + step);
        const ssize_t count = ::read(descriptor, text.data() + size, step);
        text.resize(size + static_cast<std::size_t>(count > 0 ? count : 0));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return reason(errno);
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

std::optional<InputFile> InputFile::open(const std::string& path, std::string& why, bool binary,
                                         bool is_own) {
    const Descriptor file(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    struct stat about {};
    if (file.number() < 0 || ::fstat(file.number(), &about) != 0) {
        why = reason(errno);
        return std::nullopt;
    }
    if (S_ISDIR(about.st_mode)) {
        why = "is a folder";
        return std::nullopt;
    }
    if (!is_own) note_input(file.number());
    InputFile input;
    if (path != "-" && S_ISREG(about.st_mode) && about.st_size > 0) {
        const auto size = static_cast<std::size_t>(about.st_size);
        void* mapped = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file.number(), 0);
        if (mapped != MAP_FAILED) {
            input.mapped_ = mapped;
            input.mapped_size_ = size;
            return input;
        }
    }
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
    if (mapped_ != nullptr) ::munmap(mapped_, mapped_size_);
}

std::string_view InputFile::text() const {
    return mapped_ != nullptr ? std::string_view(static_cast<const char*>(mapped_), mapped_size_) : read_;
}

void InputFile::release() const {
    if (mapped_ != nullptr) ::madvise(mapped_, mapped_size_, MADV_DONTNEED);
}

std::optional<InputFile> TextReader::open(const std::string& path, bool included, std::string& why) {
    // A pipe would wait for a writer.
    struct stat about {};
    if (included && ::stat(path.c_str(), &about) == 0 && !S_ISREG(about.st_mode)) {
        why = "not a regular file";
        return std::nullopt;
    }
    return InputFile::open(path, why);
}

Result<std::string> FileSources::read(std::string_view name, std::string_view from) {
    const auto unreadable = [](std::string why) { return Status{ErrorCode::io, std::move(why), {}}; };
    std::vector<std::string> paths{std::string(name)};
    if (!name.starts_with('/')) {
        paths.front().insert(0, from.substr(0, from.rfind('/') + 1));
        for (const std::string& folder : folders_) paths.push_back(folder + "/" + std::string(name));
    }
    std::string first_why;
    for (const std::string& path : paths) {
        if (path.find('\0') != std::string::npos || path == "-") return unreadable("no such file");
        try {
            std::string why;
            const std::optional<InputFile> file = reader_.open(path, true, why);
            if (file) {
                hashes_.emplace_back(path, hash_of(file->text()));
                return std::string(file->text());
            }
            if (first_why.empty()) first_why = std::move(why);
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
