// SPDX-License-Identifier: Apache-2.0
#include "compare/left_structure.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "image/quantize.h"

namespace glint {
namespace {

constexpr int k_group = 5;  // of the 9 pixels around one
// What is left at edges by another renderer's samples is lines. Of what is left of a small highlight, which
// is all edges, more than this fraction is in the middle of a blob: so many of the 9 pixels around it are off
// to the same side. Measured: 0.005 to 0.09 of the pixels off at edges that are sampled 0.2 pixels aside,
// 0.39 of a highlight.
constexpr double k_blobs_left = 0.2;
constexpr int k_blob = 8;
// If more than this fraction of the edges that a cause does not change is off, the programs sample
// differently, and at edges only what is not between the pixels around it counts, which is at most this
// fraction of what the cause changes. Measured: 0 to 0.013 of the edges, and more than 0.2 at edges that are
// sampled 0.2 pixels aside.
constexpr double k_changed_off = 1.0 / 30, k_same_sampling = 0.05;
// Where an exact cause changes the picture, at most so many times as many pixels are wrong as elsewhere.
constexpr double k_as_elsewhere = 2;
// If edges are left, at least this fraction of what is changed is shaded: many causes give the one color of a
// floor.
constexpr double k_shaded = 0.1;
// Of the pixels that an exact cause changes, at most this fraction is wrong, and off edges at most this
// fraction by more than rounding: a small highlight has few pixels.
constexpr double k_changed_wrong = 0.01;
// Areas of one color say little about a cause: a number there is the same everywhere, and may be near a tie
// by chance. It may be this many times as far from the right one.
constexpr double k_flat_tolerance = 5;
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

// Whether the numbers of a pixel may have become these bytes.
bool may_be(const NumbersOfBytes& of, double tolerance, std::int32_t x, std::int32_t y,
            const std::uint8_t* wanted) {
    float buffer[3], moved[3];
    const float* values =
        of.numbers.values(3 * (static_cast<std::size_t>(y) * of.numbers.width + x), 3, buffer);
    for (const int side : {-1, 1}) {
        std::uint8_t bytes[3];
        for (int c = 0; c < 3; ++c)
            moved[c] = static_cast<float>(static_cast<double>(values[c]) + side * tolerance / 255);
        quantize_row(moved, 3, 8, of.rule, bytes);
        for (int c = 0; c < 3; ++c) {
            if (side * (int{bytes[c]} - int{wanted[c]}) < 0) return false;
        }
    }
    return true;
}

bool is_shaded(const BytePicture& made, const BytePicture& target, std::int32_t x, std::int32_t y) {
    return !is_flat(made, x, y) || !is_flat(target, x, y);
}

// Whether a pixel's bytes in `target` are no roundings of the numbers. Of a tie in an area of one color,
// bytes do not tell where the number is.
bool is_wrong(const BytePicture& made, const NumbersOfBytes& of, const BytePicture& target, std::int32_t x,
              std::int32_t y) {
    const std::uint8_t* wanted = target.pixel(x, y);
    const int off = largest_difference(made.pixel(x, y), wanted);
    if (off == 0) return false;
    if (is_shaded(made, target, x, y)) return !may_be(of, of.tolerance, x, y, wanted);
    return off > k_rounding ||
           (of.numbers.has_floats() && !may_be(of, k_flat_tolerance * of.tolerance, x, y, wanted));
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
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
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

std::size_t wrong_pixels(const BytePicture& made, const NumbersOfBytes& numbers, const BytePicture& target,
                         const Area& area) {
    std::vector<std::size_t> counts(static_cast<std::size_t>(made.height));
    for_each_row(area.rows, area.threads, [&](std::int32_t y) {
        if (y < 1 || y >= made.height - 1) return;
        for (std::int32_t x = 1; x < made.width - 1; ++x)
            counts[static_cast<std::size_t>(y)] += is_wrong(made, numbers, target, x, y);
    });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

bool agrees_where_changed(const BytePicture& made, const NumbersOfBytes& numbers, const BytePicture& target,
                          const BytePicture& original, const Area& area, bool but_at_edges) {
    struct Tally {
        std::size_t pixels = 0, off = 0, by_one = 0;
        void operator+=(const Tally& other) {
            pixels += other.pixels, off += other.off, by_one += other.by_one;
        }
        std::size_t by_more() const { return off - by_one; }
    };
    struct Count {
        std::size_t changed = 0, shaded = 0, overdone = 0, beyond_samples = 0;
        Tally edges[2], calm[2];  // where the cause changes nothing, and where it does

        void operator+=(const Count& other) {
            changed += other.changed, shaded += other.shaded, overdone += other.overdone;
            beyond_samples += other.beyond_samples;
            for (const int i : {0, 1}) edges[i] += other.edges[i], calm[i] += other.calm[i];
        }
    };
    std::vector<Count> counts(static_cast<std::size_t>(made.height));
    for_each_row(area.rows, area.threads, [&](std::int32_t y) {
        if (y < 1 || y >= made.height - 1) return;
        const std::uint8_t* edges = &(*area.edges)[static_cast<std::size_t>(y) * made.width];
        Count& count = counts[static_cast<std::size_t>(y)];
        for (std::int32_t x = 1; x < made.width - 1; ++x) {
            const std::uint8_t *is = made.pixel(x, y), *wanted = target.pixel(x, y);
            const int change = largest_difference(is, original.pixel(x, y));
            count.changed += change > k_rounding;
            count.overdone += is_overdone(made, target, original, x, y);
            const bool is_edge = edges[x] != 0 || has_step(made, x, y) || has_step(target, x, y);
            count.shaded += !is_edge && change > k_rounding && is_shaded(made, target, x, y);
            const int off = largest_difference(is, wanted);
            Tally& tally = (is_edge ? count.edges : count.calm)[change > 0];
            const bool wrong = is_wrong(made, numbers, target, x, y);
            ++tally.pixels;
            tally.off += wrong;
            tally.by_one += wrong && off == k_rounding;
            if (is_edge && off > k_rounding)
                count.beyond_samples += !is_between_neighbours(made, x, y, wanted);
        }
    });
    Count all;
    for (const Count& row : counts) all += row;
    if (all.changed == 0) return true;  // truncation
    const auto rate = [](const Tally& t) {
        return t.pixels > 0 ? static_cast<double>(t.off) / static_cast<double>(t.pixels) : 0;
    };
    const auto part = [](double of, std::size_t pixels) { return of * static_cast<double>(pixels); };
    const double few_of_picture = part(k_structure_of_picture, made.rgb.size() / 3),
                 few_of_changed = part(k_changed_wrong, all.changed);
    const bool has_other_edges = rate(all.edges[0]) > k_same_sampling;
    if (!has_other_edges && all.overdone > 0) return false;
    const bool is_other_sampling = has_other_edges || all.edges[0].pixels == 0;
    const auto are_few = [&](std::size_t off, double more) {
        return static_cast<double>(off) <= 2 + std::min(few_of_picture, few_of_changed) + more;
    };
    const double at_edges = part(k_changed_off, all.changed);
    const bool agrees =
        is_other_sampling
            ? are_few(all.beyond_samples, at_edges) &&
                  are_few(all.calm[1].off, part(k_as_elsewhere * rate(all.calm[0]), all.calm[1].pixels))
            : static_cast<double>(all.calm[0].off + all.edges[0].off) <= 2 + few_of_picture &&
                  are_few(all.calm[1].off, 0) &&
                  static_cast<double>(all.calm[1].by_more()) <= few_of_changed &&
                  are_few(all.edges[1].off, at_edges) &&
                  // Where edges are elsewhere, more pixels are off by more.
                  are_few(2 * all.edges[1].by_one, static_cast<double>(all.edges[1].off));
    return agrees && (!but_at_edges || static_cast<double>(all.shaded) >= part(k_shaded, all.changed));
}

}  // namespace glint
