// SPDX-License-Identifier: Apache-2.0
// The figures of a difference, for pictures with known figures.
#include "glint/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/contact_sheet.h"
#include "image/pictures.h"

namespace glint::test {
namespace {

Image flat(std::int32_t width, std::int32_t height, float value) {
    return {width, height, std::vector<float>(std::size_t{3} * width * height, value)};
}

TEST(Compare, EqualPictures) {
    const Image image = test::make_picture(50, 40);
    for (const bool as_floats : {false, true}) {
        const PictureDifference d = compare(image, image, {as_floats}).value();
        EXPECT_EQ(d.all.pixels, 2000u);
        EXPECT_EQ(d.all.equal, 2000u);
        EXPECT_EQ(d.edges.pixels + d.interiors.pixels, 2000u);
        EXPECT_EQ(d.mean, 0);
        EXPECT_EQ(d.rms, 0);
        EXPECT_FALSE(d.psnr.has_value());
        EXPECT_NEAR(d.ssim.value(), 1, 1e-12);
    }
}

TEST(Compare, OnePixel) {
    const Image b = flat(20, 10, 100 / 255.0f);
    Image a = b;
    a.rgb[3 * (4 * 20 + 7) + 1] = 130 / 255.0f;
    const PictureDifference d = compare(a, b).value();
    EXPECT_EQ(d.all.equal, 199u);
    EXPECT_EQ(d.all.within_1, 199u);
    EXPECT_DOUBLE_EQ(d.mean, 30.0 / 600);
    EXPECT_DOUBLE_EQ(d.rms, std::sqrt(900.0 / 600));
    EXPECT_NEAR(d.psnr.value(), 10 * std::log10(255.0 * 255 * 600 / 900), 1e-9);
    EXPECT_EQ(d.largest.value, 30);
    EXPECT_EQ(d.largest.x, 7);
    EXPECT_EQ(d.largest.y, 4);
    EXPECT_EQ(to_byte(d.largest.a[1]), 130);
    EXPECT_EQ(to_byte(d.largest.b[1]), 100);
    EXPECT_EQ(d.edges.pixels, 0u) << "only the reference decides what is an edge";
    EXPECT_FALSE(d.ssim.has_value()) << "lower than a window";
}

TEST(Compare, NanAndInfinityAreNeverEqual) {
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinite = std::numeric_limits<float>::infinity();
    for (const bool as_floats : {false, true}) {
        for (const float odd : {nan, infinite, -infinite}) {
            const Image b = flat(20, 12, 0);
            Image odd_one = b;
            odd_one.rgb[3 * (4 * 20 + 7) + 1] = odd;
            const Image& a = odd_one;
            for (const auto& [x, y] : {std::pair{&a, &b}, {&b, &a}, {&a, &a}}) {
                const PictureDifference d = compare(*x, *y, {as_floats, 255}).value();
                EXPECT_EQ(d.not_finite, 1u);
                EXPECT_EQ(d.all.equal, 239u);
                EXPECT_EQ(d.all.within_1, 239u);
                EXPECT_EQ(d.all.within, 239u);
                EXPECT_EQ(d.mean, 0);
                EXPECT_TRUE(std::isfinite(d.ssim.value()));
                EXPECT_EQ(difference_image(*x, *y).value().rgb[3 * (4 * 20 + 7) + 1], 1);
            }
        }
    }
    EXPECT_EQ(compare(flat(5, 5, 1), flat(5, 5, 1))->not_finite, 0u);
}

TEST(Compare, LimitsIncludeThemselves) {
    const Image b = flat(4, 1, 0);
    Image a = b;
    for (int i = 0; i < 4; ++i) a.rgb[3 * i] = static_cast<float>(i) / 255;
    CompareOptions options;
    options.within = 2;
    const PictureDifference d = compare(a, b, options).value();
    EXPECT_EQ(d.all.equal, 1u);
    EXPECT_EQ(d.all.within_1, 2u);
    EXPECT_EQ(d.all.within, 3u);
}

// Compared as bytes, clamped values are equal; compared as floats, the last bit counts.
TEST(Compare, BytesAndFloats) {
    const Image b = flat(3, 3, 1.5f), a = flat(3, 3, std::nextafter(1.5f, 2.0f)), c = flat(3, 3, 2.5f);
    EXPECT_EQ(compare(a, b)->all.equal, 9u);
    EXPECT_EQ(compare(c, b)->all.equal, 9u);
    EXPECT_EQ(compare(a, b, {true})->all.equal, 0u);
    EXPECT_EQ(compare(a, b, {true})->all.within_1, 9u);
    EXPECT_DOUBLE_EQ(compare(c, b, {true})->mean, 255);
}

TEST(Compare, EdgesAreTheReferencesNeighbourhoods) {
    Image b = flat(20, 20, 0);
    for (int y = 0; y < 20; ++y) {
        for (int x = 10; x < 20; ++x) b.rgb[3 * (y * 20 + x)] = 26 / 255.0f;
    }
    EXPECT_EQ(compare(b, b)->edges.pixels, 40u) << "a column on either side";
    for (float& v : b.rgb) v *= 25.0f / 26;
    EXPECT_EQ(compare(b, b)->edges.pixels, 0u);
}

// By definition: window by window, in long double.
TEST(Compare, SsimAgreesWithItsDefinition) {
    const std::int32_t width = 23, height = 17;
    const Image a = test::make_picture(width, height), b = [&] {
        Image image = a;
        for (std::size_t i = 0; i < image.rgb.size(); ++i)
            image.rgb[i] = image.rgb[i] * 0.7f + 0.001f * static_cast<float>(i % 97);
        return image;
    }();
    const auto luminance = [&](const Image& image, int x, int y) {
        const float* p = &image.rgb[3 * (y * width + x)];
        return 0.299L * to_byte(p[0]) + 0.587L * to_byte(p[1]) + 0.114L * to_byte(p[2]);
    };
    long double sum = 0;
    for (int y = 0; y + 11 <= height; ++y) {
        for (int x = 0; x + 11 <= width; ++x) {
            long double weights = 0, ma = 0, mb = 0, aa = 0, bb = 0, ab = 0;
            for (int v = 0; v < 11; ++v) {
                for (int u = 0; u < 11; ++u) {
                    const long double w = std::exp(-((u - 5) * (u - 5) + (v - 5) * (v - 5)) / 4.5L);
                    weights += w;
                    ma += w * luminance(a, x + u, y + v);
                    mb += w * luminance(b, x + u, y + v);
                }
            }
            ma /= weights;
            mb /= weights;
            for (int v = 0; v < 11; ++v) {
                for (int u = 0; u < 11; ++u) {
                    const long double w = std::exp(-((u - 5) * (u - 5) + (v - 5) * (v - 5)) / 4.5L) / weights;
                    const long double da = luminance(a, x + u, y + v) - ma,
                                      db = luminance(b, x + u, y + v) - mb;
                    aa += w * da * da;
                    bb += w * db * db;
                    ab += w * da * db;
                }
            }
            const long double c1 = 2.55L * 2.55L, c2 = 7.65L * 7.65L;
            sum += (2 * ma * mb + c1) * (2 * ab + c2) / ((ma * ma + mb * mb + c1) * (aa + bb + c2));
        }
    }
    const PictureDifference d = compare(a, b).value();
    EXPECT_NEAR(d.ssim.value(), static_cast<double>(sum / (13 * 7)), 1e-9);
    EXPECT_LT(d.ssim.value(), 0.99);
}

TEST(Compare, TheSameForAnyThreads) {
    const Image a = test::make_picture(100, 90), b = flat(100, 90, 0.4f);
    CompareOptions one, many;
    one.threads = 1;
    many.threads = 7;
    const PictureDifference x = compare(a, b, one).value(), y = compare(a, b, many).value();
    EXPECT_EQ(x.mean, y.mean);
    EXPECT_EQ(x.rms, y.rms);
    EXPECT_EQ(x.ssim, y.ssim);
    EXPECT_EQ(x.largest.x, y.largest.x);
}

TEST(Compare, InvalidPictures) {
    EXPECT_NE(compare(flat(2, 3, 0), flat(3, 2, 0)).message, "");
    EXPECT_NE(compare(Image{}, Image{}).message, "");
    EXPECT_NE(compare(Image{2, 2, {}}, flat(2, 2, 0)).message, "");
    EXPECT_FALSE(difference_image(flat(2, 3, 0), flat(3, 2, 0)));
}

TEST(DifferenceImage, IsAmplified) {
    const Image b = flat(2, 1, 0.5f);
    Image a = b;
    a.rgb[0] = 0.25f;
    a.rgb[4] = 0.625f;
    EXPECT_EQ(difference_image(a, b).value().rgb, (std::vector<float>{1, 0, 0, 0, 0.5f, 0}));
    EXPECT_EQ(difference_image(a, b, 2).value().rgb, (std::vector<float>{0.5f, 0, 0, 0, 0.25f, 0}));
    EXPECT_EQ(difference_image(b, b).value().rgb, std::vector<float>(6));
}

TEST(ContactSheet, ContainsItsCells) {
    EXPECT_EQ(scaled_down(flat(100, 50, 0.5f), 20).width, 20);
    EXPECT_EQ(scaled_down(flat(100, 50, 0.5f), 20).height, 10);
    EXPECT_EQ(scaled_down(flat(1000, 1, 0.5f), 20).height, 1);
    for (const float v : scaled_down(flat(101, 53, 0.25f), 20).rgb) EXPECT_FLOAT_EQ(v, 0.25f);
    const Image small = flat(7, 5, 1);
    EXPECT_EQ(scaled_down(small, 20).rgb, small.rgb);
    const std::vector<SheetCell> cells = {
        {flat(30, 20, 0.5f), {}, "0"},
        {flat(30, 20, 0.5f), flat(30, 20, 1), "1234567890 a very long name \xc3\xa9"},
        {{}, {}, "3 ada"}};
    for (const std::size_t columns : {1, 2, 3, 100}) {
        const Image sheet = contact_sheet(cells, {20, columns, 0});
        EXPECT_EQ(sheet.rgb.size(), std::size_t{3} * sheet.width * sheet.height);
        EXPECT_EQ(encode(sheet).message, "");
    }
    EXPECT_EQ(encode(contact_sheet({}, {20, 3, 0})).message, "");
}

// The dots of the first character of a label, row by row from the top left.
std::string dots_of_label(const std::string& label) {
    const Image sheet = contact_sheet({{flat(60, 40, 0.25f), {}, label}}, {60, 1, 0});
    std::string dots;
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 3; ++x) dots += sheet.pixel(6 + 2 * (1 + x), 6 + 2 * (1 + y)).r > 0.5 ? '#' : '.';
        dots += ' ';
    }
    return dots;
}

