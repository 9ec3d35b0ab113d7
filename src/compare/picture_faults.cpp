// SPDX-License-Identifier: Apache-2.0
#include "compare/picture_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/byte_curve.h"
#include "compare/edges.h"
#include "compare/factor_search.h"
#include "math/elementary.h"

namespace glint {
namespace {

using Detail = std::optional<std::string>;

// Of a fit: after the first, weights make it one of absolute values, which another fault of a few pixels
// hardly changes.
constexpr int k_factor_rounds = 5;
// Of a picture whose colors are truncated: this fraction of the pixels may be something else, at edges.
constexpr double k_mixed_pixels = 0.05;
// A fitted curve gives all channels that change but this fraction: many others would be as near.
constexpr double k_others_of_curve = 0.1;
constexpr int k_grey_spread = 8;  // of the channels of a pixel that counts as grey

// Every channel value of the reference as the byte change(value).
template <class Change> void change_values(const PictureSource& s, BytePicture& made, Change&& change) {
    const std::size_t row = 3 * static_cast<std::size_t>(made.width);
    if (const auto bytes = s.reference.bytes(); !bytes.empty()) {
        std::array<std::uint8_t, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i) table[i] = change(static_cast<float>(i) / 255.0f);
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            const std::size_t first = row * static_cast<std::size_t>(y);
            for (std::size_t i = first; i < first + row; ++i) made.rgb[i] = table[bytes[i]];
        });
        return;
    }
    for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
        float buffer[k_values_at_a_time];
        for (std::size_t first = row * static_cast<std::size_t>(y), end = first + row; first < end;
             first += k_values_at_a_time) {
            const std::size_t count = std::min(k_values_at_a_time, end - first);
            const float* values = s.reference.values(first, count, buffer);
            for (std::size_t i = 0; i < count; ++i) made.rgb[first + i] = change(values[i]);
        }
    });
}

// A byte of the reference, that of the faulty picture there, and how often that occurs.
struct ByteChange {
    std::size_t was = 0, is = 0, count = 0;
};
std::vector<ByteChange> changes_of(const PictureSource& s) {
    std::vector<std::uint32_t> counts(std::size_t{1} << 16);
    for (const std::int32_t y : s.fit.rows) {
        const std::size_t first = 3 * static_cast<std::size_t>(y) * s.bytes.width;
        for (std::size_t i = first; i < first + 3 * static_cast<std::size_t>(s.bytes.width); ++i)
            ++counts[256 * std::size_t{s.bytes.rgb[i]} + s.faulty.rgb[i]];
    }
    std::vector<ByteChange> changes;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0) changes.push_back({i / 256, i % 256, counts[i]});
    }
    return changes;
}

// In tenths, the gamma that leaves least of these changes.
double nearest_gamma(const std::vector<ByteChange>& changes, bool encodes) {
    double best = 0, least = HUGE_VAL;
    for (int tenths = 12; tenths <= 30; ++tenths) {
        const double gamma = tenths / 10.0, power = encodes ? 1 / gamma : gamma;
        std::array<double, 256> values{};
        for (std::size_t was = 0; was < values.size(); ++was)
            values[was] = 255 * pow(static_cast<double>(was) / 255, power);
        double left = 0;
        for (const auto& [was, is, count] : changes)
            left += static_cast<double>(count) * std::fabs(values[was] - static_cast<double>(is));
        if (left < least) least = left, best = gamma;
    }
    return best;
}

// A pair of colors: of the reference, of the faulty picture. As one number, which sorts fast.
using Pair = std::array<std::uint8_t, 6>;
std::uint64_t number_of(const std::uint8_t* was, const std::uint8_t* is) {
    std::uint64_t number = 0;
    for (int c = 0; c < 3; ++c) number = number << 8 | was[c];
    for (int c = 0; c < 3; ++c) number = number << 8 | is[c];
    return number;
}
Pair pair_of(std::uint64_t number) {
    Pair pair{};
    for (std::size_t i = 0; i < pair.size(); ++i)
        pair[i] = static_cast<std::uint8_t>(number >> (8 * (pair.size() - 1 - i)));
    return pair;
}

