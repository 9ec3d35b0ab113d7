// SPDX-License-Identifier: Apache-2.0
#include "os/files.h"

#include <fcntl.h>
#include <fnmatch.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace glint::os {
namespace {

FileInfo info(const struct stat& about) {
    return {.kind = S_ISREG(about.st_mode)   ? FileKind::regular
                    : S_ISDIR(about.st_mode) ? FileKind::folder
                                             : FileKind::other,
            .size = static_cast<std::uint64_t>(about.st_size),
            .identity = {about.st_dev, about.st_ino},
            .has_name = about.st_nlink > 0};
}

constexpr mode_t k_permissions = 0666;  // without what umask takes away

}  // namespace

FileInfo info_of(const std::string& path) {
    struct stat about {};
    return ::stat(path.c_str(), &about) == 0 ? info(about) : FileInfo{};
}

FileInfo info_of(int descriptor) {
    struct stat about {};
    return ::fstat(descriptor, &about) == 0 ? info(about) : FileInfo{};
}

int open_to_read(const std::string& path) { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC); }
int open_regular(const std::string& path) {
    return ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
}
int open_to_write(const std::string& path) { return ::open(path.c_str(), O_WRONLY | O_CLOEXEC); }
int open_new(const std::string& path) {
    return ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, k_permissions);
}
int open_or_make(const std::string& path) {
    return ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, k_permissions);
}
bool close(int descriptor) { return ::close(descriptor) == 0; }

std::ptrdiff_t read(int descriptor, char* to, std::size_t size) {
    for (;;) {
        const ssize_t count = ::read(descriptor, to, size);
        if (count >= 0 || errno != EINTR) return count;
    }
}

bool write(int descriptor, const char* bytes, std::size_t size) {
    while (size > 0) {
        const ssize_t count = ::write(descriptor, bytes, size);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        bytes += count;
        size -= static_cast<std::size_t>(count);
    }
    return true;
}

bool seek(int descriptor, std::uint64_t position) {
    return ::lseek(descriptor, static_cast<off_t>(position), SEEK_SET) >= 0;
}
bool resize(int descriptor, std::uint64_t size) {
    return ::ftruncate(descriptor, static_cast<off_t>(size)) == 0;
}

bool sync(int descriptor) { return ::fdatasync(descriptor) == 0; }

void sync_folder(const std::string& folder) {
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);  // not all file systems can
    ::close(descriptor);
}

bool lock(int descriptor) { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

bool remove(const std::string& path) { return ::unlink(path.c_str()) == 0; }
bool remove_now(const char* path) { return ::unlink(path) == 0; }
bool replace(const std::string& from, const std::string& to) {
    return ::rename(from.c_str(), to.c_str()) == 0;
}

void copy_permissions(const std::string& from, int descriptor) {
    struct stat old {};
    if (::stat(from.c_str(), &old) == 0) ::fchmod(descriptor, old.st_mode & 07777);
}

bool is_link(const std::string& path) {
    struct stat link {};
    return ::lstat(path.c_str(), &link) == 0 && S_ISLNK(link.st_mode);
}
bool exists(const std::string& path) { return ::access(path.c_str(), F_OK) == 0; }
bool is_writable(const std::string& path) { return ::access(path.c_str(), W_OK) == 0; }
bool is_writable_folder(const std::string& path) { return ::access(path.c_str(), W_OK | X_OK) == 0; }

void* map(int descriptor, std::size_t size) {
    void* const mapped = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, descriptor, 0);
    return mapped == MAP_FAILED ? nullptr : mapped;
}
void unmap(void* mapped, std::size_t size) { ::munmap(mapped, size); }
void release(void* mapped, std::size_t size) { ::madvise(mapped, size, MADV_DONTNEED); }

std::filesystem::path to_path(std::string_view path) { return path; }
std::string to_string(const std::filesystem::path& path) { return path.string(); }

bool is_too_long(const std::string&) { return false; }  // the system says it

std::filesystem::path followed(const std::string& path) {
    namespace fs = std::filesystem;
    constexpr int most_links = 40;  // as the kernel: more are a circle
    std::error_code error;
    fs::path whole = fs::absolute(path.empty() ? "." : path, error);
    if (error) return {};
    // weakly_canonical() keeps the name of a link to nothing, which a writer follows.
    for (int links = 0; fs::is_symlink(fs::symlink_status(whole, error)); ++links) {
        const fs::path to = fs::read_symlink(whole, error);
        if (error || links == most_links) return {};
        whole = whole.parent_path() / to;
    }
    error.clear();
    fs::path canonical = fs::weakly_canonical(whole, error);
    return error ? fs::path() : canonical;
}

bool matches(const std::string& name, const std::string& pattern) {
    return ::fnmatch(pattern.c_str(), name.c_str(), FNM_CASEFOLD) == 0;
}

std::string folder_of(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace glint::os
