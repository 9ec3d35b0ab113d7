#pragma once
// What has been handed in: the pictures of a folder, or its folders.
#include <string>
#include <vector>

namespace glint::cli {

struct Submission {
    std::string
        name;  ///< of the folder, or the file without its extension; "folder/file" if a folder holds several
    std::string path;
};

/// The pictures in a folder and in its folders, one level down, by name. Throws Failure if there is no such
/// folder.
std::vector<Submission> list_pictures(const std::string& folder);

/// The folders in a folder, by name; the folder itself if it has none. Throws Failure if there is no such
/// folder.
std::vector<Submission> list_folders(const std::string& folder);

/// The first file of a folder, by name, that the pattern (* and ?) matches; an empty string if none does.
std::string find_file(const std::string& folder, const std::string& pattern);

}  // namespace glint::cli