// A surface may have one color throughout, too, with another fault.
bool may_be_background(const PictureSource& s, std::int32_t x, std::int32_t y) {
    if (s.background == nullptr) return true;
    return (*s.background)[static_cast<std::size_t>(y) * static_cast<std::size_t>(s.bytes.width) +
                           static_cast<std::size_t>(x)];
}

// What most of the different pixels of the background have.
std::optional<Pair> commonest_change(const PictureSource& s) {
    std::vector<std::uint64_t> pairs;
    for (const std::int32_t y : s.fit.rows) {
        for (std::int32_t x = 0; x < s.bytes.width; ++x) {
            const std::uint8_t *was = s.bytes.pixel(x, y), *is = s.faulty.pixel(x, y);
            if (!std::equal(was, was + 3, is) && may_be_background(s, x, y))
                pairs.push_back(number_of(was, is));
        }
    }
    std::sort(pairs.begin(), pairs.end());
    std::optional<Pair> best;
    std::ptrdiff_t most = 0;
    for (auto at = pairs.begin(); at != pairs.end();) {
        const auto end = std::upper_bound(at, pairs.end(), *at);
        if (end - at > most) {
            most = end - at;
            best = pair_of(*at);
        }
        at = end;
    }
    return best;
}

// Whether all but a twentieth of a picture's pixels have no color, or hardly any.
bool is_grey(const BytePicture& picture) {
    std::size_t colored = 0;
    for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3) {
        const auto [least, most] = std::minmax({picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]});
        colored += most - least > k_grey_spread ? 1 : 0;
    }
    return colored <= picture.rgb.size() / 3 / 20;
}

}  // namespace

PictureFault repeated() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        if (s.background == nullptr) return std::nullopt;
        for (const std::int32_t y : s.rows) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                const std::uint8_t* from = s.bytes.pixel(x, y);
                std::uint8_t* const to = made.pixel(x, y);
                if (may_be_background(s, x, y) && to != made.rgb.data()) from = to - 3;
                std::copy_n(from, 3, to);
            }
        }
        return "";
    };
}

PictureFault dark_specks() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        const auto rows = differing_lines(s.bytes, s.faulty, Lines::rows),
                   columns = differing_lines(s.bytes, s.faulty, Lines::columns);
        put_dark_specks(s.bytes, s.faulty, s.rows, s.fit.threads, made);
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                if (rows[y] != 0 || columns[x] != 0) std::copy_n(s.bytes.pixel(x, y), 3, made.pixel(x, y));
            }
        });
        return "";
    };
}

PictureFault unwritten(Lines lines, bool regular) {
    return [=](const PictureSource& s, BytePicture& made) -> Detail {
        const std::optional<MissingLines> missing = missing_lines(s.bytes, s.faulty, lines);
        if (!missing || missing->is_regular != regular) return std::nullopt;
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                const bool is_missing = missing->marks[lines == Lines::rows ? y : x] != 0;
                std::copy_n((is_missing ? s.faulty : s.bytes).pixel(x, y), 3, made.pixel(x, y));
            }
        });
        return missing->text;
    };
}

PictureFault rim_differs() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        const std::int32_t width = made.width, height = made.height;
        if (s.fit.rim > 0 || std::min(width, height) < 3) return std::nullopt;
        const auto differs = [&](std::int32_t x, std::int32_t y) {
            return !std::equal(s.bytes.pixel(x, y), s.bytes.pixel(x, y) + 3, s.faulty.pixel(x, y));
        };
        bool top = false, bottom = false, left = false, right = false;
        for (std::int32_t x = 1; x < width - 1; ++x) {
            top = top || differs(x, 0);
            bottom = bottom || differs(x, height - 1);
        }
        for (std::int32_t y = 1; y < height - 1; ++y) {
            left = left || differs(0, y);
            right = right || differs(width - 1, y);
        }
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            std::copy_n(s.faulty.pixel(0, y), std::size_t{3} * width, made.pixel(0, y));
        });
        std::vector<const char*> sides;
        if (top) sides.push_back("the top row");
        if (bottom) sides.push_back("the bottom row");
        if (left) sides.push_back("the left column");
        if (right) sides.push_back("the right column");
        if (sides.empty()) sides.push_back("a corner");
        return fmt::format("{}", fmt::join(sides, ", "));
    };
}

