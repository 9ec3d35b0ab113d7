// SPDX-License-Identifier: Apache-2.0
#include "cli/output_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <random>
#include <utility>
#include <vector>

#include "cli/failure.h"
#include "cli/file_policy.h"
#include "cli/interrupt.h"
#include "cli/overwriting.h"
#include "image/memory_file.h"
#include "os/files.h"
#include "os/process.h"

namespace glint::cli {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
    throw Failure(k_bad_input, fmt::format("cannot write '{}': {}", path, std::strerror(error)));
}

bool write_all(int descriptor, std::span<const std::uint8_t> bytes) {
    return os::write(descriptor, reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

}  // namespace

std::string temporary_beside(const std::string& target) {
    std::random_device random;  // process numbers are not unique if machines share a folder
    return fmt::format("{}/.glint-{:08x}{:08x}.tmp", os::folder_of(target), random(), random());
}

bool is_standard_output(const std::string& path) {
    return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1";
}

OutputFile::OutputFile(const std::string& option, std::string path) : path_(std::move(path)), target_(path_) {
    standard_output_ = cli::is_standard_output(path_);
    if (standard_output_) note_standard_output(option);
    const os::FileKind kind = standard_output_ ? os::FileKind::none : os::info_of(path_).kind;
    if (kind == os::FileKind::folder) {
        throw Failure(k_bad_input, fmt::format("cannot write '{}': is a folder", path_));
    }
    const bool exists = kind != os::FileKind::none;
    direct_ = standard_output_ || kind == os::FileKind::other;
    if (direct_) return;
    if (!exists && errno == ELOOP) fail(path_, errno);
    // The file that a link names is replaced or made, not the link.
    if (exists || os::is_link(path_)) target_ = os::to_string(followed(path_));
    if (exists && !os::is_writable(target_)) fail(path_, errno);
    const std::string folder = os::folder_of(target_);
    const os::FileKind kind_of_folder = os::info_of(folder).kind;
    if (kind_of_folder == os::FileKind::none) {
        if (errno != ENOENT) fail(path_, errno);
        throw Failure(k_bad_input, fmt::format("cannot write '{}': there is no folder '{}'", path_, folder));
    }
    if (kind_of_folder != os::FileKind::folder) {
        throw Failure(k_bad_input, fmt::format("cannot write '{}': '{}' is not a folder", path_, folder));
    }
    if (!os::is_writable_folder(folder)) {
        throw Failure(k_bad_input,
                      fmt::format("cannot write '{}': folder '{}': {}", path_, folder, std::strerror(errno)));
    }
    note_output(option, path_);
}

// A temporary file in the same folder, which replaces the target when it is complete.
class OutputFile::Replacement : public FileInProgress {
  public:
    explicit Replacement(const OutputFile& file)
        : path_(file.path_),
          target_(file.target_),
          temporary_(temporary_beside(target_)),
          unfinished_(temporary_) {
        descriptor_ = os::open_new(temporary_);
        if (descriptor_ < 0) fail(path_, errno);
        os::copy_permissions(target_, descriptor_);
    }
    ~Replacement() override {
        if (descriptor_ < 0) return;
        os::close(descriptor_);
        os::remove(temporary_);
    }
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    void write(std::span<const std::uint8_t> bytes) override {
        constexpr std::size_t most = std::size_t{1} << 20;
        if (buffer_.size() + bytes.size() > most) flush();
        if (bytes.size() > most) {
            write_now(bytes);
        } else {
            buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
        }
    }
    std::uint64_t position() const override { return written_ + buffer_.size(); }
    void seek(std::uint64_t position) override {
        flush();
        if (!os::seek(descriptor_, position)) fail(path_, errno);
        written_ = position;
    }
    void commit(bool durable) override {
        flush();
        if (durable && !os::sync(descriptor_)) fail(path_, errno);
        if (!os::close(std::exchange(descriptor_, -1)) || !os::replace(temporary_, target_)) {
            const int error = errno;
            os::remove(temporary_);
            fail(path_, error);
        }
        if (durable) os::sync_folder(os::folder_of(target_));
    }

  private:
    void flush() {
        write_now(buffer_);
        buffer_.clear();
    }
    void write_now(std::span<const std::uint8_t> bytes) {
        if (!write_all(descriptor_, bytes)) fail(path_, errno);
        written_ += bytes.size();
    }

    const std::string path_, target_, temporary_;
    const UnfinishedFile unfinished_;
    int descriptor_ = -1;
    std::vector<std::uint8_t> buffer_;
    std::uint64_t written_ = 0;  // the place in the file where the buffer begins
};

// A pipe or a device cannot be written to at earlier places, and gets nothing of an incomplete file.
class OutputFile::Direct : public FileInProgress {
  public:
    explicit Direct(const OutputFile& file) : file_(file) {}
    void write(std::span<const std::uint8_t> bytes) override { memory_.write(bytes); }
    std::uint64_t position() const override { return memory_.position(); }
    void seek(std::uint64_t position) override { memory_.seek(position); }
    void commit(bool) override { file_.write_directly(bytes_); }

  private:
    const OutputFile& file_;
    std::vector<std::uint8_t> bytes_;
    MemoryFile memory_{bytes_};
};

std::unique_ptr<FileInProgress> OutputFile::begin() const {
    if (direct_) return std::make_unique<Direct>(*this);
    return std::make_unique<Replacement>(*this);
}

void OutputFile::write(std::span<const std::uint8_t> bytes) const {
    if (direct_) return write_directly(bytes);
    const auto file = begin();
    file->write(bytes);
    file->commit(false);
}

void OutputFile::write_directly(std::span<const std::uint8_t> bytes) const {
    const int descriptor = standard_output_ ? os::k_standard_output : os::open_to_write(target_);
    if (descriptor < 0) fail(path_, errno);
    int error = write_all(descriptor, bytes) ? 0 : errno;
    if (!standard_output_ && !os::close(descriptor) && error == 0) error = errno;
    if (error == EPIPE && standard_output_) os::end_by_broken_pipe();
    if (error != 0) fail(path_, error);
}

}  // namespace glint::cli
