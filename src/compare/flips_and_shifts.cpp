// SPDX-License-Identifier: Apache-2.0
// Faults that replace a pixel by another one, or by a value between its neighbours.
#include <algorithm>
#include <array>

#include "compare/edges.h"
#include "compare/picture_faults.h"

namespace glint {
namespace {

using Detail = std::optional<std::string>;
using At = std::pair<std::int32_t, std::int32_t>;

// Pixel (x, y) is the reference's pixel from(x, y), which is inside the picture.
template <class From>
void move_pixels(const PictureSource& s, const Rows& rows, BytePicture& made, From&& from) {
    for_each_row(rows, s.fit.threads, [&](std::int32_t y) {
        for (std::int32_t x = 0; x < s.bytes.width; ++x) {
            const auto [u, v] = from(x, y);
            std::copy_n(s.bytes.pixel(u, v), 3, made.pixel(x, y));
        }
    });
}

// from(x, y, width, height)
template <class From> PictureFault moved(From&& from) {
    return [=](const PictureSource& s, BytePicture& made) -> Detail {
        move_pixels(s, s.rows, made, [&](std::int32_t x, std::int32_t y) {
            return from(x, y, s.bytes.width, s.bytes.height);
        });
        return "";
    };
}

// from(x, y, last index of a side)
template <class From> PictureFault turned(From&& from) {
    return [=](const PictureSource& s, BytePicture& made) -> Detail {
        if (s.bytes.width != s.bytes.height) return std::nullopt;
        move_pixels(s, s.rows, made,
                    [&](std::int32_t x, std::int32_t y) { return from(x, y, s.bytes.width - 1); });
        return "";
    };
}

// Horizontal and vertical shifts before the diagonals.
using Direction = std::pair<int, int>;
constexpr std::array<Direction, 8> k_directions = {
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

void shift_pixels(const PictureSource& s, Direction by, const Rows& rows, BytePicture& made) {
    move_pixels(s, rows, made, [&](std::int32_t x, std::int32_t y) {
        return At{std::clamp(x - by.first, 0, s.bytes.width - 1),
                  std::clamp(y - by.second, 0, s.bytes.height - 1)};
    });
}

void half_shift_pixels(const PictureSource& s, Direction by, const Rows& rows, BytePicture& made) {
    const auto [dx, dy] = by;
    nearest_between(s.bytes, s.faulty, std::min(-dx, 0), std::max(-dx, 0), std::min(-dy, 0), std::max(-dy, 0),
                    rows, s.fit.threads, made);
}

// The remaining difference for each direction, if faults are fitted.
template <class Shift>
std::array<double, 8> left_by_direction(const PictureSource& s, BytePicture& made, Shift&& shift) {
    std::array<double, 8> left{};
    for (std::size_t i = 0; i < k_directions.size(); ++i) {
        shift(s, k_directions[i], s.fit.rows, made);
        left[i] = distance(made, s.faulty, s.fit).all;
    }
    return left;
}

// A picture shifted by half a pixel is unknown, but each of its channels is between two neighbours in
// the reference, or four for a diagonal. More neighbours explain more of any difference, so a diagonal
// must explain much more than the sides, and a direction much more than its opposite (more samples per pixel
// have no direction).
constexpr double k_diagonal_leaves = 0.3, k_opposite_leaves = 3;

// Of anti-aliasing nearly all pixels are mixed, of edges that have moved about a quarter.
constexpr double k_min_mixed = 0.6;
// Other samples change at least this share of the edges.
constexpr double k_min_changed = 0.4;

std::optional<Direction> half_direction(const PictureSource& s, BytePicture& made) {
    const auto left = left_by_direction(s, made, half_shift_pixels);
    const auto side =
        static_cast<std::size_t>(std::min_element(left.begin(), left.begin() + 4) - left.begin());
    const auto diagonal =
        static_cast<std::size_t>(std::min_element(left.begin() + 4, left.end()) - left.begin());
    const std::size_t best = left[diagonal] < k_diagonal_leaves * left[side] ? diagonal : side;
    const auto [dx, dy] = k_directions[best];
    const auto opposite = static_cast<std::size_t>(
        std::find(k_directions.begin(), k_directions.end(), Direction{-dx, -dy}) - k_directions.begin());
    if (left[opposite] < k_opposite_leaves * left[best]) return std::nullopt;
    return k_directions[best];
}

}  // namespace

PictureFault upside_down() {
    return moved([](int x, int y, int, int height) { return At{x, height - 1 - y}; });
}
PictureFault mirrored() {
    return moved([](int x, int y, int width, int) { return At{width - 1 - x, y}; });
}
PictureFault rotated() {
    return moved([](int x, int y, int width, int height) { return At{width - 1 - x, height - 1 - y}; });
}
PictureFault turned_left() {
    return turned([](int x, int y, int last) { return At{last - y, x}; });
}
PictureFault turned_right() {
    return turned([](int x, int y, int last) { return At{y, last - x}; });
}
PictureFault transposed() {
    return turned([](int x, int y, int) { return At{y, x}; });
}
PictureFault transposed_back() {
    return turned([](int x, int y, int last) { return At{last - y, last - x}; });
}

PictureFault shifted() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        const auto left = left_by_direction(s, made, shift_pixels);
        const auto best = std::min_element(left.begin(), left.end()) - left.begin();
        const auto [dx, dy] = k_directions[static_cast<std::size_t>(best)];
        shift_pixels(s, {dx, dy}, s.rows, made);
        return direction_text(dx, dy);
    };
}

PictureFault half_shifted() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        const std::optional<Direction> best = half_direction(s, made);
        if (!best) return std::nullopt;
        half_shift_pixels(s, *best, s.rows, made);
        return direction_text(best->first, best->second);
    };
}

PictureFault halved() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        for (std::int32_t y = 0; y < made.height; ++y) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                const std::uint8_t *is = s.faulty.pixel(x, y), *first = s.faulty.pixel(x & ~1, y & ~1);
                if (!std::equal(is, is + 3, first)) return std::nullopt;
            }
        }
        nearest_between(s.bytes, s.faulty, -1, 1, -1, 1, s.rows, s.fit.threads, made);
        return "";
    };
}

PictureFault anti_aliased() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        const auto mixed = mixed_share(s.bytes, s.faulty, s.fit.rows, s.fit.threads);
        if (!mixed || *mixed < k_min_mixed) return std::nullopt;  // no edges differ, or they have moved
        const auto changed = changed_edges_share(s.bytes, s.faulty, s.fit.rows, s.fit.threads);
        if (changed && *changed < k_min_changed) return std::nullopt;  // only those of shadows, perhaps
        nearest_between(s.bytes, s.faulty, -1, 1, -1, 1, s.rows, s.fit.threads, made);
        return "";
    };
}

}  // namespace glint
