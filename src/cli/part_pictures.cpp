// SPDX-License-Identifier: Apache-2.0
#include "cli/part_pictures.h"

#include <algorithm>

#include "base/base64.h"
#include "glint/compare.h"
#include "image/contact_sheet.h"

namespace glint::cli {
namespace {

constexpr std::int32_t k_side = 240;  // pixels, of the longer side

}  // namespace

std::string png_data_uri(const Image& image) {
    return "data:image/png;base64," + base64(encode(image).value());
}

void PartPictures::put(std::size_t cell, const Image& picture) {
    if (!cells_.empty()) cells_[cell] = {png_data_uri(scaled_down(picture, k_side)), {}};
}

void PartPictures::put(std::size_t cell, const Image& picture, const Image& wanted) {
    if (cells_.empty()) return;
    put(cell, picture);
    cells_[cell].difference =
        png_data_uri(scaled_down(difference_image(picture, wanted, k_difference_gain).value(), k_side));
}

void PartPictures::copy(std::size_t from, std::size_t to) {
    if (!cells_.empty()) cells_[to] = cells_[from];
}

const PartPicture* PartPictures::find(std::size_t cell) const {
    return cells_.empty() || cells_[cell].picture.empty() ? nullptr : &cells_[cell];
}

}  // namespace glint::cli
