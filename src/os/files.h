// SPDX-License-Identifier: Apache-2.0
#pragma once
// Files as the operating system has them. Paths are UTF-8, and their separator is '/'; Windows takes '\\',
// too. Functions that return a descriptor return -1, and those that return bool false, with the reason in
// errno.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace glint::os {

inline constexpr int k_standard_input = 0, k_standard_output = 1, k_standard_error = 2;

enum class FileKind { none, regular, folder, other };

/// Identifies a file under all its names: hard and symbolic links.
struct FileIdentity {
    std::uint64_t device = 0, number = 0;
    bool operator==(const FileIdentity&) const = default;
};

struct FileInfo {
    FileKind kind = FileKind::none;  ///< `none`: nothing is known, errno has the reason
    std::uint64_t size = 0;          ///< in bytes
    FileIdentity identity{};
    bool has_name = true;  ///< false if it was removed since it was opened
};
FileInfo info_of(const std::string& path);
FileInfo info_of(int descriptor);

int open_to_read(const std::string& path);
/// Of a regular file: does not wait if it has become a pipe or a terminal.
int open_regular(const std::string& path);
/// Of a device or a pipe that is there.
int open_to_write(const std::string& path);
/// A new file, to read and write; an error if there is one.
int open_new(const std::string& path);
/// To read and write; an empty file if there is none.
int open_or_make(const std::string& path);
bool close(int descriptor);

/// How many bytes were read; 0 at the end, -1 for an error.
std::ptrdiff_t read(int descriptor, char* to, std::size_t size);
/// Writes all of the bytes.
bool write(int descriptor, const char* bytes, std::size_t size);
bool seek(int descriptor, std::uint64_t position);
bool resize(int descriptor, std::uint64_t size);
/// Brings what was written to the disk. EINVAL and EROFS: the file is of a kind that cannot.
bool sync(int descriptor);
/// The same for the names in a folder, where the system can.
void sync_folder(const std::string& folder);
/// Locks a file until it is closed. False with EWOULDBLOCK: another process has.
bool lock(int descriptor);

bool remove(const std::string& path);
/// The same for a signal handler.
bool remove_now(const char* path);
/// Gives a file another name, in place of the file that has it.
bool replace(const std::string& from, const std::string& to);
/// Gives the file the permissions of another.
void copy_permissions(const std::string& from, int descriptor);
bool is_link(const std::string& path);
bool exists(const std::string& path);
bool is_writable(const std::string& path);
/// Whether files can be made in a folder.
bool is_writable_folder(const std::string& path);

/// A file's bytes in memory; null if that is not possible.
void* map(int descriptor, std::size_t size);
void unmap(void* mapped, std::size_t size);
/// Gives back the memory of what was read; it is read from the file again.
void release(void* mapped, std::size_t size);

/// std::filesystem's own conversions are not from and to UTF-8 on Windows.
std::filesystem::path to_path(std::string_view path);
std::string to_string(const std::filesystem::path& path);

/// The absolute path of what a path names, with all links followed, also one that names no file yet. Empty if
/// that is not possible.
std::filesystem::path followed(const std::string& path);

/// Whether std::filesystem cannot read a folder because of its path's length.
bool is_too_long(const std::string& folder);

/// Whether users may make symbolic links.
#if defined(_WIN32)
inline constexpr bool k_has_links = false;  // only administrators, and in developer mode
#else
inline constexpr bool k_has_links = true;
#endif

/// Whether a name matches a pattern with *, ? and [a-z], as a shell's; upper and lower case are the same.
bool matches(const std::string& name, const std::string& pattern);

/// The folder of a file: "." if the path names none.
std::string folder_of(const std::string& path);

}  // namespace glint::os
