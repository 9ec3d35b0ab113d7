// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_sizes.h"

#include <fmt/format.h>

#include "cli/failure.h"

namespace glint::cli {

void PictureSizes::add(const Image& picture) {
    const Size size{picture.width, picture.height};
    if (count_++ == 0) first_ = size;
    are_equal_ = are_equal_ && size == first_;
}

void PictureSizes::check(bool has_reference) const {
    if (count_ < 2 || !are_equal_ || first_ == wanted_) return;
    const std::string size = fmt::format("{}x{}", first_.width, first_.height);
    throw Failure(
        k_bad_input,
        fmt::format("all {} pictures are {}, and the reference is {}x{}: {}", count_, size, wanted_.width,
                    wanted_.height, has_reference ? "give a reference of that size" : "use --size " + size));
}

}  // namespace glint::cli
