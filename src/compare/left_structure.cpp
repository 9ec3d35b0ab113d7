// SPDX-License-Identifier: Apache-2.0
#include "compare/left_structure.h"

#include <algorithm>
#include <cstdlib>

namespace glint {
namespace {

constexpr int k_group = 5;  // of the 9 pixels around one
// What is left at edges by another renderer's samples is lines. Of what is left of a small highlight, which
// is all edges, more than this fraction is in the middle of a blob: so many of the 9 pixels around it are off
// to the same side. Measured: 0.005 to 0.09 of the pixels off at edges that are sampled 0.2 pixels aside,
// 0.39 of a highlight.
constexpr double k_blobs_left = 0.2;
constexpr int k_blob = 8;
// What an exact cause changes is right but for rounding in all but this fraction of the pixels. Measured:
// 0.026 with shadow rays that start elsewhere. If more than this fraction of the edges that a cause does not
// change is off, the programs sample differently, and at edges only what is not between the pixels around it
// counts. Measured: 0 to 0.013, and more than 0.2 at edges that are sampled 0.2 pixels aside.
constexpr double k_changed_off = 1.0 / 30, k_same_sampling = 0.05;
// If edges are left, at least this fraction of what is changed is shaded: many causes give the one color of a
// floor.
constexpr double k_shaded = 0.1;
// Unless the programs sample differently, an exact cause changes no pixel too much by more than this, in
// 255ths, where it leaves no edge: an exponent that is far too large leaves a dot of each highlight.
constexpr int k_overdone = 4;

int largest_difference(const std::uint8_t* a, const std::uint8_t* b) {
    return std::max(
        {std::abs(int{a[0]} - int{b[0]}), std::abs(int{a[1]} - int{b[1]}), std::abs(int{a[2]} - int{b[2]})});
}

bool is_off(const std::uint8_t* a, const std::uint8_t* b) { return largest_difference(a, b) > k_noise; }

// Is the pixel one of a group that differs, and not on an edge of `made`?
bool is_structured(const BytePicture& made, const BytePicture& target, std::int32_t x, std::int32_t y) {
    int off = 0;
    for (std::int32_t v = y - 1; v <= y + 1; ++v) {
        for (std::int32_t u = x - 1; u <= x + 1; ++u) {
            if (is_step(made.pixel(u, v), made.pixel(x, y))) return false;
            off += is_off(made.pixel(u, v), target.pixel(u, v));
        }
    }
    return off >= k_group;
}

// 1 or -1 if the pixels differ by more than noise, by the sign of the sum over the channels; else 0.
int side_of(const std::uint8_t* a, const std::uint8_t* b) {
    if (!is_off(a, b)) return 0;
    const int sum = a[0] + a[1] + a[2] - b[0] - b[1] - b[2];
    return sum < 0 ? -1 : 1;
}

// In an area of one color a tie of rounding is one everywhere.
bool is_flat(const BytePicture& picture, std::int32_t x, std::int32_t y) {
    for (std::int32_t v = y - 1; v <= y + 1; ++v) {
        for (std::int32_t u = x - 1; u <= x + 1; ++u) {
            if (largest_difference(picture.pixel(u, v), picture.pixel(x, y)) > 0) return false;
        }
    }
    return true;
}

bool has_step(const BytePicture& picture, std::int32_t x, std::int32_t y) {
    for (std::int32_t v = y - 1; v <= y + 1; ++v) {
        for (std::int32_t u = x - 1; u <= x + 1; ++u) {
            if (is_step(picture.pixel(u, v), picture.pixel(x, y))) return true;
        }
    }
    return false;
}

// Whether each channel is one of the picture's in the 3 x 3 pixels there, or between two of them.
bool is_between_neighbours(const BytePicture& picture, std::int32_t x, std::int32_t y,
                           const std::uint8_t* pixel) {
    for (int c = 0; c < 3; ++c) {
        int least = 255, most = 0;
        for (std::int32_t v = y - 1; v <= y + 1; ++v) {
            for (std::int32_t u = x - 1; u <= x + 1; ++u) {
                least = std::min(least, int{picture.pixel(u, v)[c]});
                most = std::max(most, int{picture.pixel(u, v)[c]});
            }
        }
        if (pixel[c] < least - k_rounding || pixel[c] > most + k_rounding) return false;
    }
    return true;
}

// Whether `wanted` is on the way back to `original`, where `made` has no edge, and no other sample of it.
bool is_overdone(const BytePicture& made, const BytePicture& wanted, const BytePicture& original,
                 std::int32_t x, std::int32_t y) {
    const std::uint8_t *is = made.pixel(x, y), *to = wanted.pixel(x, y), *was = original.pixel(x, y);
    return largest_difference(is, to) > k_overdone &&
           largest_difference(to, was) < largest_difference(is, was) && !has_step(made, x, y) &&
           !is_between_neighbours(made, x, y, to);
}

}  // namespace

std::size_t structured_pixels(const BytePicture& made, const BytePicture& target, const Area& area) {
    std::vector<std::size_t> counts(static_cast<std::size_t>(made.height));
    for_each_row(area.rows, area.threads, [&](std::int32_t y) {
        if (y < 1 || y >= made.height - 1) return;
        const std::uint8_t* edges = &(*area.edges)[static_cast<std::size_t>(y) * made.width];
        for (std::int32_t x = 1; x < made.width - 1; ++x) {
            if (edges[x] == 0 && is_off(made.pixel(x, y), target.pixel(x, y)))
                counts[static_cast<std::size_t>(y)] += is_structured(made, target, x, y);
        }
    });
    std::size_t sum = 0;
    for (const std::size_t count : counts) sum += count;
    return sum;
}

bool has_blobs(const BytePicture& made, const BytePicture& target, const Area& area) {
    struct Count {
        std::size_t off = 0, middle = 0;
    };
    std::vector<Count> counts(static_cast<std::size_t>(made.height));
    for_each_row(area.rows, area.threads, [&](std::int32_t y) {
        if (y < 1 || y >= made.height - 1) return;
        Count& count = counts[static_cast<std::size_t>(y)];
        for (std::int32_t x = 1; x < made.width - 1; ++x) {
            const int side = side_of(made.pixel(x, y), target.pixel(x, y));
            if (side == 0) continue;
            ++count.off;
            int same = 0;
            for (std::int32_t v = y - 1; v <= y + 1; ++v) {
                for (std::int32_t u = x - 1; u <= x + 1; ++u)
                    same += side_of(made.pixel(u, v), target.pixel(u, v)) == side;
            }
            count.middle += same >= k_blob;
        }
    });
    Count all;
    for (const Count& row : counts) all.off += row.off, all.middle += row.middle;
    return static_cast<double>(all.middle) > k_blobs_left * static_cast<double>(all.off);
}

bool agrees_where_changed(const BytePicture& made, const BytePicture& target, const BytePicture& original,
                          const Area& area, bool but_at_edges, double most) {
    struct Count {
        std::size_t changed = 0, off = 0, overdone = 0;
        std::size_t at_edges = 0, beyond_samples = 0, same_edges = 0, same_off = 0;
        std::size_t shaded = 0, sum = 0;  // channels, and their difference
    };
    std::vector<Count> counts(static_cast<std::size_t>(made.height));
    for_each_row(area.rows, area.threads, [&](std::int32_t y) {
        if (y < 1 || y >= made.height - 1) return;
        const std::uint8_t* edges = &(*area.edges)[static_cast<std::size_t>(y) * made.width];
        Count& count = counts[static_cast<std::size_t>(y)];
        for (std::int32_t x = 1; x < made.width - 1; ++x) {
            const std::uint8_t *is = made.pixel(x, y), *wanted = target.pixel(x, y);
            const bool is_changed = largest_difference(is, original.pixel(x, y)) > k_rounding;
            count.changed += is_changed;
            const bool is_off = largest_difference(is, wanted) > k_rounding;
            count.overdone += is_overdone(made, target, original, x, y);
            if (edges[x] != 0 || has_step(made, x, y) || has_step(target, x, y)) {
                count.at_edges += is_off;
                count.beyond_samples += is_off && !is_between_neighbours(made, x, y, wanted);
                count.same_edges += !is_changed;
                count.same_off += !is_changed && is_off;
                continue;
            }
            count.off += is_off;
            if (!is_changed || (is_flat(made, x, y) && is_flat(target, x, y))) continue;
            count.shaded += 3;
            for (int c = 0; c < 3; ++c)
                count.sum += static_cast<std::size_t>(std::abs(int{is[c]} - int{wanted[c]}));
        }
    });
    Count all;
    for (const Count& row : counts) {
        all.changed += row.changed;
        all.off += row.off;
        all.overdone += row.overdone;
        all.at_edges += row.at_edges;
        all.beyond_samples += row.beyond_samples;
        all.same_edges += row.same_edges;
        all.same_off += row.same_off;
        all.shaded += row.shaded;
        all.sum += row.sum;
    }
    if (all.changed == 0) return true;  // truncation
    const auto fraction = [](std::size_t of, double part) { return part * static_cast<double>(of); };
    const bool is_other_sampling =
        static_cast<double>(all.same_off) > fraction(all.same_edges, k_same_sampling);
    if (!is_other_sampling && all.overdone > 0) return false;
    const bool is_same_sampling = all.same_edges > 0 && !is_other_sampling;
    const std::size_t off = all.off + (is_same_sampling ? all.at_edges : all.beyond_samples);
    return static_cast<double>(off) <= 2 + fraction(made.rgb.size() / 3, k_structure_of_picture) +
                                           fraction(all.changed, k_changed_off) &&
           static_cast<double>(all.sum) <= 2 + fraction(all.shaded, most) &&
           (!but_at_edges || static_cast<double>(all.shaded) >= fraction(3 * all.changed, k_shaded));
}

}  // namespace glint
