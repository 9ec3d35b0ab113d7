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

#include "cli/failure.h"
#include "cli/interrupt.h"
#include "cli/overwriting.h"

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

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace

OutputFile::OutputFile(const std::string& option, std::string path) : path_(std::move(path)), target_(path_) {
    standard_output_ = path_ == "-" || path_ == "/dev/stdout" || path_ == "/dev/fd/1";
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

void OutputFile::write(std::span<const std::uint8_t> bytes) const {
    if (direct_) {
        write_directly(bytes);
    } else {
        replace(bytes);
    }
}

void OutputFile::write_directly(std::span<const std::uint8_t> bytes) const {
    const int descriptor = standard_output_ ? STDOUT_FILENO : ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) fail(path_, errno);
    int error = write_all(descriptor, bytes);
    if (!standard_output_ && ::close(descriptor) != 0 && error == 0) error = errno;
    if (error != 0) fail(path_, error);
}

void OutputFile::replace(std::span<const std::uint8_t> bytes) const {
    const std::string folder = folder_of(target_);
    std::random_device random;  // process numbers are not unique if machines share a folder
    const std::string temporary = fmt::format("{}/.glint-{:08x}{:08x}.tmp", folder, random(), random());
    const UnfinishedFile unfinished(temporary);
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) fail(path_, errno);
    struct stat old {};
    if (::stat(target_.c_str(), &old) == 0) ::fchmod(descriptor, old.st_mode & 07777);
    int error = write_all(descriptor, bytes);
    if (::close(descriptor) != 0 && error == 0) error = errno;
    if (error == 0 && ::rename(temporary.c_str(), target_.c_str()) != 0) error = errno;
    if (error != 0) {
        ::unlink(temporary.c_str());
        fail(path_, error);
    }
}

}  // namespace glint::cli