TEST(ContactSheet, LabelsAreText) {
    EXPECT_EQ(dots_of_label("A1"), ".#. #.# ### #.# #.# ");
    EXPECT_EQ(dots_of_label("a1"), dots_of_label("A1"));
    EXPECT_EQ(dots_of_label("7"), "### ..# .#. .#. .#. ");
    EXPECT_EQ(dots_of_label("\xc3\xa9t\xc3\xa9"), dots_of_label("?")) << "no glyph";
    EXPECT_NE(dots_of_label("B"), dots_of_label("8"));
}

// As many cells as for a class of ten thousand, with the size that the layout asks for.
TEST(ContactSheet, IsNeverTooLargeForAFile) {
    const std::pair<std::size_t, int> tables[] = {{1, 160},   {17, 160},  {18, 160},
                                                  {100, 136}, {1500, 33}, {4000, 17}};
    for (const auto& [rows, side] : tables) {
        const auto layout = lay_out_table(rows, 7);
        ASSERT_TRUE(layout) << rows;
        EXPECT_EQ(layout->side, side) << rows;
        std::vector<SheetCell> cells((rows + 1) * 7);
        for (SheetCell& cell : cells) cell = {flat(layout->side, layout->side, 0.5f), {}, "12345"};
        const Image sheet = contact_sheet(cells, *layout);
        EXPECT_LE(std::max(sheet.width, sheet.height), k_sheet_side) << rows;
    }
    for (const std::size_t count : {1, 2, 30, 1000, 30000}) {
        const auto layout = lay_out_list(count);
        ASSERT_TRUE(layout) << count;
        std::vector<SheetCell> cells(count, {flat(layout->side, layout->side, 0.5f), {}, "1"});
        const Image sheet = contact_sheet(cells, *layout);
        EXPECT_LE(std::max(sheet.width, sheet.height), k_sheet_side) << count;
    }
    EXPECT_FALSE(lay_out_table(100000, 7));
    EXPECT_FALSE(lay_out_table(1, 1000));
    EXPECT_FALSE(lay_out_list(100000));
}

