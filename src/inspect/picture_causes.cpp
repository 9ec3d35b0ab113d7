// The causes that can be seen in the pictures alone, as a table: what the reference looks like with the
// fault.
#include "inspect/picture_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "glint/compare.h"
#include "inspect/picture_edges.h"
#include "math/elementary.h"

namespace glint {
namespace {

using Result = std::optional<FaultyPicture>;

// ---- Where a pixel comes from ----

// Pixel (x, y) is the reference's pixel from(x, y), which lies within it.
template <class From> Result moved(const PictureSource& s, From&& from, std::string detail = {}) {
    FaultyPicture out{s.bytes, std::move(detail)};
    for (std::int32_t y = 0; y < s.bytes.height; ++y) {
        for (std::int32_t x = 0; x < s.bytes.width; ++x) {
            const auto [u, v] = from(x, y);
            std::copy_n(s.bytes.pixel(u, v), 3, out.picture.pixel(x, y));
        }
    }
    return out;
}

using At = std::pair<std::int32_t, std::int32_t>;

Result upside_down(const PictureSource& s) {
    return moved(s, [&](std::int32_t x, std::int32_t y) { return At{x, s.bytes.height - 1 - y}; });
}
Result mirrored(const PictureSource& s) {
    return moved(s, [&](std::int32_t x, std::int32_t y) { return At{s.bytes.width - 1 - x, y}; });
}
Result rotated(const PictureSource& s) {
    return moved(s, [&](std::int32_t x, std::int32_t y) {
        return At{s.bytes.width - 1 - x, s.bytes.height - 1 - y};
    });
}
Result transposed(const PictureSource& s) {
    if (s.bytes.width != s.bytes.height) return std::nullopt;
    return moved(s, [](std::int32_t x, std::int32_t y) { return At{y, x}; });
}

double left_by(const PictureSource& s, const BytePicture& made) {
    return distance(made, s.faulty, s.edges).all;
}

// Sideways and up or down before the diagonals.
using Direction = std::pair<int, int>;
constexpr std::array<Direction, 8> k_directions = {
    {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};

Result shifted(const PictureSource& s) {
    Result best;
    double least = 0;
    for (const auto& [dx, dy] : k_directions) {
        Result found = moved(
            s,
            [&, dx = dx, dy = dy](std::int32_t x, std::int32_t y) {
                return At{std::clamp(x - dx, 0, s.bytes.width - 1),
                          std::clamp(y - dy, 0, s.bytes.height - 1)};
            },
            direction_text(dx, dy));
        const double left = left_by(s, found->picture);
        if (!best || left < least) {
            best = std::move(found);
            least = left;
        }
    }
    return best;
}

// How a picture half a pixel away looks is not known, but each of its channels is between two neighbours of
// the reference, or four by a diagonal. The more neighbours, the more they explain of anything: so a diagonal
// has to leave much less than the sides, and a direction much less than its opposite (more samples a pixel
// have no direction).
constexpr double k_diagonal_leaves = 0.3, k_opposite_leaves = 3;

Result half_shifted(const PictureSource& s) {
    std::array<Result, 8> made;
    std::array<double, 8> left{};
    for (std::size_t i = 0; i < 8; ++i) {
        const auto [dx, dy] = k_directions[i];
        made[i] = FaultyPicture{nearest_between(s.bytes, s.faulty, std::min(-dx, 0), std::max(-dx, 0),
                                                std::min(-dy, 0), std::max(-dy, 0)),
                                direction_text(dx, dy)};
        left[i] = left_by(s, made[i]->picture);
    }
    const auto side =
        static_cast<std::size_t>(std::min_element(left.begin(), left.begin() + 4) - left.begin());
    const auto diagonal =
        static_cast<std::size_t>(std::min_element(left.begin() + 4, left.end()) - left.begin());
    const std::size_t best = left[diagonal] < k_diagonal_leaves * left[side] ? diagonal : side;
    const auto [dx, dy] = k_directions[best];
    const auto opposite = static_cast<std::size_t>(
        std::find(k_directions.begin(), k_directions.end(), Direction{-dx, -dy}) - k_directions.begin());
    if (left[opposite] < k_opposite_leaves * left[best]) return std::nullopt;
    return std::move(made[best]);
}

Result anti_aliased(const PictureSource& s) {
    return FaultyPicture{nearest_between(s.bytes, s.faulty, -1, 1, -1, 1), {}};
}

Result specks(const PictureSource& s) { return FaultyPicture{with_dark_specks(s.bytes, s.faulty), {}}; }

// ---- What a channel becomes ----

template <int R, int G, int B> Result permuted(const PictureSource& s) {
    FaultyPicture out{s.bytes, {}};
    for (std::size_t i = 0; i < s.bytes.rgb.size(); i += 3) {
        out.picture.rgb[i] = s.bytes.rgb[i + R];
        out.picture.rgb[i + 1] = s.bytes.rgb[i + G];
        out.picture.rgb[i + 2] = s.bytes.rgb[i + B];
    }
    return out;
}

// Every channel value through a curve.
template <class Curve> Result curved(const PictureSource& s, Curve&& curve) {
    Image image = s.reference;
    for (float& value : image.rgb)
        value = static_cast<float>(curve(std::clamp(static_cast<double>(value), 0.0, 1.0)));
    return FaultyPicture{to_bytes(image, s.threads), {}};
}

double srgb_decoded(double v) { return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4); }

Result gamma_srgb(const PictureSource& s) {
    return FaultyPicture{to_bytes(s.reference, s.threads, Transfer::srgb), {}};
}
Result gamma_22(const PictureSource& s) {
    return curved(s, [](double v) { return pow(v, 1 / 2.2); });
}
Result no_gamma_srgb(const PictureSource& s) { return curved(s, srgb_decoded); }
Result no_gamma_22(const PictureSource& s) {
    return curved(s, [](double v) { return pow(v, 2.2); });
}
Result inverted(const PictureSource& s) {
    return curved(s, [](double v) { return 1 - v; });
}

Result scaled(const PictureSource& s) {
    const std::optional<double> factor = fit_factor({}, s.reference.rgb, s.bytes, s.faulty);
    if (!factor) return std::nullopt;
    Image image = s.reference;
    for (float& value : image.rgb) value *= static_cast<float>(*factor);
    FaultyPicture out{to_bytes(image, s.threads),
                      fmt::format("{}{:.3g}", s.unclamped ? "" : "about ", *factor)};
    for (std::size_t i = 0; !s.unclamped && i < image.rgb.size();
         ++i) {  // a file's 255 may have been anything above
        if (s.bytes.rgb[i] == 255) out.picture.rgb[i] = std::max(out.picture.rgb[i], s.faulty.rgb[i]);
    }
    return out;
}

// The whole part of value * scale, of which a byte keeps the lowest bits, or the most it can hold.
Result whole_part(const PictureSource& s, double scale, bool wraps) {
    if (!s.unclamped) return std::nullopt;
    FaultyPicture out{s.bytes, {}};
    for (std::size_t i = 0; i < s.reference.rgb.size(); ++i) {
        const double level = std::clamp(static_cast<double>(s.reference.rgb[i]) * scale, 0.0, 1e9);
        const auto whole = static_cast<std::uint32_t>(level);
        out.picture.rgb[i] = static_cast<std::uint8_t>(wraps ? whole & 255u : std::min(whole, 255u));
    }
    return out;
}

// The pair of colours (of the reference, of the faulty picture) that most of the different pixels have.
Result background(const PictureSource& s) {
    using Color = std::array<std::uint8_t, 6>;
    std::vector<Color> pairs;
    for (std::size_t i = 0; i < s.bytes.rgb.size(); i += 3) {
        const std::uint8_t *was = &s.bytes.rgb[i], *is = &s.faulty.rgb[i];
        if (!std::equal(was, was + 3, is)) pairs.push_back({was[0], was[1], was[2], is[0], is[1], is[2]});
    }
    std::sort(pairs.begin(), pairs.end());
    Color best{};
    std::ptrdiff_t most = 0;
    for (auto at = pairs.begin(); at != pairs.end();) {
        const auto end = std::upper_bound(at, pairs.end(), *at);
        if (end - at > most) {
            most = end - at;
            best = *at;
        }
        at = end;
    }
    if (most == 0) return std::nullopt;
    FaultyPicture out{s.bytes, fmt::format("({}, {}, {}) instead of ({}, {}, {})", best[3], best[4], best[5],
                                           best[0], best[1], best[2])};
    for (std::size_t i = 0; i < s.bytes.rgb.size(); i += 3) {
        if (std::equal(best.begin(), best.begin() + 3, &s.bytes.rgb[i]))
            std::copy_n(best.begin() + 3, 3, &out.picture.rgb[i]);
    }
    return out;
}

// What has no free parameter is believed earlier than what is fitted to the picture.
constexpr double k_moved = k_least_explained, k_curved = 0.7, k_fitted = 0.85, k_specks = 0.4;

}  // namespace

std::optional<double> fit_factor(const std::vector<float>& rest, const std::vector<float>& part,
                                 const BytePicture& bytes, const BytePicture& faulty) {
    double products = 0, squares = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
        const int was = bytes.rgb[i], is = faulty.rgb[i];
        if (is == was || is == 0 || is == 255 || was == 0 || was == 255) continue;
        const auto p = static_cast<double>(part[i]);
        const double wanted = is / 255.0 - (rest.empty() ? 0 : static_cast<double>(rest[i]));
        products += wanted * p;
        squares += p * p;
    }
    if (!(squares > 0)) return std::nullopt;
    const double factor = products / squares;
    if (std::fabs(factor - 1) < 0.005 || factor <= 0) return std::nullopt;
    return factor;
}

