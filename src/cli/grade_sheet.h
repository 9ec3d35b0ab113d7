// SPDX-License-Identifier: Apache-2.0
#pragma once
// The contact sheet of `glint grade`.
#include <optional>
#include <string>
#include <vector>

#include "cli/output_file.h"
#include "image/contact_sheet.h"

namespace glint::cli {

/// The small pictures of the sheet, if one is requested.
class GradeSheet {
  public:
    /// `layout` arranges the `cells`; it is empty if they do not fit. Then throws Failure
    /// if a sheet is requested.
    GradeSheet(const std::optional<OutputFile>& output, const std::optional<SheetLayout>& layout,
               std::size_t cells);

    void set_label(std::size_t cell, const std::string& label);
    void put(std::size_t cell, const Image& picture);
    /// Adds its difference from the reference, four times amplified, below the picture.
    void put(std::size_t cell, const Image& picture, const Image& wanted);

    void copy(std::size_t from, std::size_t to);

    void write(int threads) const;

  private:
    const std::optional<OutputFile>& output_;
    SheetLayout layout_;
    std::vector<SheetCell> cells_;  // empty if no sheet is requested
};

}  // namespace glint::cli
