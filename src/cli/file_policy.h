// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which files a file may name: includes, submissions' pictures, .ini files. The only place that decides it;
// SECURITY.md describes it for users.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::cli {

/// Who names a file, and how far that may reach.
struct FileReach {
    /// The user names it: a pipe or a device, too. Otherwise another file does, and only a regular file is
    /// opened: no folder, pipe, device or socket.
    bool is_users = false;
    /// Only what is inside one of `folders`, with links followed.
    bool is_confined = false;
    std::vector<std::string> folders = {};
};

/// Whether `path` is inside `folder`, with the links of both followed; the file need not exist.
bool is_inside(const std::string& path, const std::string& folder);

/// The descriptor of a file that another file names, and its size. It never waits. -1 and the reason in `why`
/// if the reach does not permit it or it cannot be opened; whether a file outside exists is not told.
struct NamedFile {
    int descriptor = -1;
    std::size_t size = 0;
};
NamedFile open_named_file(const std::string& path, const FileReach& reach, std::string& why);

/// Reads at most `size` bytes, the size of the file when it was opened: files of the kernel say 0, and
/// reading one may wait, or take what is read from others.
std::optional<std::string> read_named_file(NamedFile file, std::string& why);
/// Opens, reads and closes it.
std::optional<std::string> read_named_file(const std::string& path, const FileReach& reach, std::string& why);

/// Where a text that includes `name` is looked for: beside the text `from`, then in the folders.
std::vector<std::string> included_paths(std::string_view name, std::string_view from,
                                        std::span<const std::string> folders);

/// "no such file", or what the system says.
std::string reason_of(int error);

}  // namespace glint::cli
