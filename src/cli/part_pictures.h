// SPDX-License-Identifier: Apache-2.0
#pragma once
// Small pictures of what was handed in, as texts that HTML and JSON can contain.
#include <string>
#include <vector>

#include "glint/image.h"

namespace glint::cli {

/// The factor by which a difference is made brighter, so that small ones can be seen.
inline constexpr double k_difference_gain = 4;

/// "data:image/png;base64,..." (RFC 2397, RFC 4648).
std::string png_data_uri(const Image& image);

/// A picture and its difference from the right one, four times as bright; each a data URI, or empty.
struct PartPicture {
    std::string picture, difference;
};

/// By cell: the picture that a submission has for a part.
class PartPictures {
  public:
    /// Keeps nothing unless `is_wanted`.
    PartPictures(bool is_wanted, std::size_t cells) : cells_(is_wanted ? cells : 0) {}

    void put(std::size_t cell, const Image& picture);
    void put(std::size_t cell, const Image& picture, const Image& wanted);
    void copy(std::size_t from, std::size_t to);
    /// Null if there is none.
    const PartPicture* find(std::size_t cell) const;

  private:
    std::vector<PartPicture> cells_;
};

}  // namespace glint::cli
