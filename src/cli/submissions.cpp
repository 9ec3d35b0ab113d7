// SPDX-License-Identifier: Apache-2.0
#include "cli/submissions.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/failure.h"
#include "cli/text.h"
#include "os/files.h"

namespace glint::cli {
namespace {

namespace fs = std::filesystem;

constexpr auto k_no_picture = "holds no picture (PNG, PPM, PGM, OpenEXR or JPEG)";

constexpr std::size_t k_max_named = 5;  // of files that no pattern matches

enum class Kind { file, folder, unreadable };

struct Entry {
    std::string name, path;
    Kind kind;
    std::string error;  // if unreadable
};

struct Listing {
    std::vector<Entry> entries;
    std::string error;
};

bool is_hidden(const std::string& name) { return name.starts_with('.') || name.starts_with("__"); }

// Sorted by name, without hidden files.
Listing list(const std::string& folder) {
    Listing found;
    std::error_code error;
    if (os::is_too_long(folder)) return {{}, std::make_error_code(std::errc::filename_too_long).message()};
    fs::directory_iterator at(os::to_path(folder), error);
    for (; !error && at != fs::directory_iterator(); at.increment(error)) {
        const std::string name = os::to_string(at->path().filename()), path = os::to_string(at->path());
        if (is_hidden(name)) continue;
        std::error_code unknown;
        const auto add = [&](Kind kind, std::string fault) {
            found.entries.push_back({name, path, kind, std::move(fault)});
        };
        if (at->is_directory(unknown)) {
            add(Kind::folder, {});
        } else if (at->is_regular_file(unknown)) {
            add(Kind::file, {});
        } else if (at->status(unknown).type() == fs::file_type::not_found) {
            add(Kind::unreadable, "a link to what is not there");
        } else if (unknown) {
            add(Kind::unreadable, unknown.message());
        }
    }
    if (error) found.error = error.message();
    std::sort(found.entries.begin(), found.entries.end(),
              [](const Entry& a, const Entry& b) { return a.name < b.name; });
    return found;
}

// The entries of the folder that the command was given. An unreadable one is an error.
std::vector<Entry> entries(const std::string& folder) {
    Listing listing = list(folder);
    if (!listing.error.empty())
        throw Failure(k_bad_input, fmt::format("folder '{}': {}", folder, listing.error));
    return std::move(listing.entries);
}

std::string folder_fault(const std::string& error) {
    return error.empty() ? "" : fmt::format("the folder cannot be read: {}", error);
}

bool is_picture(const Entry& entry) { return entry.kind != Kind::folder && is_picture_name(entry.name); }

// A submission with the short name that it gets if no other submission has the same name.
struct Named {
    Submission submission;
    std::string whole;  // path within the folder; unique
};

// Makes the names unique: "ada" twice becomes "ada.png" and "ada.jpg".
std::vector<Submission> with_names_apart(std::vector<Named> all) {
    for (bool changed = true; changed;) {
        changed = false;
        std::map<std::string, int> counts;
        for (const Named& n : all) ++counts[n.submission.name];
        for (Named& n : all) {
            if (counts[n.submission.name] == 1 || n.submission.name == n.whole) continue;
            n.submission.name = n.whole;
            changed = true;
        }
    }
    std::vector<Submission> submissions;
    submissions.reserve(all.size());
    for (Named& n : all) submissions.push_back(std::move(n.submission));
    return submissions;
}

}  // namespace

bool is_picture_name(std::string_view path) {
    const std::string ending = extension(path);
    return ending == ".png" || ending == ".ppm" || ending == ".pgm" || ending == ".exr" || ending == ".jpg" ||
           ending == ".jpeg";
}

std::vector<Submission> list_pictures(const std::string& folder) {
    std::vector<Named> found;
    for (const Entry& entry : entries(folder)) {
        if (is_picture(entry)) {
            found.push_back({{stem(entry.name), entry.path, entry.error}, entry.name});
        } else if (entry.kind == Kind::unreadable) {
            found.push_back({{entry.name, entry.path, entry.error}, entry.name});
        }
        if (entry.kind != Kind::folder) continue;
        Listing inside = list(entry.path);
        if (!inside.error.empty()) {
            found.push_back({{entry.name, entry.path, folder_fault(inside.error)}, entry.name});
            continue;
        }
        std::erase_if(inside.entries, [](const Entry& e) { return !is_picture(e); });
        if (inside.entries.empty()) found.push_back({{entry.name, entry.path, k_no_picture}, entry.name});
        for (const Entry& picture : inside.entries) {
            const bool is_only = inside.entries.size() == 1;
            found.push_back(
                {{is_only ? entry.name : entry.name + "/" + stem(picture.name), picture.path, picture.error},
                 entry.name + "/" + picture.name});
        }
    }
    return with_names_apart(std::move(found));
}

std::vector<Submission> list_folders(const std::string& folder) {
    const std::vector<Entry> all = entries(folder);
    const auto is = [&](Kind kind) {
        return std::any_of(all.begin(), all.end(), [&](const Entry& e) { return e.kind == kind; });
    };
    std::vector<Submission> found;
    // Files without folders: this is the folder of one student, even if it contains links to folders.
    if (is(Kind::folder) || !is(Kind::file)) {
        for (const Entry& entry : all) {
            if (entry.kind != Kind::file && !is_picture(entry))
                found.push_back({entry.name, entry.path, folder_fault(entry.error)});
        }
    }
    if (found.empty())
        found.push_back({os::to_string(os::to_path(folder).lexically_normal().filename()), folder, {}});
    if (found.front().name.empty() || found.front().name == ".") found.front().name = folder;
    return found;
}

bool is_match(const std::string& name, const std::string& pattern) {
    return !is_hidden(name) && os::matches(name, pattern);
}

FoundFile find_file(const Submission& submission, const std::string& pattern) {
    if (!submission.error.empty()) return {{}, submission.error};
    const Listing listing = list(submission.path);
    if (!listing.error.empty()) return {{}, folder_fault(listing.error)};
    for (const Entry& entry : listing.entries) {
        if (entry.kind != Kind::folder && is_match(entry.name, pattern)) return {entry.path, entry.error};
    }
    return {{}, fmt::format("no file {}", pattern)};
}

std::string other_files_text(const Submission& submission, const std::vector<std::string>& patterns) {
    std::vector<std::string> names;
    const auto add = [&](const Entry& entry, const std::string& folder) {
        const bool is_used = folder.empty() && std::any_of(patterns.begin(), patterns.end(),
                                                           [&](auto& p) { return is_match(entry.name, p); });
        if (entry.kind == Kind::file && !is_used) names.push_back(folder + entry.name);
    };
    for (const Entry& entry : list(submission.path).entries) {
        add(entry, "");
        if (entry.kind != Kind::folder) continue;
        for (const Entry& inside : list(entry.path).entries) add(inside, entry.name + "/");
    }
    if (names.empty()) return {};
    const std::size_t named = std::min(names.size(), k_max_named);
    const std::string more =
        named < names.size() ? fmt::format(" and {} more", names.size() - named) : std::string();
    names.resize(named);
    return fmt::format("; found {}{}", fmt::join(names, ", "), more);
}

}  // namespace glint::cli
