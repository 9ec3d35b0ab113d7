// SPDX-License-Identifier: Apache-2.0
#pragma once
// Submissions that are folders, and small pictures of what is in them.
#include <vector>

#include "cli/grade_sheet.h"
#include "cli/part_pictures.h"
#include "cli/picture_sizes.h"
#include "cli/submissions.h"
#include "grade/grade_by_rubric.h"

namespace glint::cli {

/// The sheet has a row of cells for the wanted pictures and one for each submission; `pictures` has a cell
/// for each row of each submission.
class GradedFolders : public Submissions {
  public:
    GradedFolders(const std::vector<Submission>& folders, const std::vector<RubricRow>& rows,
                  GradeSheet& sheet, PartPictures& pictures);

    std::vector<std::string> names() const override;
    HandedIn find(std::size_t submission, const RubricRow& row) override;
    void show_wanted(std::size_t row, const Image& wanted) override;
    void show(std::size_t submission, std::size_t row, const Image& picture, const Image* wanted) override;
    void show_same(std::size_t from, std::size_t to) override;

    const PictureSizes& sizes() const { return sizes_; }

  private:
    std::size_t cell(std::size_t submission, std::size_t row) const { return (submission + 1) * rows_ + row; }

    const std::vector<Submission>& folders_;
    const std::size_t rows_;
    std::vector<std::string> patterns_;
    GradeSheet& sheet_;
    PartPictures& pictures_;
    PictureSizes sizes_;
};

/// Reads a picture.
HandedIn read_handed_in(FoundFile file);

}  // namespace glint::cli
