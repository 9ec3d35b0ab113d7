// SPDX-License-Identifier: Apache-2.0
#include "grade/grading.h"

#include <algorithm>
#include <cstdlib>

#include "base/status.h"
#include "compare/render_scene.h"
#include "image/levels.h"

namespace glint {
namespace {

bool is_right(const std::uint8_t* a, const std::uint8_t* b) {
    for (int c = 0; c < 3; ++c) {
        if (std::abs(int{a[c]} - int{b[c]}) > k_right_within) return false;
    }
    return true;
}

// Right pixels of those marked; all, if none is. What is infinite or NaN is not right, whatever its byte.
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

double points_factor(double share) {
    return std::clamp((share - k_no_share) / (k_full_share - k_no_share), 0.0, 1.0);
}

WantedPicture render_wanted(const Scene& scene, const RubricRow& row, int threads) {
    WantedPicture wanted;
    Status status = status_of([&] {
        wanted.scene = with_settings(scene, row.settings);
        Result<Rendering> rendered = render_scene(wanted.scene, threads);
        wanted.error = rendered.message;
        if (!rendered) return;
        wanted.image = std::move(rendered->image);
        wanted.bytes = to_bytes(wanted.image, threads);
        for (std::size_t i = 0; i < wanted.image.rgb.size(); ++i)
            wanted.image.rgb[i] = static_cast<float>(wanted.bytes.rgb[i]) / 255;
        wanted.counts = edges_of(wanted.bytes, threads);
        for (std::uint8_t& mark : wanted.counts) mark = mark == 0;
        if (row.without.empty()) return;
        rendered = render_scene(with_settings(wanted.scene, row.without), threads);
        wanted.error = rendered.message;
        if (!rendered) return;
        const BytePicture without = to_bytes(rendered->image, threads);
        wanted.shows = wanted.counts;
        for (std::size_t i = 0; i < wanted.shows.size(); ++i) {
            if (is_right(&without.rgb[3 * i], &wanted.bytes.rgb[3 * i])) wanted.shows[i] = 0;
        }
        if (std::find(wanted.shows.begin(), wanted.shows.end(), 1) == wanted.shows.end())
            wanted.error = "this part shows nothing in this scene: with and without it is the same picture";
    });
    if (!status) wanted.error = std::move(status.message);
    return wanted;
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
    score.points = points * points_factor(std::min(score.share, score.part_share));
    return score;
}

}  // namespace glint
