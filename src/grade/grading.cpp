// SPDX-License-Identifier: Apache-2.0
#include "grade/grading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "compare/lines.h"
#include "image/levels.h"

namespace glint {
namespace {

// The fraction of right pixels among the marked ones; 1 if none is marked. Infinite and NaN are never right.
double right_share(const Image& picture, const BytePicture& a, const BytePicture& b,
                   const std::vector<std::uint8_t>& marks) {
    std::size_t marked = 0, right = 0;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        if (marks[i] == 0) continue;
        ++marked;
        right += is_finite_pixel(&picture.rgb[3 * i]) && is_right(&a.rgb[3 * i], &b.rgb[3 * i]);
    }
    return marked == 0 ? 1 : static_cast<double>(right) / static_cast<double>(marked);
}

}  // namespace

bool is_right(const std::uint8_t* a, const std::uint8_t* b) {
    for (int c = 0; c < 3; ++c) {
        if (std::abs(int{a[c]} - int{b[c]}) > k_right_within) return false;
    }
    return true;
}

double points_factor(double share) {
    return std::clamp((share - k_no_share) / (k_full_share - k_no_share), 0.0, 1.0);
}

double rounded_points(double points) { return std::floor(points * 100 + 0.5) / 100; }

double points_of(double points, double factor) {
    return factor < 1 ? std::min(rounded_points(points * factor), points) : points;
}

std::string size_fault(const Image& picture, const Image& wanted) {
    if (picture.width == wanted.width && picture.height == wanted.height) return {};
    return fmt::format("{}x{} pixels, expected {}x{}", picture.width, picture.height, wanted.width,
                       wanted.height);
}

std::uint64_t count_not_finite(const Image& picture) {
    std::uint64_t count = 0;
    for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3) count += !is_finite_pixel(&picture.rgb[i]);
    return count;
}

PartScore grade(const Image& picture, const WantedPicture& wanted, double points, int threads) {
    const BytePicture bytes = to_bytes(picture, threads);
    PartScore score;
    score.not_finite = count_not_finite(picture);
    score.share = right_share(picture, bytes, wanted.bytes, wanted.counts);
    score.part_share =
        wanted.shows.empty() ? score.share : right_share(picture, bytes, wanted.bytes, wanted.shows);
    score.is_empty = one_color(bytes) && !one_color(wanted.bytes);
    if (!score.is_empty) score.factor = points_factor(std::min(score.share, score.part_share));
    score.points = points_of(points, score.factor);
    return score;
}

}  // namespace glint
