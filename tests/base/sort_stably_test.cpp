// SPDX-License-Identifier: Apache-2.0
#include "base/sort_stably.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <string>

namespace glint {
namespace {

TEST(SortStably, GivesTheOrderOfTheStandardLibrary) {
    std::mt19937 random(7);
    for (const std::size_t count : {0, 1, 2, 3, 10, 100, 3000}) {
        for (const unsigned kinds : {1u, 2u, 7u, 4000u}) {
            std::vector<std::pair<unsigned, std::string>> items;
            for (std::size_t i = 0; i < count; ++i) items.emplace_back(random() % kinds, std::to_string(i));
            auto expected = items;
            const auto less = [](const auto& a, const auto& b) { return a.first < b.first; };
            std::stable_sort(expected.begin(), expected.end(), less);
            sort_stably(items, less);
            EXPECT_EQ(items, expected);
        }
    }
}

TEST(SortStably, MovesItemsThatCannotBeCopied) {
    std::vector<std::unique_ptr<int>> items;
    for (const int value : {5, 3, 9, 1, 4}) items.push_back(std::make_unique<int>(value));
    sort_stably(std::span(items).subspan(1), [](const auto& a, const auto& b) { return *a < *b; });
    std::vector<int> values;
    for (const auto& item : items) values.push_back(*item);
    EXPECT_EQ(values, (std::vector{5, 1, 3, 4, 9}));
}

}  // namespace
}  // namespace glint
