// SPDX-License-Identifier: Apache-2.0
// Pictures of so many pixels that causes are tried on a sample of their rows.
#include <cstring>
#include <functional>

#include "compare/planted_faults.h"

namespace glint::test {
namespace {

constexpr int k_width = 1500, k_height = 1000;

Image large_picture() {
    return draw_text(replaced(test_scenes()[1].text, "size = 160 x 120", "size = 1500 x 1000"));
}

Image changed(const Image& image, const std::function<void(float* to, int x, int y)>& change) {
    Image out = image;
    for (int y = 0; y < k_height; ++y) {
        for (int x = 0; x < k_width; ++x) change(&out.rgb[3 * (y * k_width + x)], x, y);
    }
    return out;
}

// What explains a large picture explains all of it, not the sample alone.
TEST(CausesLarge, AreNamedByASampleAndMeasuredOnAll) {
    const Image right = large_picture();
    const auto at = [&](int x, int y) { return &right.rgb[3 * (y * k_width + x)]; };
    const std::pair<const char*, Image> plants[] = {
        {"upside-down",
         changed(right, [&](float* to, int x, int y) { std::copy_n(at(x, k_height - 1 - y), 3, to); })},
        {"red-blue-swapped", changed(right, [](float* to, int, int) { std::swap(to[0], to[2]); })},
        {"shifted-one-pixel",
         changed(right, [&](float* to, int x, int y) { std::copy_n(at(x, std::max(y - 1, 0)), 3, to); })},
        {"inverted", changed(right, [](float* to, int, int) {
             for (int c = 0; c < 3; ++c) to[c] = 1 - to[c];
         })}};
    for (const auto& [cause, faulty] : plants) {
        const CauseReport report = find_causes(faulty, right).value();
        ASSERT_EQ(first_cause(report), cause) << all_causes(report);
        EXPECT_EQ(report.causes.front().remaining, 0) << all_causes(report);
    }
}

// What stays is the mean of all pixels, not of those of the sample.
TEST(CausesLarge, SharesAreOfTheWhole) {
    const Image right = large_picture();
    const Image faulty = changed(right, [](float* to, int, int y) {
        if (y % 5 != 0) std::swap(to[0], to[2]);
        if (y % 5 == 0) std::swap(to[0], to[1]);
    });
    const CauseReport report = find_causes(faulty, right).value();
    ASSERT_EQ(first_cause(report), "red-blue-swapped") << all_causes(report);
    double left = 0;
    for (int y = 1; y < k_height - 1; ++y) {
        for (int x = 1; x < k_width - 1; ++x) {
            const float* is = &faulty.rgb[3 * (y * k_width + x)];
            const float* was = &right.rgb[3 * (y * k_width + x)];
            for (int c = 0; c < 3; ++c)
                left += 255 * std::fabs(static_cast<double>(is[c]) - static_cast<double>(was[2 - c]));
        }
    }
    EXPECT_NEAR(report.causes.front().remaining, left / (3.0 * (k_width - 2) * (k_height - 2)), 1e-4);
}

// A difference in a few rows, of which the sample may have none.
TEST(CausesLarge, SmallDifferencesAreSeen) {
    const Image right = large_picture();
    const Image faulty = changed(right, [](float* to, int x, int y) {
        if (y >= 700 && y < 703 && x > 100 && x < 900) std::swap(to[0], to[2]);
    });
    const CauseReport report = find_causes(faulty, right).value();
    EXPECT_GT(report.difference, 0);
    EXPECT_GT(report.tried, 5) << all_causes(report);
}

TEST(CausesLarge, ProgressGoesFromNothingToAllWithoutAScene) {
    const Image right = large_picture();
    const Image faulty = changed(right, [](float* to, int, int) { std::swap(to[0], to[2]); });
    std::vector<double> fractions;
    CauseOptions options;
    options.progress = [&](double fraction) { fractions.push_back(fraction); };
    EXPECT_TRUE(find_causes(faulty, right, nullptr, options));
    ASSERT_GT(fractions.size(), 10u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_LT(fractions.front(), 0.1);
    EXPECT_EQ(fractions.back(), 1);
}

}  // namespace
}  // namespace glint::test
