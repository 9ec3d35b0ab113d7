// SPDX-License-Identifier: Apache-2.0
#include "image/contact_sheet.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace glint {
namespace {

constexpr std::int32_t k_gap = 6, k_wide_gap = 18;         // pixels: between cells, and after a head
constexpr std::int32_t k_min_side = 16, k_max_side = 160;  // pixels on the side of a picture
constexpr float k_paper = 0.15f, k_frame = 0.35f;

// A character of 3 x 5 dots: five rows of three bits, the first row in the highest bits.
struct Glyph {
    char character;
    std::uint16_t dots;
};
constexpr Glyph k_glyphs[] = {
    {'A', 025755}, {'B', 065656}, {'C', 034443}, {'D', 065556}, {'E', 074647}, {'F', 074644}, {'G', 034553},
    {'H', 055755}, {'I', 072227}, {'J', 011152}, {'K', 055655}, {'L', 044447}, {'M', 057755}, {'N', 065555},
    {'O', 025552}, {'P', 065644}, {'Q', 025573}, {'R', 065655}, {'S', 034216}, {'T', 072222}, {'U', 055557},
    {'V', 055552}, {'W', 055775}, {'X', 055255}, {'Y', 055222}, {'Z', 071247}, {'0', 075557}, {'1', 026227},
    {'2', 071747}, {'3', 071717}, {'4', 055711}, {'5', 074717}, {'6', 074757}, {'7', 071222}, {'8', 075757},
    {'9', 075717}, {'-', 000700}, {'_', 000007}, {'.', 000002}, {',', 000024}, {'/', 011244}, {'(', 012221},
    {')', 042224}, {'+', 002720}, {'@', 025743}, {'?', 071202}};

// Capitals stand for small letters, and "?" for characters that have no glyph. Spaces have no dots.
std::uint16_t dots_of(char c) {
    if (c == ' ') return 0;
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    for (const Glyph& glyph : k_glyphs) {
        if (glyph.character == c) return glyph.dots;
    }
    return dots_of('?');
}

void fill(Image& sheet, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height,
          float value) {
    for (std::int32_t v = std::max(y, 0); v < std::min(y + height, sheet.height); ++v) {
        for (std::int32_t u = std::max(x, 0); u < std::min(x + width, sheet.width); ++u)
            std::fill_n(&sheet.rgb[3 * (static_cast<std::size_t>(v) * sheet.width + u)], 3, value);
    }
}

void put(Image& sheet, const Image& picture, std::int32_t x, std::int32_t y) {
    for (std::int32_t v = 0; v < picture.height; ++v) {
        std::copy_n(&picture.rgb[3 * static_cast<std::size_t>(v) * picture.width], 3 * picture.width,
                    &sheet.rgb[3 * (static_cast<std::size_t>(y + v) * sheet.width + x)]);
    }
}

void put_frame(Image& sheet, std::int32_t x, std::int32_t y, std::int32_t width, std::int32_t height) {
    fill(sheet, x, y, width, height, k_frame);
    fill(sheet, x + 1, y + 1, width - 2, height - 2, k_paper);
}

// Writes a label with dots of two pixels if the cell is wide enough, else of one; what does not fit is cut
// off.
void put_label(Image& sheet, std::string_view label, std::int32_t x, std::int32_t y,
               std::int32_t cell_width) {
    std::string text;  // one "?" for each character that is not ASCII
    for (const char c : label) {
        if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) text += c;
    }
    const auto width_of = [](std::size_t characters) {
        return 4 * static_cast<std::int32_t>(characters) + 1;
    };
    const std::int32_t dot = 2 * width_of(text.size()) <= cell_width ? 2 : 1;
    while (!text.empty() && dot * width_of(text.size()) > cell_width) text.pop_back();
    fill(sheet, x, y, dot * width_of(text.size()), dot * 7, 0);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::uint16_t dots = dots_of(text[i]);
        for (std::int32_t row = 0; row < 5; ++row) {
            for (std::int32_t column = 0; column < 3; ++column) {
                if ((dots >> (14 - 3 * row - column) & 1) == 0) continue;
                fill(sheet, x + dot * (1 + column + 4 * static_cast<std::int32_t>(i)), y + dot * (1 + row),
                     dot, dot, 1);
            }
        }
    }
}

// The sheet's side for a number of cells of this width.
std::size_t across(std::size_t cells, std::int32_t width) {
    return cells * static_cast<std::size_t>(width + k_gap);
}
std::size_t down(std::size_t cells, std::int32_t height) {
    return cells * static_cast<std::size_t>(2 * height + 2 * k_gap);
}
bool fits(std::size_t pixels) { return pixels + k_gap <= static_cast<std::size_t>(k_sheet_side); }

std::size_t quotient_up(std::size_t n, std::size_t by) { return (n + by - 1) / by; }

