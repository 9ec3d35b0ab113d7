// SPDX-License-Identifier: Apache-2.0
// Whether what a cause leaves is rounding: synthetic pictures.
#include "compare/left_structure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "compare/edges.h"
#include "compare/factor_search.h"

namespace glint::test {
namespace {

struct Size {
    int width, height;
};
constexpr Size k_sizes[] = {{60, 40}, {97, 71}};

using GreyAt = std::function<int(int x, int y)>;
BytePicture drawn(Size size, const GreyAt& grey_at) {
    BytePicture picture{size.width, size.height, {}};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            for (int c = 0; c < 3; ++c)
                picture.rgb.push_back(static_cast<std::uint8_t>(std::clamp(grey_at(x, y), 0, 255)));
        }
    }
    return picture;
}

// A ramp that a cause makes 20 brighter in the left half.
int original_at(int x, int y) { return 40 + x + y / 2; }
GreyAt changed_in(Size size) {
    return [half = size.width / 2](int x, int y) { return original_at(x, y) + (x < half ? 20 : 0); };
}

bool agrees(Size size, const GreyAt& made_at, const GreyAt& target_at, bool but_at_edges = false) {
    const BytePicture made = drawn(size, made_at), target = drawn(size, target_at),
                      original = drawn(size, original_at);
    const std::vector<std::uint8_t> edges = edges_of(original, 1);
    const ByteRule rule;
    return agrees_where_changed(made, {view_of(made), rule}, target, original,
                                {&edges, all_rows(size.height), 1, 1}, but_at_edges);
}

TEST(LeftStructure, FewPixelsAreRoundedOtherwise) {
    for (const Size size : k_sizes) {
        const GreyAt made = changed_in(size);
        EXPECT_TRUE(agrees(size, made, made));
        const auto few = [&](int x, int y) { return made(x, y) + ((x * 7 + y * 13) % 20 == 0 ? 1 : 0); };
        EXPECT_TRUE(agrees(size, made, few));
    }
}

TEST(LeftStructure, AnotherCurveIsNoRounding) {
    for (const Size size : k_sizes) {
        const GreyAt made = changed_in(size);
        const auto half = [&](int x, int y) {
            return made(x, y) + (x < size.width / 2 && (x + y) % 2 == 0 ? 1 : 0);
        };
        EXPECT_FALSE(agrees(size, made, half));
        const auto off_by_two = [&](int x, int y) { return made(x, y) + (x < 5 ? 2 : 0); };
        EXPECT_FALSE(agrees(size, made, off_by_two));
    }
}

// A byte is right if it is a rounding of the cause's number: also one that is not the nearest, of a tie.
TEST(LeftStructure, BytesAreRoundingsOfNumbers) {
    for (const Size size : k_sizes) {
        const auto made_at = changed_in(size);
        const BytePicture made = drawn(size, made_at), original = drawn(size, original_at);
        const std::vector<std::uint8_t> edges = edges_of(original, 1);
        const auto agree_if = [&](double fraction, int off) {
            Image image{size.width, size.height, {}};
            for (const std::uint8_t v : made.rgb)
                image.rgb.push_back(static_cast<float>((v + fraction) / 255));
            const BytePicture target = drawn(size, [&](int x, int y) {
                return made_at(x, y) + (x < size.width / 2 && (x + y) % 20 == 0 ? off : 0);
            });
            const ByteRule rule;
            const PictureView numbers = image;
            return agrees_where_changed(made, {numbers, rule}, target, original,
                                        {&edges, all_rows(size.height), 1, 1}, false);
        };
        EXPECT_TRUE(agree_if(0.49, 1));
        EXPECT_TRUE(agree_if(0.3, 0));
        EXPECT_FALSE(agree_if(0.3, 1));
        EXPECT_FALSE(agree_if(0.49, -1));
    }
}

// What differs where the cause changes nothing has another cause. An edge there shows that both pictures are
// sampled alike.
TEST(LeftStructure, WhatIsLeftElsewhereIsNoRounding) {
    for (const Size size : k_sizes) {
        const auto with_edge = [&](const GreyAt& grey_at) {
            return drawn(size, [&](int x, int y) { return grey_at(x, y) + (y > size.height - 8 ? 60 : 0); });
        };
        const GreyAt made_at = changed_in(size);
        const BytePicture made = with_edge(made_at), original = with_edge(original_at);
        const std::vector<std::uint8_t> edges = edges_of(original, 1);
        const ByteRule rule;
        for (const int off : {0, 2}) {
            const BytePicture target = with_edge(
                [&](int x, int y) { return made_at(x, y) + (x > size.width - 5 && y < 9 ? off : 0); });
            EXPECT_EQ(agrees_where_changed(made, {view_of(made), rule}, target, original,
                                           {&edges, all_rows(size.height), 1, 1}, false),
                      off == 0);
        }
    }
}

// A dot where the change is missing is not of other samples, unlike a step that is one pixel further.
TEST(LeftStructure, ADotThatIsLeftIsNoRounding) {
    for (const Size size : k_sizes) {
        const GreyAt made = changed_in(size);
        const auto with_dot = [&](int by) {
            return [=](int x, int y) { return made(x, y) + (x == 9 && y == 11 ? by : 0); };
        };
        EXPECT_FALSE(agrees(size, made, with_dot(-7)));
        EXPECT_TRUE(agrees(size, made, with_dot(-3)));
        EXPECT_TRUE(agrees(size, made, with_dot(7)));
        const auto farther = [&](int x, int y) { return y == 11 ? made(x + 1, y) : made(x, y); };
        EXPECT_TRUE(agrees(size, made, farther));
    }
}

