// SPDX-License-Identifier: Apache-2.0
#include "compare/lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace glint {
namespace {

// Of the pixels of a line that differs. Darker ones hide what would differ.
constexpr double k_nearly_all = 0.9;
constexpr int k_dark = 8;

// A picture's lines of one kind.
struct LineView {
    const BytePicture& picture;
    Lines lines;
    std::int32_t count() const { return lines == Lines::rows ? picture.height : picture.width; }
    std::int32_t length() const { return lines == Lines::rows ? picture.width : picture.height; }
    const std::uint8_t* pixel(std::int32_t line, std::int32_t i) const {
        return lines == Lines::rows ? picture.pixel(i, line) : picture.pixel(line, i);
    }
};

bool is_near(const std::uint8_t* a, const std::uint8_t* b) {
    for (int c = 0; c < 3; ++c) {
        if (std::abs(int{a[c]} - int{b[c]}) > k_noise) return false;
    }
    return true;
}

bool has_color(const LineView& view, std::int32_t line, const std::uint8_t* color) {
    for (std::int32_t i = 0; i < view.length(); ++i) {
        if (!is_near(view.pixel(line, i), color)) return false;
    }
    return true;
}

std::string color_text(const std::uint8_t* c) { return fmt::format("({}, {}, {})", c[0], c[1], c[2]); }

struct LinesText {
    std::string text;  // "every second row", "rows 60 to 119", "row 5", "12 rows"
    bool is_regular;
};

// `same` marks lines that cannot be told from missing ones.
LinesText lines_text(const std::vector<std::int32_t>& missing, const std::vector<std::uint8_t>& same,
                     const char* one) {
    const std::int32_t first = missing.front(), last = missing.back();
    if (first == last) return {fmt::format("{} {}", one, first), true};
    std::int32_t step = 0, gaps = 0;
    for (std::size_t i = 1; i < missing.size(); ++i) {
        step = std::gcd(step, missing[i] - missing[i - 1]);
        for (std::int32_t line = missing[i - 1] + 1; line < missing[i]; ++line) gaps += same[line] == 0;
    }
    if (gaps == 0) return {fmt::format("{}s {} to {}", one, first, last), false};
    if (step == 1 || missing.size() == 2) return {fmt::format("{} {}s", missing.size(), one), false};
    if (step == 2) return {fmt::format("every second {}", one), true};
    return {step == 3 ? fmt::format("every third {}", one) : fmt::format("every {}th {}", step, one), true};
}

}  // namespace

std::optional<MissingLines> missing_lines(const BytePicture& reference, const BytePicture& faulty,
                                          Lines lines) {
    const LineView was{reference, lines}, is{faulty, lines};
    const std::uint8_t* color = nullptr;
    for (std::int32_t line = 0; line < is.count() && color == nullptr; ++line) {
        const std::uint8_t* first = is.pixel(line, 0);
        if (has_color(is, line, first) && !has_color(was, line, was.pixel(line, 0))) color = first;
    }
    if (color == nullptr) return std::nullopt;
    MissingLines found{std::vector<std::uint8_t>(static_cast<std::size_t>(is.count())), {}, false};
    std::vector<std::uint8_t> same = found.marks;
    std::vector<std::int32_t> missing;
    for (std::int32_t line = 0; line < is.count(); ++line) {
        if (!has_color(is, line, color)) continue;
        same[line] = has_color(was, line, color);
        found.marks[line] = same[line] == 0;
        if (same[line] == 0) missing.push_back(line);
    }
    // What is within k_noise of one color need not be so of another line's.
    if (missing.empty() || missing.size() == found.marks.size()) return std::nullopt;
    const LinesText text = lines_text(missing, same, lines == Lines::rows ? "row" : "column");
    found.text = fmt::format("{}, {} throughout", text.text, color_text(color));
    found.is_regular = text.is_regular;
    return found;
}

std::vector<std::uint8_t> differing_lines(const BytePicture& reference, const BytePicture& faulty,
                                          Lines lines) {
    const LineView was{reference, lines};
    std::vector<std::int32_t> lit(static_cast<std::size_t>(was.count())), differing = lit;
    for (std::int32_t y = 0; y < reference.height; ++y) {  // in memory's order
        for (std::int32_t x = 0; x < reference.width; ++x) {
            const std::uint8_t* pixel = reference.pixel(x, y);
            if (std::max({pixel[0], pixel[1], pixel[2]}) <= k_dark) continue;
            const std::int32_t line = lines == Lines::rows ? y : x;
            ++lit[line];
            differing[line] += !is_near(pixel, faulty.pixel(x, y));
        }
    }
    std::vector<std::uint8_t> marks(lit.size());
    for (std::size_t i = 0; i < marks.size(); ++i)
        marks[i] = lit[i] > 0 && differing[i] >= k_nearly_all * lit[i];
    return marks;
}

std::optional<std::string> one_color(const BytePicture& picture) {
    for (std::int32_t y = 0; y < picture.height; ++y) {
        if (!has_color({picture, Lines::rows}, y, picture.pixel(0, 0))) return std::nullopt;
    }
    return color_text(picture.pixel(0, 0));
}

}  // namespace glint
