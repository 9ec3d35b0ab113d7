// SPDX-License-Identifier: Apache-2.0
#include "cli/grade_sheet.h"

#include <fmt/format.h>

#include "cli/failure.h"
#include "cli/part_pictures.h"
#include "cli/render_or_fail.h"
#include "cli/text.h"
#include "glint/compare.h"

namespace glint::cli {
GradeSheet::GradeSheet(const std::optional<OutputFile>& output, const std::optional<SheetLayout>& layout,
                       std::size_t cells)
    : output_(output) {
    if (!output) return;
    if (!layout)
        throw Failure(k_bad_input, fmt::format("--sheet: {} pictures are too many for a sheet; grade them in "
                                               "parts, or without --sheet",
                                               with_commas(cells)));
    layout_ = *layout;
    cells_.resize(cells);
}

void GradeSheet::set_label(std::size_t cell, const std::string& label) {
    if (!cells_.empty()) cells_[cell].label = label;
}

void GradeSheet::copy(std::size_t from, std::size_t to) {
    if (cells_.empty()) return;
    cells_[to].picture = cells_[from].picture;
    cells_[to].difference = cells_[from].difference;
}

void GradeSheet::put(std::size_t cell, const Image& picture) {
    if (!cells_.empty()) cells_[cell].picture = scaled_down(picture, layout_.side);
}

void GradeSheet::put(std::size_t cell, const Image& picture, const Image& wanted) {
    if (cells_.empty()) return;
    put(cell, picture);
    cells_[cell].difference =
        scaled_down(difference_image(picture, wanted, k_difference_gain).value(), layout_.side);
}

void GradeSheet::write(int threads) const {
    if (output_) write_png(contact_sheet(cells_, layout_), *output_, {.threads = threads});
}

}  // namespace glint::cli