// The position of cells: the table's rows in blocks side by side.
struct Grid {
    Grid(std::size_t cells, const SheetLayout& layout)
        : columns(std::max<std::size_t>(layout.columns, 1)), rows(quotient_up(cells, columns)) {
        if (layout.rows == 0 || rows < 2) return;
        head = 1;
        blocks = quotient_up(rows - 1, layout.rows);
        rows = 1 + quotient_up(rows - 1, blocks);  // no block is much shorter than the others
    }
    std::size_t columns, rows, head = 0, blocks = 1;
};

}  // namespace

Image scaled_down(const Image& picture, std::int32_t side) {
    const std::int32_t longest = std::max(picture.width, picture.height);
    if (longest <= side) return picture;
    const auto scaled = [&](std::int32_t length) {
        return std::max(static_cast<std::int32_t>(std::int64_t{length} * side / longest), 1);
    };
    Image small{scaled(picture.width), scaled(picture.height), {}};
    small.rgb.resize(std::size_t{3} * small.width * small.height);
    const auto first = [](std::int32_t i, std::int32_t from, std::int32_t to) {
        return static_cast<std::int32_t>(std::int64_t{i} * from / to);
    };
    for (std::int32_t y = 0; y < small.height; ++y) {
        const std::int32_t top = first(y, picture.height, small.height),
                           bottom = first(y + 1, picture.height, small.height);
        for (std::int32_t x = 0; x < small.width; ++x) {
            const std::int32_t left = first(x, picture.width, small.width),
                               right = first(x + 1, picture.width, small.width);
            for (int c = 0; c < 3; ++c) {
                float sum = 0;
                for (std::int32_t v = top; v < bottom; ++v) {
                    for (std::int32_t u = left; u < right; ++u)
                        sum += picture.rgb[3 * (static_cast<std::size_t>(v) * picture.width + u) + c];
                }
                small.rgb[3 * (static_cast<std::size_t>(y) * small.width + x) + c] =
                    sum / static_cast<float>((bottom - top) * (right - left));
            }
        }
    }
    return small;
}

std::optional<SheetLayout> lay_out_list(std::size_t cells) {
    SheetLayout layout;
    while (layout.columns * layout.columns < 2 * cells) ++layout.columns;  // cells are twice as high as wide
    const std::size_t rows = quotient_up(cells, layout.columns);
    for (layout.side = k_max_side; layout.side >= k_min_side; --layout.side) {
        if (fits(across(layout.columns, layout.side)) && fits(down(rows, layout.side))) return layout;
    }
    return std::nullopt;
}

std::optional<SheetLayout> lay_out_table(std::size_t rows, std::size_t columns) {
    SheetLayout layout;
    layout.columns = columns;
    for (layout.side = k_max_side; layout.side >= k_min_side; --layout.side) {
        layout.rows = (k_sheet_side - k_gap) / down(1, layout.side) - 1;
        const std::size_t blocks = quotient_up(rows, layout.rows);
        if (fits(blocks * (across(columns, layout.side) + k_wide_gap))) return layout;
    }
    return std::nullopt;
}

Image contact_sheet(const std::vector<SheetCell>& cells, const SheetLayout& layout) {
    std::int32_t width = 1, height = 1;
    for (const SheetCell& cell : cells) {
        width = std::max({width, cell.picture.width, cell.difference.width});
        height = std::max({height, cell.picture.height, cell.difference.height});
    }
    const Grid grid(cells.size(), layout);
    const std::size_t block_width = across(grid.columns, width) + k_wide_gap;
    const std::size_t saved = grid.head * static_cast<std::size_t>(height);  // heads have no differences
    Image sheet{static_cast<std::int32_t>(grid.blocks * block_width - k_wide_gap + k_gap),
                static_cast<std::int32_t>(down(grid.rows, height) - saved + k_gap),
                {}};
    sheet.rgb.assign(std::size_t{3} * sheet.width * sheet.height, k_paper);
    const auto put_cell = [&](const SheetCell& cell, std::size_t block, std::size_t row, std::size_t column) {
        const auto x = static_cast<std::int32_t>(k_gap + block * block_width + across(column, width));
        const auto y = static_cast<std::int32_t>(k_gap + down(row, height) - (row == 0 ? 0 : saved));
        if (cell.picture.rgb.empty()) put_frame(sheet, x, y, width, height);
        put(sheet, cell.picture, x, y);
        put(sheet, cell.difference, x, y + height + k_gap / 2);
        if (!cell.label.empty()) put_label(sheet, cell.label, x, y, width + k_gap);
    };
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::size_t row = i / grid.columns, column = i % grid.columns;
        if (row < grid.head) {
            for (std::size_t block = 0; block < grid.blocks; ++block) put_cell(cells[i], block, row, column);
        } else {
            const std::size_t rows = std::max<std::size_t>(grid.rows - grid.head, 1), at = row - grid.head;
            put_cell(cells[i], at / rows, grid.head + at % rows, column);
        }
    }
    return sheet;
}

}  // namespace glint
