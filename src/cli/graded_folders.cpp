// SPDX-License-Identifier: Apache-2.0
#include "cli/graded_folders.h"

#include <fmt/format.h>

#include "cli/picture_file.h"

namespace glint::cli {

GradedFolders::GradedFolders(const std::vector<Submission>& folders, const std::vector<RubricRow>& rows,
                             GradeSheet& sheet, PartPictures& pictures)
    : folders_(folders), rows_(rows.size()), sheet_(sheet), pictures_(pictures) {
    for (std::size_t k = 0; k < rows_; ++k) {
        sheet.set_label(k, rows[k].part);
        patterns_.push_back(rows[k].file);
        for (std::size_t i = 0; i < folders.size(); ++i)
            sheet.set_label(cell(i, k), fmt::format("{} {}", i + 1, folders[i].name));
    }
}

std::vector<std::string> GradedFolders::names() const {
    std::vector<std::string> names;
    for (const Submission& folder : folders_) names.push_back(folder.name);
    return names;
}

HandedIn GradedFolders::find(std::size_t submission, const RubricRow& row) {
    FoundFile file = find_file(folders_[submission], row.file);
    if (file.path.empty() && folders_[submission].error.empty())
        file.error += other_files_text(folders_[submission], patterns_);
    return read_handed_in(std::move(file));
}

void GradedFolders::show_wanted(std::size_t row, const Image& wanted) {
    sizes_.set_wanted(wanted);
    sheet_.put(row, wanted);
}

void GradedFolders::show(std::size_t submission, std::size_t row, const Image& picture, const Image* wanted) {
    sizes_.add(picture);
    if (wanted != nullptr) {
        sheet_.put(cell(submission, row), picture, *wanted);
        pictures_.put(submission * rows_ + row, picture, *wanted);
    } else {
        sheet_.put(cell(submission, row), picture);
        pictures_.put(submission * rows_ + row, picture);
    }
}

void GradedFolders::show_same(std::size_t from, std::size_t to) {
    sheet_.copy(from, to);
    for (std::size_t i = 0; i < folders_.size(); ++i) {
        sheet_.copy(cell(i, from), cell(i, to));
        pictures_.copy(i * rows_ + from, i * rows_ + to);
    }
}

HandedIn read_handed_in(FoundFile file) {
    HandedIn found{std::move(file.path), std::move(file.error), {}};
    if (!found.error.empty()) return found;
    Result<DecodedImage> read = try_handed_in(found.path);
    if (read) {
        found.image = std::move(read->image);
        found.note = std::move(read->note);
    } else {
        found.error = read.message;
    }
    return found;
}

}  // namespace glint::cli
