#include "cli/submissions.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <filesystem>

#include "cli/failure.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

namespace fs = std::filesystem;

struct Entry {
    std::string name, path;
    bool is_folder = false;
};

// Sorted by name; hidden ones, and those that archives of other systems leave ("__MACOSX"), are left out.
std::vector<Entry> entries(const std::string& folder) {
    std::error_code error;
    fs::directory_iterator at(folder, error);
    if (error) throw Failure(k_bad_input, fmt::format("folder '{}': {}", folder, error.message()));
    std::vector<Entry> found;
    for (; !error && at != fs::directory_iterator(); at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (name.starts_with('.') || name.starts_with("__")) continue;
        std::error_code unknown;
        const bool is_folder = at->is_directory(unknown);
        if (is_folder || at->is_regular_file(unknown))
            found.push_back({name, at->path().string(), is_folder});
    }
    if (error) throw Failure(k_bad_input, fmt::format("folder '{}': {}", folder, error.message()));
    std::sort(found.begin(), found.end(), [](const Entry& a, const Entry& b) { return a.name < b.name; });
    return found;
}

bool is_picture(const Entry& entry) {
    const std::string ending = extension(entry.name);
    return !entry.is_folder && (ending == ".png" || ending == ".ppm" || ending == ".pgm" ||
                                ending == ".exr" || ending == ".jpg" || ending == ".jpeg");
}

}  // namespace

std::vector<Submission> list_pictures(const std::string& folder) {
    std::vector<Submission> found;
    for (const Entry& entry : entries(folder)) {
        if (is_picture(entry)) found.push_back({stem(entry.name), entry.path});
        if (!entry.is_folder) continue;
        std::vector<Entry> inside = entries(entry.path);
        std::erase_if(inside, [](const Entry& e) { return !is_picture(e); });
        for (const Entry& picture : inside) {
            found.push_back(
                {inside.size() == 1 ? entry.name : entry.name + "/" + stem(picture.name), picture.path});
        }
    }
    return found;
}

std::vector<Submission> list_folders(const std::string& folder) {
    std::vector<Submission> found;
    for (const Entry& entry : entries(folder)) {
        if (entry.is_folder) found.push_back({entry.name, entry.path});
    }
    if (found.empty()) found.push_back({fs::path(folder).lexically_normal().filename().string(), folder});
    if (found.front().name.empty() || found.front().name == ".") found.front().name = folder;
    return found;
}

std::string find_file(const std::string& folder, const std::string& pattern) {
    for (const Entry& entry : entries(folder)) {
        if (!entry.is_folder && ::fnmatch(pattern.c_str(), entry.name.c_str(), 0) == 0) return entry.path;
    }
    return {};
}

}  // namespace glint::cli
