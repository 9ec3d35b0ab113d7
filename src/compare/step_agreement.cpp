// SPDX-License-Identifier: Apache-2.0
#include "compare/step_agreement.h"

#include <algorithm>

namespace glint {
namespace {

// Fewer steps than this fraction of the pixels are not significant.
constexpr double k_min_steps = 0.002;

// One mark per pixel of a row: whether there is a step to the next.
void mark_steps(const BytePicture& picture, std::int32_t y, std::vector<std::uint8_t>& marks) {
    const std::uint8_t* pixels = picture.pixel(0, y);
    for (std::int32_t x = 0; x + 1 < picture.width; ++x)
        marks[x] = is_step(pixels + 3 * x, pixels + 3 * x + 3);
}

struct StepCounts {
    std::uint32_t steps = 0, near = 0, met = 0;  // steps, pixels near a step, the other's steps among them
};

void count_steps(const std::vector<std::uint8_t>& mine, const std::vector<std::uint8_t>& others,
                 StepCounts& counts) {
    const std::size_t last = mine.size() - 1;
    StepCounts row;
    const auto count = [&](std::size_t x, std::uint8_t left, std::uint8_t right) {
        const std::uint32_t near = left | mine[x] | right;
        row.steps += mine[x];
        row.near += near;
        row.met += near & others[x];
    };
    count(0, 0, mine[std::min<std::size_t>(1, last)]);
    for (std::size_t x = 1; x < last; ++x) count(x, mine[x - 1], mine[x + 1]);
    if (last > 0) count(last, mine[last - 1], 0);
    counts = {counts.steps + row.steps, counts.near + row.near, counts.met + row.met};
}

// The fraction of the other's steps that are near this picture's, beyond chance.
double agreement(const StepCounts& mine, const StepCounts& others, double pixels) {
    const double chance = mine.near / pixels;
    return chance < 1 ? (static_cast<double>(mine.met) / others.steps - chance) / (1 - chance) : 0;
}

}  // namespace

std::optional<StepAgreement> step_agreement(const BytePicture& a, const BytePicture& b, const Rows& rows) {
    StepCounts of_a, of_b;
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