TEST(ContactSheet, WhatIsMissingIsAFrame) {
    const Image sheet = contact_sheet({{flat(20, 10, 1), {}, ""}, {{}, {}, ""}}, {20, 2, 0});
    const auto at = [&](int x, int y) {
        return sheet.rgb[3 * static_cast<std::size_t>(y * sheet.width + x)];
    };
    EXPECT_EQ(at(6, 6), 1.0f);
    EXPECT_GT(at(32, 6), at(33, 7));
    EXPECT_GT(at(51, 15), at(50, 14));
    EXPECT_EQ(at(40, 10), at(0, 0));
}

TEST(ContactSheet, LongTablesContinueInAnotherBlock) {
    std::vector<SheetCell> cells;  // a head and five rows of two columns
    for (int i = 0; i < 12; ++i) cells.push_back({flat(20, 20, i < 2 ? 1.0f : 0.5f), {}, ""});
    const Image sheet = contact_sheet(cells, {20, 2, 3});
    ASSERT_EQ(sheet.height, 32 + 3 * 52 + 6);  // two blocks of three rows and two, each below the head
    ASSERT_EQ(sheet.width, 2 * (2 * 26 + 18) - 18 + 6);
    const auto at = [&](int block, int row, int column) {
        return sheet
            .rgb[3 * ((6 + row * 52 - (row == 0 ? 0 : 20) + 10) * static_cast<std::size_t>(sheet.width) + 6 +
                      block * 70 + column * 26 + 10)];
    };
    for (const int block : {0, 1}) {
        for (const int column : {0, 1}) {
            EXPECT_EQ(at(block, 0, column), 1.0f);
            EXPECT_EQ(at(block, 1, column), 0.5f);
            EXPECT_EQ(at(block, 2, column), 0.5f);
            EXPECT_EQ(at(block, 3, column) == 0.5f, block == 0) << column;
        }
    }
}

}  // namespace
}  // namespace glint::test
