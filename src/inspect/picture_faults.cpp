#include "inspect/picture_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "image/quantize.h"
#include "inspect/picture_edges.h"
#include "math/elementary.h"

namespace glint {
namespace {

using Detail = std::optional<std::string>;
using At = std::pair<std::int32_t, std::int32_t>;

// Pixel (x, y) is the reference's pixel from(x, y), which lies within it.
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

// Sideways and up or down before the diagonals.
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

// How much each direction leaves of the difference, where faults are fitted.
template <class Shift>
std::array<double, 8> left_by_direction(const PictureSource& s, BytePicture& made, Shift&& shift) {
    std::array<double, 8> left{};
    for (std::size_t i = 0; i < k_directions.size(); ++i) {
        shift(s, k_directions[i], s.fit.rows, made);
        left[i] = distance(made, s.faulty, s.fit).all;
    }
    return left;
}

// How a picture half a pixel away looks is not known, but each of its channels is between two neighbours of
// the reference, or four by a diagonal. The more neighbours, the more they explain of anything: so a diagonal
// has to leave much less than the sides, and a direction much less than its opposite (more samples a pixel
// have no direction).
constexpr double k_diagonal_leaves = 0.3, k_opposite_leaves = 3;

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

// Every channel value of the reference by change(value), as bytes.
template <class Change> void change_values(const PictureSource& s, BytePicture& made, Change&& change) {
    for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
        const std::size_t first = 3 * static_cast<std::size_t>(y) * made.width;
        for (std::size_t i = first; i < first + 3 * static_cast<std::size_t>(made.width); ++i)
            made.rgb[i] = static_cast<std::uint8_t>(quantize(change(s.reference.rgb[i]), 255));
    });
}

// A pair of colours: of the reference, of the faulty picture.
using Pair = std::array<std::uint8_t, 6>;

// What most of the different pixels have.
std::optional<Pair> commonest_change(const PictureSource& s) {
    std::vector<Pair> pairs;
    for (const std::int32_t y : s.fit.rows) {
        for (std::int32_t x = 0; x < s.bytes.width; ++x) {
            const std::uint8_t *was = s.bytes.pixel(x, y), *is = s.faulty.pixel(x, y);
            if (!std::equal(was, was + 3, is)) pairs.push_back({was[0], was[1], was[2], is[0], is[1], is[2]});
        }
    }
    std::sort(pairs.begin(), pairs.end());
    std::optional<Pair> best;
    std::ptrdiff_t most = 0;
    for (auto at = pairs.begin(); at != pairs.end();) {
        const auto end = std::upper_bound(at, pairs.end(), *at);
        if (end - at > most) {
            most = end - at;
            best = *at;
        }
        at = end;
    }
    return best;
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
PictureFault transposed() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        if (s.bytes.width != s.bytes.height) return std::nullopt;
        move_pixels(s, s.rows, made, [](std::int32_t x, std::int32_t y) { return At{y, x}; });
        return "";
    };
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

PictureFault anti_aliased() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        nearest_between(s.bytes, s.faulty, -1, 1, -1, 1, s.rows, s.fit.threads, made);
        return "";
    };
}

PictureFault dark_specks() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        put_dark_specks(s.bytes, s.faulty, s.rows, s.fit.threads, made);
        return "";
    };
}

PictureFault permuted(int red, int green, int blue) {
    return [=](const PictureSource& s, BytePicture& made) -> Detail {
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                const std::uint8_t* from = s.bytes.pixel(x, y);
                std::uint8_t* to = made.pixel(x, y);
                to[0] = from[red];
                to[1] = from[green];
                to[2] = from[blue];
            }
        });
        return "";
    };
}

PictureFault curved(std::function<double(double)> curve) {
    return [curve = std::move(curve)](const PictureSource& s, BytePicture& made) -> Detail {
        change_values(s, made,
                      [&](float value) { return curve(std::clamp(static_cast<double>(value), 0.0, 1.0)); });
        return "";
    };
}

double srgb_decoded(double v) { return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4); }

PictureFault scaled() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        const std::optional<double> factor = fit_factor({}, s.reference.rgb, s.bytes, s.faulty, s.fit.rows);
        if (!factor) return std::nullopt;
        change_values(s, made, [by = static_cast<float>(*factor)](float value) {
            return static_cast<double>(value * by);
        });
        if (s.unclamped) return fmt::format("{:.3g}", *factor);
        for_each_row(
            s.rows, s.fit.threads, [&](std::int32_t y) {  // a file's 255 may have been anything above
                const std::size_t first = 3 * static_cast<std::size_t>(y) * made.width;
                for (std::size_t i = first; i < first + 3 * static_cast<std::size_t>(made.width); ++i) {
                    if (s.bytes.rgb[i] == 255) made.rgb[i] = std::max(made.rgb[i], s.faulty.rgb[i]);
                }
            });
        return fmt::format("about {:.3g}", *factor);
    };
}

PictureFault whole_part(double scale, bool wraps) {
    return [=](const PictureSource& s, BytePicture& made) -> Detail {
        if (!s.unclamped) return std::nullopt;
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            const std::size_t first = 3 * static_cast<std::size_t>(y) * made.width;
            for (std::size_t i = first; i < first + 3 * static_cast<std::size_t>(made.width); ++i) {
                const double level = std::clamp(static_cast<double>(s.reference.rgb[i]) * scale, 0.0, 1e9);
                const auto whole = static_cast<std::uint32_t>(level);
                made.rgb[i] = static_cast<std::uint8_t>(wraps ? whole & 255u : std::min(whole, 255u));
            }
        });
        return "";
    };
}

PictureFault recolored() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        const std::optional<Pair> pair = commonest_change(s);
        if (!pair) return std::nullopt;
        const Pair& colors = *pair;
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                const std::uint8_t* was = s.bytes.pixel(x, y);
                const bool is_changed = std::equal(was, was + 3, colors.begin());
                std::copy_n(is_changed ? &colors[3] : was, 3, made.pixel(x, y));
            }
        });
        return fmt::format("({}, {}, {}) instead of ({}, {}, {})", colors[3], colors[4], colors[5], colors[0],
                           colors[1], colors[2]);
    };
}

std::optional<double> fit_factor(const std::vector<float>& rest, const std::vector<float>& part,
                                 const BytePicture& bytes, const BytePicture& faulty, const Rows& rows) {
    double products = 0, squares = 0;
    for (const std::int32_t y : rows) {
        const std::size_t first = 3 * static_cast<std::size_t>(y) * bytes.width;
        for (std::size_t i = first; i < first + 3 * static_cast<std::size_t>(bytes.width); ++i) {
            const int was = bytes.rgb[i], is = faulty.rgb[i];
            if (is == was || is == 0 || is == 255 || was == 0 || was == 255) continue;
            const auto p = static_cast<double>(part[i]);
            const double wanted = is / 255.0 - (rest.empty() ? 0 : static_cast<double>(rest[i]));
            products += wanted * p;
            squares += p * p;
        }
    }
    if (!(squares > 0)) return std::nullopt;
    const double factor = products / squares;
    if (std::fabs(factor - 1) < 0.005 || factor <= 0) return std::nullopt;
    return factor;
}

}  // namespace glint
