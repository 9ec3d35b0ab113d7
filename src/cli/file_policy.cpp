// SPDX-License-Identifier: Apache-2.0
#include "cli/file_policy.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iterator>

#include "base/text.h"
#include "formats/povray/standard_includes.h"
#include "formats/registry.h"
#include "os/files.h"

namespace glint::cli {

namespace fs = std::filesystem;

std::string reason_of(int error) { return error == ENOENT ? "no such file" : std::strerror(error); }

bool is_inside(const std::string& path, const std::string& folder) {
    const fs::path whole = os::followed(path), root = os::followed(folder);
    if (whole.empty() || root.empty()) return false;
    // The last part of a folder that does not exist is empty if it was written with a slash.
    const auto end = root.has_filename() ? root.end() : std::prev(root.end());
    const auto [at, rest] = std::mismatch(root.begin(), end, whole.begin(), whole.end());
    return at == end && rest != whole.end();
}

// A link with the name of a scene may lead to any file, of which messages would quote lines.
bool hides_its_type(const std::string& path) {
    return is_scene_name(path) && !is_scene_name(os::to_string(os::followed(path)));
}

NamedFile open_named_file(const std::string& path, const FileReach& reach, std::string& why) {
    if (reach.is_confined && !is_inside(path, std::string(povray::k_system_folder)) &&
        std::none_of(reach.folders.begin(), reach.folders.end(),
                     [&](const std::string& folder) { return is_inside(path, folder); })) {
        why = "is outside the folders that may be read here";
        return {};
    }
    if (!reach.is_confined && hides_its_type(path)) {
        why = "is a link to a file that is no scene";
        return {};
    }
    // Opening a device may already do something, so it is looked at first.
    os::FileInfo about = os::info_of(path);
    NamedFile file;
    if (about.kind == os::FileKind::regular) {
        file.descriptor = os::open_regular(path);
        about = file.descriptor < 0 ? os::FileInfo() : os::info_of(file.descriptor);
    }
    if (about.kind == os::FileKind::none) {
        why = reason_of(errno);
        return {};
    }
    if (about.kind != os::FileKind::regular) {  // it may have been replaced
        if (file.descriptor >= 0) os::close(file.descriptor);
        why = about.kind == os::FileKind::folder ? "is a folder, not a regular file" : "not a regular file";
        return {};
    }
    file.size = static_cast<std::size_t>(about.size);
    return file;
}

std::optional<std::string> read_named_file(NamedFile file, std::string& why) {
    constexpr std::size_t step = 1 << 16;  // a size is only what the file says
    std::string text;
    while (text.size() < file.size) {
        const std::size_t size = text.size();
        text.resize(size + std::min(step, file.size - size));
        const std::ptrdiff_t count = os::read(file.descriptor, text.data() + size, text.size() - size);
        text.resize(size + static_cast<std::size_t>(std::max<std::ptrdiff_t>(count, 0)));
        if (count < 0) {
            why = reason_of(errno);
            return std::nullopt;
        }
        if (count == 0) break;
    }
    return text;
}

std::optional<std::string> read_named_file(const std::string& path, const FileReach& reach,
                                           std::string& why) {
    const NamedFile file = open_named_file(path, reach, why);
    if (file.descriptor < 0) return std::nullopt;
    auto text = read_named_file(file, why);
    os::close(file.descriptor);
    return text;
}

std::vector<std::string> included_paths(std::string_view name, std::string_view from,
                                        std::span<const std::string> folders) {
    std::vector<std::string> paths{std::string(name)};
    // In a name it would end the path.
    if (name.find('\0') != std::string_view::npos) return {};
    if (is_absolute_path(name)) return paths;
    paths.front().insert(0, from.substr(0, from.rfind('/') + 1));
    for (const std::string& folder : folders) paths.push_back(folder + "/" + std::string(name));
    return paths;
}

}  // namespace glint::cli