PictureFault grey(double red, double green, double blue) {
    return [=](const PictureSource& s, BytePicture& made) -> Detail {
        if (!is_grey(s.faulty)) return std::nullopt;
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                const std::uint8_t* from = s.bytes.pixel(x, y);
                const double sum = red * from[0] + green * from[1] + blue * from[2];
                std::fill_n(made.pixel(x, y), 3, static_cast<std::uint8_t>(std::lround(sum)));
            }
        });
        return "";
    };
}

PictureFault channels_left(bool red, bool green, bool blue) {
    return [is_left = std::array{red, green, blue}](const PictureSource& s, BytePicture& made) -> Detail {
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                for (std::size_t c = 0; c < 3; ++c)
                    made.pixel(x, y)[c] = is_left[c] ? s.bytes.pixel(x, y)[c] : 0;
            }
        });
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
    return [bytes = ByteCurve(std::move(curve))](const PictureSource& s, BytePicture& made) -> Detail {
        change_values(s, made, [&](float value) { return bytes(static_cast<double>(value)); });
        return "";
    };
}

PictureFault to_a_power(bool encodes) {
    return [encodes](const PictureSource& s, BytePicture& made) -> Detail {
        const double gamma = nearest_gamma(changes_of(s), encodes), power = encodes ? 1 / gamma : gamma;
        const ByteCurve curve([power](double v) { return pow(v, power); });
        change_values(s, made, [&](float value) { return curve(static_cast<double>(value)); });
        std::size_t all = 0, others = 0;
        for (const std::int32_t y : s.rows) {
            const std::size_t first = 3 * static_cast<std::size_t>(y) * made.width;
            for (std::size_t i = first; i < first + 3 * static_cast<std::size_t>(made.width); ++i) {
                if (s.faulty.rgb[i] == s.bytes.rgb[i] && made.rgb[i] == s.bytes.rgb[i]) continue;
                ++all;
                others += std::abs(int{made.rgb[i]} - int{s.faulty.rgb[i]}) > k_noise;
            }
        }
        if (static_cast<double>(others) > k_others_of_curve * static_cast<double>(all)) return std::nullopt;
        return fmt::format("{:.1f}", gamma);
    };
}

PictureFault scaled() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        const std::optional<double> factor = fit_factor({}, s.reference, s.bytes, s.faulty, s.fit.rows);
        if (!factor) return std::nullopt;
        change_values(s, made, [by = static_cast<float>(*factor)](float value) {
            return to_byte(static_cast<double>(value * by));
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

PictureFault raised() {
    return [](const PictureSource& s, BytePicture& made) -> Detail {
        std::int64_t sum = 0, count = 0;
        for (const std::int32_t y : s.fit.rows) {
            const std::size_t first = 3 * static_cast<std::size_t>(y) * made.width;
            for (std::size_t i = first; i < first + 3 * static_cast<std::size_t>(made.width); ++i) {
                const int was = s.bytes.rgb[i], is = s.faulty.rgb[i];
                if (is == 0 || is == 255) continue;  // clamped, perhaps
                sum += is - was;
                ++count;
            }
        }
        if (count == 0) return std::nullopt;
        const int by = static_cast<int>(std::lround(static_cast<double>(sum) / static_cast<double>(count)));
        if (std::abs(by) <= k_noise) return std::nullopt;  // rounding or quantisation
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            const std::size_t first = 3 * static_cast<std::size_t>(y) * made.width;
            for (std::size_t i = first; i < first + 3 * static_cast<std::size_t>(made.width); ++i)
                made.rgb[i] = static_cast<std::uint8_t>(std::clamp(s.bytes.rgb[i] + by, 0, 255));
        });
        return fmt::format("{:+}", by);
    };
}

