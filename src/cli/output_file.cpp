// SPDX-License-Identifier: Apache-2.0
#include "cli/output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <random>
#include <utility>
#include <vector>

#include "cli/failure.h"
#include "cli/file_policy.h"
#include "cli/interrupt.h"
#include "cli/overwriting.h"
#include "cli/program.h"
#include "image/memory_file.h"

namespace glint::cli {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
    throw Failure(k_bad_input, fmt::format("cannot write '{}': {}", path, std::strerror(error)));
}

// Returns 0 or errno.
int write_all(int descriptor, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return 0;
}

}  // namespace

std::string temporary_beside(const std::string& target) {
    std::random_device random;  // process numbers are not unique if machines share a folder
    return fmt::format("{}/.glint-{:08x}{:08x}.tmp", folder_of(target), random(), random());
}

void sync_folder(const std::string& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);  // not all file systems can
    ::close(descriptor);
}

bool is_standard_output(const std::string& path) {
    return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1";
}

OutputFile::OutputFile(const std::string& option, std::string path) : path_(std::move(path)), target_(path_) {
    standard_output_ = cli::is_standard_output(path_);
    if (standard_output_) note_standard_output(option);
    struct stat about {};
    const bool exists = !standard_output_ && ::stat(path_.c_str(), &about) == 0;
    if (exists && S_ISDIR(about.st_mode)) {
        throw Failure(k_bad_input, fmt::format("cannot write '{}': is a folder", path_));
    }
    direct_ = standard_output_ || (exists && !S_ISREG(about.st_mode));
    if (direct_) return;
    if (!exists && errno == ELOOP) fail(path_, errno);
    // The file that a link names is replaced or made, not the link.
    struct stat link {};
    if (exists || (::lstat(path_.c_str(), &link) == 0 && S_ISLNK(link.st_mode))) target_ = followed(path_);
    if (exists && ::access(target_.c_str(), W_OK) != 0) fail(path_, errno);
    const std::string folder = folder_of(target_);
    if (::stat(folder.c_str(), &about) != 0) {
        if (errno != ENOENT) fail(path_, errno);
        throw Failure(k_bad_input, fmt::format("cannot write '{}': there is no folder '{}'", path_, folder));
    }
    if (!S_ISDIR(about.st_mode)) {
        throw Failure(k_bad_input, fmt::format("cannot write '{}': '{}' is not a folder", path_, folder));
    }
    if (::access(folder.c_str(), W_OK | X_OK) != 0) {
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
        descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0) fail(path_, errno);
        struct stat old {};
        if (::stat(target_.c_str(), &old) == 0) ::fchmod(descriptor_, old.st_mode & 07777);
    }
    ~Replacement() override {
        if (descriptor_ < 0) return;
        ::close(descriptor_);
        ::unlink(temporary_.c_str());
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
        if (::lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) fail(path_, errno);
        written_ = position;
    }
    void commit(bool durable) override {
        flush();
        if (durable && ::fsync(descriptor_) != 0) fail(path_, errno);
        int error = ::close(std::exchange(descriptor_, -1)) != 0 ? errno : 0;
        if (error == 0 && ::rename(temporary_.c_str(), target_.c_str()) != 0) error = errno;
        if (error != 0) {
            ::unlink(temporary_.c_str());
            fail(path_, error);
        }
        if (durable) sync_folder(folder_of(target_));
    }

  private:
    void flush() {
        write_now(buffer_);
        buffer_.clear();
    }
    void write_now(std::span<const std::uint8_t> bytes) {
        if (const int error = write_all(descriptor_, bytes); error != 0) fail(path_, error);
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
    const int descriptor = standard_output_ ? STDOUT_FILENO : ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) fail(path_, errno);
    int error = write_all(descriptor, bytes);
    if (!standard_output_ && ::close(descriptor) != 0 && error == 0) error = errno;
    if (error == EPIPE && standard_output_) end_by_broken_pipe();
    if (error != 0) fail(path_, error);
}

}  // namespace glint::cli
