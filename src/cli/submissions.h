// SPDX-License-Identifier: Apache-2.0
#pragma once
// The submissions to grade: the pictures of a folder, or its folders.
#include <string>
#include <string_view>
#include <vector>

namespace glint::cli {

struct Submission {
    /// The name of the folder, or of the file without its extension; "folder/file" if a folder has several
    /// files. If two names were equal, they are "file.png" and "file.jpg".
    std::string name;
    std::string path;
    std::string error;  ///< why it cannot be read; empty if no error is known
};

/// True if the name has the extension of a picture format that can be read.
bool is_picture_name(std::string_view path);

/// The pictures in a folder and one level of its folders, sorted by name. Unreadable entries, and folders
/// without a picture, are listed with their error.
/// Throws Failure if the folder itself cannot be read.
std::vector<Submission> list_pictures(const std::string& folder);

/// The folders in a folder, sorted by name, and entries that cannot be read; the folder itself if it has no
/// folders. Throws Failure if the folder itself cannot be read.
std::vector<Submission> list_folders(const std::string& folder);

struct FoundFile {
    std::string path;   ///< empty if no file matches
    std::string error;  ///< "no file *phong*.png", or why the folder cannot be read
};

/// Whether a file of a submission has a name that matches the pattern (* and ?). Case does not matter. Hidden
/// files do not match, nor those that archives of other systems contain ("__MACOSX").
bool is_match(const std::string& name, const std::string& pattern);

/// The first file of a submission, by name, that matches the pattern.
FoundFile find_file(const Submission& submission, const std::string& pattern);

/// The files of a submission, and of its folders, that match none of the patterns: they may have wrong names.
/// "; found castle.jpg, out/phong.png", or an empty text if there are none.
std::string other_files_text(const Submission& submission, const std::vector<std::string>& patterns);

}  // namespace glint::cli