PictureFault whole_part(double scale, bool wraps) {
    return [=](const PictureSource& s, BytePicture& made) -> Detail {
        if (!s.unclamped) return std::nullopt;
        change_values(s, made, [=](float value) {
            const double level = std::clamp(static_cast<double>(value) * scale, 0.0, 1e9);
            const auto whole = static_cast<std::uint32_t>(level);
            return static_cast<std::uint8_t>(wraps ? whole & 255u : std::min(whole, 255u));
        });
        return "";
    };
}

PictureFault truncated(bool background) {
    return [=](const PictureSource& s, BytePicture& made) -> Detail {
        if (!s.unclamped || (!background && s.background == nullptr)) return std::nullopt;
        const auto is_kept = [&](std::int32_t x, std::int32_t y) {
            return !background && may_be_background(s, x, y);
        };
        std::size_t others = 0, all = 0;
        for (const std::int32_t y : s.fit.rows) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                if (is_kept(x, y)) continue;
                const std::uint8_t* is = s.faulty.pixel(x, y);
                others += std::any_of(is, is + 3, [](int v) { return v != 0 && v != 255; });
                ++all;
            }
        }
        if (static_cast<double>(others) > k_mixed_pixels * static_cast<double>(all)) return std::nullopt;
        change_values(s, made, [](float value) -> std::uint8_t { return value >= 1 ? 255 : 0; });
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                if (is_kept(x, y)) std::copy_n(s.bytes.pixel(x, y), 3, made.pixel(x, y));
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
        // One color may be a tie of rounding.
        const auto is_rounded = [](int was, int is) { return std::abs(is - was) <= k_rounding; };
        if (std::equal(colors.begin(), colors.begin() + 3, colors.begin() + 3, is_rounded))
            return std::nullopt;
        for_each_row(s.rows, s.fit.threads, [&](std::int32_t y) {
            for (std::int32_t x = 0; x < made.width; ++x) {
                const std::uint8_t* was = s.bytes.pixel(x, y);
                const bool is_changed =
                    std::equal(was, was + 3, colors.begin()) && may_be_background(s, x, y);
                std::copy_n(is_changed ? &colors[3] : was, 3, made.pixel(x, y));
            }
        });
        return fmt::format("({}, {}, {}) instead of ({}, {}, {})", colors[3], colors[4], colors[5], colors[0],
                           colors[1], colors[2]);
    };
}

std::optional<double> fit_factor(const std::vector<float>& rest, const PictureView& part,
                                 const BytePicture& bytes, const BytePicture& faulty, const Rows& rows) {
    const std::size_t row = 3 * static_cast<std::size_t>(bytes.width);
    const auto counts = [&](std::size_t i) {
        const int was = bytes.rgb[i], is = faulty.rgb[i];
        return is != was && is != 0 && is != 255 && was != 0 && was != 255;
    };
    std::size_t count = 0;
    for (const std::int32_t y : rows) {
        const std::size_t first = row * static_cast<std::size_t>(y);
        for (std::size_t i = first; i < first + row; ++i) count += counts(i);
    }
    std::vector<WantedValue> values;
    values.reserve(count);
    std::vector<float> buffer(row);
    for (const std::int32_t y : rows) {
        const std::size_t first = row * static_cast<std::size_t>(y);
        const float* parts = part.row(y, buffer.data());
        for (std::size_t i = first; i < first + row; ++i) {
            if (!counts(i)) continue;
            values.emplace_back(faulty.rgb[i] / 255.0 - (rest.empty() ? 0 : static_cast<double>(rest[i])),
                                static_cast<double>(parts[i - first]));
        }
    }
    double factor = 0;
    for (int round = 0; round < k_factor_rounds; ++round) {
        double products = 0, squares = 0;
        for (const auto& [wanted, p] : values) {
            const double weight = round == 0 ? 1 : 1 / std::max(std::fabs(wanted - factor * p), 0.5 / 255);
            products += weight * wanted * p;
            squares += weight * p * p;
        }
        if (!(squares > 0)) return std::nullopt;
        factor = products / squares;
    }
    factor = factor_of_most(values, factor);
    if (std::fabs(factor - 1) < 0.005 || factor <= 0) return std::nullopt;
    return factor;
}

}  // namespace glint