// In a picture that is large, a cause that changes a small spot has to be right in the spot.
TEST(LeftStructure, ASmallSpotOfALargePictureIsRight) {
    constexpr Size size{400, 300};
    const GreyAt original_at = [](int x, int y) {
        return 40 + std::abs(x % 100 - 50) + y / 4 + (y > size.height - 8 ? 60 : 0);
    };
    const auto in_spot = [](int x, int y) { return x >= 30 && x < 50 && y >= 40 && y < 60; };
    const GreyAt made_at = [&](int x, int y) { return original_at(x, y) + (in_spot(x, y) ? 20 : 0); };
    const BytePicture made = drawn(size, made_at), original = drawn(size, original_at);
    const std::vector<std::uint8_t> edges = edges_of(original, 1);
    const Area area{&edges, all_rows(size.height), 1, 1};
    const ByteRule rule;
    // Of the 400 pixels, so many in a diagonal are off by so much.
    const auto agrees_with = [&](int count, int off, bool in_the_spot) {
        const int left = in_the_spot ? 32 : 200;
        const BytePicture target = drawn(size, [&](int x, int y) {
            return made_at(x, y) + (x - left == y - 42 && x >= left && x < left + count ? off : 0);
        });
        EXPECT_EQ(wrong_pixels(made, {view_of(made), rule}, target, area), static_cast<std::size_t>(count));
        return agrees_where_changed(made, {view_of(made), rule}, target, original, area, false);
    };
    EXPECT_TRUE(agrees_with(6, 1, true));
    EXPECT_FALSE(agrees_with(7, 1, true));
    EXPECT_TRUE(agrees_with(4, 3, true));
    EXPECT_FALSE(agrees_with(5, 3, true));
    // Elsewhere, the picture's size counts.
    EXPECT_TRUE(agrees_with(13, 1, false));
    EXPECT_FALSE(agrees_with(15, 1, false));
}

// It changes no pixel by more than rounding, so that nothing else can be asked of it.
TEST(LeftStructure, TruncationAgrees) {
    for (const Size size : k_sizes) {
        const auto truncated = [](int x, int y) { return original_at(x, y) - (x + y) % 2; };
        const auto with_specks = [&](int x, int y) {
            return truncated(x, y) + ((x * 7 + y * 13) % 90 == 0 ? 5 : 0);
        };
        EXPECT_TRUE(agrees(size, truncated, with_specks));
    }
}

// 127.5 is 127 or 128, in all of an area of one color, and says nothing about a cause.
TEST(LeftStructure, ATieOfOneColorIsRounding) {
    for (const Size size : k_sizes) {
        const auto flat = [](int, int) { return 127; };
        EXPECT_TRUE(agrees(size, flat, [](int, int) { return 128; }));
        // It does not excuse edges, either: nothing shaded confirms the cause.
        EXPECT_FALSE(agrees(
            size, flat, [](int, int) { return 128; }, true));
    }
}

// If the numbers are known, they tell whether there is a tie.
TEST(LeftStructure, OneColorIsATieIfItsNumberIsNearOne) {
    for (const Size size : k_sizes) {
        const BytePicture made = drawn(size, [](int, int) { return 127; }),
                          target = drawn(size, [](int, int) { return 128; }),
                          original = drawn(size, [](int x, int y) { return original_at(x, y) / 4; });
        const std::vector<std::uint8_t> edges = edges_of(original, 1);
        const auto agrees_if = [&](double number) {
            const Image image{size.width, size.height,
                              std::vector<float>(made.rgb.size(), static_cast<float>(number / 255))};
            const PictureView numbers = image;
            const ByteRule rule;
            return agrees_where_changed(made, {numbers, rule}, target, original,
                                        {&edges, all_rows(size.height), 1, 1}, false);
        };
        EXPECT_TRUE(agrees_if(127.42));
        EXPECT_FALSE(agrees_if(127.3));
        EXPECT_FALSE(agrees_if(127));
    }
}

TEST(FactorSearch, TheFactorOfMostBytes) {
    for (const double factor : {1.2, 0.85}) {
        std::vector<WantedValue> values;
        const auto add = [&](double value) {
            values.emplace_back(std::round(255 * value * factor) / 255, value);
        };
        for (int i = 0; i < 400; ++i) add(0.3711);  // a floor, whose rounding decides the mean factor
        for (int i = 0; i < 500; ++i) add(0.2 + 0.001 * i);
        const double mean = std::round(255 * 0.3711 * factor) / 255 / 0.3711;
        EXPECT_NEAR(factor_of_most(values, mean), factor, 0.0015);
        // Of noise, no factor gives half of the bytes.
        for (std::size_t i = 0; i < values.size(); ++i) values[i].first += 0.01 * static_cast<double>(i % 40);
        EXPECT_EQ(factor_of_most(values, mean), mean);
    }
}

}  // namespace
}  // namespace glint::test
