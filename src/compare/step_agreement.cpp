// SPDX-License-Identifier: Apache-2.0
#include "compare/step_agreement.h"

#include <algorithm>

namespace glint {
namespace {

// Fewer steps than this fraction of the pixels are not significant.
constexpr double k_min_steps = 0.002;

// One mark per pixel of a row: whether there is a step to the next.
void mark_steps(const BytePicture& picture, std::int32_t y, std::vector<std::uint8_t>& marks) {
    for (std::int32_t x = 0; x + 1 < picture.width; ++x) {
        marks[x] = is_step(picture.pixel(x, y), picture.pixel(x + 1, y));
    }
}

struct Counts {
    double steps = 0, near = 0, met = 0;  // steps, pixels near a step, the other's steps among them
};

void count_steps(const std::vector<std::uint8_t>& mine, const std::vector<std::uint8_t>& others,
                 Counts& counts) {
    for (std::size_t x = 0; x < mine.size(); ++x) {
        const bool is_near =
            mine[x] != 0 || (x > 0 && mine[x - 1] != 0) || (x + 1 < mine.size() && mine[x + 1] != 0);
        counts.steps += mine[x];
        counts.near += is_near;
        counts.met += is_near && others[x] != 0;
    }
}

// The fraction of the other's steps that are near this picture's, beyond chance.
double agreement(const Counts& mine, const Counts& others, double pixels) {
    const double chance = mine.near / pixels;
    return chance < 1 ? (mine.met / others.steps - chance) / (1 - chance) : 0;
}

}  // namespace

std::optional<StepAgreement> step_agreement(const BytePicture& a, const BytePicture& b, const Rows& rows) {
    Counts of_a, of_b;
    std::vector<std::uint8_t> steps_a(static_cast<std::size_t>(a.width)), steps_b = steps_a;
    for (const std::int32_t y : rows) {
        mark_steps(a, y, steps_a);
        mark_steps(b, y, steps_b);
        count_steps(steps_a, steps_b, of_a);
        count_steps(steps_b, steps_a, of_b);
    }
    const double pixels = static_cast<double>(rows.size()) * a.width, least = k_min_steps * pixels;
    if (of_a.steps <= least || of_b.steps <= least) return std::nullopt;
    const auto [worse, better] = std::minmax({agreement(of_a, of_b, pixels), agreement(of_b, of_a, pixels)});
    return StepAgreement{better, worse};
}

}  // namespace glint
