#include "image/contact_sheet.h"

#include <algorithm>
#include <array>
#include <string>

namespace glint {
namespace {

constexpr std::int32_t k_gap = 6, k_dot = 2;  // pixels: between cells, and of a digit's dot
constexpr float k_paper = 0.15f;

// Digits of 3 x 5 dots, a row in three bits: enough to tell the pictures by the table's numbers.
constexpr std::array<std::array<std::uint8_t, 5>, 10> k_digits = {{{7, 5, 5, 5, 7},
                                                                   {2, 6, 2, 2, 7},
                                                                   {7, 1, 7, 4, 7},
                                                                   {7, 1, 3, 1, 7},
                                                                   {5, 5, 7, 1, 1},
                                                                   {7, 4, 7, 1, 7},
                                                                   {7, 4, 7, 5, 7},
                                                                   {7, 1, 2, 2, 2},
                                                                   {7, 5, 7, 5, 7},
                                                                   {7, 5, 7, 1, 7}}};

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

void put_number(Image& sheet, int number, std::int32_t x, std::int32_t y) {
    const std::string text = std::to_string(number);
    fill(sheet, x, y, k_dot * (4 * static_cast<std::int32_t>(text.size()) + 1), k_dot * 7, 0);
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto& digit = k_digits[static_cast<std::size_t>(text[i] - '0')];
        for (std::int32_t row = 0; row < 5; ++row) {
            for (std::int32_t column = 0; column < 3; ++column) {
                if ((digit[row] >> (2 - column) & 1) == 0) continue;
                fill(sheet, x + k_dot * (1 + column + 4 * static_cast<std::int32_t>(i)),
                     y + k_dot * (1 + row), k_dot, k_dot, 1);
            }
        }
    }
}

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

Image contact_sheet(const std::vector<SheetCell>& cells, std::size_t columns) {
    std::int32_t width = 1, height = 1;
    for (const SheetCell& cell : cells) {
        width = std::max({width, cell.picture.width, cell.difference.width});
        height = std::max({height, cell.picture.height, cell.difference.height});
    }
    columns = std::clamp<std::size_t>(columns, 1, std::max<std::size_t>(cells.size(), 1));
    const auto rows = static_cast<std::int32_t>((cells.size() + columns - 1) / columns);
    const std::int32_t step_x = width + k_gap, step_y = 2 * height + 2 * k_gap;
    Image sheet{static_cast<std::int32_t>(columns) * step_x + k_gap, rows * step_y + k_gap, {}};
    sheet.rgb.assign(std::size_t{3} * sheet.width * sheet.height, k_paper);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::int32_t x = k_gap + static_cast<std::int32_t>(i % columns) * step_x,
                           y = k_gap + static_cast<std::int32_t>(i / columns) * step_y;
        put(sheet, cells[i].picture, x, y);
        put(sheet, cells[i].difference, x, y + height + k_gap / 2);
        if (cells[i].number >= 0) put_number(sheet, cells[i].number, x, y);
    }
    return sheet;
}

}  // namespace glint
