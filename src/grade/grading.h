// SPDX-License-Identifier: Apache-2.0
#pragma once
// Points for a picture by how much of it is as it should be.
#include <cstdint>
#include <string>
#include <vector>

#include "compare/byte_picture.h"
#include "grade/rubric.h"

namespace glint {

/// Away from edges, a pixel is right if no channel differs by more than this, in 255ths.
inline constexpr int k_right_within = 2;
/// All points from this share of right pixels on, none up to that, in proportion between.
inline constexpr double k_full_share = 0.99, k_no_share = 0.5;

/// The picture that a row of a rubric wants.
struct WantedPicture {
    std::string error;  ///< the scene cannot be drawn so
    Image image;        ///< as a file of 8 bits holds it
    Scene scene;        ///< that draws it
    BytePicture bytes;
    std::vector<std::uint8_t> counts;  ///< one a pixel: away from edges
    std::vector<std::uint8_t>
        shows;  ///< one a pixel: counts, and changes with the part; empty: all that count
};

/// Draws the scene as the row says, in the scene's size, and once more without the part.
WantedPicture render_wanted(const Scene& scene, const RubricRow& row, int threads);

struct PartScore {
    double share = 0;              ///< right pixels of those that count
    double part_share = 0;         ///< right pixels of those that show the part
    double points = 0;             ///< by the smaller of the two
    std::uint64_t not_finite = 0;  ///< pixels with a channel that is infinite or NaN: never right
};

/// Pixels with a channel that is infinite or NaN.
std::uint64_t count_not_finite(const Image& picture);

/// A picture of the wanted one's size.
PartScore grade(const Image& picture, const WantedPicture& wanted, double points, int threads);

/// The factor of the points for a share of right pixels: 0 to 1.
double points_factor(double share);

}  // namespace glint
