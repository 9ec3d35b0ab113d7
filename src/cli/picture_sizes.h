// SPDX-License-Identifier: Apache-2.0
#pragma once
// A class whose pictures all have one size that is not the reference's.
#include <cstddef>
#include <cstdint>

#include "glint/image.h"

namespace glint::cli {

/// The sizes of the pictures that a class handed in.
class PictureSizes {
  public:
    void set_wanted(const Image& wanted) { wanted_ = {wanted.width, wanted.height}; }
    void add(const Image& picture);
    /// Throws Failure if there are several pictures, all of one size that is not the wanted one.
    /// has_reference: the wanted size is that of a file, which --size does not change.
    void check(bool has_reference) const;

  private:
    struct Size {
        std::int32_t width = 0, height = 0;
        bool operator==(const Size&) const = default;
    };
    Size wanted_, first_;
    std::size_t count_ = 0;
    bool are_equal_ = true;
};

}  // namespace glint::cli