const std::vector<PictureCause>& picture_causes() {
    static const std::vector<PictureCause> table = {
        {"upside-down",
         "The picture is upside down: rows are counted from the bottom where the file counts from the top "
         "(or y "
         "points the other way). Write row H - 1 - y.",
         k_moved, upside_down},
        {"mirrored",
         "The picture is mirrored left to right: the camera's x axis points the other way (handedness). Swap "
         "the "
         "factors of the cross product that makes it, or negate x.",
         k_moved, mirrored},
        {"rotated", "The picture is turned by half a turn: both x and y count the wrong way.", k_moved,
         rotated},
        {"transposed", "Rows and columns are swapped: the pixel (x, y) was written to (y, x).", k_moved,
         transposed},
        {"red-blue-swapped",
         "Red and blue are swapped: the file wants R, G, B and was given B, G, R (or the other way round).",
         k_moved, permuted<2, 1, 0>},
        {"red-green-swapped", "Red and green are swapped.", k_moved, permuted<1, 0, 2>},
        {"green-blue-swapped", "Green and blue are swapped.", k_moved, permuted<0, 2, 1>},
        {"channels-rotated", "The channels have moved on by one: R, G, B arrive as G, B, R.", k_moved,
         permuted<1, 2, 0>},
        {"channels-rotated", "The channels have moved on by one: R, G, B arrive as B, R, G.", k_moved,
         permuted<2, 0, 1>},
        {"inverted", "The picture is a negative: 1 - value was written.", k_moved, inverted},
        {"shifted-one-pixel",
         "Everything is one pixel {}: an index begins at 1, or a half too many is rounded.", k_curved,
         shifted},
        {"gamma-applied",
         "The sRGB curve was applied once more than in the reference: leave it out (or, if the reference has "
         "it, "
         "apply it once, at the very end).",
         k_curved, gamma_srgb},
        {"gamma-applied",
         "A gamma of 1/2.2 was applied once more than in the reference: leave it out (or, if the reference "
         "has "
         "it, apply it once, at the very end).",
         k_curved, gamma_22},
        {"gamma-missing",
         "The reference has the sRGB curve and the picture has not (or its colours were decoded once too "
         "often): "
         "apply it once, at the very end.",
         k_curved, no_gamma_srgb},
        {"gamma-missing",
         "The reference has a gamma of 1/2.2 and the picture has not (or it was decoded once too often): "
         "apply "
         "it once, at the very end.",
         k_curved, no_gamma_22},
        {"rounded-down",
         "Bytes are cut off and not rounded: write floor(255 v + 0.5). The difference is 1/255 at most.",
         k_curved, [](const PictureSource& s) { return whole_part(s, 255.0, false); }},
        {"rounded-down", "Bytes are floor(256 v) in place of 255 v rounded. The difference is 1/255 at most.",
         k_curved, [](const PictureSource& s) { return whole_part(s, 256.0, false); }},
        {"not-clamped",
         "Colours above 1 begin again at black: clamp to 1 before making a byte of 255 times the value.",
         k_moved, [](const PictureSource& s) { return whole_part(s, 255.0, true); }},
        {"light-intensity",
         "Everything is {} times as bright: a light's intensity, or a factor of all lights.", k_fitted,
         scaled},
        {"background", "One colour is another, and nothing else: {}. Most often the background.", k_fitted,
         background},
        {"shifted-half-pixel",
         "Everything is half a pixel {}: rays pass through a pixel's middle (x + 0.5) here and its corner "
         "there.",
         k_fitted, half_shifted, 1},
        {"acne",
         "Dark specks on lit surfaces (acne): a shadow ray hits the very surface it leaves. Start it a "
         "little off "
         "the surface, or ignore hits with t below a small epsilon.",
         k_specks, specks, 1},
        {"anti-aliasing",
         "Only edges differ: the number or the places of the samples in a pixel, not the lighting.", k_fitted,
         anti_aliased, 2},
    };
    return table;
}

}  // namespace glint
