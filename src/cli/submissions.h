// SPDX-License-Identifier: Apache-2.0
#pragma once
// What has been handed in: the pictures of a folder, or its folders.
#include <string>
#include <string_view>
#include <vector>

namespace glint::cli {

struct Submission {
    /// Of the folder, or the file without its extension; "folder/file" if a folder holds several. Where two
    /// would be called the same, they are "file.png" and "file.jpg".
    std::string name;
    std::string path;
    std::string error;  ///< why nothing of it can be read; empty if it can, as far as one can tell
};

/// True for the endings of pictures that can be read.
bool is_picture_name(std::string_view path);

/// The pictures in a folder and in its folders, one level down, by name; what cannot be read is one, too,
/// and so is a folder without a picture.
/// Throws Failure if the folder itself cannot be read.
std::vector<Submission> list_pictures(const std::string& folder);

/// The folders in a folder, by name, and what may be one and cannot be read; the folder itself if it has
/// none. Throws Failure if the folder itself cannot be read.
std::vector<Submission> list_folders(const std::string& folder);

struct FoundFile {
    std::string path;   ///< empty if there is none
    std::string error;  ///< "no file *phong*.png", or why the folder cannot be read
};

/// The first file of a submission, by name, that the pattern (* and ?) matches, small letters like capitals.
FoundFile find_file(const Submission& submission, const std::string& pattern);

}  // namespace glint::cli
