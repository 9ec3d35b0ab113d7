// SPDX-License-Identifier: Apache-2.0
#pragma once
// The contact sheet of `glint grade`.
#include <optional>
#include <string>
#include <vector>

#include "cli/output_file.h"
#include "image/contact_sheet.h"

namespace glint::cli {

/// The small pictures of the sheet, if one is asked for.
class GradeSheet {
  public:
    /// `cells` of which `layout` says how they lie; nothing if they do not fit, and then it throws Failure,
    /// unless no sheet is asked for.
    GradeSheet(const std::optional<OutputFile>& output, const std::optional<SheetLayout>& layout,
               std::size_t cells);

    void set_number(std::size_t cell, int number);
    void put(std::size_t cell, const Image& picture);
    /// And below it four times its difference from what it should be.
    void put(std::size_t cell, const Image& picture, const Image& wanted);

    void write(int threads) const;

  private:
    const std::optional<OutputFile>& output_;
    SheetLayout layout_;
    std::vector<SheetCell> cells_;  // none if no sheet is asked for
};

}  // namespace glint::cli
