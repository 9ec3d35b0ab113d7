// SPDX-License-Identifier: Apache-2.0
#pragma once
// Points for a picture by the fraction of its pixels that are right.
#include <cstdint>
#include <string>
#include <vector>

#include "compare/byte_picture.h"
#include "grade/rubric.h"

namespace glint {

/// Away from edges, a pixel is right if no channel differs by more than this, in 255ths.
inline constexpr int k_right_within = 2;
/// All points from this fraction of right pixels on, none up to that one, linear in between.
inline constexpr double k_full_share = 0.99, k_no_share = 0.5;

/// The picture that a row of a rubric requires.
struct WantedPicture {
    std::string error;      ///< the reason why the scene cannot be rendered
    Image image;            ///< as a file with 8 bits
    Scene scene;            ///< the scene that gives it
    bool has_scene = true;  ///< false: no single scene gives it
    BytePicture bytes;
    std::vector<std::uint8_t> counts;  ///< one per pixel: it is away from edges
    std::vector<std::uint8_t>
        shows;  ///< one per pixel: counts, and changes with the part; empty: all that count
};

/// Whether two pixels, as bytes, differ by at most k_right_within.
bool is_right(const std::uint8_t* a, const std::uint8_t* b);

struct PartScore {
    double share = 0;              ///< fraction of right pixels among those that count
    double part_share = 0;         ///< fraction of right pixels among those that show the part
    double factor = 0;             ///< of the points, by the smaller of the two; 0 if is_empty
    bool is_empty = false;         ///< the picture is of one color, and the right one is not
    double points = 0;             ///< points_of() a part
    std::uint64_t not_finite = 0;  ///< pixels with an infinite or NaN channel: never right
};

/// Why a picture of this size cannot be graded; empty if it can.
std::string size_fault(const Image& picture, const Image& wanted);

/// The number of pixels with an infinite or NaN channel.
std::uint64_t count_not_finite(const Image& picture);

/// A picture with the size of the required one.
PartScore grade(const Image& picture, const WantedPicture& wanted, double points, int threads);

/// The factor of the points for a fraction of right pixels: 0 to 1.
double points_factor(double share);

/// To hundredths.
double rounded_points(double points);

/// The factor's part of a row's points, rounded to hundredths.
double points_of(double points, double factor);

}  // namespace glint
