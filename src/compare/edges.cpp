// SPDX-License-Identifier: Apache-2.0
#include "compare/edges.h"

#include <algorithm>
#include <cstdlib>

#include "glint/compare.h"

namespace glint {
namespace {

// A speck is darker by more than k_darker; k_calm of its neighbours differ by at most k_same. In 255ths.
constexpr int k_darker = 8, k_same = 2, k_calm = 2;
// What is mixed of two colors differs by more than this, or a tenth of their difference, from both.
constexpr int k_mixed = 4;

// Differences of a pixel: the smallest and the largest channel of faulty - reference.
struct Extremes {
    int least = 0, most = 0;
};
Extremes change_at(const BytePicture& reference, const BytePicture& faulty, std::int32_t x, std::int32_t y) {
    const std::uint8_t *was = reference.pixel(x, y), *is = faulty.pixel(x, y);
    Extremes change{255, -255};
    for (int c = 0; c < 3; ++c) {
        change.least = std::min(change.least, int{is[c]} - int{was[c]});
        change.most = std::max(change.most, int{is[c]} - int{was[c]});
    }
    return change;
}

// Is the channel that varies most around a pixel clearly between its extremes there?
bool is_mixed(const BytePicture& picture, std::int32_t x, std::int32_t y) {
    int widest = 0;
    bool is_between = false;
    for (int c = 0; c < 3; ++c) {
        int least = 255, most = 0;
        for (int i = 0; i < 9; ++i) {
            if (i == 4) continue;
            const int near = picture.pixel(x - 1 + i % 3, y - 1 + i / 3)[c];
            least = std::min(least, near);
            most = std::max(most, near);
        }
        if (most - least <= widest) continue;
        widest = most - least;
        const int here = picture.pixel(x, y)[c], margin = std::max(widest / 10, k_mixed);
        is_between = here > least + margin && here < most - margin;
    }
    return is_between;
}

bool is_speck(const BytePicture& reference, const BytePicture& faulty, std::int32_t x, std::int32_t y) {
    const Extremes here = change_at(reference, faulty, x, y);
    if (here.least >= -k_darker || here.most > k_same) return false;
    int calm = 0;
    for (std::int32_t v = std::max(y - 1, 0); v <= std::min(y + 1, reference.height - 1); ++v) {
        for (std::int32_t u = std::max(x - 1, 0); u <= std::min(x + 1, reference.width - 1); ++u) {
            if (is_step(reference.pixel(u, v), reference.pixel(x, y))) return false;
            const Extremes near = change_at(reference, faulty, u, v);
            calm += near.least >= -k_same && near.most <= k_same;
        }
    }
    return calm >= k_calm;
}

bool is_changed(const BytePicture& reference, const BytePicture& faulty, std::int32_t x, std::int32_t y) {
    const Extremes change = change_at(reference, faulty, x, y);
    return change.least < -k_noise || change.most > k_noise;
}

struct Counts {
    std::size_t steps = 0, counted = 0;
};

// The share of the steps that `count` counts in rows that are not outermost ones.
template <class Count>
std::optional<double> share_of_steps(std::int32_t height, const Rows& rows, int threads, Count&& count) {
    std::vector<Counts> counts(static_cast<std::size_t>(height));
    for_each_row(rows, threads, [&](std::int32_t y) {
        if (y >= 1 && y < height - 1) count(y, counts[static_cast<std::size_t>(y)]);
    });
    Counts all;
    for (const Counts& row : counts) all = {all.steps + row.steps, all.counted + row.counted};
    if (all.steps == 0) return std::nullopt;
    return static_cast<double>(all.counted) / static_cast<double>(all.steps);
}

}  // namespace

std::string direction_text(int dx, int dy) {
    std::string text = dx == 0 ? "" : dx > 0 ? "to the right" : "to the left";
    if (dy != 0) text += std::string(text.empty() ? "" : " and ") + (dy > 0 ? "down" : "up");
    return text;
}

void nearest_between(const BytePicture& reference, const BytePicture& faulty, int left, int right, int up,
                     int down, const Rows& rows, int threads, BytePicture& out) {
    for_each_row(rows, threads, [&](std::int32_t y) {
        const std::int32_t top = std::clamp(y + up, 0, reference.height - 1),
                           bottom = std::clamp(y + down, 0, reference.height - 1);
        for (std::int32_t x = 0; x < reference.width; ++x) {
            const std::int32_t first = std::clamp(x + left, 0, reference.width - 1),
                               last = std::clamp(x + right, 0, reference.width - 1);
            std::uint8_t least[3] = {255, 255, 255}, most[3] = {0, 0, 0};
            for (std::int32_t v = top; v <= bottom; ++v) {
                for (std::int32_t u = first; u <= last; ++u) {
                    const std::uint8_t* near = reference.pixel(u, v);
                    for (int c = 0; c < 3; ++c) {
                        least[c] = std::min(least[c], near[c]);
                        most[c] = std::max(most[c], near[c]);
                    }
                }
            }
            const std::uint8_t* is = faulty.pixel(x, y);
            std::uint8_t* pixel = out.pixel(x, y);
            for (int c = 0; c < 3; ++c) pixel[c] = std::clamp(is[c], least[c], most[c]);
        }
    });
}

std::optional<double> mixed_share(const BytePicture& reference, const BytePicture& faulty, const Rows& rows,
                                  int threads) {
    return share_of_steps(reference.height, rows, threads, [&](std::int32_t y, Counts& row) {
        for (std::int32_t x = 1; x < reference.width - 1; ++x) {
            if (!is_step(reference.pixel(x, y), faulty.pixel(x, y))) continue;
            ++row.steps;
            row.counted += is_mixed(reference, x, y) || is_mixed(faulty, x, y);
        }
    });
}

std::optional<double> changed_edges_share(const BytePicture& reference, const BytePicture& faulty,
                                          const Rows& rows, int threads) {
    return share_of_steps(reference.height, rows, threads, [&](std::int32_t y, Counts& row) {
        for (std::int32_t x = 1; x < reference.width - 2; ++x) {
            if (!is_step(reference.pixel(x, y), reference.pixel(x + 1, y)) &&
                !is_step(faulty.pixel(x, y), faulty.pixel(x + 1, y)))
                continue;
            ++row.steps;
            row.counted += is_changed(reference, faulty, x, y) || is_changed(reference, faulty, x + 1, y);
        }
    });
}

void put_dark_specks(const BytePicture& reference, const BytePicture& faulty, const Rows& rows, int threads,
                     BytePicture& out) {
    for_each_row(rows, threads, [&](std::int32_t y) {
        for (std::int32_t x = 0; x < reference.width; ++x) {
            const BytePicture& from = is_speck(reference, faulty, x, y) ? faulty : reference;
            std::copy_n(from.pixel(x, y), 3, out.pixel(x, y));
        }
    });
}

}  // namespace glint
